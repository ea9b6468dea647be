// Vesicles and spheres beside a plane wall.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"
#include "solver/linear/Gmres.h"
#include "solver/mesh/shapes/SampleMeshes.h"
#include "solver/simulation/StartMesh.h"
#include "solver/stokes/LayerSum.h"
#include "solver/stokes/StokesOperator.h"
#include "solver/stokes/WallImages.h"
#include "solver/surface/Collocation.h"
#include "solver/surface/LoopBasis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vesicle::validation
{
namespace
{

const Wall ground{ Vector3::Zero(), Vector3::UnitZ() };

/// A unit sphere over the wall and the single layer of its surface, images with it.
class SphereOverWall
{
public:
  SphereOverWall(int triangles, double height)
    : mesh_(smooth_sphere(triangles)),
      basis_(mesh_.triangles, static_cast<int>(mesh_.points.rows())), collocation_(basis_),
      rules_(basis_, layer_quadrature(basis_, 3))
  {
    mesh_.points.col(2).array() += height;
    control_ = collocation_.fit(mesh_.points);
    const StokesOperator layer({ { &rules_, mesh_.points, control_ } });
    alone_ = std::make_unique<const LayerSum>(layer);
    images_ =
      std::make_unique<const WallImages>(layer, ground, PointKind::force, std::vector<double>{ 1 },
        [](const PointPlaces& places)
        {
          return std::make_unique<DirectPointSum<PointKind::force_image>>(
            places.sources, places.targets);
        });
  }

  /// The force on the fluid of the sphere as a rigid body with the velocity U, over 6πμ: by the
  /// densities that make that velocity at all vertices.
  Vector3 drag(const Vector3& U) const
  {
    const Eigen::VectorXd velocity = flat(Points(U.transpose().replicate(mesh_.points.rows(), 1)));
    const GmresResult solved = gmres(
      [&](const Eigen::VectorXd& f)
      {
        const std::vector<Eigen::VectorXd> density{ collocation_.to_control(f) };
        Eigen::VectorXd u = alone_->apply(density);
        images_->add(density, 0, u);
        return u;
      },
      [](const Eigen::VectorXd& r) { return r; }, velocity, 1e-7, 300);
    const BasisTable& table = rules_.regular().table;
    const RowVectors f =
      interpolate(table, rows_of_three(collocation_.to_control(solved.solution)));
    const Vector3 force = f.transpose() * evaluate(table, control_).area_weight;
    return force / (6 * std::numbers::pi);
  }

private:
  TriangleMesh mesh_;
  LoopBasis basis_;
  Collocation collocation_;
  LayerRules rules_;
  Points control_;
  std::unique_ptr<const LayerSum> alone_;
  std::unique_ptr<const WallImages> images_;
};

/// Height, drag of a rigid unit sphere perpendicular and parallel to the wall, over 6πμU.
constexpr std::array<std::array<double, 3>, 4> drags{ { { 1.5430806, 3.0360645, 1.567460 },
  { 2, 2.1255356, 1.382752 }, { 3, 1.5692054, 1.227155 }, { 5, 1.2850866, 1.125861 } } };

// H. Brenner, Chem. Eng. Sci. 16 (1961) 242; A. Goldman, R. Cox, H. Brenner, Chem. Eng. Sci. 22 (1967) 637.
void rigid_sphere(Report& report)
{
  for (const auto& [height, perpendicular, parallel] : drags)
  {
    const SphereOverWall sphere(report.triangles(), height);
    const double tolerance = report.full() ? 3e-5 : 1e-4;
    report.add(relative(fmt::format("h = {:.4g}: perpendicular F/6 pi mu U", height), perpendicular,
      sphere.drag(Vector3::UnitZ()).z(), tolerance));
    report.add(relative(fmt::format("h = {:.4g}: parallel F/6 pi mu U", height), parallel,
      sphere.drag(Vector3::UnitX()).x(), tolerance));
  }
}

// Nothing moves within an inextensible sphere along the normal.
void falling_sphere(Report& report)
{
  for (const double ratio : { 1., 5. })
    for (const auto& [height, drag, parallel] : drags)
    {
      Scene scene;
      scene.vesicle.shape.kind = ShapeRequest::Kind::sphere;
      scene.vesicle.shape.triangles = report.triangles();
      scene.vesicle.center.z() = height;
      scene.fluid.viscosity_ratio = ratio;
      scene.gravity = Scene::Gravity{};
      scene.gravity->bond_number = -1;
      scene.wall = ground;
      scene.time.end = 1;
      Simulation simulation(scene, make_start_meshes(scene));
      report.add(relative(fmt::format("lambda = {:g}, h = {:.4g}: U / (2 Bo/9)", ratio, height),
        1 / drag, -*simulation.diagnose(simulation.instant()).lift_speed / (2. / 9),
        report.full() ? 3e-5 : 1e-4, "a rigid sphere's"));
    }
}

// Spectral. It starts with the shape that it would keep far from the wall.
void lift(Report& report)
{
  const History before = simulate(scene_of("tank-treading", { "vesicle.triangles=320" }));
  TriangleMesh start = before.simulation->mesh(before.last);
  const auto& center = before.end().centroid;
  start.points.rowwise() += Eigen::RowVector3d(-center[0], -center[1], 1.5 - center[2]);
  const History run = simulate(scene_of("wall-lift"), start);
  // Time, height, lift speed, velocity along the wall, inclination, gap.
  const double reference[][6] = { { 2, 1.5830, 0.03902, 1.4785, 33.22, 0.580 },
    { 4, 1.6585, 0.03651, 1.5635, 33.16, 0.658 }, { 8, 1.7961, 0.03252, 1.7152, 33.04, 0.800 } };
  for (const auto& [time, height, speed, along, angle, gap] : reference)
  {
    const Diagnostics& d = at_time(run, time);
    const auto what = [t = time](const char* of) { return fmt::format("t = {:g}: {}", t, of); };
    report.add(absolute(what("height"), height, d.centroid[2], 2e-3));
    report.add(relative(what("lift speed"), speed, *d.lift_speed, 0.01));
    report.add(relative(what("velocity along the wall"), along, d.velocity[0], 1e-3));
    report.add(absolute(what("inclination (deg)"), angle, inclination(d), 0.03));
    report.add(absolute(what("gap"), gap, *d.wall_gap, 3e-3));
  }
}

}

std::vector<Case> wall_cases()
{
  return {
    { "wall/rigid-sphere", "Drag of a rigid sphere near a wall, by the single layer and its images",
      Case::Set::fast, rigid_sphere },
    { "wall/falling-sphere", "A sphere with an inextensible membrane falls towards a wall",
      Case::Set::fast, falling_sphere },
    { "wall/lift", "A vesicle in shear is lifted off a wall", Case::Set::full, lift },
  };
}

}
