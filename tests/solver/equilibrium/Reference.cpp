#include "tests/solver/equilibrium/Reference.h"

#include "solver/files/FileBytes.h"
#include "solver/state/Table.h"

#include <cmath>
#include <stdexcept>

namespace vesicle::test
{

std::vector<ReferenceEquilibrium> reference_equilibria()
{
  const Table table =
    parse_table(read_file(std::string(VESICLE_SOURCE_DIR) + "/data/reference/equilibria.csv"));
  const auto v = table.column("reduced_volume"), energy = table.column("energy_over_8pi_kappa"),
             tension = table.column("tension"), pressure = table.column("pressure_jump");
  std::vector<ReferenceEquilibrium> rows;
  for (std::size_t i = 0; i < v.size(); ++i)
    rows.push_back({ table.rows[i][0], v[i], energy[i], tension[i], pressure[i] });
  return rows;
}

ReferenceEquilibrium reference_equilibrium(const std::string& branch, double reduced_volume)
{
  for (const ReferenceEquilibrium& row : reference_equilibria())
    if (row.branch == branch && std::abs(row.reduced_volume - reduced_volume) < 1e-9)
      return row;
  throw std::logic_error("there is no such row");
}

}
