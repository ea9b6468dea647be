// extremes_map TRIANGLES OUT [FINE]: what becomes of every cell, a row each of OUT.csv, and OUT.png of it. With
// FINE each cell that runs is run again on so many triangles, and the two are compared.

#include "Extremes.h"
#include "MapPicture.h"

#include "solver/files/FileBytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace
{

using namespace vesicle::test;

std::string quoted(std::string text)
{
  for (char& c : text)
    c = c == '"' ? '\'' : c == '\n' ? ' ' : c;
  return '"' + text + '"';
}

std::string cell_of(const std::optional<double>& number)
{
  return number ? fmt::format("{:.3g}", *number) : "";
}

std::string note_of(const CellResult& r, const std::optional<double>& off)
{
  if (r.end != CellResult::End::runs)
    return r.time > 0 ? fmt::format("t = {:.2g}", r.time) : "";
  return off ? fmt::format("{:.1g} of {:.1g}", *off, r.estimate)
             : fmt::format("est. {:.1g}", r.estimate);
}

}

int main(int argc, char** argv)
{
  if (argc != 3 && argc != 4)
  {
    std::cerr << "extremes_map TRIANGLES OUT [FINE]\n";
    return 2;
  }
  const int triangles = std::atoi(argv[1]), fine = argc == 4 ? std::atoi(argv[3]) : 0;
  const std::vector<Cell> cells = extremes(triangles);
  const std::vector<Cell> fine_cells = fine ? extremes(fine) : cells;
  std::string table =
    "axis,value,end,steps,time,energy_over_8pi,own_estimate,imbalance,difference,message\n";
  std::vector<MapBox> boxes;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const CellResult r = run_cell(cells[i]);
    std::optional<double> off;
    if (fine && r.end == CellResult::End::runs)
      if (const CellResult better = run_cell(fine_cells[i]); better.end == CellResult::End::runs)
        off = difference(r, better);
    table += fmt::format("\"{}\",{},{},{},{},{},{:.3g},{},{},{}\n", cells[i].axis, cells[i].value,
      end_name(r.end), r.steps, r.time, r.energy, r.estimate, cell_of(r.imbalance), cell_of(off),
      quoted(r.message));
    boxes.push_back({ cells[i].axis, cells[i].value, note_of(r, off), end_name(r.end) });
    std::cout << fmt::format(
                   "{:<24}{:<22}{:<9}{:>4} steps  estimate {:<9.2g} imbalance {:<9} off {:<9} {}\n",
                   cells[i].axis, cells[i].value, end_name(r.end), r.steps, r.estimate,
                   cell_of(r.imbalance), cell_of(off), r.message.substr(0, 90))
              << std::flush;
    vesicle::replace_file(std::string(argv[2]) + ".csv", table);
  }
  write_map(std::string(argv[2]) + ".png",
    fine
      ? fmt::format("Extremes on {} triangles: difference to {} of what the run itself estimates",
          triangles, fine)
      : fmt::format(
          "Extremes on {} triangles, with each run's own estimate of its error", triangles),
    boxes);
}
