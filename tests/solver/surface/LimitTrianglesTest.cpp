#include "solver/surface/LimitTriangles.h"

#include "solver/mesh/MeshIntegrals.h"
#include "solver/surface/SurfaceMeasures.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle::test
{

// The fine triangles' area goes to that of Loop's surface as 1/cuts².
TEST(LimitTriangles, ApproachTheSurface)
{
  const TriangleMesh mesh = mapped(jittered_sphere(4, 0.1), paper_surface);
  const double exact = surface_measures(SurfaceBasis::loop, mesh).area;
  double last = 0;
  for (const int cuts : { 2, 4, 8 })
  {
    const TriangleMesh fine = limit_triangles(mesh, cuts);
    EXPECT_EQ(fine.triangles.rows(), cuts * cuts * mesh.triangles.rows());
    const double error = flat_area(fine) - exact;
    EXPECT_LT(error, 0); // chords
    if (last < 0)
    {
      EXPECT_NEAR(last / error, 4, 0.8);
    }
    last = error;
  }
}

// They face as the mesh does, and its points are corners; at extraordinary ones, where the last part
// of LimitSurface is 1/64 of an edge wide, to that width's square times the curvature.
TEST(LimitTriangles, FaceAsTheMeshAndHaveItsPoints)
{
  const TriangleMesh mesh = jittered_sphere(3, 0.1);
  const TriangleMesh fine = limit_triangles(mesh, 3);
  EXPECT_GT(flat_volume(fine), 0);
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::RowVector3d corner = mesh.points.row(mesh.triangles(t, k));
      const double nearest =
        (fine.points.middleRows(10 * t, 10).rowwise() - corner).rowwise().norm().minCoeff();
      EXPECT_LT(nearest, std::pow(0.4 / 64, 2));
    }
  }
}

}
