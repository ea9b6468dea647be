// Vesicles with a viscous membrane, close to a sphere.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"
#include "solver/flow/Extension.h"
#include "solver/mesh/shapes/SphericalHarmonics.h"
#include "solver/simulation/StartMesh.h"
#include "solver/surface/Surface.h"

#include <fmt/format.h>

#include <array>
#include <functional>

namespace vesicle::validation
{
namespace
{

struct Viscosities
{
  double ratio, membrane;
};

constexpr std::array<Viscosities, 6> viscosities{ { { 1, 0.1 }, { 1, 1 }, { 1, 10 }, { 1, 100 },
  { 5, 1 }, { 5, 100 } } };

/// r = 1 + Σ amplitude Y_lm, without bending.
Scene nearly_sphere(const Report& report, const Viscosities& v, std::vector<ShapeMode> modes)
{
  Scene scene;
  scene.vesicle.shape.kind = ShapeRequest::Kind::perturbed;
  scene.vesicle.shape.modes = std::move(modes);
  scene.vesicle.shape.triangles = report.triangles();
  scene.fluid.viscosity_ratio = v.ratio;
  scene.membrane.surface_viscosity = v.membrane;
  scene.time.end = 1;
  return scene;
}

/// At the first instant.
class Instant
{
public:
  explicit Instant(const Scene& scene) : Instant(scene, make_start_mesh(scene)) {}

  /// Of the normal speed: its part along a function of the direction.
  double rate(const std::function<double(const Vector3&)>& function) const
  {
    const VesicleState& vesicle = state_.vesicles[0];
    double product = 0, square = 0;
    for (Eigen::Index i = 0; i < vesicle.points.rows(); ++i)
    {
      const double f = function(vesicle.points.row(i).normalized().transpose());
      product += surface_.vertex_area[i] * vesicle.velocity.row(i).dot(surface_.normals.row(i)) * f;
      square += surface_.vertex_area[i] * f * f;
    }
    return product / square;
  }
  double mean_tension() const
  {
    return surface_.vertex_area.dot(state_.vesicles[0].tension) / surface_.area;
  }

private:
  Instant(const Scene& scene, const TriangleMesh& mesh)
    : space_(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows())),
      state_(Simulation(scene, mesh).instant()), surface_(space_, state_.vesicles[0].points)
  {
  }

  SurfaceSpace space_;
  State state_;
  Surface surface_;
};

double gain(int l)
{
  return (l - 1) * (l + 2);
}

double resistance(int l, const Viscosities& v)
{
  const double cubic = 2 * l * l * l + 3 * l * l;
  return cubic + 4 + v.ratio * (cubic - 5) + 4 * gain(l) * v.membrane;
}

std::string text_of(const Viscosities& v)
{
  return fmt::format(" at lambda = {:g}, eta = {:g}", v.ratio, v.membrane);
}

// 60/(23λ + 32 + 16η). What the tension adds is the opposite of shapes bent the other way about.
void strain(Report& report)
{
  for (const Viscosities& v : viscosities)
  {
    double rate = 0;
    for (const double amplitude : { -0.02, 0.02 })
    {
      Scene scene = nearly_sphere(report, v, { { 2, -2, amplitude } });
      scene.flow = std::make_shared<Extension>(Extension::Type::planar, 1);
      rate +=
        Instant(scene).rate([](const Vector3& n) { return n.x() * n.x() - n.z() * n.z(); }) / 2;
    }
    report.add(relative("response" + text_of(v), 60 / resistance(2, v), rate, 1e-2));
  }
}

// du_l/dt = −l(l + 1)(l − 1)(l + 2) [l(l + 1) + σ] u_l over the resistance, σ the tension. Of shapes that are
// bent the other way about the linear part is the opposite one.
void relaxation(Report& report)
{
  const std::vector<ShapeMode> modes{ { 2, 0, 0.015 }, { 4, 0, 0.005 } };
  for (const Viscosities& v : viscosities)
  {
    std::array<double, 2> rate{}, exact{};
    for (const double sign : { -1., 1. })
    {
      std::vector<ShapeMode> bent = modes;
      for (ShapeMode& mode : bent)
      {
        mode.amplitude *= sign;
      }
      Scene scene = nearly_sphere(report, v, bent);
      scene.membrane.bending_rigidity = 1;
      const Instant instant(scene);
      for (int k = 0; k < 2; ++k)
      {
        const int l = modes[k].l, squared = l * (l + 1);
        rate[k] += sign / 2 *
          instant.rate([l](const Vector3& n) { return real_spherical_harmonic(l, 0, n); });
        exact[k] -= squared * gain(l) * (squared + instant.mean_tension()) / resistance(l, v) *
          modes[k].amplitude / 2;
      }
    }
    for (int k = 0; k < 2; ++k)
    {
      report.add(relative(fmt::format("rate of u{}{}", modes[k].l, text_of(v)), exact[k], rate[k],
        report.full() ? 1e-2 : 2.5e-2));
    }
  }
}

}

std::vector<Case> membrane_viscosity_cases()
{
  return {
    { "membrane-viscosity/strain",
      "How a nearly spherical vesicle with a viscous membrane takes up a strain", Case::Set::fast,
      strain },
    { "membrane-viscosity/relaxation", "How two of its modes relax", Case::Set::fast, relaxation },
  };
}

}
