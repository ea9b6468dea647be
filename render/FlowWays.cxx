#include "render/FlowWays.h"

#include "render/SurfaceMeasures.h"
#include "solver/Errors.h"
#include "solver/flow/ImposedFlow.h"
#include "vtkfilters/Filters/SceneNumbers.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamTracer.h"
#include "vtkVesicleProbeFilter.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vesicle
{
namespace
{

constexpr int rows = 10; // of lines, each shifted by half a distance against the last
/// Cells of the image of velocities from one start to the next, which then are points of it.
constexpr int cells_between = 4;
constexpr double longest = 0.95;  // way, in distances between their starts
constexpr double shortest = 0.12; // that is worth drawing, likewise

/// The starts are a pattern of equal distances that fills the plane.
struct Pattern
{
  explicit Pattern(const FlowPlane& plane)
    : distance(2 * plane.half_height / rows),
      columns(std::max(1, static_cast<int>(std::round(2 * plane.half_width / distance))))
  {
  }
  double distance;
  int columns;
};

/// Points of a vesicle's plane in space.
vtkSmartPointer<vtkPolyData> in_space(const FlowPlane& plane, vtkDataSet* flat)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    flat->GetPoint(i, p.data());
    Point3 x = plane.center;
    for (int k = 0; k < 3; ++k)
    {
      x[k] += p[0] * plane.view.right[k] + p[1] * plane.view.up[k];
    }
    points->InsertNextPoint(x.data());
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  return cloud;
}

/// What the vesicle and the flow that it says do at the points, and where they are inside of it.
vtkSmartPointer<vtkPointData> probed(vtkPolyData* surface, vtkPolyData* points)
{
  const VtkMessages messages;
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(points);
  probe->SetSourceData(surface);
  probe->Update();
  if (messages.any_error())
  {
    throw InputError("no flow lines: " + messages.first_error());
  }
  return probe->GetOutput()->GetPointData();
}

/// The surface in a fluid at rest.
vtkSmartPointer<vtkPolyData> at_rest(vtkPolyData* surface)
{
  auto alone = vtkSmartPointer<vtkPolyData>::New();
  alone->ShallowCopy(surface);
  add_number(alone->GetFieldData(), "Flow_Kind", 0);
  return alone;
}

/// Nothing outside the field.
std::optional<Vector3> velocity_in(const ImposedFlow& field, const double* x)
{
  try
  {
    return field.velocity_at(Eigen::Map<const Vector3>(x));
  }
  catch (const NumericalError&)
  {
    return std::nullopt;
  }
}

/// Adds the field's velocities. Where it has none the fluid counts as at rest and as inside, so that
/// no way starts there.
void add_field(
  const ImposedFlow& field, vtkPolyData* points, vtkDataArray* velocity, vtkDataArray* inside)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vector3 u;
    velocity->GetTuple(i, u.data());
    const auto given = velocity_in(field, points->GetPoint(i));
    u = given ? Vector3(u + *given) : Vector3::Zero();
    velocity->SetTuple(i, u.data());
    inside->SetComponent(i, 0, given ? inside->GetComponent(i, 0) : 1);
  }
}

/// The fluid's velocity at the points of a data set of the plane, as its active vectors, and the
/// array Inside.
void add_velocity(vtkPolyData* surface, const FlowPlane& plane, vtkDataSet* flat)
{
  const auto points = in_space(plane, flat);
  const auto found = probed(plane.field ? at_rest(surface).Get() : surface, points);
  vtkDataArray* velocity = found->GetArray("Velocity");
  if (plane.field)
  {
    add_field(*plane.field, points, velocity, found->GetArray("Inside"));
  }
  const Point3 drift = plane.along
    ? centroid_velocity(surface, finite_vectors(surface, "Velocity", "flow lines"))
    : Point3{};
  vtkNew<vtkDoubleArray> seen;
  seen->SetName("Velocity");
  seen->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < velocity->GetNumberOfTuples(); ++i)
  {
    Point3 u;
    velocity->GetTuple(i, u.data());
    vtkMath::Subtract(u.data(), drift.data(), u.data());
    seen->InsertNextTuple3(vtkMath::Dot(u.data(), plane.view.right.data()),
      vtkMath::Dot(u.data(), plane.view.up.data()), 0);
  }
  flat->GetPointData()->SetVectors(seen);
  flat->GetPointData()->AddArray(found->GetArray("Inside"));
}

