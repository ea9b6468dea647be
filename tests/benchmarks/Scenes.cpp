#include "tests/benchmarks/Scenes.h"

#include "solver/scene/SceneFile.h"
#include "solver/simulation/StartMesh.h"

#include <map>

namespace vesicle::benchmarks
{

Scene scene_of(const std::string& name, const std::vector<std::string>& overrides)
{
  return read_scene(VESICLE_SOURCE_DIR "/data/scenes/" + name + ".toml", overrides);
}

Scene endless(const std::string& name, int triangles)
{
  Scene scene = scene_of(name, { "vesicle.triangles=" + std::to_string(triangles) });
  scene.time.end = 1000;
  scene.time.output_every = 0;
  return scene;
}

Run::Run(const Scene& scene, int steps)
  : simulation(scene, make_start_meshes(scene)), state(simulation.start())
{
  for (int i = 0; i < steps; ++i)
    step();
}

Run& kept_run(const std::string& name, const Scene& scene)
{
  static std::map<std::string, Run> runs;
  return runs.try_emplace(name, scene).first->second;
}

}
