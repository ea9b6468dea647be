#include "apps/CsvFile.h"

#include "solver/Joined.h"
#include "solver/dynamics/Diagnostics.h"
#include "solver/files/FileBytes.h"

#include <fmt/format.h>

#include <string>

namespace vesicle
{
namespace
{

std::string header()
{
  return joined(Diagnostics::names(), ",") + '\n';
}

std::string line_of(const Row& row)
{
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    line += i > 0 ? "," : "";
    line += row[i] ? fmt::format("{}", *row[i]) : "";
  }
  return line + '\n';
}

OpenFile written(const std::filesystem::path& file, const std::vector<Row>& rows)
{
  std::string text = header();
  for (const Row& row : rows)
  {
    text += line_of(row);
  }
  replace_file(file, text);
  return OpenFile(file);
}

}

CsvFile::CsvFile(const std::filesystem::path& file, const std::vector<Row>& rows)
  : file_(written(file, rows))
{
}

void CsvFile::append(const Row& row)
{
  file_.append(line_of(row));
}

void CsvFile::close()
{
  file_.sync();
}

}
