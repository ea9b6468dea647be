#include "solver/surface/LoopBasis.h"

#include "solver/Errors.h"
#include "solver/mesh/Connectivity.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/surface/SurfaceIntegrals.h"
#include "tests/solver/support/TestMeshes.h"

#include <Eigen/SparseLU>
#include <gtest/gtest.h>

#include <numbers>

namespace vesicle
{
namespace
{

// All valences from 3 to 10 by vertex: a double pyramid over an n-gon, its triangles cut in four.
TriangleMesh bipyramid(int n)
{
  TriangleMesh mesh;
  mesh.points.resize(n + 2, 3);
  mesh.triangles.resize(2 * n, 3);
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2 * std::numbers::pi * i / n;
    mesh.points.row(i) << std::cos(angle), std::sin(angle), 0;
    mesh.triangles.row(2 * i) << i, (i + 1) % n, n;
    mesh.triangles.row(2 * i + 1) << (i + 1) % n, i, n + 1;
  }
  mesh.points.row(n) << 0, 0, 1;
  mesh.points.row(n + 1) << 0, 0, -1;
  return mesh;
}

// One step of Loop's subdivision done the plain way, on the whole mesh: the surface must not
// change.
TriangleMesh subdivided(const TriangleMesh& mesh)
{
  const Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const int n = static_cast<int>(mesh.points.rows());
  std::map<std::pair<int, int>, int> edge_point;
  TriangleMesh fine;
  fine.points = Points::Zero(n + static_cast<int>(connectivity.edges.size()), 3);
  for (std::size_t e = 0; e < connectivity.edges.size(); ++e)
  {
    const auto [a, b] = connectivity.edges[e];
    edge_point[{ a, b }] = edge_point[{ b, a }] = n + static_cast<int>(e);
    fine.points.row(n + e) = 3. / 8 * (mesh.points.row(a) + mesh.points.row(b));
  }
  fine.triangles.resize(4 * mesh.triangles.rows(), 3);
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const int a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
    const int ab = edge_point[{ a, b }], bc = edge_point[{ b, c }], ca = edge_point[{ c, a }];
    fine.points.row(ab) += mesh.points.row(c) / 8;
    fine.points.row(bc) += mesh.points.row(a) / 8;
    fine.points.row(ca) += mesh.points.row(b) / 8;
    fine.triangles.row(4 * t) << a, ab, ca;
    fine.triangles.row(4 * t + 1) << ab, b, bc;
    fine.triangles.row(4 * t + 2) << ca, bc, c;
    fine.triangles.row(4 * t + 3) << bc, ca, ab;
  }
  for (int i = 0; i < n; ++i)
  {
    const int valence = connectivity.vertex_neighbours.size(i);
    const double beta = loop_vertex_weight(valence);
    fine.points.row(i) = (1 - valence * beta) * mesh.points.row(i);
    for (const int* j = connectivity.vertex_neighbours.begin(i);
         j != connectivity.vertex_neighbours.end(i); ++j)
      fine.points.row(i) += beta * mesh.points.row(*j);
  }
  return fine;
}

LoopBasis basis_of(const TriangleMesh& mesh)
{
  return LoopBasis(mesh.triangles, static_cast<int>(mesh.points.rows()));
}

const ParametricPoint inner{ 0, 0.21, 0.33, 0.5 };

class AnyValence : public testing::TestWithParam<int>
{
};

TEST_P(AnyValence, PartitionOfUnity)
{
  const TriangleMesh mesh = bipyramid(GetParam());
  const BasisTable table = tabulate_rule(basis_of(mesh), triangle_rule(6), 2);
  for (int q = 0; q < table.rows(); ++q)
  {
    double sum[6] = {};
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
    {
      const double entry[] = { table.value[k] - (k == table.start[q]), table.du[k], table.dv[k],
        table.duu[k], table.duv[k], table.dvv[k] };
      for (int d = 0; d < 6; ++d)
        sum[d] += entry[d];
    }
    for (double s : sum)
      ASSERT_NEAR(s, 0, 1e-11);
  }
}

TEST_P(AnyValence, DerivativesAreThoseOfThePosition)
{
  const TriangleMesh mesh = bipyramid(GetParam());
  const LoopBasis basis = basis_of(mesh);
  const double h = 1e-5;
  std::vector<ParametricPoint> points{ inner };
  for (double du : { -h, h })
    points.push_back({ 0, inner.u + du, inner.v, 0.5 });
  for (double dv : { -h, h })
    points.push_back({ 0, inner.u, inner.v + dv, 0.5 });
  const BasisTable t = basis.tabulate(points);
  const int width = t.start[1];
  for (int k = 0; k < width; ++k)
  {
    const auto at = [&](const std::vector<double>& f, int row) { return f[row * width + k]; };
    EXPECT_NEAR(at(t.du, 0), (at(t.value, 2) - at(t.value, 1)) / (2 * h), 1e-8);
    EXPECT_NEAR(at(t.dv, 0), (at(t.value, 4) - at(t.value, 3)) / (2 * h), 1e-8);
    EXPECT_NEAR(at(t.duu, 0), (at(t.du, 2) - at(t.du, 1)) / (2 * h), 1e-7);
    EXPECT_NEAR(at(t.duv, 0), (at(t.dv, 2) - at(t.dv, 1)) / (2 * h), 1e-7);
    EXPECT_NEAR(at(t.dvv, 0), (at(t.dv, 4) - at(t.dv, 3)) / (2 * h), 1e-7);
  }
}

