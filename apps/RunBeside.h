#pragma once
// What lies beside a series when `vesicle run` wrote it.

#include "apps/RunTable.h"

#include "solver/scene/Scene.h"

#include <filesystem>
#include <optional>

namespace vesicle
{

struct RunBeside
{
  std::optional<Scene> scene;    ///< of <folder>/summary.json
  std::optional<RunTable> table; ///< <folder>/<name>.csv
};

/// Empty where the files are missing; a table that is there but can't be understood throws (see
/// read_run_table).
RunBeside run_beside(const std::filesystem::path& series);

}
