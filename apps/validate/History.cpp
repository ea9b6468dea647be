#include "apps/validate/History.h"

#include "apps/Progress.h"
#include "apps/validate/Data.h"
#include "solver/dynamics/StartMesh.h"

#include "solver/scene/SceneFile.h"

#include <algorithm>
#include <cmath>

#include <unistd.h>

namespace vesicle::validation
{

Scene scene_of(const std::string& name, const std::vector<std::string>& overrides)
{
  const std::string file = "scenes/" + name + ".toml";
  return parse_scene(data_file(file), "data/" + file, ".", overrides);
}

History simulate(const Scene& scene)
{
  return simulate(scene, make_start_mesh(scene));
}

History simulate(const Scene& scene, const TriangleMesh& start, double latest)
{
  const auto simulation = std::make_shared<Simulation>(scene, start);
  History run{ simulation, {}, simulation->start() };
  Progress progress(!isatty(STDOUT_FILENO), 0, scene.time.end);
  run.rows.push_back(simulation->diagnose(run.last));
  while (!simulation->finished(run.last) && run.last.time < latest)
  {
    run.last = simulation->step(run.last);
    run.rows.push_back(simulation->diagnose(run.last));
    progress.step(run.end());
  }
  return run;
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

RelativeSpeeds relative_speeds(const History& run)
{
  const Points normal = run.simulation->fields(run.last).at("Normals");
  const auto& U = run.end().velocity;
  const Eigen::RowVector3d frame =
    Eigen::RowVector3d(U[0], U[1], U[2]) / run.simulation->scales().velocity();
  const Points u = run.last.velocity.rowwise() - frame;
  const Eigen::VectorXd along = u.cwiseProduct(normal).rowwise().sum();
  const Points tangential = u - (normal.array().colwise() * along.array()).matrix();
  return { along.cwiseAbs().maxCoeff(), tangential.rowwise().norm().maxCoeff() };
}

double largest_energy_rise(const History& run)
{
  double rise = 0;
  for (std::size_t i = 1; i < run.rows.size(); ++i)
  {
    rise = std::max(rise, run.rows[i].bending_energy / run.rows[i - 1].bending_energy - 1);
  }
  return rise;
}

double largest_drift(const History& run)
{
  double drift = 0;
  for (const Diagnostics& d : run.rows)
  {
    drift = std::max({ drift, std::abs(d.area_drift), std::abs(d.volume_drift) });
  }
  return drift;
}

}
