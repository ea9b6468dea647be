#pragma once
// A finer mesh to look at: Loop's limit surface through the vertices of a closed triangle mesh.

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace vesicle
{

struct SmoothMesh
{
  vtkSmartPointer<vtkPolyData> surface; ///< with the point arrays asked for and Normals
  vtkSmartPointer<vtkPolyData> edges;   ///< the coarse mesh's edges, as lines along the surface
};

/// For display only: the vertices and the values there stay what they are, and in between comes the
/// limit surface (Loop 1987, see solver/surface/LoopBasis.h) that passes through them.
class SmoothSurface
{
public:
  /// Refines to at least about this many triangles. More than 10,000 change no more than 300 pixels
  /// of a picture of 1280 × 720 by more than 3%, all on the outline.
  explicit SmoothSurface(int wanted_triangles = 10000);
  ~SmoothSurface();

  /// What the triangles alone decide is kept until others come. Throws InputError where the mesh is
  /// not closed.
  SmoothMesh refine(vtkPolyData* coarse, const std::vector<std::string>& arrays);

private:
  struct Lattice;
  int wanted_triangles_;
  std::unique_ptr<Lattice> lattice_;
};

}
