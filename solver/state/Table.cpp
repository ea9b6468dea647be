#include "solver/state/Table.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace vesicle
{
namespace
{

std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells(1);
  for (const char c : line)
  {
    if (c == ',')
    {
      cells.emplace_back();
    }
    else if (c != '\r')
    {
      cells.back() += c;
    }
  }
  return cells;
}

}

std::optional<double> number_in(const std::string& cell)
{
  const auto first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
  if (first == std::string::npos)
  {
    return std::nullopt;
  }
  double value = 0;
  const char* const end = cell.data() + last + 1;
  const auto [read_to, failure] = std::from_chars(cell.data() + first, end, value);
  return failure == std::errc() && read_to == end ? std::optional(value) : std::nullopt;
}

std::vector<double> Table::column(const std::string& name) const
{
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
  {
    throw InputError("table without a column '" + name + "'");
  }
  const auto index = static_cast<std::size_t>(found - names.begin());
  std::vector<double> values;
  for (const auto& row : rows)
  {
    const auto value = number_in(row[index]);
    if (!value)
    {
      throw InputError("table column '" + name + "': '" + row[index] + "' is not a number");
    }
    values.push_back(*value);
  }
  return values;
}

Table parse_table(const std::string& text, const std::string& name)
{
  Table table;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);)
  {
    ++number;
    if (line.empty() || line.front() == '#')
    {
      continue;
    }
    auto cells = cells_of(line);
    if (table.names.empty())
    {
      for (const std::string& cell : cells)
      {
        table.names.push_back(cell.substr(0, cell.find(' ')));
      }
      continue;
    }
    if (cells.size() != table.names.size())
    {
      throw InputError(fmt::format(
        "{}:{}: has {} values for {} columns", name, number, cells.size(), table.names.size()));
    }
    table.rows.push_back(std::move(cells));
    table.lines.push_back(number);
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
