#pragma once
// Tables of comma-separated values, as in data/reference.

#include <string>
#include <vector>

namespace vesicle
{

struct Table
{
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows; ///< as many cells as names

  /// A column as numbers. Throws InputError if there is none of that name or a cell isn't a number.
  std::vector<double> column(const std::string& name) const;
};

/// The first line that doesn't start with # names the columns; what follows a blank in a name is
/// left out. Throws InputError for rows of another length.
Table parse_table(const std::string& text);

/// Cubic through the four values around x in a table of equal steps from 0, periodic, with the last
/// value repeating the first.
double periodic_cubic(const std::vector<double>& values, double step, double x);

}
