#pragma once
// The diagnostics of a run as comma-separated values.

#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

namespace vesicle
{

/// One row of the table; a missing value leaves its field empty.
using Row = std::vector<std::optional<double>>;

/// Columns are those of Diagnostics::names(). Numbers are the shortest that read back to the same
/// double, so that a table written again from them is the same to the byte.
class CsvFile
{
public:
  /// Replaces the file by one with these rows and goes on behind them. Throws IoError.
  CsvFile(std::filesystem::path file, const std::vector<Row>& rows);

  /// The row is in the file, whatever comes next. Throws IoError.
  void append(const Row& row);

private:
  std::filesystem::path file_;
  std::ofstream out_;
};

}
