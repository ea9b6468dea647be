// Ways of the fluid where its velocity is known.

#include "TestSurfaces.h"

#include "render/FlowWays.h"
#include "solver/Errors.h"
#include "solver/flow/FlowKinds.h"
#include "solver/flow/Rotation.h"
#include "solver/flow/Uniform.h"
#include "vtkfilters/Filters/SceneNumbers.h"

#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkVesicleSource.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

/// A sphere of radius 1 about `center` that exerts nothing and moves as the flow does.
vtkSmartPointer<vtkPolyData> sphere_in(const ImposedFlow& flow, const Vector3& center)
{
  vtkNew<vtkVesicleSource> source;
  source->SetShape(vtkVesicleSource::Sphere);
  source->SetCenter(center[0], center[1], center[2]);
  source->SetRadius(1);
  source->Update();
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(source->GetOutput());
  vtkNew<vtkDoubleArray> force, velocity;
  force->SetName("Membrane_Force");
  velocity->SetName("Velocity");
  for (auto* array : { force.Get(), velocity.Get() })
  {
    array->SetNumberOfComponents(3);
    surface->GetPointData()->AddArray(array);
  }
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const Vector3 u = flow.velocity_at(Eigen::Map<const Vector3>(surface->GetPoint(i)));
    velocity->InsertNextTuple(u.data());
    force->InsertNextTuple3(0, 0, 0);
  }
  Scene scene;
  scene.flow = flow.times(1);
  add_medium(scene, 0, surface->GetFieldData());
  return surface;
}

Rotation turning(double rate)
{
  return Rotation(rate, { 0, 1, 0 });
}

FlowPlane plane_about(const Point3& center)
{
  return { View::named("front"), center, 4, 3, true, nullptr };
}

constexpr double single = 1e-6; // the tracer's points have single precision

double radius(const Point3& x)
{
  return std::hypot(x[0], x[1]);
}

/// The angle from the first to the last point, seen from the centre.
double angle(const Way& way)
{
  const Point3 &a = way.front(), &b = way.back();
  return std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
}

void expect_arcs(const FlowWays& flow, double rate)
{
  // The end lies on a chord between two points, a quarter of a cell's diagonal apart.
  const double chord = flow.distance * std::sqrt(2) / 16;
  EXPECT_GT(flow.ways.size(), 100u);
  for (const Way& way : flow.ways)
  {
    const double r = radius(way.front());
    EXPECT_GT(r, 1); // outside
    EXPECT_NEAR(radius(way.back()), r, 1.01 * chord * chord / (8 * r) + single);
    EXPECT_NEAR(angle(way), -rate * flow.time, std::pow(chord / r, 3) + 3 * single);
  }
}

}

TEST(FlowWays, AreArcsWhereTheFluidTurns)
{
  const double rate = 0.7;
  const auto surface = sphere_in(turning(rate), Vector3::Zero());
  const FlowPlane plane = plane_about({});
  const double speed = largest_flow_speed(surface, plane);
  EXPECT_NEAR(speed, rate * std::hypot(4, 3), 0.1 * speed); // near the corners
  const FlowWays flow = flow_ways(surface, plane, speed);
  double longest = 0;
  for (const Way& way : flow.ways)
  {
    longest = std::max(longest, length_of(way));
  }
  EXPECT_NEAR(longest, speed * flow.time, 1e-3 * longest);
  expect_arcs(flow, rate);
}

TEST(FlowWays, FollowAFieldThatTheSurfaceDoesNotHold)
{
  const double rate = 0.7;
  auto surface = sphere_in(turning(rate), Vector3::Zero());
  FlowPlane plane = plane_about({});
  plane.field = turning(rate).times(1);
  add_number(surface->GetFieldData(), "Flow_Kind", static_cast<double>(flow_kinds().size())); // any
  expect_arcs(flow_ways(surface, plane, 4), rate);
}

TEST(FlowWays, AreThoseThatACameraSeesThatFollows)
{
  const Uniform flow({ 0.3, 0.1, 0.4 });
  const Vector3 center(5, 6, 7);
  const auto surface = sphere_in(flow, center);
  FlowPlane plane = plane_about({ center[0], center[1], center[2] });
  EXPECT_NEAR(largest_flow_speed(surface, plane), 0, 1e-12);
  plane.along = false;
  EXPECT_NEAR(largest_flow_speed(surface, plane), 0.5, 1e-12);
  const FlowWays ways = flow_ways(surface, plane, 0.5);
  EXPECT_GT(ways.ways.size(), 100u);
  for (const Way& way : ways.ways)
  {
    EXPECT_NEAR(way.back()[0] - way.front()[0], 0.3 * ways.time, single);
    EXPECT_NEAR(way.back()[1] - way.front()[1], 0.4 * ways.time, single);
  }
}

TEST(FlowWays, TakeASurfaceThatSaysHowTheFluidMoves)
{
  const auto message =
    message_of<InputError>([] { largest_flow_speed(make_surface(), plane_about({})); });
  EXPECT_NE(message.find("no flow lines"), std::string::npos) << message;
  EXPECT_NE(message.find("Viscosity"), std::string::npos) << message;
}

TEST(FlowWays, AreInThePictureAroundTheVesicle)
{
  const auto surface = sphere_in(turning(1), Vector3::Zero());
  PictureSettings settings;
  settings.color = "Velocity";
  settings.size = { 640, 360 };
  settings.flow_lines = true;
  Picture with(settings);
  with.draw(surface);
  settings.flow_lines = false;
  Picture without(settings);
  without.draw(surface);
  EXPECT_GT(with.camera_scale(), without.camera_scale());
  EXPECT_GT(difference(with.image(), without.image(), 0, 0.1), 0.01); // left of the vesicle
}
