#include "solver/dynamics/Diagnostics.h"

#include <fmt/format.h>

#include <cstdlib>

namespace vesicle
{
namespace
{

// harmonic_l_m; no "-" in it: readers that make identifiers of column names would drop it.
std::string harmonic_name(int l, int m)
{
  return fmt::format("harmonic_{}_{}{}", l, m < 0 ? "minus" : "", std::abs(m));
}

std::vector<std::string> all_names()
{
  std::vector<std::string> names{ "step", "time", "dt", "area", "volume", "area_drift",
    "volume_drift", "area_correction", "volume_correction", "divergence", "power_in", "dissipation",
    "reduced_volume", "bending_energy", "energy_over_8pi", "tension_min", "tension_max",
    "centroid_x", "centroid_y", "centroid_z", "velocity_x", "velocity_y", "velocity_z",
    "inclination_deg", "tilt_deg", "semi_axis_1", "semi_axis_2", "semi_axis_3",
    "taylor_deformation", "tank_treading_frequency", "min_angle_deg", "edge_ratio", "iterations",
    "rejected", "stresslet_xx", "stresslet_xy", "stresslet_xz", "stresslet_yy", "stresslet_yz",
    "stresslet_zz" };
  for (int l = 0; l <= Diagnostics::harmonic_degree; ++l)
    for (int m = -l; m <= l; ++m)
      names.push_back(harmonic_name(l, m));
  names.insert(names.end(), { "triangles", "remeshings", "remeshing_energy" });
  return names;
}

}

const std::vector<std::string>& Diagnostics::names()
{
  static const std::vector<std::string> names = all_names();
  return names;
}

std::vector<std::optional<double>> Diagnostics::values() const
{
  std::vector<std::optional<double>> values{ step, time, dt, area, volume, area_drift, volume_drift,
    area_correction, volume_correction, divergence, power_in, dissipation, reduced_volume,
    bending_energy, energy_over_8pi, tension_min, tension_max, centroid[0], centroid[1],
    centroid[2], velocity[0], velocity[1], velocity[2], inclination_deg, tilt_deg, semi_axes[0],
    semi_axes[1], semi_axes[2], taylor_deformation, tank_treading_frequency, min_angle_deg,
    edge_ratio, iterations, rejected };
  values.insert(values.end(), stresslet.begin(), stresslet.end());
  for (int i = 0; i < harmonic_count(harmonic_degree); ++i)
    values.push_back(harmonics ? std::optional((*harmonics)[i]) : std::nullopt);
  values.insert(values.end(), { triangles, remeshings, remeshing_energy });
  return values;
}

}
