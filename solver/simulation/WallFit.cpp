#include "solver/simulation/WallFit.h"

#include "solver/Errors.h"
#include "solver/flow/FlowKind.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

// Of the speed one vesicle's size above the wall, at the same points.
constexpr double allowed_slip = 1e-6;

std::string prefix(const Scene& scene)
{
  return scene.file.empty() ? "" : scene.file.string() + ": ";
}

/// Points of the wall under the vertices.
Points feet(const Wall& wall, const Points& vertices)
{
  return vertices - wall.heights(vertices) * wall.normal.transpose();
}

void require_rest(const Scene& scene, const Points& vertices)
{
  const auto flow = imposed_flow(scene) ? scene.flow : nullptr;
  if (!flow)
    return;
  const Wall& wall = *scene.wall;
  const Points at = feet(wall, vertices);
  const double size = box_diagonal(vertices);
  const Points above = at.rowwise() + size * wall.normal.transpose(), slip = flow->velocities(at);
  Eigen::Index worst = 0;
  const double fastest = slip.rowwise().norm().maxCoeff(&worst),
               speed = flow->velocities(above).rowwise().norm().maxCoeff();
  if (fastest <= allowed_slip * speed)
    return;
  const auto text = [](const Eigen::RowVector3d& v)
  { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x(), v.y(), v.z()); };
  throw InputError(fmt::format(
    "{}the wall sticks, and the flow ({}) isn't zero there: {} at {}. Let the wall be where the "
    "flow is zero (shear with rate z e_x: wall.point = [0, 0, 0], wall.normal = [0, 0, 1]), or "
    "leave out [wall] or [flow]",
    prefix(scene), flow->kind().name, text(slip.row(worst)), text(at.row(worst))));
}

}

void require_fit_for_wall(const Scene& scene, const std::vector<TriangleMesh>& start)
{
  if (!scene.wall)
    return;
  if (scene.accuracy.basis != Scene::Basis::loop)
    throw InputError(prefix(scene) +
      "a wall takes Loop's surface (accuracy.preset = \"balanced\" or \"accurate\")");
  for (std::size_t v = 0; v < start.size(); ++v)
  {
    const Points& vertices = start[v].points;
    Eigen::Index lowest = 0;
    if (const double height = scene.wall->heights(vertices).minCoeff(&lowest); height <= 0)
    {
      const std::string which = start.size() > 1 ? fmt::format("vesicle {}", v) : "the vesicle";
      throw InputError(
        fmt::format("{}{} crosses the wall or is behind it: ({:.4g}, {:.4g}, {:.4g}) is {:.4g} "
                    "behind; move its center, the wall's point, or turn the wall's normal, which "
                    "points into the fluid",
          prefix(scene), which, vertices(lowest, 0), vertices(lowest, 1), vertices(lowest, 2),
          -height));
    }
    require_rest(scene, vertices);
  }
}

}
