#include "solver/dynamics/TangentialMotion.h"

#include "solver/Errors.h"
#include "solver/linear/Symmetric.h"
#include "solver/surface/NodeFrames.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vesicle
{

// Two orthonormal tangents a vertex.
using Tangents = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;

namespace
{

Eigen::VectorXd spread(const Tangents& T, const Eigen::VectorXd& d)
{
  Eigen::VectorXd t(3 * T.rows());
  for (Eigen::Index i = 0; i < T.rows(); ++i)
    t.segment<3>(3 * i) =
      (d[2 * i] * T.row(i).head<3>() + d[2 * i + 1] * T.row(i).tail<3>()).transpose();
  return t;
}

Eigen::VectorXd gathered(const Tangents& T, const Eigen::VectorXd& t)
{
  Eigen::VectorXd d(2 * T.rows());
  for (Eigen::Index i = 0; i < T.rows(); ++i)
  {
    d[2 * i] = T.row(i).head<3>().dot(t.segment<3>(3 * i));
    d[2 * i + 1] = T.row(i).tail<3>().dot(t.segment<3>(3 * i));
  }
  return d;
}

// TᵀPT, its blocks of 2 by 2 in the places of P's entries.
SparseMatrix between_tangents(const SparseMatrix& P, const Tangents& T)
{
  SparseMatrix X(2 * P.rows(), 2 * P.cols());
  X.resizeNonZeros(4 * P.nonZeros());
  int next = 0;
  for (int i = 0; i < P.rows(); ++i)
    for (int a = 0; a < 2; ++a)
    {
      X.outerIndexPtr()[2 * i + a] = next;
      for (SparseMatrix::InnerIterator it(P, i); it; ++it)
        for (int b = 0; b < 2; ++b, ++next)
        {
          X.innerIndexPtr()[next] = 2 * static_cast<int>(it.col()) + b;
          X.valuePtr()[next] =
            it.value() * T.row(i).segment<3>(3 * a).dot(T.row(it.col()).segment<3>(3 * b));
        }
    }
  X.outerIndexPtr()[2 * P.rows()] = next;
  return X;
}

// form += XᵀWX, W of the nodes' weights, block by block. Neighbours of a node are on one element with
// it, so that the form of a stiffness has places for them.
void add_weighted_square(const SparseMatrix& X, const Eigen::VectorXd& weight, SparseMatrix& form)
{
  using Block = Eigen::Matrix2d;
  for (int k = 0; k < weight.size(); ++k)
  {
    const int begin = X.outerIndexPtr()[2 * k], end = X.outerIndexPtr()[2 * k + 1],
              row_size = end - begin;
    const auto block = [&](int p) // of rows 2k and 2k + 1
    {
      const double *first = X.valuePtr() + p, *second = first + row_size;
      return Block{ { first[0], first[1] }, { second[0], second[1] } };
    };
    for (int p = begin; p < end; p += 2)
    {
      const int row = X.innerIndexPtr()[p];
      const int *from = form.innerIndexPtr() + form.outerIndexPtr()[row],
                *to = form.innerIndexPtr() + form.outerIndexPtr()[row + 1];
      const Block left = weight[k] * block(p).transpose();
      for (int q = begin; q < end; q += 2)
      {
        const Block product = left * block(q);
        double* at = form.valuePtr() +
          (std::lower_bound(from, to, X.innerIndexPtr()[q]) - form.innerIndexPtr());
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b)
            at[a * (to - from) + b] += product(a, b);
      }
    }
  }
}

}

// The operator of the quadratic form in the coordinates d, t = T d, and its preconditioner:
// the same with TᵀPT between vertices and control points, which is sparse, and without what changes area
// and volume.
class TangentialForm
{
public:
  TangentialForm(const VesicleLoads& loads, double tau, double beta)
    : loads_(loads), T_(frames_along(loads.surface().normals).rightCols<6>()), tau_(tau),
      weight_(loads.surface().vertex_area / beta)
  {
    if (!stiff())
      return;
    X_ = between_tangents(loads.surface().collocation().matrix(), T_);
    SparseMatrix form = loads.stiffness_along(T_);
    form.coeffs() *= mesh_implicitness * tau;
    add_weighted_square(X_, weight_, form);
    factors_.compute(by_columns(form), loads.surface().space->plans());
    if (!factors_.regular())
      throw NumericalError("the problem of the tangential motion is singular");
  }

