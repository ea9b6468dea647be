// Any bytes as VTK's XML file of a surface: an InputError that names the file, or triangles of
// finite points with a value of each array for each.
#include "tests/fuzz/Fault.h"
#include "tests/fuzz/Surfaces.h"
#include "tests/fuzz/Targets.h"

#include "solver/Errors.h"
#include "tests/support/TemporaryFolder.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkPolyData.h"

#include <fstream>
#include <iterator>

namespace vesicle::fuzz
{
namespace
{

void write(const std::filesystem::path& file, std::string_view bytes)
{
  std::ofstream(file, std::ios::binary) << bytes;
}

/// Writes what is to be read, and says its name.
std::filesystem::path input_file(const test::TemporaryFolder& folder, std::string_view bytes)
{
  constexpr const char* names[] = { "input.vtp", "input.vtu", "input.pvtu" };
  const auto kind = static_cast<unsigned char>(bytes[0]) % std::size(names);
  const std::string_view file = bytes.substr(1);
  const std::size_t end = kind == 2 ? file.find('\0') : std::string_view::npos;
  write(folder / names[kind], file.substr(0, end));
  if (end != std::string_view::npos)
    write(folder / "piece.vtu", file.substr(end + 1));
  return folder / names[kind];
}

}

void xml_surfaces(std::string_view bytes)
{
  static const test::TemporaryFolder folder;
  if (bytes.empty())
    return;
  const auto file = input_file(folder, bytes);
  try
  {
    const auto surface = read_mesh(file);
    require_sound(surface);
    require_sound(membrane_of(surface));
  }
  catch (const InputError& error)
  {
    require(std::string_view(error.what()).find(folder.path().string()) == 0, error.what());
  }
}

}
