#pragma once
// The loops of StokesletKernel.h, of one instruction set.

#include "solver/stokes/kernels/StokesletKernel.h"

namespace vesicle
{

struct StokesletLoops
{
  void (*add_stokeslets)(const StokesletSources& sources, int begin, int end, const double* targets,
    const double* mask, const int* place, double* sum);
  void (*add_stresslets)(const StressletSources& sources, int begin, int end, const double* targets,
    const double* mask, const int* place, double* sum);
  void (*multiply_stokeslets)(
    const double* sum, int nodes, const double* vectors, double* velocities);
  void (*add_stokeslet_moments)(
    const PanelPoints& points, const PanelShape& panel, const double* target, double* sum);
  void (*add_stresslet_moments)(
    const PanelPoints& points, const PanelShape& panel, const double* target, double* sum);
  void (*add_stokeslet_image_moments)(
    const PanelPoints& points, const PanelShape& panel, const double* target, double* sum);
  void (*add_stresslet_image_moments)(
    const PanelPoints& points, const PanelShape& panel, const double* target, double* sum);
  void (*add_velocities)(const ForceSources& sources, int begin, int end, const double* targets,
    const double* mask, double* sum);
  void (*add_forces_double)(
    const PointForces<double>& forces, const double* targets, double* velocities);
  void (*add_forces_float)(
    const PointForces<float>& forces, const float* targets, float* velocities);
  void (*add_stresslets_double)(
    const PointStresslets<double>& stresslets, const double* targets, double* velocities);
  void (*add_stresslets_float)(
    const PointStresslets<float>& stresslets, const float* targets, float* velocities);
  void (*add_force_images_double)(
    const PointForceImages<double>& forces, const double* targets, double* velocities);
  void (*add_force_images_float)(
    const PointForceImages<float>& forces, const float* targets, float* velocities);
  void (*add_stresslet_images_double)(
    const PointStressletImages<double>& stresslets, const double* targets, double* velocities);
  void (*add_stresslet_images_float)(
    const PointStressletImages<float>& stresslets, const float* targets, float* velocities);
  double (*dot)(const double* a, const double* b, long n);
};

const StokesletLoops& portable_loops();
#ifdef VESICLE_X86_LOOPS
const StokesletLoops& avx2_loops();   ///< AVX2 and FMA: x86-64-v3
const StokesletLoops& avx512_loops(); ///< x86-64-v4
#endif

}