  const Tangents& tangents() const { return T_; }
  /// Of a functional of the control points' velocities.
  Eigen::VectorXd dual(const Eigen::VectorXd& functional) const
  {
    return gathered(T_, loads_.surface().collocation().from_control(functional));
  }
  Eigen::VectorXd weighted(const Eigen::VectorXd& d) const
  {
    Eigen::VectorXd result(d.size());
    for (Eigen::Index i = 0; i < weight_.size(); ++i)
      result.segment<2>(2 * i) = weight_[i] * d.segment<2>(2 * i);
    return result;
  }
  /// τ TᵀP⁻ᵀK P⁻¹w of velocities w at the vertices.
  Eigen::VectorXd stiffness(const Eigen::VectorXd& w) const
  {
    if (!stiff())
      return Eigen::VectorXd::Zero(2 * T_.rows());
    return tau_ * dual(loads_.stiff_force(loads_.surface().to_control(w)));
  }
  /// From now on solve() keeps to d with a·d = v·d = 0.
  void constrain(const Eigen::VectorXd& a, const Eigen::VectorXd& v)
  {
    const Eigen::VectorXd a_pulled = precondition(a), v_pulled = precondition(v);
    rows_.resize(2, a.size());
    rows_ << a.transpose(), v.transpose();
    directions_.resize(a.size(), 2);
    directions_ << a_pulled, v_pulled;
    amounts_.compute(rows_ * directions_);
  }
  /// By conjugate gradients, projected (Gould, Hribar & Nocedal, SIAM J. Sci. Comput. 23 (2001) 1376).
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const
  {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size()), r = free_part(b), z = precondition(r),
                    p = z;
    double rz = r.dot(z);
    const double first = rz;
    for (int k = 0; k < 100 && rz > 1e-8 * first; ++k)
    {
      const Eigen::VectorXd Ap = apply(p);
      const double alpha = rz / p.dot(Ap);
      x += alpha * p;
      r = free_part(r - alpha * Ap);
      z = precondition(r);
      const double next = r.dot(z);
      p = z + next / rz * p;
      rz = next;
    }
    return x;
  }

private:
  bool stiff() const { return loads_.stiff() && tau_ > 0; }
  Eigen::VectorXd apply(const Eigen::VectorXd& d) const
  {
    return weighted(d) + mesh_implicitness * stiffness(spread(T_, d));
  }
  // Less what the constraints bear, which solutions don't feel, but their rounding.
  Eigen::VectorXd free_part(const Eigen::VectorXd& r) const
  {
    return r - rows_.transpose() * amounts_.solve(directions_.transpose() * r);
  }
  Eigen::VectorXd precondition(const Eigen::VectorXd& r) const
  {
    Eigen::VectorXd z(r.size());
    if (stiff())
      z = X_ * Eigen::VectorXd(factors_.solve(X_.transpose() * r));
    else
      for (Eigen::Index i = 0; i < weight_.size(); ++i)
        z.segment<2>(2 * i) = r.segment<2>(2 * i) / weight_[i];
    if (rows_.size() > 0)
      z -= directions_ * amounts_.solve(rows_ * z);
    return z;
  }

  const VesicleLoads& loads_;
  Tangents T_;
  double tau_;
  Eigen::VectorXd weight_; ///< m_i/β
  SparseMatrix X_;
  SupernodalCholesky<float> factors_; ///< of the preconditioner
  // Of constraints: their gradients, what takes their changes back and how much of it they want.
  Eigen::Matrix<double, 2, Eigen::Dynamic> rows_;
  Eigen::Matrix<double, Eigen::Dynamic, 2> directions_;
  Eigen::FullPivLU<Eigen::Matrix2d> amounts_;
};

TangentialMotion::TangentialMotion(const VesicleLoads& loads, double tau, double beta)
  : form_(std::make_unique<TangentialForm>(loads, tau, beta)),
    gradient_(form_->dual(loads.gradient()))
{
  form_->constrain(form_->dual(loads.area_gradient()), form_->dual(loads.volume_gradient()));
}

TangentialMotion::TangentialMotion(TangentialMotion&&) noexcept = default;
TangentialMotion::~TangentialMotion() = default;

Eigen::VectorXd TangentialMotion::velocities(
  const Eigen::VectorXd& wanted, const Eigen::VectorXd& otherwise, double released) const
{
  constexpr double largest_share = 0.5;
  Eigen::VectorXd d = form_->solve(
    form_->weighted(gathered(form_->tangents(), wanted)) - form_->stiffness(otherwise) - gradient_);
  if (const double excess = gradient_.dot(d) - largest_share * std::max(0., released); excess > 0)
  {
    const Eigen::VectorXd downhill = form_->solve(gradient_);
    if (const double rate = gradient_.dot(downhill); rate > 0)
      d -= excess / rate * downhill;
  }
  return spread(form_->tangents(), d);
}

}
