// Any text as a scene: an InputError, or a scene that is the same when written and read again.
#include "solver/Errors.h"
#include "solver/scene/SceneFile.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace vesicle;
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::string written;
  try
  {
    written = write_scene(parse_scene(text, "scene.toml"));
  }
  catch (const InputError&)
  {
    return 0;
  }
  if (write_scene(parse_scene(written, "written.toml")) != written)
    std::abort();
  return 0;
}
