#pragma once
// Numbers with a unit: "10 um", "20 kT", "1 mPa s". They are read into SI, and SI numbers are shown
// with a unit that people use.

#include <stdexcept>
#include <string>
#include <vector>

namespace vesicle
{

/// Powers of m, kg, s and K.
struct PhysicalDimension
{
  int length = 0, mass = 0, time = 0, temperature = 0;
  bool operator==(const PhysicalDimension&) const = default;
};

/// What a key's unit measures, as the schema says it: "energy / area", "pressure × time", "length";
/// "time, a number" is of rows of both. Empty where it has no dimension ("r0", "").
using Dimensions = std::vector<PhysicalDimension>;
Dimensions dimensions_of(const std::string& unit);

/// What isn't understood of a quantity.
struct QuantityError : std::runtime_error
{
  using runtime_error::runtime_error;
};

struct Quantity
{
  double value; ///< in SI
  PhysicalDimension dimension;
};

/// Units have prefixes (f to G) and are multiplied ("mPa s", "N*m"), divided ("N/m": the next factor
/// only) and raised ("m^2", "s^-1", "µm²"); "degC" stands alone. `temperature` in K is that of kT. A
/// text without a unit is a number of no dimension. Throws QuantityError.
Quantity parse_quantity(const std::string& text, double temperature);

/// Whether a text begins like a number, so that it is meant as a quantity.
bool is_like_a_quantity(const std::string& text);

/// "10 um", with so many digits at most.
std::string quantity_text(double value, const PhysicalDimension& dimension, int digits = 4);
/// What an SI number is in: "m/s".
std::string si_unit(const PhysicalDimension& dimension);
/// How one may look, for messages: "10 um".
std::string example_of(const PhysicalDimension& dimension);

}
