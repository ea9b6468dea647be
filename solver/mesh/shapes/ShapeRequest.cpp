#include "solver/mesh/shapes/ShapeRequest.h"

#include "solver/Errors.h"
#include "solver/Joined.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vesicle
{

namespace
{
constexpr std::array<std::pair<const char*, ShapeRequest::Kind>, 7> kinds{ {
  { "sphere", ShapeRequest::Kind::sphere },
  { "prolate", ShapeRequest::Kind::prolate },
  { "oblate", ShapeRequest::Kind::oblate },
  { "ellipsoid", ShapeRequest::Kind::ellipsoid },
  { "discocyte", ShapeRequest::Kind::discocyte },
  { "perturbed", ShapeRequest::Kind::perturbed },
  { "stomatocyte", ShapeRequest::Kind::stomatocyte },
} };
}

ShapeRequest::Kind shape_kind(const std::string& name)
{
  std::vector<std::string> known;
  for (const auto& [text, kind] : kinds)
  {
    if (name == text)
      return kind;
    known.emplace_back(text);
  }
  throw InputError(
    fmt::format("there is no shape '{}': choose one of {}", name, joined(known, ", ")));
}

std::string shape_name(ShapeRequest::Kind kind)
{
  return std::ranges::find(kinds, kind, &std::pair<const char*, ShapeRequest::Kind>::second)->first;
}

}
