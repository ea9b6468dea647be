#include "apps/CsvFile.h"

#include "solver/Errors.h"
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
  return fmt::format("{}\n", fmt::join(Diagnostics::names(), ","));
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

}

CsvFile::CsvFile(std::filesystem::path file, const std::vector<Row>& rows) : file_(std::move(file))
{
  std::string text = header();
  for (const Row& row : rows)
  {
    text += line_of(row);
  }
  replace_file(file_, text);
  out_.open(file_, std::ios::binary | std::ios::app);
}

void CsvFile::append(const Row& row)
{
  out_ << line_of(row) << std::flush;
  if (!out_)
  {
    throw IoError(file_.string() + ": can't be written; check the folder and the space left");
  }
}

}
