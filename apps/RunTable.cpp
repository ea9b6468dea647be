#include "apps/RunTable.h"

#include "solver/Errors.h"
#include "solver/dynamics/Diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>

namespace vesicle
{
namespace
{

std::vector<std::string> split(const std::string& line)
{
  std::vector<std::string> fields(1);
  for (const char c : line)
  {
    if (c == ',')
    {
      fields.emplace_back();
    }
    else if (c != '\r')
    {
      fields.back() += c;
    }
  }
  return fields;
}

std::optional<double> number_of(const std::string& field, const std::string& where)
{
  if (field.empty())
  {
    return std::nullopt;
  }
  double value = 0;
  const char* end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end)
  {
    throw InputError(fmt::format("{}: \"{}\" is not a number", where, field));
  }
  return value;
}

}

std::vector<std::optional<double>> RunTable::column(const std::string& name) const
{
  const auto found = std::find(columns.begin(), columns.end(), name);
  std::vector<std::optional<double>> values(rows.size());
  if (found != columns.end())
  {
    const auto index = static_cast<std::size_t>(found - columns.begin());
    std::transform(
      rows.begin(), rows.end(), values.begin(), [index](const Row& row) { return row[index]; });
  }
  return values;
}

RunTable run_table(std::vector<Row> rows)
{
  const auto& names = Diagnostics::names();
  return { { names.begin(), names.end() }, std::move(rows) };
}

RunTable read_run_table(const std::filesystem::path& file)
{
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line))
  {
    throw IoError(file.string() + ": can't be read");
  }
  RunTable table;
  table.columns = split(line);
  for (int number = 2; std::getline(in, line); ++number)
  {
    const std::string where = fmt::format("{}:{}", file.string(), number);
    Row row;
    for (const auto& field : split(line))
    {
      row.push_back(number_of(field, where));
    }
    if (row.size() != table.columns.size())
    {
      throw InputError(
        fmt::format("{}: has {} values for {} columns", where, row.size(), table.columns.size()));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}
