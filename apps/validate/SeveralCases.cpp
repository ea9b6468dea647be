// Vesicles beside each other.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"
#include "solver/mesh/shapes/SampleMeshes.h"
#include "solver/simulation/StartMesh.h"
#include "solver/stokes/LayerSum.h"
#include "solver/stokes/StokesOperator.h"
#include "solver/surface/Collocation.h"
#include "solver/surface/LoopBasis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vesicle::validation
{
namespace
{

/// Two unit spheres one above the other, their centres `distance` apart.
Scene spheres(double distance, int triangles, bool incompressible)
{
  Scene scene;
  scene.vesicle.shape.kind = ShapeRequest::Kind::sphere;
  scene.vesicle.shape.triangles = triangles;
  scene.membrane.incompressible = incompressible;
  scene.gravity = Scene::Gravity{};
  scene.gravity->bond_number = 1;
  scene.time.end = 1;
  scene.companions.push_back(scene.companion());
  scene.companions[0].vesicle.center = { 0, 0, distance };
  return scene;
}

/// How fast both rise at the first instant, in Bo EB/μ r0².
std::vector<Diagnostics> first_instant(const Scene& scene)
{
  Simulation simulation(scene, make_start_meshes(scene));
  return simulation.diagnose_all(simulation.instant());
}

// Spheres of fluid without a membrane: U/U0 = 1 + 5/(4d) − 1/(2d³), U0 = 4/15 of one alone.
void blobs(Report& report)
{
  for (const double gap : { 1., 0.1, 0.01 })
  {
    const double d = 2 + gap, alone = 4. / 15;
    const auto both = first_instant(spheres(d, report.triangles(), false));
    for (const Diagnostics& one : both)
      report.add(relative(fmt::format("gap {:g}: U / Bo", gap),
        alone * (1 + 5 / (4 * d) - 1 / (2 * d * d * d)), one.velocity[2],
        report.full() ? 4e-5 : 1.5e-4, "closed form"));
  }
}

/// A unit sphere's surface and the rules of its layer.
struct Sphere
{
  TriangleMesh mesh;
  LoopBasis basis;
  Collocation collocation;
  LayerRules rules;

  explicit Sphere(int triangles)
    : mesh(smooth_sphere(triangles)), basis(mesh.triangles, static_cast<int>(mesh.points.rows())),
      collocation(basis), rules(basis, layer_quadrature(basis, 3))
  {
  }
};

/// Outside a sphere of fluid under the load z n: with a = e_z/r + x z/r³, u = a/6 + ∇²a/60.
Vector3 beside_blob(const Vector3& x)
{
  const double r = x.norm(), r3 = r * r * r;
  const Vector3 e = Vector3::UnitZ(), n = x / r;
  return (e / r + x * x.z() / r3) / 6 + (e - 3 * n * n.z()) * 2 / r3 / 60;
}

double largest_error(const Points& at, const Eigen::VectorXd& velocity)
{
  double error = 0;
  for (Eigen::Index i = 0; i < at.rows(); ++i)
    error = std::max(error,
      (velocity.segment<3>(3 * i) - beside_blob(at.row(i).transpose())).cwiseAbs().maxCoeff());
  return error;
}

// At the vertices of another sphere, turned so that none is over a vertex, and at its own.
void layer(Report& report)
{
  const Sphere blob(report.triangles());
  const Points& x = blob.mesh.points;
  const Points load = (x.array().colwise() * x.col(2).array()).matrix();
  const Eigen::VectorXd f = blob.collocation.to_control(flat(load)),
                        none = Eigen::VectorXd::Zero(f.size());
  const LayerSurface surface{ &blob.rules, x, blob.collocation.fit(x) };
  const double own = largest_error(x, LayerSum(StokesOperator({ surface })).apply({ f }));
  report.add(at_most("on the sphere itself: velocity", report.full() ? 2e-5 : 8e-5, own));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Vector3(1, 2, 3).normalized()).matrix();
  for (const double gap : { 1., 0.1, 0.01, 0.001 })
  {
    const Points above = (x * turn.transpose()).rowwise() + Eigen::RowVector3d(0, 0, 2 + gap);
    const StokesOperator both({ surface, { &blob.rules, above, blob.collocation.fit(above) } });
    report.add(at_most(fmt::format("gap {:g}: velocity", gap), own,
      largest_error(above, LayerSum(both).apply({ f, none }).tail(none.size())),
      "no more than on it"));
  }
}

// Along their line of centres inextensible spheres are rigid ones (M. Stimson, G. Jeffery, 1926).
void inextensible(Report& report)
{
  const std::array<std::array<double, 2>, 3> drag{ { { 2.1, 0.6509001445 }, { 2.5, 0.6729155138 },
    { 4, 0.7422582851 } } };
  for (const auto& [distance, factor] : drag)
  {
    const auto both = first_instant(spheres(distance, report.triangles(), true));
    report.add(relative(fmt::format("d = {:g}: U / (2 Bo/9)", distance), 1 / factor,
      both[0].velocity[2] / (2. / 9), report.full() ? 3e-5 : 1.2e-4, "rigid spheres"));
  }
}

// Spectral, each started with the shape that it would keep alone; ours start as ellipsoids of its axes.
void pair(Report& report)
{
  const History run =
    simulate(scene_of("pair", { fmt::format("vesicle.triangles={}", report.full() ? 320 : 120) }));
  const double reference[][3] = { { 1, -1.2459, 0.2778 }, { 2, -0.9865, 0.3430 },
    { 3, -0.7001, 0.4856 } };
  const double tolerance = report.full() ? 1e-3 : 1e-2;
  for (const auto& [time, x, z] : reference)
  {
    const Diagnostics& d = at_time(run, time);
    report.add(absolute(fmt::format("t = {:g}: centre x", time), x, d.centroid[0], tolerance));
    report.add(absolute(fmt::format("t = {:g}: centre z", time), z, d.centroid[2], tolerance));
  }
  report.add(absolute("inclination (deg)", 38.99, inclination(run.end()), 0.2));
}

}

std::vector<Case> several_cases()
{
  return {
    { "several/blobs", "Two spheres of fluid rise one above the other, down to a gap of .01 r0",
      Case::Set::fast, blobs },
    { "several/layer", "Velocity beside a sphere of fluid, at another one's vertices",
      Case::Set::fast, layer },
    { "several/inextensible",
      "Two spheres with inextensible membranes rise along their line of "
      "centres as rigid ones",
      Case::Set::fast, inextensible },
    { "several/pair", "Two vesicles pass each other in shear", Case::Set::full, pair },
  };
}

}
