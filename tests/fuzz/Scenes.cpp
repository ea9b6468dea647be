// Any text as a scene: an InputError that names it, or a scene that is the same when it is written
// and read again.
#include "tests/fuzz/Fault.h"
#include "tests/fuzz/Targets.h"

#include "solver/Errors.h"
#include "solver/scene/SceneFile.h"

#include <string>

namespace vesicle::fuzz
{

void scenes(std::string_view bytes)
{
  std::string written;
  try
  {
    written = write_scene(parse_scene(std::string(bytes), "scene.toml"));
  }
  catch (const InputError& error)
  {
    require(std::string_view(error.what()).starts_with("scene.toml"), error.what());
    return;
  }
  require(write_scene(parse_scene(written, "written.toml")) == written, written);
}

}
