#include "apps/EquilibriumText.h"

#include "apps/JsonText.h"

#include "solver/mesh/MeshIntegrals.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <numbers>

namespace vesicle
{

EquilibriumReport report_of(const Equilibrium& e, const TriangleMesh& mesh)
{
  const Eigen::VectorXd& lowest = e.modes.eigenvalues;
  return { std::nullopt, reduced_volume(e.area, e.volume), mesh.triangles.rows(),
    e.energy / (8 * std::numbers::pi), std::nullopt, e.multipliers.tension, e.multipliers.pressure,
    e.stable(), { lowest.begin(), lowest.end() }, e.imbalance, e.steps };
}

std::string to_json_text(const EquilibriumReport& r)
{
  const auto or_null = [](const auto& value)
  { return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(); };
  const nlohmann::ordered_json json{ { "branch", or_null(r.branch) },
    { "reduced_volume", r.reduced_volume }, { "triangles", r.triangles },
    { "energy_over_8pi", r.energy_over_8pi }, { "energy_error", or_null(r.energy_error) },
    { "tension", r.tension }, { "pressure", r.pressure }, { "stable", r.stable },
    { "lowest_eigenvalues", r.lowest_eigenvalues }, { "imbalance", r.imbalance },
    { "steps", r.steps } };
  return json_text(json, 2) + "\n";
}

std::string to_text(const EquilibriumReport& r)
{
  std::string text = fmt::format("  triangles        {}\n  reduced volume   {:.10g}\n"
                                 "  energy / 8 pi EB {:.8g}",
    r.triangles, r.reduced_volume, r.energy_over_8pi);
  if (r.energy_error)
  {
    text += fmt::format(" ({:+.1e} of the axisymmetric shape's)", *r.energy_error);
  }
  text += fmt::format("\n  tension          {:.7g} EB/r0^2\n  pressure         {:.7g} EB/r0^3\n"
                      "  imbalance        {:.1e} EB/r0^3 after {} steps\n  eigenvalues     ",
    r.tension, r.pressure, r.imbalance, r.steps);
  for (const double value : r.lowest_eigenvalues)
  {
    text += fmt::format(" {:.4g}", value);
  }
  text += fmt::format(" EB/r0^4: {}\n", r.stable ? "stable" : "unstable");
  return text;
}

}
