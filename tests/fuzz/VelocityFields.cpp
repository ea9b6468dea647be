// Any bytes as the file of a velocity field: an InputError that names the file, or a field whose velocities
// are finite or not there.
#include "tests/fuzz/Fault.h"
#include "tests/fuzz/Targets.h"

#include "solver/Errors.h"
#include "tests/support/TemporaryFolder.h"
#include "vtkfilters/Filters/VelocityFieldFile.h"

#include <cmath>
#include <fstream>
#include <iterator>

namespace vesicle::fuzz
{

void velocity_fields(std::string_view bytes)
{
  static const test::TemporaryFolder folder;
  constexpr const char* names[] = { "field.vti", "field.vtr", "field.vts", "field.vtu",
    "field.vtk" };
  if (bytes.empty())
    return;
  const auto file = folder / names[static_cast<unsigned char>(bytes[0]) % std::size(names)];
  std::ofstream(file, std::ios::binary) << bytes.substr(1);
  try
  {
    std::string notes;
    const auto field = read_velocity_field(file, notes);
    require(std::isfinite(field->largest_rate()), "the rate isn't finite");
    for (const double x : { -0.6, 0.1, 0.5, 1.4 })
    {
      const Points at = Points::Constant(1, 3, x);
      require(field->velocities(at, 0).allFinite(), "a velocity isn't finite");
    }
  }
  catch (const InputError& error)
  {
    require(std::string_view(error.what()).find(folder.path().string()) == 0, error.what());
  }
  catch (const NumericalError&) // outside of the field
  {
  }
}

}
