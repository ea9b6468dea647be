#pragma once
// The mesh that a scene starts from.

#include "solver/scene/Scene.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vesicle
{

/// Of a vesicle, in the scene's units, and what is to be said of how it was made.
struct StartMesh
{
  TriangleMesh mesh;
  std::string notes;
  /// Of an elastic sheet whose shape without stress is a file's: that mesh.
  std::optional<TriangleMesh> reference = {};
};

/// How a scene's vesicle is turned: the shape's own z axis to its axis, or by its rotation.
Eigen::Matrix3d orientation(const Scene::Vesicle& vesicle);

/// Start shapes before they are placed, each made once.
class StartShapes
{
public:
  const TriangleMesh& of(const ShapeRequest& shape, SurfaceBasis basis);

private:
  std::vector<std::pair<ShapeRequest, TriangleMesh>> made_; ///< on one basis
  SurfaceBasis basis_ = SurfaceBasis::loop;
};

/// The start mesh of a scene's first vesicle, which has a shape, placed and oriented.
TriangleMesh make_start_mesh(const Scene& scene);
TriangleMesh make_start_mesh(const Scene& scene, StartShapes& shapes);
/// Of all vesicles of a scene without mesh files.
std::vector<StartMesh> make_start_meshes(const Scene& scene);

/// What that mesh doesn't hold of the shape, start_shape_warning().
std::string check_start_shape(const Scene& scene, const TriangleMesh& mesh);

/// Places a mesh that was read from the scene's mesh_file: resampled if the scene asks for a number
/// of triangles, scaled to the radius, rotated about its centroid, moved to the center. `notes` tells what was changed.
/// Throws InputError.
TriangleMesh place_start_mesh(const Scene& scene, TriangleMesh mesh, std::string& notes);

/// A warning if the mesh is too rough for the scene's basis; empty if it isn't.
std::string check_smoothness(const Scene& scene, const TriangleMesh& mesh);

}
