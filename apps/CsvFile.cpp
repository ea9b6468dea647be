#include "apps/CsvFile.h"

#include "solver/Joined.h"
#include "solver/files/FileBytes.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace vesicle
{
namespace
{

std::string lines_of(const Row& row, std::size_t columns)
{
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    text += row[i] ? fmt::format("{}", *row[i]) : "";
    text += (i + 1) % columns == 0 ? '\n' : ',';
  }
  return text;
}

OpenFile written(const std::filesystem::path& file, const std::vector<std::string>& columns,
  const std::vector<Row>& rows)
{
  std::string text = joined(columns, ",") + '\n';
  for (const Row& row : rows)
  {
    text += lines_of(row, columns.size());
  }
  replace_file(file, text);
  return OpenFile(file);
}

}

CsvFile::CsvFile(
  const std::filesystem::path& file, std::vector<std::string> columns, const std::vector<Row>& rows)
  : columns_(std::move(columns)), file_(written(file, columns_, rows))
{
}

void CsvFile::append(const Row& row)
{
  file_.append(lines_of(row, columns_.size()));
}

void CsvFile::close()
{
  file_.sync();
}

}
