#pragma once
// The diagnostics of a run as comma-separated values.

#include "solver/files/OpenFile.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// One row of the table; a missing value leaves its field empty.
using Row = std::vector<std::optional<double>>;

/// Numbers are the shortest that read back to the same
/// double, so that a table written again from them is the same to the byte. All functions throw
/// IoError.
class CsvFile
{
public:
  /// Replaces the file by one with these rows and goes on behind them. A row longer than there are
  /// columns is several lines, one after the other: those of a step's vesicles.
  CsvFile(const std::filesystem::path& file, std::vector<std::string> columns,
    const std::vector<Row>& rows);

  /// The row is in the file as a whole, or not at all.
  void append(const Row& row);
  /// Returns when all rows are on the disk.
  void close();

private:
  std::vector<std::string> columns_;
  OpenFile file_;
};

}
