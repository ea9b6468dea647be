#include "solver/stokes/kernels/StokesletKernel.h"

#include "solver/stokes/kernels/StokesletLoops.h"

namespace vesicle
{

namespace
{

const StokesletLoops& widest_loops()
{
#ifdef VESICLE_X86_LOOPS
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
    __builtin_cpu_supports("avx512vl"))
    return avx512_loops();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
    __builtin_cpu_supports("bmi2"))
    return avx2_loops();
#endif
  return portable_loops();
}

const StokesletLoops& loops()
{
  static const StokesletLoops& chosen = widest_loops();
  return chosen;
}

}

void add_stokeslets(const StokesletSources& sources, int begin, int end, const double* targets,
  const double* mask, const int* place, double* sum)
{
  loops().add_stokeslets(sources, begin, end, targets, mask, place, sum);
}

void add_stresslets(const StressletSources& sources, int begin, int end, const double* targets,
  const double* mask, const int* place, double* sum)
{
  loops().add_stresslets(sources, begin, end, targets, mask, place, sum);
}

void multiply_stokeslets(const double* sum, int nodes, const double* vectors, double* velocities)
{
  loops().multiply_stokeslets(sum, nodes, vectors, velocities);
}

void add_moments(PointKind kind, const PanelPoints& points, const PanelShape& panel,
  const double* target, double* sum)
{
  loops().add_moments[static_cast<std::size_t>(kind)](points, panel, target, sum);
}

void add_velocities(const ForceSources& sources, int begin, int end, const double* targets,
  const double* mask, double* sum)
{
  loops().add_velocities(sources, begin, end, targets, mask, sum);
}

template<class Real, PointKind kind>
void add_points(
  const PointSources<Real, kind>& sources, const Coordinate<Real>* targets, double* velocities)
{
  loops().add_points<Real, kind>()(sources, targets, velocities);
}

template void add_points(const PointSources<double, PointKind::force>&, const double*, double*);
template void add_points(
  const PointSources<float, PointKind::force>&, const std::int32_t*, double*);
template void add_points(const PointSources<double, PointKind::stresslet>&, const double*, double*);
template void add_points(
  const PointSources<float, PointKind::stresslet>&, const std::int32_t*, double*);
template void add_points(
  const PointSources<double, PointKind::force_image>&, const double*, double*);
template void add_points(
  const PointSources<float, PointKind::force_image>&, const std::int32_t*, double*);
template void add_points(
  const PointSources<double, PointKind::stresslet_image>&, const double*, double*);
template void add_points(
  const PointSources<float, PointKind::stresslet_image>&, const std::int32_t*, double*);

double dot(const double* a, const double* b, long n)
{
  return loops().dot(a, b, n);
}

}
