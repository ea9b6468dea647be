#pragma once
// Finds the point of a set of triangles that is nearest to a given one, or where a line meets them,
// in a tree of boxes.

#include "solver/mesh/TriangleMesh.h"

#include <functional>
#include <vector>

namespace vesicle
{

/// Barycentric weights of the point of triangle a, b, c nearest to the origin.
Vector3 nearest_weights(const Vector3& a, const Vector3& b, const Vector3& c);

class TriangleTree
{
public:
  /// `facings`: a direction (of any length) that each triangle faces, one a row; only intersect()
  /// needs them. Without triangles nothing may be asked.
  explicit TriangleTree(TriangleMesh mesh, Points facings = {});

  struct Hit
  {
    int triangle = -1; ///< −1: none
    Vector3 weights;   ///< barycentric, of the triangle's corners
    double squared_distance = 0;
  };
  Hit nearest(const Vector3& x) const;
  /// Where the line through x along `direction` (unit vector) meets triangles that face into the
  /// half space of `direction`, the place nearest to x.
  Hit intersect(const Vector3& x, const Vector3& direction) const;

  /// Calls `visit(i, j)` with pairs of triangles whose boxes meet, each once, until it returns true.
  void visit_overlaps(const std::function<bool(int, int)>& visit) const;

  const TriangleMesh& mesh() const { return mesh_; }
  const Points& facings() const { return facings_; }

private:
  /// The children of an inner node follow it: the left one at once, the right one at `right`; a
  /// leaf (right < 0) has the triangles order_[first] … order_[last − 1].
  struct Node
  {
    Eigen::AlignedBox3d box;
    int right = -1;
    int first = 0;
    int last = 0;
  };

  void build(int first, int last, const Points& centres);
  void visit_nearest(int node, const Vector3& x, Hit& best) const;
  void visit_intersections(int node, const Vector3& x, const Vector3& direction, Hit& best) const;

  using VisitPair = std::function<bool(int, int)>;
  bool visit_within(int node, const VisitPair& visit) const;
  bool visit_between(int left, int right, const VisitPair& visit) const;
  Eigen::AlignedBox3d box_of(int triangle) const;

  TriangleMesh mesh_;
  Points facings_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}
