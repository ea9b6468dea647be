#include "solver/surface/LoopBasis.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace vesicle
{

namespace
{

// A control point of a subdivided patch as a combination of the patch's own control points.
using Weights = Eigen::VectorXd;

// One quartic box spline in barycentric coordinates, Σ coefficient λ₀^i λ₁^j λ₂^k / 12.
struct Monomial
{
  double coefficient;
  int power[3];
};
using Polynomial = std::vector<Monomial>;

// Of a corner of the triangle; λ₀ belongs to that corner.
const Polynomial corner_spline{ { 6, { 4, 0, 0 } }, { 24, { 3, 1, 0 } }, { 24, { 3, 0, 1 } },
  { 24, { 2, 2, 0 } }, { 60, { 2, 1, 1 } }, { 24, { 2, 0, 2 } }, { 8, { 1, 3, 0 } },
  { 36, { 1, 2, 1 } }, { 36, { 1, 1, 2 } }, { 8, { 1, 0, 3 } }, { 1, { 0, 4, 0 } },
  { 6, { 0, 3, 1 } }, { 12, { 0, 2, 2 } }, { 6, { 0, 1, 3 } }, { 1, { 0, 0, 4 } } };
// Of the vertex across the edge between corners 0 and 1.
const Polynomial across_spline{ { 1, { 4, 0, 0 } }, { 6, { 3, 1, 0 } }, { 12, { 2, 2, 0 } },
  { 6, { 1, 3, 0 } }, { 1, { 0, 4, 0 } }, { 2, { 3, 0, 1 } }, { 6, { 2, 1, 1 } },
  { 6, { 1, 2, 1 } }, { 2, { 0, 3, 1 } } };
// Of the vertex that only corner 0 has as neighbour, on corner 1's side.
const Polynomial far_spline{ { 1, { 4, 0, 0 } }, { 2, { 3, 1, 0 } } };

// Value, first and second derivatives with respect to (u, v) = (λ₁, λ₂), λ₀ = 1 − u − v.
struct Jet
{
  double value = 0, du = 0, dv = 0, duu = 0, duv = 0, dvv = 0;
  void add(double w, const Jet& j)
  {
    value += w * j.value;
    du += w * j.du;
    dv += w * j.dv;
    duu += w * j.duu;
    duv += w * j.duv;
    dvv += w * j.dvv;
  }
};

double power(double x, int n)
{
  double result = 1;
  for (; n > 0; --n)
    result *= x;
  return result;
}

// The spline with its corner 0, 1, 2 at the triangle's corners order[0], order[1], order[2].
Jet evaluate(const Polynomial& polynomial, const std::array<int, 3>& order, const double lambda[3])
{
  double first[3] = {}, second[3][3] = {}, value = 0;
  for (const Monomial& m : polynomial)
  {
    const auto term = [&](int drop_a, int drop_b)
    {
      double factor = m.coefficient / 12;
      int p[3] = { m.power[0], m.power[1], m.power[2] };
      for (int d : { drop_a, drop_b })
        if (d >= 0)
          factor *= p[d]--;
      if (factor == 0)
        return 0.;
      for (int i = 0; i < 3; ++i)
        factor *= power(lambda[order[i]], p[i]);
      return factor;
    };
    value += term(-1, -1);
    for (int a = 0; a < 3; ++a)
    {
      first[order[a]] += term(a, -1);
      for (int b = 0; b < 3; ++b)
        second[order[a]][order[b]] += term(a, b);
    }
  }
  // ∂/∂u = ∂₁ − ∂₀, ∂/∂v = ∂₂ − ∂₀.
  return { value, first[1] - first[0], first[2] - first[0],
    second[1][1] - 2 * second[0][1] + second[0][0],
    second[1][2] - second[0][1] - second[0][2] + second[0][0],
    second[2][2] - 2 * second[0][2] + second[0][0] };
}

// The twelve functions of a regular patch at a point of it: of each corner c, with d and e the next
// ones, those of c, across c–d, far from c towards e and towards d.
using RegularJets = std::array<std::array<Jet, 4>, 3>;

RegularJets regular_jets(double u, double v)
{
  const double lambda[3] = { 1 - u - v, u, v };
  RegularJets jets;
  for (int c = 0; c < 3; ++c)
  {
    const int d = (c + 1) % 3, e = (c + 2) % 3;
    jets[c] = { evaluate(corner_spline, { c, d, e }, lambda),
      evaluate(across_spline, { c, d, e }, lambda), evaluate(far_spline, { c, e, d }, lambda),
      evaluate(far_spline, { c, d, e }, lambda) };
  }
  return jets;
}

Weights edge_point(const Weights& a, const Weights& b, const Weights& left, const Weights& right)
{
  return 3. / 8 * (a + b) + 1. / 8 * (left + right);
}

}

double loop_vertex_weight(int n)
{
  const double c = 3. / 8 + std::cos(2 * std::numbers::pi / n) / 4;
  return (5. / 8 - c * c) / n;
}

// A triangle with the one-rings of its corners: all that its limit surface depends on. The ring of
// corner c starts with corners c + 1 and c + 2 and goes on counter-clockwise.
struct LoopBasis::Patch
{
  std::array<Weights, 3> corner;
  std::array<std::vector<Weights>, 3> ring;
  std::vector<int> nodes; ///< control points that the weights count

  int valence(int c) const { return static_cast<int>(ring[c].size()); }
  bool regular() const { return valence(0) == 6 && valence(1) == 6 && valence(2) == 6; }

  Weights even(int c) const
  {
    const double beta = loop_vertex_weight(valence(c));
    Weights sum = Weights::Zero(corner[c].size());
    for (const Weights& r : ring[c])
      sum += r;
    return (1 - valence(c) * beta) * corner[c] + beta * sum;
  }
  // New point on the edge from corner c to the k-th vertex of its ring.
  Weights odd(int c, int k) const
  {
    const auto& r = ring[c];
    const int n = valence(c);
    return edge_point(corner[c], r[k % n], r[(k + n - 1) % n], r[(k + 1) % n]);
  }

  Patch corner_child(int c) const;
  Patch centre_child() const;
  // Ring of the new point on the edge c, c + 1, counter-clockwise from the new point on edge c, c
  // + 2.
  std::vector<Weights> ring_of_edge(int c) const;
  // Adds each control point's jet where the patch's functions are `regular` to `jets`.
  void add_regular(const RegularJets& regular, std::vector<Jet>& jets) const;
};

std::vector<Weights> LoopBasis::Patch::ring_of_edge(int c) const
{
  const int d = (c + 1) % 3;
  const int n = valence(c);
  // The edge's other triangle has the vertex before corner c + 1 in the ring of c, or the one after
  // corner c in the ring of c + 1.
  return { odd(c, 1), even(c), odd(c, n - 1), odd(d, 2), even(d), odd(d, 0) };
}

LoopBasis::Patch LoopBasis::Patch::corner_child(int c) const
{
  const int d = (c + 1) % 3, e = (c + 2) % 3;
  Patch child;
  child.nodes = nodes;
  child.corner[c] = even(c);
  child.corner[d] = odd(c, 0);
  child.corner[e] = odd(c, 1);
  for (int k = 0; k < valence(c); ++k)
    child.ring[c].push_back(odd(c, k));
  child.ring[d] = ring_of_edge(c);
  // Around the point on edge e, c: [on e–d, even e, …, even c, on c–d]; it starts with even c here.
  const std::vector<Weights> around = ring_of_edge(e);
  for (int k = 0; k < 6; ++k)
    child.ring[e].push_back(around[(k + 4) % 6]);
  return child;
}

LoopBasis::Patch LoopBasis::Patch::centre_child() const
{
  // Corner c lies on the edge opposite to the parent's corner c: the parent turned by half a turn.
  Patch child;
  child.nodes = nodes;
  child.corner = { odd(1, 0), odd(2, 0), odd(0, 0) };
  // Around the point on edge c, c + 1: [on c–c+2, even c, …, even c+1, on c+1–c+2]; it starts with
  // the last.
  for (int c = 0; c < 3; ++c)
  {
    const std::vector<Weights> around = ring_of_edge(c);
    for (int k = 0; k < 6; ++k)
      child.ring[(c + 2) % 3].push_back(around[(k + 5) % 6]);
  }
  return child;
}

void LoopBasis::Patch::add_regular(const RegularJets& regular, std::vector<Jet>& jets) const
{
  const auto add = [&](const Weights& weights, const Jet& jet)
  {
    for (int i = 0; i < weights.size(); ++i)
      if (weights[i] != 0)
        jets[i].add(weights[i], jet);
  };
  for (int c = 0; c < 3; ++c)
  {
    // Ring of corner c: [d, e, across c–e, far towards e, far towards d, across c–d].
    add(corner[c], regular[c][0]);
    add(ring[c][5], regular[c][1]);
    add(ring[c][3], regular[c][2]);
    add(ring[c][4], regular[c][3]);
  }
}

LoopBasis::LoopBasis(Triangles triangles, int nodes)
  : triangles_(std::move(triangles)), nodes_(nodes)
{
  // Around vertex i, triangle (i, j, k) says that k follows j.
  std::vector<std::map<int, int>> next(nodes);
  for (const auto& t : triangles_.rowwise())
    for (int c = 0; c < 3; ++c)
      next[t[c]][t[(c + 1) % 3]] = t[(c + 2) % 3];
  ring_.start.push_back(0);
  for (int i = 0; i < nodes; ++i)
  {
    if (next[i].size() < 3)
      throw InputError(fmt::format("point {} has {} neighbours: a Loop surface needs three or more "
                                   "around every point of a closed mesh",
        i, next[i].size()));
    int j = next[i].begin()->first;
    for (std::size_t k = 0; k < next[i].size(); ++k)
    {
      ring_.item.push_back(j);
      const auto after = next[i].find(j);
      if (after == next[i].end())
        throw InputError(
          fmt::format("the triangles around point {} do not close: a Loop surface needs a closed, "
                      "consistently oriented mesh",
            i));
      j = after->second;
    }
    ring_.start.push_back(static_cast<int>(ring_.item.size()));
  }
}

LoopBasis::Patch LoopBasis::patch(int element) const
{
  Patch result;
  std::array<std::vector<int>, 3> rings;
  std::map<int, int> local;
  const auto index = [&](int node)
  {
    const auto [it, inserted] = local.emplace(node, static_cast<int>(result.nodes.size()));
    if (inserted)
      result.nodes.push_back(node);
    return it->second;
  };
  for (int c = 0; c < 3; ++c)
  {
    const int i = triangles_(element, c), j = triangles_(element, (c + 1) % 3);
    index(i);
    const int* start = std::find(ring_.begin(i), ring_.end(i), j);
    for (int k = 0; k < ring_.size(i); ++k)
      rings[c].push_back(*(ring_.begin(i) + (start - ring_.begin(i) + k) % ring_.size(i)));
    for (int node : rings[c])
      index(node);
  }
  const auto unit = [&](int node) -> Weights
  { return Weights::Unit(static_cast<Eigen::Index>(result.nodes.size()), local.at(node)); };
  for (int c = 0; c < 3; ++c)
  {
    result.corner[c] = unit(triangles_(element, c));
    for (int node : rings[c])
      result.ring[c].push_back(unit(node));
  }
  return result;
}

BasisTable LoopBasis::tabulate(std::span<const ParametricPoint> points) const
{
  // Points are grouped by element, so that a patch and its subdivisions are made once.
  BasisTable table;
  table.nodes = nodes_;
  int element = -1;
  std::map<std::vector<int>, Patch> patches; // of the element, by the path of children taken
  std::map<std::pair<double, double>, RegularJets> known; // rules repeat their points
  for (const ParametricPoint& p : points)
  {
    if (p.element != element)
    {
      element = p.element;
      patches.clear();
      patches[{}] = patch(element);
    }
    std::vector<int> path;
    const Patch* leaf = &patches[{}];
    double u = p.u, v = p.v, scale = 1; // of derivatives: each level halves the parameters
    while (!leaf->regular())
    {
      if (path.size() > 50)
        throw InputError("a Loop surface can't be evaluated at an extraordinary vertex");
      int child = 3;
      if (1 - u - v >= 0.5)
        child = 0, u = 2 * u, v = 2 * v, scale *= 2;
      else if (u >= 0.5)
        child = 1, u = 2 * u - 1, v = 2 * v, scale *= 2;
      else if (v >= 0.5)
        child = 2, u = 2 * u, v = 2 * v - 1, scale *= 2;
      else
        u = 1 - 2 * u, v = 1 - 2 * v, scale *= -2;
      path.push_back(child);
      auto [it, inserted] = patches.try_emplace(path);
      if (inserted)
        it->second = child == 3 ? leaf->centre_child() : leaf->corner_child(child);
      leaf = &it->second;
    }
    std::vector<Jet> jets(leaf->nodes.size());
    auto [jet, unknown] = known.try_emplace({ u, v });
    if (unknown)
      jet->second = regular_jets(u, v);
    leaf->add_regular(jet->second, jets);
    table.element.push_back(p.element);
    table.weight.push_back(p.weight);
    for (std::size_t i = 0; i < jets.size(); ++i)
    {
      table.node.push_back(leaf->nodes[i]);
      table.value.push_back(jets[i].value);
      table.du.push_back(scale * jets[i].du);
      table.dv.push_back(scale * jets[i].dv);
      table.duu.push_back(scale * scale * jets[i].duu);
      table.duv.push_back(scale * scale * jets[i].duv);
      table.dvv.push_back(scale * scale * jets[i].dvv);
    }
    table.start.push_back(static_cast<int>(table.node.size()));
  }
  return table;
}

// χ, what a neighbour gives to a vertex's limit position.
Eigen::VectorXd LoopBasis::collocation_scale() const
{
  Eigen::VectorXd chi(nodes_);
  for (int i = 0; i < nodes_; ++i)
    chi[i] = 1 / (3 / (8 * loop_vertex_weight(ring_.size(i))) + ring_.size(i));
  return chi;
}

SparseMatrix LoopBasis::collocation() const
{
  // Limit position of a vertex: (1 − nχ) x + χ Σ neighbours.
  const Eigen::VectorXd scale = collocation_scale();
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < nodes_; ++i)
  {
    const int n = ring_.size(i);
    const double chi = scale[i];
    entries.emplace_back(i, i, 1 - n * chi);
    for (const int* j = ring_.begin(i); j != ring_.end(i); ++j)
      entries.emplace_back(i, *j, chi);
  }
  SparseMatrix P(nodes_, nodes_);
  P.setFromTriplets(entries.begin(), entries.end());
  return P;
}

double LoopBasis::radial_exponent(int vertex) const
{
  return -std::log2(3. / 8 + std::cos(2 * std::numbers::pi / ring_.size(vertex)) / 4);
}

Points LoopBasis::vertex_normals(const Points& control) const
{
  // Limit tangents: the ring weighted by cos and sin of its angle.
  Points normals(nodes_, 3);
  for (int i = 0; i < nodes_; ++i)
  {
    Eigen::RowVector3d a = Eigen::RowVector3d::Zero(), b = a;
    for (int k = 0; k < ring_.size(i); ++k)
    {
      const double angle = 2 * std::numbers::pi * k / ring_.size(i);
      a += std::cos(angle) * control.row(*(ring_.begin(i) + k));
      b += std::sin(angle) * control.row(*(ring_.begin(i) + k));
    }
    normals.row(i) = a.cross(b).normalized();
  }
  return normals;
}

std::array<bool, 3> LoopBasis::rough_corners(int element) const
{
  std::array<bool, 3> rough;
  for (int c = 0; c < 3; ++c)
    rough[c] = ring_.size(triangles_(element, c)) != 6;
  return rough;
}

}
