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

void add_stokeslet_moments(
  const PanelPoints& points, const PanelShape& panel, const double* target, double* sum)
{
  loops().add_stokeslet_moments(points, panel, target, sum);
}

void add_stresslet_moments(
  const PanelPoints& points, const PanelShape& panel, const double* target, double* sum)
{
  loops().add_stresslet_moments(points, panel, target, sum);
}

void add_stokeslet_image_moments(
  const PanelPoints& points, const PanelShape& panel, const double* target, double* sum)
{
  loops().add_stokeslet_image_moments(points, panel, target, sum);
}

void add_stresslet_image_moments(
  const PanelPoints& points, const PanelShape& panel, const double* target, double* sum)
{
  loops().add_stresslet_image_moments(points, panel, target, sum);
}

void add_velocities(const ForceSources& sources, int begin, int end, const double* targets,
  const double* mask, double* sum)
{
  loops().add_velocities(sources, begin, end, targets, mask, sum);
}

void add_points(const PointForces<double>& sources, const double* targets, double* velocities)
{
  loops().add_forces_double(sources, targets, velocities);
}

void add_points(const PointForces<float>& sources, const float* targets, float* velocities)
{
  loops().add_forces_float(sources, targets, velocities);
}

void add_points(const PointStresslets<double>& sources, const double* targets, double* velocities)
{
  loops().add_stresslets_double(sources, targets, velocities);
}

void add_points(const PointStresslets<float>& sources, const float* targets, float* velocities)
{
  loops().add_stresslets_float(sources, targets, velocities);
}

void add_points(const PointForceImages<double>& sources, const double* targets, double* velocities)
{
  loops().add_force_images_double(sources, targets, velocities);
}

void add_points(const PointForceImages<float>& sources, const float* targets, float* velocities)
{
  loops().add_force_images_float(sources, targets, velocities);
}

void add_points(
  const PointStressletImages<double>& sources, const double* targets, double* velocities)
{
  loops().add_stresslet_images_double(sources, targets, velocities);
}

void add_points(const PointStressletImages<float>& sources, const float* targets, float* velocities)
{
  loops().add_stresslet_images_float(sources, targets, velocities);
}

double dot(const double* a, const double* b, long n)
{
  return loops().dot(a, b, n);
}

}
