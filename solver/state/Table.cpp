#include "solver/state/Table.h"

#include "solver/Errors.h"

#include <algorithm>
#include <sstream>

namespace vesicle
{

namespace
{

std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');)
    cells.push_back(cell);
  return cells;
}

}

std::vector<double> Table::column(const std::string& name) const
{
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError("table without a column '" + name + "'");
  const auto index = static_cast<std::size_t>(found - names.begin());
  std::vector<double> values;
  for (const auto& row : rows)
  {
    std::size_t end = 0;
    try
    {
      values.push_back(std::stod(row[index], &end));
    }
    catch (const std::logic_error&)
    {
      end = 0;
    }
    if (end == 0)
      throw InputError("table column '" + name + "': '" + row[index] + "' is not a number");
  }
  return values;
}

Table parse_table(const std::string& text)
{
  Table table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    if (line.empty() || line.front() == '#')
      continue;
    std::vector<std::string> cells = cells_of(line);
    if (table.names.empty())
    {
      for (std::string& name : cells)
        table.names.push_back(name.substr(0, name.find(' ')));
      continue;
    }
    if (cells.size() != table.names.size())
      throw InputError("table row '" + line + "' has another number of columns than the header");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

double periodic_cubic(const std::vector<double>& values, double step, double x)
{
  const int period = static_cast<int>(values.size()) - 1, first = static_cast<int>(x / step) - 1;
  const double s = x / step - first; // between 1 and 2
  double sum = 0;
  for (int k = 0; k < 4; ++k)
  {
    double weight = 1;
    for (int m = 0; m < 4; ++m)
      weight *= m == k ? 1 : (s - m) / (k - m);
    sum += weight * values[(first + k + period) % period];
  }
  return sum;
}

}
