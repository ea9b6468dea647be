#pragma once
// JSON for files and standard output.

#include <nlohmann/json_fwd.hpp>

#include <cmath>
#include <optional>
#include <string>

namespace vesicle
{

/// File names come from the system and need not be UTF-8, which JSON is: what isn't is replaced by
/// U+FFFD. `indent` < 0: one line.
template<typename Json>
std::string json_text(const Json& json, int indent = -1)
{
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// null where there is no finite number: JSON has none other.
template<typename Json = nlohmann::ordered_json>
Json json_number(const std::optional<double>& value)
{
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

}
