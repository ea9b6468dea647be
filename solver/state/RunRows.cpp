#include "solver/state/RunRows.h"

#include <cmath>

namespace vesicle
{

RowKind row_kind(const std::vector<Diagnostics>& vesicles)
{
  return { vesicles.size(), vesicles.front().wall_gap.has_value(),
    vesicles.front().split.has_value() };
}

std::vector<std::string> run_columns(const RowKind& kind)
{
  std::vector<std::string> columns;
  if (kind.vesicles > 1)
    columns.emplace_back("vesicle");
  columns.insert(columns.end(), Diagnostics::names().begin(), Diagnostics::names().end());
  if (kind.vesicles > 1)
    columns.emplace_back("gap");
  if (kind.wall)
    columns.insert(columns.end(), { "wall_gap", "lift_speed" });
  if (kind.splits_power)
    columns.insert(
      columns.end(), { "dissipation_outside", "dissipation_inside", "dissipation_membrane" });
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
    if (const auto& split = vesicles[v].split)
      row.insert(row.end(), { split->outside, split->inside, split->membrane });
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
