// Any bytes as the file of a mesh, read, cut into triangles and prepared for dynamics: an InputError
// that names the file, or a mesh, which is the same when it is written and read again.
#include "tests/fuzz/Fault.h"
#include "tests/fuzz/Targets.h"

#include "solver/Errors.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/Triangulation.h"
#include "solver/mesh/io/GmshFile.h"
#include "solver/mesh/io/LegacyVtkFile.h"
#include "solver/mesh/io/ObjFile.h"
#include "solver/mesh/io/OffFile.h"
#include "solver/mesh/io/PlyFile.h"
#include "solver/mesh/io/StlFile.h"

#include <iterator>

namespace vesicle::fuzz
{
namespace
{

constexpr decltype(&read_off) readers[] = { read_off, read_obj, read_ply, read_stl, read_legacy_vtk,
  read_gmsh };

TriangleMesh mesh_of(const SurfaceFile& file)
{
  check_points(file.points, "input");
  check_corners(file.polygons, file.points.rows(), "input");
  return { file.points, triangulate(file.points, file.polygons, "input").triangles };
}

void require_same(const TriangleMesh& mesh, const SurfaceFile& again, const std::string& format)
{
  const TriangleMesh back = mesh_of(again);
  require(back.points.rows() == mesh.points.rows() && back.points == mesh.points,
    format + " moves points");
  require(back.triangles.rows() == mesh.triangles.rows() && back.triangles == mesh.triangles,
    format + " changes triangles");
}

}

void meshes(std::string_view bytes)
{
  if (bytes.empty())
    return;
  const auto format = static_cast<unsigned char>(bytes[0]) % std::size(readers);
  try
  {
    SurfaceFile file = readers[format](bytes.substr(1), "input");
    TriangleMesh mesh = mesh_of(file);
    require_same(mesh, read_obj(obj_text(mesh), "written"), "OBJ");
    require_same(mesh, read_off(off_text(mesh), "written"), "OFF");
    prepare_for_dynamics(mesh, "input");
  }
  catch (const InputError& error)
  {
    require(std::string_view(error.what()).starts_with("input"), error.what());
  }
}

}
