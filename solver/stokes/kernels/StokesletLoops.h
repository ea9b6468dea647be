#pragma once
// The loops of StokesletKernel.h, of one instruction set.

#include "solver/stokes/kernels/StokesletKernel.h"

#include <tuple>
#include <type_traits>

namespace vesicle
{

using AddMoments = void (*)(
  const PanelPoints& points, const PanelShape& panel, const double* target, double* sum);
template<class Real, PointKind kind>
using AddPoints = void (*)(
  const PointSources<Real, kind>& sources, const Coordinate<Real>* targets, double* velocities);
/// By PointKind.
template<class Real>
using PointLoops =
  std::tuple<AddPoints<Real, PointKind::force>, AddPoints<Real, PointKind::stresslet>,
    AddPoints<Real, PointKind::force_image>, AddPoints<Real, PointKind::stresslet_image>>;

struct StokesletLoops
{
  void (*add_stokeslets)(const StokesletSources& sources, int begin, int end, const double* targets,
    const double* mask, const int* place, double* sum);
  void (*add_stresslets)(const StressletSources& sources, int begin, int end, const double* targets,
    const double* mask, const int* place, double* sum);
  void (*multiply_stokeslets)(
    const double* sum, int nodes, const double* vectors, double* velocities);
  std::array<AddMoments, point_kinds> add_moments; ///< by PointKind
  void (*add_velocities)(const ForceSources& sources, int begin, int end, const double* targets,
    const double* mask, double* sum);
  PointLoops<double> points_in_double;
  PointLoops<float> points_in_single;
  double (*dot)(const double* a, const double* b, long n);

  template<class Real, PointKind kind>
  AddPoints<Real, kind> add_points() const
  {
    constexpr auto number = static_cast<std::size_t>(kind);
    if constexpr (std::is_same_v<Real, double>)
      return std::get<number>(points_in_double);
    else
      return std::get<number>(points_in_single);
  }
};

const StokesletLoops& portable_loops();
#ifdef VESICLE_X86_LOOPS
const StokesletLoops& avx2_loops();   ///< AVX2 and FMA: x86-64-v3
const StokesletLoops& avx512_loops(); ///< x86-64-v4
#endif

}
