#pragma once
// Stages on flat triangles: dense columns and a factorisation of the whole system, kept as long as
// it helps.

#include "solver/dynamics/Preconditioner.h"
#include "solver/dynamics/StageSolver.h"

namespace vesicle
{

class CollocatedStages final : public StageSolver
{
public:
  explicit CollocatedStages(const System& system) : system_(system) {}
  StageSolution solve(const SystemShape& shape, const Stage& stage, State& state) override;

private:
  void factorize(const StageSystem& stage, const SystemShape& shape, const Stage& of, State& state);
  void restore(const Stage& stage, const State& state);

  const System& system_;
  DensePreconditioner preconditioner_;
  PreconditionerState made_for_;
};

}
