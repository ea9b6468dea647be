#pragma once
// What is reported of each accepted step: one row of the CSV and of the HDF5 series, in the units
// of the scene.

#include "solver/mesh/shapes/SphericalHarmonics.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// Where the dissipation is: in the fluid outside, of the flow less the imposed one, in the fluid inside,
/// and in the membrane.
struct PowerSplit
{
  double outside = 0, inside = 0, membrane = 0;
};

/// Values are in the order of the names; empty where undefined (degenerate axes, say).
struct Diagnostics
{
  static constexpr int harmonic_degree = 8;

  double step = 0, time = 0, dt = 0;
  double area = 0, volume = 0;
  double area_drift = 0, volume_drift = 0; ///< relative to the target, after the projection
  double area_correction = 0,
         volume_correction = 0; ///< removed by projections so far, relative, summed absolutely
  double divergence = 0;        ///< max |∇_s·u| r0/U0
  double power_in = 0, dissipation = 0;
  double reduced_volume = 0;
  double bending_energy = 0, energy_over_8pi = 0; ///< the latter E/8πEB
  double tension_min = 0, tension_max = 0;
  std::array<double, 3> centroid{};      ///< of the enclosed volume
  std::array<double, 3> velocity{};      ///< of that centroid
  std::optional<double> inclination_deg; ///< long axis on x–z, to +x, in (−90, 90]
  std::optional<double> tilt_deg;        ///< long axis to z, 0 to 90
  std::array<double, 3> semi_axes{};     ///< descending, ellipsoid of equal volume inertia
  double taylor_deformation = 0;         ///< (a1 − a3)/(a1 + a3)
  double tank_treading_frequency = 0;    ///< angular
  double min_angle_deg = 0, edge_ratio = 0;
  double iterations = 0, rejected = 0;
  std::array<double, 6> stresslet{}; ///< xx, xy, xz, yy, yz, zz; see Observables.h
  /// Of the shape about its centroid, in r0, by harmonic_index; none where it isn't star-shaped.
  std::optional<std::array<double, harmonic_count(harmonic_degree)>> harmonics;
  double triangles = 0;
  double remeshings = 0;       ///< so far
  double remeshing_energy = 0; ///< what they have changed the membrane's energy by, in all
  /// Distance to the nearest other vesicle; none where there is no other within r0. Not among the names and
  /// values below, which a vesicle alone has.
  std::optional<double> gap;
  /// Distance to the wall and the centroid's speed away from it; in scenes with a wall alone, and not
  /// among the names and values either.
  std::optional<double> wall_gap, lift_speed;
  /// Only of systems where a membrane has a viscosity or fluids have unlike ones (System::splits_power);
  /// not among the names and values below.
  std::optional<PowerSplit> split;

  static const std::vector<std::string>& names(); ///< the CSV's header
  std::vector<std::optional<double>> values() const;
};

}
