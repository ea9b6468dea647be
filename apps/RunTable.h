#pragma once
// A run's diagnostics, to be looked up by column.

#include "apps/CsvFile.h"

#include "solver/scene/Scene.h"
#include "solver/state/RunRows.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle
{

struct RunTable
{
  std::vector<std::string> columns;
  std::vector<Row> rows; ///< as many values as columns, missing ones empty

  /// The column's values; all missing where there is no such column.
  std::vector<std::optional<double>> column(const std::string& name) const;
  /// The rows of each vesicle, by their numbers; a table without the column `vesicle` is of one.
  std::vector<RunTable> by_vesicle() const;
};

/// What a scene's rows have.
RowKind rows_of(const Scene& scene);
/// Of the rows of steps (run_row).
RunTable run_table(std::vector<std::string> columns, const std::vector<Row>& steps);

/// Reads a table that CsvFile wrote. Throws IoError when it can't be read, InputError naming the
/// line that is none of a table of numbers.
RunTable read_run_table(const std::filesystem::path& file);

}