// The surface of a mesh and of the mesh subdivided once is the same surface: position and
// derivatives at the same points, corner vertices on P, in all four children.
TEST_P(AnyValence, SubdivisionDoesNotChangeTheSurface)
{
  const TriangleMesh mesh = bipyramid(GetParam()), fine = subdivided(mesh);
  const LoopBasis coarse_basis = basis_of(mesh), fine_basis = basis_of(fine);
  const double u = 0.3, v = 0.25;
  const ParametricPoint in_parent[] = { { 0, u / 2, v / 2, 0.5 }, { 0, (1 + u) / 2, v / 2, 0.5 },
    { 0, u / 2, (1 + v) / 2, 0.5 }, { 0, (1 - u) / 2, (1 - v) / 2, 0.5 } };
  for (int child = 0; child < 4; ++child)
  {
    const SurfacePoints a =
      evaluate(coarse_basis.tabulate(std::span(in_parent + child, 1)), mesh.points);
    const ParametricPoint in_child{ child, u, v, 0.5 };
    const SurfacePoints b = evaluate(fine_basis.tabulate(std::span(&in_child, 1)), fine.points);
    EXPECT_LT((a.position - b.position).norm(), 1e-13) << child;
    const double factor = child == 3 ? -0.5 : 0.5; // the child's parameters run twice as fast
    EXPECT_LT((factor * a.tangent_u - b.tangent_u).norm(), 1e-13) << child;
    EXPECT_LT((factor * a.tangent_v - b.tangent_v).norm(), 1e-13) << child;
  }
  const Points limit = coarse_basis.collocation() * mesh.points;
  const Points fine_limit = fine_basis.collocation() * fine.points;
  EXPECT_LT((limit - fine_limit.topRows(limit.rows())).norm(), 1e-13);
}

TEST_P(AnyValence, VertexNormalsAreTheLimitOfNearbyNormals)
{
  const TriangleMesh mesh = bipyramid(GetParam());
  const LoopBasis basis = basis_of(mesh);
  const Points normals = basis.vertex_normals(mesh.points);
  for (int e : { 0, 1 })
  {
    const ParametricPoint near_apex{ e, 5e-5, 1 - 1e-4, 0.5 };
    const SurfacePoints s = evaluate(basis.tabulate(std::span(&near_apex, 1)), mesh.points);
    const Vector3 n = s.cross.row(0).normalized().transpose();
    // The curvature may grow towards an extraordinary vertex, the normal converges all the same.
    EXPECT_LT((n - normals.row(mesh.triangles(e, 2)).transpose()).norm(), 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Valences, AnyValence, testing::Range(3, 13));

TEST(LoopBasis, RegularElementsHaveTwelveEntries)
{
  const TriangleMesh mesh = geodesic_sphere(6);
  const BasisTable table = tabulate_rule(basis_of(mesh), triangle_rule(1));
  int regular = 0;
  for (int q = 0; q < table.rows(); ++q)
    regular += table.start[q + 1] - table.start[q] == 12;
  EXPECT_EQ(regular, mesh.triangles.rows() - 60); // five at each of twelve vertices of valence five
}

TEST(LoopBasis, RefusesOpenMeshes)
{
  TriangleMesh open = geodesic_sphere(2);
  open.triangles.conservativeResize(open.triangles.rows() - 1, 3);
  EXPECT_THROW(basis_of(open), InputError);
}

// A smooth mesh whose vertices lie on a sphere: area and volume of the surface that passes through
// them.
TEST(LoopBasis, AreaAndVolumeOfASphere)
{
  double error[2][2];
  for (int level = 0; level < 2; ++level)
  {
    const TriangleMesh mesh = test::smooth_sphere(level == 0 ? 320 : 1280);
    const LoopBasis basis = basis_of(mesh);
    Eigen::SparseMatrix<double> P = basis.collocation();
    P.makeCompressed();
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(P);
    const Eigen::MatrixXd x = mesh.points;
    const Points control = Eigen::MatrixXd(lu.solve(x));
    const BasisTable table = tabulate_rule(basis, triangle_rule(6), 3);
    const SurfacePoints s = evaluate(table, control);
    error[level][0] = std::abs(area(s) / (4 * std::numbers::pi) - 1);
    error[level][1] = std::abs(volume(table, s) / (4 * std::numbers::pi / 3) - 1);
  }
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_LT(error[1][i], 1e-5);
    EXPECT_GT(test::order(error[0][i], error[1][i]), 2.5) << error[0][i] << " " << error[1][i];
  }
}

}
}
