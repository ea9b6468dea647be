#pragma once
// What a run says at each step, as rows of a table.

#include "solver/dynamics/Diagnostics.h"

#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// What rows have beside what a vesicle alone has.
struct RowKind
{
  std::size_t vesicles = 1;
  bool wall = false, splits_power = false;
};
/// Of one vesicle or more.
RowKind row_kind(const std::vector<Diagnostics>& vesicles);

/// The columns of a run's table: those of Diagnostics; where there are several vesicles, `vesicle` before and
/// `gap` behind them; where there is a wall, `wall_gap` and `lift_speed`; last, where there is one, the
/// split of the dissipation.
std::vector<std::string> run_columns(const RowKind& kind);
/// What a step adds to it: the rows of all vesicles, one after the other, which are all of one kind.
std::vector<std::optional<double>> run_row(const std::vector<Diagnostics>& vesicles);
/// Of the vesicles' values that which is largest in magnitude.
double largest(const std::vector<Diagnostics>& vesicles, double Diagnostics::*member);

}
