#pragma once
// What `vesicle info` says of a mesh.

#include "solver/surface/SurfaceBasis.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/SelfCrossing.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/TriangleMesh.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace vesicle
{

struct MeshReport
{
  /// Loop's surface takes a closed, oriented, manifold mesh without loose points; of others the
  /// flat triangles are measured.
  MeshReport(TriangleMesh mesh, SurfaceBasis basis);

  long vertices = 0; ///< those that a triangle uses
  long triangles = 0;
  Topology topology;
  std::string nonmanifold;               ///< what keeps it from being a manifold; empty: nothing
  std::optional<Crossing> self_crossing; ///< two triangles that cross
  /// Of several bodies, those that are inside out, which are measured as facing outward, and those
  /// that are the inner side of a shell, whose volume is hollow; empty: none.
  std::string facing;
  /// By which corners of neighbouring triangles differ along an open seam.
  std::optional<double> seam_gap;
  MeshQuality quality; ///< of the triangles
  /// The surface that the following was measured on.
  SurfaceBasis basis = SurfaceBasis::linear;
  double area = 0;
  std::optional<double> volume;         ///< of a closed, oriented mesh; negative if it faces inward
  std::optional<double> reduced_volume; ///< of |volume|
  std::optional<double> energy_over_8pi; ///< of a closed, oriented mesh: bending energy over 8π EB
};

/// The keys of the output contract; null where undefined.
nlohmann::ordered_json to_json(const MeshReport& report);
std::string surface_name(const MeshReport& report); ///< flat or Loop
std::string to_text(const MeshReport& report);

}
