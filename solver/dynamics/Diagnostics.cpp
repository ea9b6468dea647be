#include "solver/dynamics/Diagnostics.h"

namespace vesicle
{

const std::vector<std::string_view>& Diagnostics::names()
{
  static const std::vector<std::string_view> names{ "step", "time", "dt", "area", "volume",
    "area_drift", "volume_drift", "area_correction", "volume_correction", "divergence", "power_in",
    "dissipation", "reduced_volume", "bending_energy", "energy_over_8pi", "tension_min",
    "tension_max", "centroid_x", "centroid_y", "centroid_z", "velocity_x", "velocity_y",
    "velocity_z", "inclination_deg", "tilt_deg", "semi_axis_1", "semi_axis_2", "semi_axis_3",
    "taylor_deformation", "tank_treading_frequency", "min_angle_deg", "edge_ratio", "iterations",
    "rejected" };
  return names;
}

std::vector<std::optional<double>> Diagnostics::values() const
{
  return { step, time, dt, area, volume, area_drift, volume_drift, area_correction,
    volume_correction, divergence, power_in, dissipation, reduced_volume, bending_energy,
    energy_over_8pi, tension_min, tension_max, centroid[0], centroid[1], centroid[2], velocity[0],
    velocity[1], velocity[2], inclination_deg, tilt_deg, semi_axes[0], semi_axes[1], semi_axes[2],
    taylor_deformation, tank_treading_frequency, min_angle_deg, edge_ratio, iterations, rejected };
}

}
