#pragma once
// However layers are applied, a stage has the same solution.

#include "solver/dynamics/StageSolver.h"
#include "solver/dynamics/State.h"
#include "solver/dynamics/SystemShape.h"

#include <gtest/gtest.h>

namespace vesicle::test
{

inline void expect_methods_agree(const System& system, const SystemShape& shape)
{
  const auto velocity = [&](const LayerSettings& layer)
  {
    State state;
    return make_stage_solver(system, layer)->solve(shape, { 0.03, 0.01, {}, 1e-9 }, state).velocity;
  };
  const Eigen::VectorXd dense = velocity({ LayerMethod::dense, LayerPrecision::full });
  for (const LayerMethod method : { LayerMethod::direct, LayerMethod::tree })
    EXPECT_LT(
      (velocity({ method, LayerPrecision::mixed, 1e-8 }) - dense).norm(), 1e-7 * dense.norm());
}

}
