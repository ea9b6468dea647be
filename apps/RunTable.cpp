#include "apps/RunTable.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/state/Table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace vesicle
{
namespace
{

/// Empty where the field is; `where` says where it is.
std::optional<double> value_of(const std::string& field, const std::string& where)
{
  const auto value = number_in(field);
  if (!value && !field.empty())
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

std::vector<RunTable> RunTable::by_vesicle() const
{
  const auto numbers = column("vesicle");
  std::map<double, RunTable> of;
  for (std::size_t i = 0; i < rows.size(); ++i)
    of.try_emplace(numbers[i].value_or(0), RunTable{ columns, {} })
      .first->second.rows.push_back(rows[i]);
  std::vector<RunTable> tables;
  for (auto& [number, table] : of)
    tables.push_back(std::move(table));
  return tables.empty() ? std::vector{ *this } : tables;
}

RowKind rows_of(const Scene& scene)
{
  return { scene.vesicles(), scene.wall.has_value(), scene.splits_power() };
}

RunTable run_table(std::vector<std::string> columns, const std::vector<Row>& steps)
{
  RunTable table{ std::move(columns), {} };
  const auto length = static_cast<std::ptrdiff_t>(table.columns.size());
  for (const Row& step : steps)
    for (auto first = step.begin(); first != step.end(); first += length)
      table.rows.emplace_back(first, first + length);
  return table;
}

RunTable read_run_table(const std::filesystem::path& file)
{
  const Table text = parse_table(read_file(file), file.string());
  if (text.names.empty())
  {
    throw IoError(file.string() + ": can't be read");
  }
  RunTable table{ text.names, {} };
  for (std::size_t i = 0; i < text.rows.size(); ++i)
  {
    const std::string where = fmt::format("{}:{}", file.string(), text.lines[i]);
    Row row;
    for (const auto& field : text.rows[i])
    {
      row.push_back(value_of(field, where));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}
