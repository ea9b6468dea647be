#pragma once
// A surface's basis as polynomials on panels, made once a mesh: what quadratures are made of for
// every single target.

#include "solver/surface/Basis.h"

#include <Eigen/Core>

#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace vesicle
{

/// Panels are the elements, in their order; those at extraordinary vertices are halved towards them,
/// as Basis::rule does. On each N_k = Σ_t C_tk m_t with the monomials m_t of PanelPolynomials.h: of
/// degree 1 on flat triangles, where that is exact, of degree 4 on smooth surfaces, where it is on
/// regular elements.
class PanelBasis
{
public:
  explicit PanelBasis(const Basis& basis);

  int degree() const { return degree_; }
  int terms() const { return terms_; }
  int size() const { return static_cast<int>(element_.size()); }
  int elements() const { return static_cast<int>(first_.size()) - 1; }
  /// The panels first(element) to first(element + 1) are an element's.
  int first(int element) const { return first_[element]; }
  /// The nodes that an element feels.
  std::span<const int> nodes(int element) const
  {
    return std::span(node_).subspan(start_[element], start_[element + 1] - start_[element]);
  }
  /// C of a panel: terms by nodes of its element.
  Eigen::Map<const Eigen::MatrixXd> coefficients(int panel) const
  {
    const int element = element_[panel];
    return { coefficients_.data() + place_[panel], terms_, start_[element + 1] - start_[element] };
  }
  int element(int panel) const { return element_[panel]; }
  /// N_k of its element's nodes at a panel's point.
  Eigen::VectorXd values(int panel, double u, double v) const;

private:
  int degree_, terms_;
  std::vector<int> first_{ 0 }, start_{ 0 }, node_; ///< of elements
  std::vector<int> element_;                        ///< of panels
  std::vector<std::size_t> place_;                  ///< of panels, in the coefficients
  std::vector<double> coefficients_;
};

/// Made when it is asked for: one surface alone needs none. May be used by several threads.
class LazyPanelBasis
{
public:
  /// The basis must live when it is asked.
  explicit LazyPanelBasis(const Basis& basis) : basis_(&basis) {}
  const PanelBasis& get() const
  {
    std::call_once(once_, [this] { panels_ = std::make_unique<const PanelBasis>(*basis_); });
    return *panels_;
  }

private:
  const Basis* basis_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const PanelBasis> panels_;
};

}
