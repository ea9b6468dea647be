// extremes_map TRIANGLES FILE.csv: what becomes of every cell, a row each.

#include "Extremes.h"

#include "solver/files/FileBytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

int main(int argc, char** argv)
{
  using namespace vesicle::test;
  if (argc != 3)
  {
    std::cerr << "extremes_map TRIANGLES FILE.csv\n";
    return 2;
  }
  std::string table = "axis,value,end,steps,time,energy_over_8pi,own_estimate,message\n";
  for (const Cell& cell : extremes(std::atoi(argv[1])))
  {
    CellResult r = run_cell(cell);
    for (char& c : r.message)
      c = c == '"' ? '\'' : c == '\n' ? ' ' : c;
    table += fmt::format("\"{}\",{},{},{},{},{},{},\"{}\"\n", cell.axis, cell.value,
      end_name(r.end), r.steps, r.time, r.energy, r.estimate, r.message);
    std::cout << fmt::format("{:<24}{:<20}{:<9}{} steps  {}\n", cell.axis, cell.value,
                   end_name(r.end), r.steps, r.message.substr(0, 90))
              << std::flush;
  }
  vesicle::replace_file(argv[2], table);
}
