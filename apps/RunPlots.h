#pragma once
// Charts of a run's diagnostics against time.

#include "apps/RunTable.h"

#include "render/Chart.h"
#include "solver/scene/Scene.h"

#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// The chart of a subject (chart_names of the scene and others); empty where the table has nothing
/// to show of it. In SI its axes name their units. Throws InputError for an unknown subject.
std::optional<ChartSpec> run_chart(
  const std::string& subject, const RunTable& table, Units units = Units::any);

/// The columns of the table that it shows.
std::vector<std::string> chart_columns(const std::string& subject, const RunTable& table);

struct RunPlot
{
  std::string name; ///< of the subject, and of the file but for its ending
  ChartSpec chart;
};

/// Those that say something of this scene: energy where there is bending, velocity under gravity,
/// inclination in a flow, tension, axes, corrections, time step.
std::vector<RunPlot> run_plots(const Scene& scene, const RunTable& table);

}
