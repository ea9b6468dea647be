#pragma once

#include "solver/Errors.h"
#include "solver/scene/SceneFile.h"

#include <string>
#include <vector>

namespace vesicle::test
{

/// What reading a scene, s.toml, says is wrong with it.
inline std::string error_of(const std::string& toml, const std::vector<std::string>& overrides = {})
{
  try
  {
    parse_scene(toml, "s.toml", ".", overrides);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no error";
}

}
