#pragma once
// Tables of comma-separated values: the diagnostics of a run, the references of data/reference.

#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct Table
{
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows; ///< as many cells as names
  std::vector<int> lines;                     ///< of each row, from 1

  /// A column as numbers. Throws InputError if there is none of that name or a cell isn't a number.
  std::vector<double> column(const std::string& name) const;
};

/// The first line that doesn't start with # names the columns; what follows a blank in a name is
/// left out. `name` stands for the file in messages. Throws InputError with the line for rows of
/// another length.
Table parse_table(const std::string& text, const std::string& name = "table");

/// The number that a cell holds, or nothing.
std::optional<double> number_in(const std::string& cell);

/// Cubic through the four values around x in a table of equal steps from 0, periodic, with the last
/// value repeating the first.
double periodic_cubic(const std::vector<double>& values, double step, double x);

}
