#include "solver/scene/TomlText.h"

#include <fmt/format.h>

namespace vesicle
{

std::string to_toml(double value)
{
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string to_toml(int value)
{
  return fmt::format("{}", value);
}

std::string to_toml(bool value)
{
  return value ? "true" : "false";
}

std::string to_toml(const std::string& text)
{
  std::string escaped = "\"";
  for (const char c : text)
    if (c == '"' || c == '\\')
    {
      escaped += '\\';
      escaped += c;
    }
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      escaped += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      escaped += c;
  return escaped + "\"";
}

std::string to_toml(const ShapeMode& mode)
{
  return fmt::format("[{}, {}, {}]", mode.l, mode.m, to_toml(mode.amplitude));
}

std::string to_toml(const Vector3& v)
{
  return to_toml(std::array<double, 3>{ v[0], v[1], v[2] });
}

}
