#include "apps/validate/Runs.h"

#include "apps/DataFiles.h"
#include "apps/Progress.h"

#include "solver/simulation/StartMesh.h"
#include "solver/scene/SceneFile.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace vesicle::validation
{

Scene scene_of(const std::string& name, const std::vector<std::string>& overrides)
{
  const std::string file = "scenes/" + name + ".toml";
  return parse_scene(data_file(file), "data/" + file, ".", overrides);
}

static History watched(std::shared_ptr<Simulation> simulation, double latest)
{
  Progress progress(!isatty(STDOUT_FILENO), 0, simulation->scene().time.end);
  return run_to_end(std::move(simulation), latest,
    [&](const Diagnostics& diagnostics) { progress.step({ diagnostics }); });
}

History simulate(const Scene& scene)
{
  return watched(std::make_shared<Simulation>(scene, make_start_meshes(scene)), HUGE_VAL);
}

History simulate(const Scene& scene, const TriangleMesh& start, double latest)
{
  return watched(std::make_shared<Simulation>(scene, start), latest);
}

const Diagnostics& at_time(const History& run, double time)
{
  return *std::min_element(run.rows.begin(), run.rows.end(),
    [=](const Diagnostics& a, const Diagnostics& b)
    { return std::abs(a.time - time) < std::abs(b.time - time); });
}

double inclination(const Diagnostics& d)
{
  return d.inclination_deg.value_or(std::nan(""));
}

ChartLine line_of(const History& run, const std::string& label,
  const std::function<double(const Diagnostics&)>& quantity)
{
  ChartLine line;
  line.label = label;
  for (const Diagnostics& d : run.rows)
  {
    line.x.push_back(d.time);
    line.y.push_back(quantity(d));
  }
  return line;
}

}
