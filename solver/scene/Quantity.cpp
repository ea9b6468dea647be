#include "solver/scene/Quantity.h"

#include "solver/scene/NearestName.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

namespace vesicle
{
namespace
{

constexpr double boltzmann = 1.380649; // 1e-23 J/K, exact
constexpr double ice_point = 273.15;   // K

constexpr PhysicalDimension none{}, length{ 1 }, mass{ 0, 1 }, duration{ 0, 0, 1 },
  temperature_dimension{ 0, 0, 0, 1 }, rate{ 0, 0, -1 }, velocity{ 1, 0, -1 },
  acceleration{ 1, 0, -2 }, force{ 1, 1, -2 }, energy{ 2, 1, -2 }, pressure{ -1, 1, -2 },
  viscosity{ -1, 1, -1 }, tension{ 0, 1, -2 }, surface_viscosity{ 0, 1, -1 }, curvature{ -1 },
  density{ -3, 1 };

PhysicalDimension operator+(const PhysicalDimension& a, const PhysicalDimension& b)
{
  return { a.length + b.length, a.mass + b.mass, a.time + b.time, a.temperature + b.temperature };
}

PhysicalDimension operator*(int power, const PhysicalDimension& d)
{
  return { power * d.length, power * d.mass, power * d.time, power * d.temperature };
}

/// A factor of what the schema calls a unit.
struct Named
{
  std::string_view name;
  PhysicalDimension dimension;
};
constexpr std::array words{ Named{ "length", length }, Named{ "area", { 2 } },
  Named{ "volume", { 3 } }, Named{ "time", duration }, Named{ "mass", mass },
  Named{ "energy", energy }, Named{ "pressure", pressure },
  Named{ "temperature", temperature_dimension } };

/// number × 10^decade in SI, kept apart so that "10 um" is the double nearest to 1e-5.
struct Factor
{
  double number;
  int decade;
  PhysicalDimension dimension;
};

struct Unit
{
  std::string_view name;
  Factor factor;
  bool takes_prefix;
};
constexpr std::array units{ Unit{ "m", { 1, 0, length }, true }, Unit{ "g", { 1, -3, mass }, true },
  Unit{ "s", { 1, 0, duration }, true }, Unit{ "K", { 1, 0, temperature_dimension }, true },
  Unit{ "N", { 1, 0, force }, true }, Unit{ "J", { 1, 0, energy }, true },
  Unit{ "Pa", { 1, 0, pressure }, true }, Unit{ "Hz", { 1, 0, rate }, true },
  Unit{ "eV", { 1.602176634, -19, energy }, true }, Unit{ "P", { 1, -1, viscosity }, true },
  Unit{ "dyn", { 1, -5, force }, true }, Unit{ "erg", { 1, -7, energy }, false },
  Unit{ "min", { 60, 0, duration }, false }, Unit{ "h", { 3600, 0, duration }, false },
  Unit{ "angstrom", { 1, -10, length }, false } };

struct Prefix
{
  std::string_view letter;
  int decade;
  bool is_shown;
};
/// From the smallest on.
constexpr std::array prefixes{ Prefix{ "a", -18, false }, Prefix{ "f", -15, true },
  Prefix{ "p", -12, true }, Prefix{ "n", -9, true }, Prefix{ "u", -6, true },
  Prefix{ "m", -3, true }, Prefix{ "c", -2, false }, Prefix{ "d", -1, false },
  Prefix{ "", 0, true }, Prefix{ "k", 3, true }, Prefix{ "M", 6, true }, Prefix{ "G", 9, true } };

/// Exact to rounding where the power of ten is a double.
double times_power_of_ten(double value, int decade)
{
  return decade < 0 ? value / std::pow(10., -decade) : value * std::pow(10., decade);
}

/// What SI numbers are shown in: the unit, the factor to it, whether it takes prefixes.
struct Shown
{
  PhysicalDimension dimension;
  const char* unit;
  bool takes_prefix;
  const char* example;
};
constexpr std::array shown{ Shown{ length, "m", true, "10 um" },
  Shown{ duration, "s", true, "10 s" }, Shown{ energy, "J", false, "20 kT" },
  Shown{ viscosity, "Pa s", true, "1 mPa s" }, Shown{ velocity, "m/s", true, "10 um/s" },
  Shown{ tension, "N/m", true, "1 uN/m" }, Shown{ rate, "/s", false, "1 /s" },
  Shown{ pressure, "Pa", true, "1 Pa" }, Shown{ force, "N", true, "1 pN" },
  Shown{ acceleration, "m/s^2", false, "9.81 m/s^2" }, Shown{ curvature, "/m", false, "1 /um" },
  Shown{ density, "kg/m^3", false, "40 kg/m^3" },
  Shown{ surface_viscosity, "Pa s m", true, "5 nPa s m" },
  Shown{ temperature_dimension, "K", false, "298.15 K" } };

const Shown* shown_as(const PhysicalDimension& dimension)
{
  const auto* found = std::find_if(
    shown.begin(), shown.end(), [&](const Shown& s) { return s.dimension == dimension; });
  return found == shown.end() ? nullptr : found;
}

std::string power_text(const char* unit, int power)
{
  return power == 0 ? ""
    : power == 1    ? fmt::format(" {}", unit)
                    : fmt::format(" {}^{}", unit, power);
}

std::string base_units(const PhysicalDimension& d)
{
  return power_text("kg", d.mass) + power_text("m", d.length) + power_text("s", d.time) +
    power_text("K", d.temperature);
}

/// What people write beside plain letters.
std::string in_plain_letters(std::string text)
{
  using Pair = std::pair<std::string_view, std::string_view>;
  static constexpr std::array replacements{ Pair{ "µ", "u" }, Pair{ "μ", "u" },
    Pair{ "Å", "angstrom" }, Pair{ "·", "*" }, Pair{ "×", "*" }, Pair{ "⁻¹", "^-1" },
    Pair{ "⁻²", "^-2" }, Pair{ "⁻³", "^-3" }, Pair{ "²", "^2" }, Pair{ "³", "^3" },
    Pair{ "°", "deg" } };
  for (const auto& [from, to] : replacements)
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at))
      text.replace(at, from.size(), to);
  return text;
}

