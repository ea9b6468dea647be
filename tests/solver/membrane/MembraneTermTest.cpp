// The force of every term is minus the derivative of its energy.
#include "solver/dynamics/LumpedForces.h"
#include "solver/membrane/AreaDifference.h"
#include "solver/membrane/Buoyancy.h"
#include "solver/membrane/ElasticSheet.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/membrane/ScaledTerm.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <functional>

namespace vesicle
{
namespace
{

using MakeTerm = std::function<std::unique_ptr<const MembraneTerm>(const SurfaceSpace&)>;

struct TermCase
{
  const char* name;
  MakeTerm make;
  SurfaceBasis basis;
  double coarse, fine; ///< bounds of the power's relative error at 320 and 1,280 triangles, twice
                       ///< what was measured; exact terms show the difference quotient's
};

// A displacement without symmetry that keeps the volume, ∇·v = 0: the load is one up to a pressure.
Points displacement(const Points& x)
{
  Points v(x.rows(), 3);
  v.col(0) = 0.3 * x.col(0) + 0.2 * x.col(2);
  v.col(1) = -0.2 * x.col(1) + (0.1 * x.col(2).array().square()).matrix();
  v.col(2) = 1 + (-0.1 * x.col(2).array() + 0.1 * x.col(0).array() * x.col(0).array());
  return v;
}

TriangleMesh body(int triangles)
{
  return test::mapped(test::smooth_sphere(triangles),
    [](const Vector3& d) -> Vector3 {
      return { 1.4 * d.x() + 0.3 * d.z(), 1.1 * d.y(), 0.8 * d.z() + 0.15 * d.x() * d.x() };
    });
}

double power_error(const TermCase& term_case, int triangles)
{
  const TriangleMesh mesh = body(triangles);
  const SurfaceSpace space(term_case.basis, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const auto term = term_case.make(space);
  const Points v = displacement(mesh.points);
  const double h = 1e-4;
  const double slope = (term->energy(Surface(space, mesh.points + h * v)) -
                         term->energy(Surface(space, mesh.points - h * v))) /
    (2 * h);
  const Surface surface(space, mesh.points);
  const double power = space.smooth()
    ? -term->variation(surface).gradient.dot(surface.to_control(flat(v)))
    : LumpedForces(surface, nullptr).power(term->force(surface).density, flat(v));
  return std::abs(power / -slope - 1);
}

class Term : public testing::TestWithParam<TermCase>
{
};

TEST_P(Term, PowerIsTheDescentOfTheEnergy)
{
  EXPECT_LT(power_error(GetParam(), 320), GetParam().coarse);
  EXPECT_LT(power_error(GetParam(), 1280), GetParam().fine);
}

const MakeTerm bending = [](const SurfaceSpace& space) { return make_bending(space, 0); };
const MakeTerm curved = [](const SurfaceSpace& space) { return make_bending(space, 1.5); };
const MakeTerm inward = [](const SurfaceSpace& space) { return make_bending(space, -2); };
const MakeTerm stronger = [](const SurfaceSpace& space)
{ return std::make_unique<ScaledTerm>(make_bending(space, 1.5), 3.7); };
const MakeTerm area_difference = [](const SurfaceSpace&)
{ return std::make_unique<AreaDifference>(1.4, 1.2); };
const MakeTerm buoyancy = [](const SurfaceSpace& space) { return make_buoyancy(space, 3); };

MakeTerm sheet(ElasticLaw law)
{
  return [law](const SurfaceSpace& space)
  {
    const int triangles = static_cast<int>(space.triangles().rows());
    return std::make_unique<ElasticSheet>(
      ElasticModuli{ law, 1.5, 2 }, space, test::smooth_sphere(triangles).points);
  };
}

INSTANTIATE_TEST_SUITE_P(Terms, Term,
  testing::Values(TermCase{ "Bending", bending, SurfaceBasis::loop, 1e-6, 1e-6 },
    TermCase{ "SpontaneousCurvature", curved, SurfaceBasis::loop, 1e-6, 1e-6 },
    TermCase{ "NegativeSpontaneousCurvature", inward, SurfaceBasis::loop, 1e-6, 1e-6 },
    TermCase{ "StrongerBending", stronger, SurfaceBasis::loop, 1e-6, 1e-6 },
    TermCase{ "AreaDifference", area_difference, SurfaceBasis::loop, 1e-6, 1e-6 },
    TermCase{ "FlatAreaDifference", area_difference, SurfaceBasis::linear, 0.13, 0.032 },
    TermCase{ "Buoyancy", buoyancy, SurfaceBasis::loop, 2e-8, 2e-9 },
    TermCase{ "NeoHookean", sheet(ElasticLaw::neo_hookean), SurfaceBasis::loop, 1e-7, 1e-7 },
    TermCase{ "Skalak", sheet(ElasticLaw::skalak), SurfaceBasis::loop, 1e-7, 1e-7 },
    TermCase{ "FlatBuoyancy", buoyancy, SurfaceBasis::linear, 2e-9, 2e-9 }),
  [](const auto& term) { return term.param.name; });

}
}
