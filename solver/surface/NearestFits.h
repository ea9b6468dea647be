#pragma once
// The fits of all vertices of a mesh to their nearest neighbours (HeightFit.h): for smooth meshes,
// of which they tell most. What is asked for and by what it was measured is told by
// FittedCurvature.h.

#include "solver/mesh/Connectivity.h"
#include "solver/surface/HeightFit.h"
#include "solver/surface/NeighbourSearch.h"

namespace vesicle
{

class NearestFits
{
public:
  /// All must outlive it. `border`: border_vertices().
  NearestFits(
    const TriangleMesh& mesh, const Connectivity& connectivity, const std::vector<char>& border);

  /// What a thread keeps from a vertex to the next.
  struct Workspace
  {
    NeighbourSearch search;
    std::vector<double> squares;
    Patch patch;
    HeightFit fit;
  };
  /// The degree of the fit of vertex i that the workspace then holds, to the points that its search
  /// has found; 0: there is none.
  int fit(int i, Workspace& work) const;

private:
  void gather(int i, NeighbourSearch& search) const;
  void describe(int i, Workspace& work) const;

  const Points& points_;
  const AdjacencyList& neighbours_;
  const std::vector<char>& border_;
  Points normal_;
};

}
