#include "solver/mesh/shapes/CappedTube.h"

#include "solver/mesh/PointHash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace vesicle
{

namespace
{

/// a + b ω, ω = e^{iπ/3}: a point of the hexagonal lattice.
struct Lattice
{
  int a = 0, b = 0;
  friend Lattice operator+(Lattice p, Lattice q) { return { p.a + q.a, p.b + q.b }; }
  friend Lattice operator-(Lattice p, Lattice q) { return { p.a - q.a, p.b - q.b }; }
  friend Lattice operator*(int n, Lattice p) { return { n * p.a, n * p.b }; }
  friend bool operator==(Lattice, Lattice) = default;
};

/// Turned by 60° counter-clockwise: ω² = ω − 1.
Lattice turned(Lattice p)
{
  return { -p.b, p.a + p.b };
}

/// The area of the triangle o, p, q in small triangles, positive counter-clockwise.
int area(Lattice o, Lattice p, Lattice q)
{
  return (p.a - o.a) * (q.b - o.b) - (p.b - o.b) * (q.a - o.a);
}

double dot(Lattice p, Lattice q)
{
  return p.a * q.a + p.b * q.b + 0.5 * (p.a * q.b + p.b * q.a);
}

/// Distances in the nets are thirds of an edge, so that centres of small triangles are points too.
constexpr int edge = 3;

/// Corners in the face's own copy of the lattice, counter-clockwise seen from outside.
struct Face
{
  std::array<int, 3> corner; ///< which of the net's
  std::array<Lattice, 3> at;
  std::array<double, 3> polar, azimuth; ///< of the corners' directions

  bool beyond(int side, Lattice p) const { return area(at[side], at[(side + 1) % 3], p) < 0; }
};

/// The flat faces of a capped tube, and the lattice's triangles across their sides.
class Net
{
public:
  explicit Net(const CappedTube& shape);
  SphereMesh mesh();

private:
  struct Side
  {
    int face, side;
  };
  void add_faces(int sector, Lattice along, Lattice down, const CappedTube& shape);
  void join_sides();
  bool owns(int face, Lattice centre) const;
  void triangulate(int face);
  int vertex(int face, Lattice centre, Lattice p);
  void step_over(Side from, Lattice& centre, Lattice& p) const;
  Vector3 direction(const Face& face, Lattice p) const;

  std::vector<Face> faces_;
  std::vector<std::array<Side, 3>> across_; ///< of each face's sides: the same side elsewhere
  std::vector<Vector3> directions_;
  std::vector<std::array<int, 3>> triangles_;
  PointHash known_{ 1e-9 };
};

/// The side of a face of the tube that runs down from one rim to the other, where it is least
/// skewed: with `along`, the side on the rim, it spans Q triangles.
Lattice way_down(const CappedTube& shape)
{
  const Lattice along{ shape.h, shape.k };
  const int g = std::gcd(shape.h, shape.k);
  Lattice down;
  while ((down.a * shape.k - shape.Q) % shape.h != 0)
    ++down.a;
  down.b = (down.a * shape.k - shape.Q) / shape.h;
  const double T = shape.T();
  const int steps = static_cast<int>(std::lround((T / 2 - dot(down, along)) / (T / g)));
  return { down.a + steps * shape.h / g, down.b + steps * shape.k / g };
}

Net::Net(const CappedTube& shape)
{
  const Lattice along{ edge * shape.h, edge * shape.k }, down = edge * way_down(shape);
  for (int sector = 0; sector < shape.fold; ++sector)
    add_faces(sector, along, down, shape);
  join_sides();
}

/// One of each cap and two of the tube. Corners: the poles 0 and 1, then those of the upper rim and
/// those of the lower.
void Net::add_faces(int sector, Lattice along, Lattice down, const CappedTube& shape)
{
  const double turn = 2 * std::numbers::pi / shape.fold;
  // Heights of a cap and of the tube in rows of triangles are as T and Q.
  const double rim = std::numbers::pi * shape.T() / (2. * shape.T() + shape.Q);
  const double skew = dot(down, along) / dot(along, along);
  // So that the half turn about y exchanges the rims.
  const double first = std::numbers::pi / 2 - turn * skew / 2;
  const auto upper = [&](int k) { return std::tuple{ 2 + k % shape.fold, rim, first + k * turn }; };
  const auto lower = [&](int k)
  {
    return std::tuple{ 2 + shape.fold + k % shape.fold, std::numbers::pi - rim,
      first + (k + skew) * turn };
  };
  const std::tuple north{ 0, 0., 0. }, south{ 1, std::numbers::pi, 0. };
  const auto add = [&](auto a, Lattice at_a, auto b, Lattice at_b, auto c, Lattice at_c)
  {
    const auto& [i, polar_i, azimuth_i] = a;
    const auto& [j, polar_j, azimuth_j] = b;
    const auto& [k, polar_k, azimuth_k] = c;
    faces_.push_back({ { i, j, k }, { at_a, at_b, at_c }, { polar_i, polar_j, polar_k },
      { azimuth_i, azimuth_j, azimuth_k } });
  };
  const Lattice origin;
  const int k = sector;
  add(north, turned(along), upper(k), origin, upper(k + 1), along);
  add(upper(k), origin, lower(k), down, upper(k + 1), along);
  add(upper(k + 1), along, lower(k), down, lower(k + 1), down + along);
  add(south, along - turned(along), lower(k + 1), along, lower(k), origin);
}

void Net::join_sides()
{
  across_.resize(faces_.size());
  const int count = static_cast<int>(faces_.size());
  for (int f = 0; f < count; ++f)
    for (int s = 0; s < 3; ++s)
      for (int g = 0; g < count; ++g)
        for (int r = 0; r < 3; ++r)
          if (faces_[g].corner[r] == faces_[f].corner[(s + 1) % 3] &&
            faces_[g].corner[(r + 1) % 3] == faces_[f].corner[s])
            across_[f][s] = { g, r };
}

/// Whether a small triangle with that centre belongs to the face: of two faces that share a side
/// with the centre on it, to the first.
bool Net::owns(int face, Lattice centre) const
{
  for (int s = 0; s < 3; ++s)
  {
    const int doubled = area(faces_[face].at[s], faces_[face].at[(s + 1) % 3], centre);
    if (doubled < 0 || (doubled == 0 && across_[face][s].face < face))
      return false;
  }
  return true;
}

void Net::triangulate(int face)
{
  const auto& at = faces_[face].at;
  const auto [a0, a1] = std::minmax({ at[0].a, at[1].a, at[2].a });
  const auto [b0, b1] = std::minmax({ at[0].b, at[1].b, at[2].b });
  const Lattice right{ edge, 0 }, up{ 0, edge };
  for (int a = a0 - edge; a <= a1; a += edge)
    for (int b = b0 - edge; b <= b1; b += edge)
    {
      const Lattice p{ a, b };
      for (const auto& [i, j, k] :
        { std::array{ p, p + right, p + up }, std::array{ p + right, p + right + up, p + up } })
      {
        const Lattice sum = i + j + k, centre{ sum.a / 3, sum.b / 3 };
        if (owns(face, centre))
          triangles_.push_back(
            { vertex(face, centre, i), vertex(face, centre, j), vertex(face, centre, k) });
      }
    }
}

/// The number of the point p, reached on the straight line from the centre of its triangle: that
/// line meets no corner.
int Net::vertex(int face, Lattice centre, Lattice p)
{
  const auto crossed = [&](int s)
  {
    const Face& f = faces_[face];
    return f.beyond(s, p) && area(centre, p, f.at[s]) < 0 && area(centre, p, f.at[(s + 1) % 3]) > 0;
  };
  for (int s = 0; s < 3;)
  {
    if (!crossed(s))
    {
      ++s;
      continue;
    }
    step_over({ face, s }, centre, p);
    face = across_[face][s].face;
    s = 0;
  }
  const Vector3 there = direction(faces_[face], p);
  int number = known_.find(there);
  if (number < 0)
  {
    number = static_cast<int>(directions_.size());
    directions_.push_back(there);
    known_.insert(there, number);
  }
  return number;
}

/// To the lattice of the face on the other side.
void Net::step_over(Side from, Lattice& centre, Lattice& p) const
{
  const auto [face, side] = across_[from.face][from.side];
  const Lattice here = faces_[from.face].at[from.side],
                along = faces_[from.face].at[(from.side + 1) % 3] - here,
                there = faces_[face].at[(side + 1) % 3], wanted = faces_[face].at[side] - there;
  Lattice to_centre = centre - here, to_p = p - here;
  for (Lattice side_turned = along; !(side_turned == wanted); side_turned = turned(side_turned))
  {
    to_centre = turned(to_centre);
    to_p = turned(to_p);
  }
  centre = there + to_centre;
  p = there + to_p;
}

/// Polar angle and azimuth are linear on the face; around a pole only the polar angle is.
Vector3 Net::direction(const Face& face, Lattice p) const
{
  double polar = 0, azimuth = 0, turning = 0;
  const double whole = area(face.at[0], face.at[1], face.at[2]);
  for (int c = 0; c < 3; ++c)
  {
    const double weight = area(face.at[(c + 1) % 3], face.at[(c + 2) % 3], p) / whole;
    polar += weight * face.polar[c];
    const bool pole = face.corner[c] < 2;
    azimuth += pole ? 0 : weight * face.azimuth[c];
    turning += pole ? 0 : weight;
  }
  azimuth /= turning > 0 ? turning : 1;
  return { std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
    std::cos(polar) };
}

SphereMesh Net::mesh()
{
  for (int f = 0; f < static_cast<int>(faces_.size()); ++f)
    triangulate(f);
  SphereMesh result;
  result.directions.resize(static_cast<Eigen::Index>(directions_.size()), 3);
  for (std::size_t i = 0; i < directions_.size(); ++i)
    result.directions.row(static_cast<Eigen::Index>(i)) = directions_[i];
  result.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    result.triangles.row(static_cast<Eigen::Index>(t)) << triangles_[t][0], triangles_[t][1],
      triangles_[t][2];
  return result;
}
}

std::vector<CappedTube> capped_tubes(int triangles)
{
  std::vector<CappedTube> tubes;
  for (const int fold : { 5, 6 })
  {
    const int sum = triangles / (2 * fold); // T + Q
    if (triangles % (2 * fold) != 0)
      continue;
    for (int h = 1; h * h < sum; ++h)
      for (int k = 0; k <= h; ++k)
      {
        CappedTube tube{ fold, h, k, 0 };
        tube.Q = sum - tube.T();
        if (tube.Q > 0 && tube.Q % std::gcd(h, k) == 0)
          tubes.push_back(tube);
      }
  }
  return tubes;
}

SphereMesh capped_tube_mesh(const CappedTube& shape)
{
  return Net(shape).mesh();
}

}
