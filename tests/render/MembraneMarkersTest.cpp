// Markers go with the membrane where its motion is known.

#include "TestSurfaces.h"

#include "render/MembraneMarkers.h"
#include "render/Movie.h"
#include "solver/Errors.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkAppendPolyData.h"
#include "vtkFieldData.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

const Vector3 axes(1.4, 1, 0.8), drift(3, -2, 1);

/// A motion of points of the unit sphere, and the velocity of what is at one.
struct Motion
{
  virtual ~Motion() = default;
  virtual Vector3 place(const Vector3& x, double time) const = 0;
  virtual Vector3 velocity(const Vector3& x, double time) const = 0;
  /// Its nodes stay with the shape (true), or with the membrane.
  virtual Vector3 node(const Vector3& x, double time) const { return place(x, time); }
  virtual Vector3 node_velocity(const Vector3& x, double time) const { return velocity(x, time); }
};

Vector3 turned(const Vector3& x, double angle)
{
  return Eigen::AngleAxisd(angle, Vector3::UnitY()) * x;
}

/// An ellipsoid whose membrane runs around in it while it drifts, as tank-treading does:
/// x = A R(ωt) x0. The nodes don't run with it.
struct Treading final : Motion
{
  double rate = 1.3;
  Vector3 place(const Vector3& x, double time) const override
  {
    return axes.cwiseProduct(turned(x, rate * time)) + time * drift;
  }
  Vector3 velocity(const Vector3& x, double time) const override
  {
    return axes.cwiseProduct(rate * Vector3::UnitY().cross(turned(x, rate * time))) + drift;
  }
  Vector3 node(const Vector3& x, double time) const override
  {
    return axes.cwiseProduct(x) + time * drift;
  }
  Vector3 node_velocity(const Vector3& x, double) const override { return velocity(x, 0); }
};

/// The same ellipsoid, tumbling as a solid.
struct Tumbling final : Motion
{
  double rate = 1.3;
  Vector3 place(const Vector3& x, double time) const override
  {
    return turned(axes.cwiseProduct(x), rate * time) + time * drift;
  }
  Vector3 velocity(const Vector3& x, double time) const override
  {
    return rate * Vector3::UnitY().cross(turned(axes.cwiseProduct(x), rate * time)) + drift;
  }
};

vtkSmartPointer<vtkPolyData> surface_at(const Motion& motion, double time)
{
  TriangleMesh mesh = geodesic_sphere(8);
  Points velocities(mesh.points.rows(), 3);
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
  {
    const Vector3 x = mesh.points.row(i).transpose().normalized();
    mesh.points.row(i) = motion.node(x, time).transpose();
    velocities.row(i) = motion.node_velocity(x, time).transpose();
  }
  const auto surface = to_polydata(mesh);
  surface->GetPointData()->AddArray(to_array("Velocity", Eigen::MatrixXd(velocities)));
  return surface;
}

/// How far the markers are from where the motion takes them by time 2 in so many frames.
double error(const Motion& motion, int frames)
{
  MembraneMarkers markers(20);
  std::vector<Vector3> starts;
  double largest = 0;
  for (int k = 0; k <= frames; ++k)
  {
    const double time = 2. * k / frames;
    const auto places = markers.at(surface_at(motion, time), time);
    EXPECT_EQ(places.size(), 20u);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const Vector3 x = vector_of(places[i]);
      if (k == 0)
      {
        starts.push_back(x.cwiseQuotient(axes).normalized());
      }
      largest = std::max(largest, (x - motion.place(starts[i], time)).norm());
    }
  }
  return largest;
}

}

TEST(MembraneMarkers, RunAroundAShapeThatStays)
{
  // The field of velocities is steady: the time between frames doesn't matter, the triangles do.
  const double often = error(Treading{}, 20), seldom = error(Treading{}, 2);
  EXPECT_LT(often, 2e-3);
  EXPECT_LT(seldom, 2e-3);
}

TEST(MembraneMarkers, TumbleWithAnErrorOfSecondOrder)
{
  const double coarse = error(Tumbling{}, 8), fine = error(Tumbling{}, 16);
  EXPECT_LT(fine, 0.02);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.4);
}

TEST(MembraneMarkers, GoWithTheirVesicle)
{
  const auto pair = [](double time)
  {
    const auto a = surface_at(Treading{}, time), b = surface_at(Tumbling{}, time);
    for (vtkIdType i = 0; i < b->GetNumberOfPoints(); ++i)
    {
      const Vector3 x = Eigen::Map<const Vector3>(b->GetPoint(i)) + Vector3(0, 2.1, 0);
      b->GetPoints()->SetPoint(i, x.data());
    }
    vtkNew<vtkAppendPolyData> both;
    both->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    both->AddInputData(a);
    both->AddInputData(b);
    both->Update();
    return vtkSmartPointer<vtkPolyData>(both->GetOutput());
  };
  MembraneMarkers markers(10);
  const auto start = markers.at(pair(0), 0), end = markers.at(pair(0.1), 0.1);
  ASSERT_EQ(start.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i)
  {
    const Vector3 to = i < 10 ? Vector3(0, 0, 0) : Vector3(0, 2.1, 0);
    const Vector3 x = (vector_of(start[i]) - to).cwiseQuotient(axes).normalized();
    const Vector3 there = i < 10 ? Treading{}.place(x, 0.1) : Tumbling{}.place(x, 0.1);
    EXPECT_LT((vector_of(end[i]) - to - there).norm(), 1e-3);
  }
}

TEST(MembraneMarkers, TakeVelocitiesAndTheSameVesicles)
{
  MembraneMarkers markers(5);
  const auto bare = to_polydata(geodesic_sphere(2));
  EXPECT_NE(
    message_of<InputError>([&] { markers.at(bare, 0); }).find("Velocity"), std::string::npos);
  EXPECT_EQ(markers.at(surface_at(Treading{}, 0), 0).size(), 5u);
  vtkNew<vtkAppendPolyData> two;
  two->AddInputData(surface_at(Treading{}, 0));
  two->AddInputData(surface_at(Treading{}, 3));
  two->Update();
  EXPECT_NE(message_of<InputError>([&] { markers.at(two->GetOutput(), 1); }).find("1 vesicles"),
    std::string::npos);
}

TEST(MembraneMarkers, AreInTheMovie)
{
  const TemporaryFolder folder;
  const auto frame = [](int i)
  {
    const auto surface = surface_at(Treading{}, 0.3 * i);
    surface->GetFieldData()->AddArray(
      to_array("TimeValue", Eigen::MatrixXd::Constant(1, 1, 0.3 * i)));
    return surface;
  };
  MovieSettings settings;
  settings.picture.color = "Velocity";
  settings.picture.size = { 320, 180 };
  const auto pictures = [&](int count, const char* name)
  {
    settings.markers = count;
    settings.directory = folder / name;
    make_movie(frame, { 0, 0.3 }, settings);
    return read_png(settings.directory / "frame_000001.png");
  };
  EXPECT_GT(difference(pictures(40, "with"), pictures(0, "without")), 0.003);
}
