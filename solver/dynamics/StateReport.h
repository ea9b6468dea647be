#pragma once
// What is reported of a state: a row of diagnostics and fields at the vertices, of each vesicle, in
// the scene's units. Whatever terms there are, each reports itself.

#include "solver/dynamics/Diagnostics.h"
#include "solver/dynamics/Scales.h"
#include "solver/dynamics/State.h"
#include "solver/dynamics/SystemShape.h"
#include "solver/surface/FlatPieces.h"

#include <map>
#include <string>

namespace vesicle
{

class StateReport
{
public:
  /// The system must outlive the report.
  StateReport(const System& system, const Scales& scales);

  /// `shape` is that of the state, here and below.
  Diagnostics diagnose(const State& state, const SystemShape& shape, std::size_t vesicle) const;

  /// By the names of the output contract: Mean_Curvature, Gauss_Curvature,
  /// Laplacian_Mean_Curvature, Normals, Velocity, Surface_Divergence, <term>_Force, Tension,
  /// Tension_Force, Membrane_Force; #vertices rows, 1 or 3 columns. Only what the system has.
  std::map<std::string, Eigen::MatrixXd> fields(
    const State& state, const SystemShape& shape, std::size_t vesicle) const;

private:
  void add_geometry(const VesicleShape& shape, Diagnostics& d) const;
  void add_power(const VesicleShape& shape, const VesicleState& state,
    const Eigen::VectorXd& imposed, Diagnostics& d) const;
  void add_shape(const VesicleShape& shape, Diagnostics& d) const;
  void add_wall(const VesicleShape& shape, Diagnostics& d) const;
  void add_flow(const VesicleShape& shape, const VesicleState& state, const FlatPieces& pieces,
    Diagnostics& d) const;

  const System& system_;
  Scales scales_;
  std::vector<FlatPieces> pieces_; ///< of each vesicle
};

}
