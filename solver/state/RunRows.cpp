#include "solver/state/RunRows.h"

#include <cmath>

namespace vesicle
{

std::vector<std::string> run_columns(std::size_t vesicles, bool wall)
{
  std::vector<std::string> columns;
  if (vesicles > 1)
    columns.emplace_back("vesicle");
  columns.insert(columns.end(), Diagnostics::names().begin(), Diagnostics::names().end());
  if (vesicles > 1)
    columns.emplace_back("gap");
  if (wall)
    columns.insert(columns.end(), { "wall_gap", "lift_speed" });
  return columns;
}

std::vector<std::optional<double>> run_row(const std::vector<Diagnostics>& vesicles)
{
  std::vector<std::optional<double>> row;
  for (std::size_t v = 0; v < vesicles.size(); ++v)
  {
    if (vesicles.size() > 1)
      row.emplace_back(static_cast<double>(v));
    const auto values = vesicles[v].values();
    row.insert(row.end(), values.begin(), values.end());
    if (vesicles.size() > 1)
      row.push_back(vesicles[v].gap);
    if (vesicles[v].wall_gap)
      row.insert(row.end(), { vesicles[v].wall_gap, vesicles[v].lift_speed });
  }
  return row;
}

double largest(const std::vector<Diagnostics>& vesicles, double Diagnostics::*member)
{
  double value = 0;
  for (const Diagnostics& vesicle : vesicles)
    if (std::abs(vesicle.*member) >= std::abs(value))
      value = vesicle.*member;
  return value;
}

}
