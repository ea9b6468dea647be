#pragma once
// What is reported of a state: a row of diagnostics and fields at the vertices, of each vesicle, in
// the scene's units. Whatever terms there are, each reports itself.

#include "solver/dynamics/Diagnostics.h"
#include "solver/dynamics/Method.h"
#include "solver/dynamics/Scales.h"
#include "solver/dynamics/State.h"
#include "solver/dynamics/SystemShape.h"
#include "solver/surface/FlatPieces.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vesicle
{

class StateReport
{
public:
  /// The system must outlive the report. `layer`: how layers are summed.
  StateReport(const System& system, const Scales& scales, const LayerSettings& layer);

  /// `shape` is that of the state, here and below.
  Diagnostics diagnose(const State& state, const SystemShape& shape, std::size_t vesicle) const;

  /// By the names of the output contract: Mean_Curvature, Gauss_Curvature,
  /// Laplacian_Mean_Curvature, Normals, Velocity, Surface_Divergence, <term>_Force, Viscous_Force, Tension,
  /// Tension_Force, Membrane_Force; #vertices rows, 1 or 3 columns. Only what the system has.
  std::map<std::string, Eigen::MatrixXd> fields(
    const State& state, const SystemShape& shape, std::size_t vesicle) const;

private:
  void add_geometry(const VesicleShape& shape, Diagnostics& d) const;
  void add_power(const VesicleShape& shape, const VesicleState& state,
    const Eigen::VectorXd& imposed, Diagnostics& d) const;
  /// `on_disturbance`: the power of all forces on the velocity less the imposed one.
  void split_power(const VesicleShape& shape, const Eigen::VectorXd& velocity,
    const Eigen::VectorXd& imposed, double on_disturbance, Diagnostics& d) const;
  void add_shape(const VesicleShape& shape, Diagnostics& d) const;
  void add_wall(const VesicleShape& shape, Diagnostics& d) const;
  void add_flow(const VesicleShape& shape, const VesicleState& state, const FlatPieces& pieces,
    Diagnostics& d) const;

  const System& system_;
  Scales scales_;
  LayerSettings layer_;
  /// Of each vesicle; shared like its space.
  std::vector<std::shared_ptr<const FlatPieces>> pieces_;
};

}
