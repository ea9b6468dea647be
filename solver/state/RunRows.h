#pragma once
// What a run says at each step, as rows of a table.

#include "solver/dynamics/Diagnostics.h"

#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// The columns of a run's table: those of Diagnostics; where there are several vesicles, `vesicle` before and
/// `gap` behind them; where there is a wall, `wall_gap` and `lift_speed`.
std::vector<std::string> run_columns(std::size_t vesicles, bool wall);
/// What a step adds to it: the rows of all vesicles, one after the other.
std::vector<std::optional<double>> run_row(const std::vector<Diagnostics>& vesicles);
/// Of the vesicles' values that which is largest in magnitude.
double largest(const std::vector<Diagnostics>& vesicles, double Diagnostics::*member);

}