bool is_letter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_digit(char c)
{
  return c >= '0' && c <= '9';
}

bool is_one_of(char c, std::string_view set)
{
  return set.find(c) != std::string_view::npos;
}

std::optional<Factor> find_unit(std::string_view name)
{
  for (const Unit& unit : units)
    for (const Prefix& prefix : prefixes)
      if ((unit.takes_prefix || prefix.letter.empty()) && name.starts_with(prefix.letter) &&
        name.substr(prefix.letter.size()) == unit.name)
        return Factor{ unit.factor.number, unit.factor.decade + prefix.decade,
          unit.factor.dimension };
  return std::nullopt;
}

std::string unknown_unit(const std::string& name)
{
  std::vector<std::string> known{ "kT" };
  for (const Unit& unit : units)
    for (const Prefix& prefix : prefixes)
      if (unit.takes_prefix || prefix.letter.empty())
        known.push_back(fmt::format("{}{}", prefix.letter, unit.name));
  const std::string nearest = nearest_name(name, known);
  return fmt::format("there is no unit \"{}\"{}", name,
    nearest.empty() ? "" : fmt::format(", did you mean {}?", nearest));
}

/// "mPa s/um^2", factor by factor; `Meaning` tells what the name of one stands for.
template<class Meaning>
class Product
{
public:
  Product(std::string_view text, const Meaning& meaning) : text_(text), meaning_(meaning) {}

  Factor evaluate()
  {
    Factor product{ 1, 0, none };
    for (bool divided = skip_signs(); at_ < text_.size(); divided = skip_signs())
    {
      const Factor factor = meaning_(name());
      const int power = (divided ? -1 : 1) * exponent();
      product.number *= std::pow(factor.number, power);
      product.decade += power * factor.decade;
      product.dimension = product.dimension + power * factor.dimension;
    }
    return product;
  }

private:
  /// Whether the next factor is divided by.
  bool skip_signs()
  {
    bool divided = false;
    for (; at_ < text_.size() && is_one_of(text_[at_], " */"); ++at_)
      divided = divided || text_[at_] == '/';
    return divided;
  }

  std::string_view name()
  {
    const std::size_t begin = at_;
    if (text_[at_] == '1') // "1/s"
      return text_.substr(at_++, 1);
    while (at_ < text_.size() && is_letter(text_[at_]))
      ++at_;
    if (at_ == begin)
      throw QuantityError(fmt::format("\"{}\" is no unit", text_.substr(begin)));
    return text_.substr(begin, at_ - begin);
  }

