#pragma once
// What the linear problem of a stage has for an answer, whichever way it is posed.

#include <Eigen/Core>

#include <vector>

namespace vesicle
{

struct StageSolution
{
  struct Part
  {
    /// The density of the stiff terms' force, with its change over the step: see VesicleState.
    Eigen::VectorXd stiff_force;
    Eigen::VectorXd tension; ///< γ: N or empty
    double volume_speed = 0; ///< c
    double pressure = 0;     ///< p
  };
  Eigen::VectorXd velocity; ///< of all vertices: 3N
  std::vector<Part> vesicles;
  int iterations = 0;
};

}
