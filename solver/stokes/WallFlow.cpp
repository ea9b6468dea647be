#include "solver/stokes/WallFlow.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/MembraneFlow.h"
#include "solver/stokes/NearRule.h"
#include "solver/stokes/PointSum.h"
#include "solver/stokes/WallImage.h"
#include "solver/stokes/kernels/StokesletKernel.h"

namespace vesicle
{

namespace
{

constexpr double of_contrast = double_layer_factor * kernel_factor;

}

WallFlow::WallFlow(const Wall& wall, const TriangleMesh& mesh, SurfaceBasis basis,
  const Points& forces, const Points& velocities)
  : frame_(wall),
    panels_(membrane_panels({ frame_.mirrored_positions(mesh.points), mesh.triangles }, basis,
      frame_.mirrored_vectors(forces), frame_.mirrored_vectors(velocities)))
{
  const auto rule = triangle_rule(fixed_panel_points);
  rows_per_panel_ = static_cast<int>(rule.size());
  const int rows = panels_.size() * rows_per_panel_;
  position_ = force_ = RowVectors(rows, 3);
  if (panels_.has_velocity())
    velocity_ = area_ = RowVectors(rows, 3);
  int row = 0;
  for (int panel = 0; panel < panels_.size(); ++panel)
    for (const TrianglePoint& p : rule)
    {
      const SurfacePanels::Sample sample = panels_.sample(panel, p.u, p.v);
      position_.row(row) = sample.position.transpose();
      force_.row(row) = kernel_factor * p.weight * sample.force.transpose();
      if (panels_.has_velocity())
      {
        // A mirrored surface is inside out.
        const SurfacePanels::Motion motion = panels_.motion(panel, p.u, p.v);
        velocity_.row(row) = motion.velocity.transpose();
        area_.row(row) = -of_contrast * p.weight * motion.area.transpose();
      }
      ++row;
    }
}

// The fixed rule's share.
Vector3 WallFlow::fixed(int panel, const Vector3& x, double layer, double contrast) const
{
  Vector3 sum = Vector3::Zero();
  for (int row = panel * rows_per_panel_; row < (panel + 1) * rows_per_panel_; ++row)
  {
    const Vector3 y = position_.row(row).transpose();
    sum += layer * force_image(x, y) * force_.row(row).transpose();
    if (contrast != 0)
      sum += contrast * stresslet_image(x, y, area_.row(row).transpose()) *
        velocity_.row(row).transpose();
  }
  return sum;
}

// By the panel's own rule for x.
Vector3 WallFlow::near(int panel, const Vector3& x, double layer, double contrast) const
{
  Vector3 sum = Vector3::Zero();
  for_each_near_point(panels_.nearest(panel, x), x,
    [&](double u, double v, double weight)
    {
      const SurfacePanels::Sample s = panels_.sample(panel, u, v);
      sum += layer * kernel_factor * weight * force_image(x, s.position) * s.force;
      if (contrast == 0)
        return;
      const SurfacePanels::Motion at = panels_.motion(panel, u, v);
      sum -=
        contrast * of_contrast * weight * stresslet_image(x, s.position, at.area) * at.velocity;
    });
  return sum;
}

Points WallFlow::at(const Points& points, double layer, double contrast) const
{
  const Points x = frame_.positions(points);
  Points made = Points::Zero(x.rows(), 3);
  DirectPointSum<PointKind::force_image>(position_, x).add(layer * force_, 0, made);
  if (contrast != 0)
    DirectPointSum<PointKind::stresslet_image>(position_, x)
      .add(contrast * symmetric_products(velocity_, area_), 0, made);
  const AdjacencyList close = near_panels(panels_, x);
  parallel_for(static_cast<int>(x.rows()),
    [&](int i)
    {
      const Vector3 here = x.row(i).transpose();
      Vector3 change = Vector3::Zero();
      for (const int* panel = close.begin(i); panel != close.end(i); ++panel)
        change += near(*panel, here, layer, contrast) - fixed(*panel, here, layer, contrast);
      made.row(i) += change.transpose();
    });
  return frame_.vectors_outside(made);
}

}