vtkSmartPointer<vtkImageData> image_of(const Pattern& pattern)
{
  const double step = pattern.distance / cells_between;
  const int around = static_cast<int>(longest * cells_between) + 1; // lines may leave the picture
  const int wide = pattern.columns * cells_between + 2 * around,
            high = rows * cells_between + 2 * around;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(wide + 1, high + 1, 1);
  image->SetSpacing(step, step, step);
  image->SetOrigin(-wide * step / 2, -high * step / 2, 0);
  return image;
}

vtkSmartPointer<vtkPolyData> starts_of(const Pattern& pattern)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int j = 0; j < rows; ++j)
  {
    const double shift = j % 2 == 0 ? 0.25 : -0.25;
    for (int i = 0; i < pattern.columns; ++i)
    {
      points->InsertNextPoint((i + 0.5 + shift - 0.5 * pattern.columns) * pattern.distance,
        (j + 0.5 - 0.5 * rows) * pattern.distance, 0);
    }
  }
  auto starts = vtkSmartPointer<vtkPolyData>::New();
  starts->SetPoints(points);
  return starts;
}

/// The starts in the fluid outside.
vtkSmartPointer<vtkPolyData> outside(const Pattern& pattern, vtkImageData* image)
{
  vtkDataArray* inside = image->GetPointData()->GetArray("Inside");
  const auto starts = starts_of(pattern);
  vtkNew<vtkPoints> kept;
  kept->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < starts->GetNumberOfPoints(); ++i)
  {
    if (inside->GetComponent(image->FindPoint(starts->GetPoint(i)), 0) == 0)
    {
      kept->InsertNextPoint(starts->GetPoint(i));
    }
  }
  starts->SetPoints(kept);
  return starts;
}

/// The lines from these starts, as far as `length`; the point array IntegrationTime is what the fluid
/// takes.
vtkSmartPointer<vtkPolyData> traced(vtkImageData* image, vtkPolyData* starts, double length)
{
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputData(image);
  tracer->SetSourceData(starts);
  tracer->SetIntegratorTypeToRungeKutta4();
  tracer->SetIntegrationStepUnit(vtkStreamTracer::CELL_LENGTH_UNIT);
  tracer->SetInitialIntegrationStep(0.25);
  tracer->SetMaximumPropagation(length);
  tracer->SetComputeVorticity(false);
  tracer->Update();
  return tracer->GetOutput();
}

/// One line as far as the fluid goes within a time.
Way cut(vtkPolyData* lines, vtkIdType count, const vtkIdType* ids, double time)
{
  vtkDataArray* times = lines->GetPointData()->GetArray("IntegrationTime");
  Way way;
  for (vtkIdType k = 0; k < count; ++k)
  {
    Point3 x;
    lines->GetPoint(ids[k], x.data());
    const double now = times->GetComponent(ids[k], 0);
    if (now > time)
    {
      const double before = times->GetComponent(ids[k - 1], 0);
      const double share = (time - before) / (now - before);
      for (int c = 0; c < 3; ++c)
      {
        x[c] = way.back()[c] + share * (x[c] - way.back()[c]);
      }
      way.push_back(x);
      break;
    }
    way.push_back(x);
  }
  return way;
}

}

double length_of(const Way& way)
{
  double length = 0;
  for (std::size_t k = 1; k < way.size(); ++k)
  {
    length += std::sqrt(vtkMath::Distance2BetweenPoints(way[k - 1].data(), way[k].data()));
  }
  return length;
}

FlowWays flow_ways(vtkPolyData* surface, const FlowPlane& plane, double speed)
{
  const Pattern pattern(plane);
  const auto image = image_of(pattern);
  add_velocity(surface, plane, image);
  const double reach = longest * pattern.distance;
  FlowWays all{ {}, reach / speed, pattern.distance };
  const auto lines = traced(image, outside(pattern, image), reach);
  auto cells = vtk::TakeSmartPointer(lines->GetLines()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    auto way = cut(lines, count, ids, all.time);
    if (length_of(way) > shortest * pattern.distance)
    {
      all.ways.push_back(std::move(way));
    }
  }
  return all;
}

double largest_flow_speed(vtkPolyData* surface, const FlowPlane& plane)
{
  const auto starts = starts_of(Pattern(plane));
  add_velocity(surface, plane, starts);
  vtkDataArray* velocity = starts->GetPointData()->GetVectors();
  vtkDataArray* inside = starts->GetPointData()->GetArray("Inside");
  double largest = 0;
  for (vtkIdType i = 0; i < velocity->GetNumberOfTuples(); ++i)
  {
    if (inside->GetComponent(i, 0) == 0)
    {
      largest = std::max(largest, vtkMath::Norm(velocity->GetTuple3(i)));
    }
  }
  return largest;
}

}
