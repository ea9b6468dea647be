// Any bytes as the file of a mesh, read, cut into triangles and prepared for dynamics: an InputError
// or a mesh, and nothing else. The first byte chooses the format.
#include "solver/Errors.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/Triangulation.h"
#include "solver/mesh/io/LegacyVtkFile.h"
#include "solver/mesh/io/ObjFile.h"
#include "solver/mesh/io/OffFile.h"
#include "solver/mesh/io/PlyFile.h"
#include "solver/mesh/io/StlFile.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace vesicle;
  constexpr decltype(&read_off) readers[] = { read_off, read_obj, read_ply, read_stl,
    read_legacy_vtk };
  if (size == 0)
    return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try
  {
    const SurfaceFile file = readers[data[0] % std::size(readers)](bytes, "input");
    check_points(file.points, "input");
    check_corners(file.polygons, file.points.rows(), "input");
    TriangleMesh mesh{ file.points, triangulate(file.points, file.polygons, "input").triangles };
    prepare_for_dynamics(mesh, "input");
  }
  catch (const InputError&)
  {
  }
  return 0;
}
