#pragma once
// Values as TOML.

#include "solver/mesh/TriangleMesh.h"
#include "solver/mesh/shapes/ShapeRequest.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// The shortest text that reads back as the same double, and as a float rather than an integer.
std::string to_toml(double value);
std::string to_toml(int value);
std::string to_toml(bool value);
std::string to_toml(const std::string& text);
std::string to_toml(const ShapeMode& mode);
std::string to_toml(const Vector3& v);
template<class T, std::size_t n>
std::string to_toml(const std::array<T, n>& values);

template<class Values>
std::string toml_array(const Values& values)
{
  std::string text = "[";
  for (const auto& value : values)
    text += (text.size() > 1 ? ", " : "") + to_toml(value);
  return text + "]";
}

template<class T, std::size_t n>
std::string to_toml(const std::array<T, n>& values)
{
  return toml_array(values);
}

template<class T>
std::string to_toml(const std::vector<T>& values)
{
  return toml_array(values);
}

/// Nothing for what is empty.
template<class T>
std::string to_toml(const std::optional<T>& value)
{
  return value ? to_toml(*value) : "";
}

}
