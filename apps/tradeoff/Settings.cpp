#include "apps/tradeoff/Settings.h"

#include "solver/scene/SceneNames.h"
#include "solver/scene/TomlText.h"

#include <fmt/format.h>

namespace vesicle::tradeoff
{
namespace
{

/// Numbers stay, words get quotes.
std::string toml_value(const std::string& value)
{
  return value.find_first_not_of("0123456789.e-+") == std::string::npos ? value : '"' + value + '"';
}

}

std::array<std::string, 2> Settings::knob_halves() const
{
  const std::size_t equals = knob.find('=');
  return { knob.substr(0, equals), knob.substr(equals + 1) };
}

std::string Settings::preset_name() const
{
  return name_of(preset_names, preset);
}

std::string Settings::label() const
{
  std::string label =
    fmt::format("{}-{}-{}{:g}", preset_name(), triangles, time.fixed_step ? "dt" : "", time.value);
  if (!knob.empty())
  {
    const auto [key, value] = knob_halves();
    label += "-" + key + "-" + value;
  }
  return label;
}

std::vector<std::string> Settings::overrides() const
{
  std::vector<std::string> result{ "accuracy.preset=" + preset_name(),
    fmt::format("vesicle.triangles={}", triangles),
    fmt::format("time.{}={}", time.key(), to_toml(time.value)) };
  if (!knob.empty())
    result.push_back("accuracy." + knob);
  return result;
}

std::string Settings::toml(std::size_t vesicles) const
{
  std::string text =
    fmt::format("{}triangles = {}\n\n[time]\n{} = {}\n\n[accuracy]\npreset = \"{}\"\n",
      vesicles > 1 ? "# of each [[vesicle]]: " : "[vesicle]\n", triangles, time.key(),
      to_toml(time.value), preset_name());
  if (!knob.empty())
  {
    const auto [key, value] = knob_halves();
    text += fmt::format("{} = {}\n", key, toml_value(value));
  }
  return text;
}

}
