#pragma once
// The fits of all vertices of a mesh at a length scale (ScaleFit.h).

#include "solver/ProgressCallback.h"
#include "solver/mesh/Connectivity.h"
#include "solver/surface/NeighbourSearch.h"
#include "solver/surface/ScaleFit.h"
#include "solver/surface/VertexClusters.h"

namespace vesicle
{

/// A vertex' points are those within the radius that face as it does and are connected with it not
/// much farther away. How a vertex faces is the direction of the area vectors within a third of the
/// radius, added up: of a staircase as of the surface that it follows. The search for points is
/// done once for a cluster of vertices.
class ScaleFits
{
public:
  /// Mesh and connectivity must outlive it.
  ScaleFits(const TriangleMesh& mesh, const Connectivity& connectivity, double radius,
    const ProgressCallback& progress = {});

  const VertexClusters& clusters() const { return clusters_; }

  /// What a thread keeps from a cluster to the next.
  struct Workspace
  {
    NeighbourSearch search;
    std::vector<int> candidate;
    Candidates candidates;
    ScaleFit fit;
    std::vector<double> field;
  };
  /// Collects what the fits of a cluster's vertices, which come next, need.
  void begin(int cluster, Workspace& work) const;
  /// The fit of vertex i in the workspace; false where it has fewer than twelve points or they
  /// don't determine it.
  bool fit(int i, Workspace& work) const;
  /// Δ_s f at vertex i of a field given at all vertices; `normal` is that of its fit.
  double laplacian(
    int i, const Vector3& normal, const Eigen::VectorXd& field, Workspace& work) const;

private:
  Vector3 smoothed_normal(int i, const Points& area, NeighbourSearch& search) const;

  const Points& points_;
  const AdjacencyList& neighbours_;
  double radius_;
  VertexClusters clusters_;
  Points normal_;
};

}