  int exponent()
  {
    const std::size_t begin = at_;
    if (at_ < text_.size() && text_[at_] == '^')
      ++at_;
    if (at_ == begin && !(at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '-')))
      return 1;
    int power = 1;
    const auto [end, error] =
      std::from_chars(text_.data() + at_, text_.data() + text_.size(), power);
    if (error != std::errc() || std::abs(power) > 9)
      throw QuantityError(fmt::format("\"{}\" is no power from -9 to 9", text_.substr(begin)));
    at_ = static_cast<std::size_t>(end - text_.data());
    return power;
  }

  std::string_view text_;
  const Meaning& meaning_;
  std::size_t at_ = 0;
};

std::string_view trimmed(std::string_view text)
{
  const auto begin = text.find_first_not_of(' ');
  return begin == std::string_view::npos
    ? std::string_view()
    : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// The number that a text begins with, and where it ends; nothing if there is none.
std::optional<std::pair<double, std::string_view>> number_in(std::string_view text)
{
  text = trimmed(text);
  if (text.starts_with('+'))
    text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc::invalid_argument || !std::isfinite(number))
    return std::nullopt;
  if (error != std::errc())
    throw QuantityError("its number is beyond double precision");
  return std::pair{ number, trimmed(text.substr(static_cast<std::size_t>(end - text.data()))) };
}

/// A part of what the schema calls a unit; none of what isn't made of its words (r0, pixels).
PhysicalDimension dimension_of(const std::string& part)
{
  bool known = true;
  const auto meaning = [&known](std::string_view name)
  {
    const auto* word = std::find_if(
      words.begin(), words.end(), [&](const Named& candidate) { return candidate.name == name; });
    known = known && (word != words.end() || name == "1");
    return Factor{ 1, 0, word == words.end() ? none : word->dimension };
  };
  const Factor product = Product(in_plain_letters(part), meaning).evaluate();
  return known ? product.dimension : none;
}

}

Dimensions dimensions_of(const std::string& unit)
{
  Dimensions dimensions;
  for (std::size_t begin = 0; begin < unit.size();)
  {
    const std::size_t end = std::min(unit.find(", ", begin), unit.size());
    dimensions.push_back(dimension_of(unit.substr(begin, end - begin)));
    begin = end + 2;
  }
  const bool any = std::any_of(
    dimensions.begin(), dimensions.end(), [](const PhysicalDimension& d) { return d != none; });
  return any ? dimensions : Dimensions{};
}

Quantity parse_quantity(const std::string& text, double temperature)
{
  const std::string plain = in_plain_letters(text);
  const auto number = number_in(plain);
  if (!number)
    throw QuantityError(fmt::format("\"{}\" doesn't begin with a number", text));
  const auto& [value, unit] = *number;
  if (unit == "degC")
    return { value + ice_point, temperature_dimension };
  const auto meaning = [temperature](std::string_view name)
  {
    if (name == "1")
      return Factor{ 1, 0, none };
    if (name == "kT")
      return Factor{ boltzmann * temperature, -23, energy };
    const auto found = find_unit(name);
    if (!found)
      throw QuantityError(unknown_unit(std::string(name)));
    return *found;
  };
  const Factor one = Product(unit, meaning).evaluate();
  return { times_power_of_ten(value * one.number, one.decade), one.dimension };
}

bool is_like_a_quantity(const std::string& text)
{
  const std::string_view begin = trimmed(text);
  return !begin.empty() && (is_digit(begin.front()) || is_one_of(begin.front(), "+-."));
}

std::string quantity_text(double value, const PhysicalDimension& dimension, int digits)
{
  const Shown* as = shown_as(dimension);
  if (!as)
    return fmt::format("{:.{}g}{}", value, digits, base_units(dimension));
  Prefix prefix{ "", 0, true };
  if (as->takes_prefix && value != 0)
  {
    prefix = prefixes[1];
    for (const Prefix& candidate : prefixes)
      if (candidate.is_shown &&
        times_power_of_ten(std::abs(value), -candidate.decade) >= 1 - .5 * std::pow(10., -digits))
        prefix = candidate;
  }
  return fmt::format(
    "{:.{}g} {}{}", times_power_of_ten(value, -prefix.decade), digits, prefix.letter, as->unit);
}

std::string si_unit(const PhysicalDimension& dimension)
{
  const Shown* as = shown_as(dimension);
  return as ? as->unit : base_units(dimension).substr(1);
}

std::string example_of(const PhysicalDimension& dimension)
{
  const Shown* as = shown_as(dimension);
  return as ? as->example : "1" + base_units(dimension);
}

}
