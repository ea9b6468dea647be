#include "solver/simulation/History.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

History run_to_end(std::shared_ptr<Simulation> simulation, double latest,
  const std::function<void(const Diagnostics&)>& watch)
{
  History run{ std::move(simulation), {}, {} };
  Simulation& sim = *run.simulation;
  run.last = sim.start();
  run.rows.push_back(sim.diagnose(run.last));
  while (!sim.finished(run.last) && run.last.time < latest)
  {
    run.last = sim.step(run.last);
    run.rows.push_back(sim.diagnose(run.last));
    if (watch)
    {
      watch(run.end());
    }
  }
  return run;
}

RelativeSpeeds relative_speeds(const History& run)
{
  const Points normal =
    run.simulation->fields(run.last).at("Normals").topRows(run.last.vesicles[0].points.rows());
  const auto& U = run.end().velocity;
  const Eigen::RowVector3d frame =
    Eigen::RowVector3d(U[0], U[1], U[2]) / run.simulation->scales().velocity();
  const Points u = run.last.vesicles[0].velocity.rowwise() - frame;
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
