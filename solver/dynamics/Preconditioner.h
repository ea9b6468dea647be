#pragma once
// What makes the linear problem of a stage converge in a few iterations.

#include "solver/linear/DenseFactorization.h"

#include <Eigen/Core>

#include <memory>

namespace vesicle
{

class StageSystem;

class Preconditioner
{
public:
  virtual ~Preconditioner() = default;
  /// For this system; good for nearby ones, too. Throws NumericalError if it is singular.
  virtual void build(const StageSystem& system) = 0;
  /// The unknowns of the system it was built for; 0 before that.
  virtual Eigen::Index size() const = 0;
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& residual) const = 0;
  /// Rows times this are of one size.
  virtual Eigen::VectorXd row_scale() const = 0;
};

/// LU of the whole system in single precision.
class DensePreconditioner final : public Preconditioner
{
public:
  void build(const StageSystem& system) override;
  Eigen::Index size() const override { return factorization_.size(); }
  Eigen::VectorXd solve(const Eigen::VectorXd& residual) const override
  {
    return factorization_.solve(residual);
  }
  Eigen::VectorXd row_scale() const override { return factorization_.row_scale(); }

private:
  DenseFactorization factorization_;
};

}
