#include "VelocitySample.h"

#include "CellList.h"
#include "VtkMessages.h"

#include "solver/Errors.h"
#include "solver/Joined.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGradientFilter.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkStaticCellLocator.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/SVD>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace vesicle
{
namespace
{

// A point this share of the field's diagonal outside still counts as in it.
constexpr double slack = 1e-6;
// Of the divergence in the velocity's gradient, on average: more is told.
constexpr double told_divergence = 0.05;
constexpr const char* velocity_name = "Velocity";

[[noreturn]] void fail(
  const std::string& name, const std::string& problem, const std::string& remedy)
{
  throw InputError(fmt::format("{}: {}; {}", name, problem, remedy));
}

/// The array that is the velocity, or nullptr.
vtkDataArray* velocity_in(vtkDataSetAttributes* arrays)
{
  if (vtkDataArray* active = arrays->GetVectors())
    return active;
  vtkDataArray* found = nullptr;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = arrays->GetArray(i); array && array->GetNumberOfComponents() == 3)
    {
      if (found)
        return nullptr;
      found = array;
    }
  return found;
}

std::string names_of(vtkDataSetAttributes* arrays)
{
  std::vector<std::string> names;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    if (const char* name = arrays->GetArrayName(i))
      names.emplace_back(name);
  return names.empty() ? "none" : joined(names, ", ");
}

/// Of forms with any number of points.
std::size_t fewest_points(int type)
{
  switch (type)
  {
    case VTK_POLY_LINE:
      return 2;
    case VTK_POLYGON:
    case VTK_TRIANGLE_STRIP:
      return 3;
    case VTK_POLYHEDRON:
      return 4;
    case VTK_QUADRATIC_POLYGON:
      return 6;
    default:
      return 1;
  }
}

/// VTK's forms by their numbers, which go up to 255. Not taken are those of any order, which have as many
/// points as that takes, and only VTK's own cells know how many; and convex sets of points, whose
/// derivatives VTK takes without a look at whether it could triangulate them.
class Forms
{
public:
  /// Points of each; 0: any.
  std::optional<std::size_t> points(int type)
  {
    if (!asked_[type])
    {
      asked_[type] = true;
      const auto form =
        type == VTK_EMPTY_CELL || type == VTK_CONVEX_POINT_SET || type >= VTK_HIGHER_ORDER_EDGE
        ? nullptr
        : vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
      if (form)
        points_[type] = static_cast<std::size_t>(form->GetNumberOfPoints());
    }
    return points_[type];
  }

private:
  std::array<bool, 256> asked_{};
  std::array<std::optional<std::size_t>, 256> points_;
};

/// Numbers of a polyhedron's faces, from `first` on.
void check_faces(std::span<const std::int64_t> faces, std::int64_t first, std::int64_t points,
  std::int64_t cell, const std::string& name)
{
  const auto wrong = [&]
  { fail(name, fmt::format("the faces of cell {} are damaged", cell), "write it anew"); };
  const auto size = static_cast<std::int64_t>(faces.size());
  std::int64_t at = first;
  const auto next = [&]
  {
    if (at < 0 || at >= size)
      wrong();
    return faces[at++];
  };
  const std::int64_t count = next();
  if (count < 4 || count > size)
    wrong();
  for (std::int64_t face = 0; face < count; ++face)
  {
    const std::int64_t corners = next();
    if (corners < 3 || corners > size - at)
      wrong();
    for (std::int64_t k = 0; k < corners; ++k)
      if (const std::int64_t point = next(); point < 0 || point >= points)
        fail(name, fmt::format("a face of cell {} has a point {} that there isn't", cell, point),
          "mend it");
  }
}

/// Nothing follows a cell's number before it is known to be one of a point.
void check_cells(vtkUnstructuredGrid* grid, const std::string& name)
{
  if (!grid->GetCells())
    return;
  const CellList cells(grid->GetCells(), "cells", name);
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (!types || types->GetNumberOfValues() != cells.size())
    fail(name, "hasn't a type for each of its cells", "write it anew");
  const auto numbers = [](vtkDataArray* array)
  { return array ? CellList::numbers(array) : std::vector<std::int64_t>(); };
  const std::vector<std::int64_t> faces = numbers(grid->GetFaces()),
                                  first_face = numbers(grid->GetFaceLocations());
  Forms forms;
  for (std::int64_t i = 0; i < cells.size(); ++i)
  {
    const int type = types->GetValue(i);
    const std::size_t corners = cells[i].size();
    const auto points = forms.points(type);
    if (!points)
      fail(name, fmt::format("cell {} is of type {}, which isn't taken", i, type),
        "cut it into tetrahedra (vtkDataSetTriangleFilter, ParaView's Tetrahedralize)");
    if (*points > 0 ? *points != corners : corners < fewest_points(type))
      fail(name, fmt::format("cell {} of type {} has {} points", i, type, corners), "mend it");
    for (const std::int64_t point : cells[i])
      if (point < 0 || point >= grid->GetNumberOfPoints())
        fail(name, fmt::format("cell {} has a point {} that there isn't", i, point), "mend it");
    if (type == VTK_POLYHEDRON)
      check_faces(faces, i < static_cast<std::int64_t>(first_face.size()) ? first_face[i] : -1,
        grid->GetNumberOfPoints(), i, name);
  }
}

/// Of grids whose points are numbered by their places along three axes: as many numbers as that takes.
void check_places(vtkDataSet* data, const std::string& name)
{
  const auto wrong = [&](vtkIdType there, vtkIdType needed)
  {
    fail(name, fmt::format("has {} places for the {} points of its dimensions", there, needed),
      "write it anew");
  };
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    vtkDataArray* along[] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    for (int axis = 0; axis < 3; ++axis)
      if (const vtkIdType there = along[axis] ? along[axis]->GetNumberOfTuples() : 0;
          there < grid->GetDimensions()[axis])
        wrong(there, grid->GetDimensions()[axis]);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    const int* n = structured->GetDimensions();
    const auto needed = static_cast<vtkIdType>(n[0]) * n[1] * n[2];
    if (structured->GetNumberOfPoints() != needed)
      wrong(structured->GetNumberOfPoints(), needed);
  }
  else if (auto* cells = vtkUnstructuredGrid::SafeDownCast(data))
    check_cells(cells, name);
  else if (!vtkImageData::SafeDownCast(data))
    fail(name, fmt::format("is a {}", data->GetClassName()),
      "give an image or a grid that fills a volume");
}

void check_finite(vtkDataArray* numbers, const std::string& name)
{
  for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfTuples(); ++i)
    for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
      if (!(std::abs(numbers->GetComponent(i, c)) <= greatest_coordinate))
        fail(name, fmt::format("place {} isn't finite", i), "write it anew");
}

/// An image has no more numbers than its bounds show.
void check_finite(vtkDataSet* data, const std::string& name)
{
  if (auto* points = vtkPointSet::SafeDownCast(data))
    check_finite(points->GetPoints()->GetData(), name);
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
    for (vtkDataArray* along :
      { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() })
      check_finite(along, name);
  else
    for (int i = 0; i < 6; ++i)
      if (!(std::abs(data->GetBounds()[i]) <= greatest_coordinate))
        fail(name, "its places aren't finite", "write it anew");
}

/// A field of cells brought to the points, alone: other arrays may be damaged.
vtkSmartPointer<vtkDataSet> at_points(
  vtkDataSet* data, vtkDataArray* of_cells, const std::string& name)
{
  if (of_cells->GetNumberOfTuples() != data->GetNumberOfCells())
    fail(name,
      fmt::format(
        "has {} velocities for {} cells", of_cells->GetNumberOfTuples(), data->GetNumberOfCells()),
      "give every cell one");
  vtkSmartPointer<vtkDataSet> alone = vtk::TakeSmartPointer(data->NewInstance());
  alone->CopyStructure(data);
  alone->GetCellData()->AddArray(of_cells);
  vtkNew<vtkCellDataToPointData> to_points;
  to_points->SetInputData(alone);
  to_points->Update();
  vtkSmartPointer<vtkDataSet> result = to_points->GetOutput();
  result->GetCellData()->Initialize();
  return result;
}

}

std::string divergence_note(const std::string& name, double divergence)
{
  if (divergence <= told_divergence)
    return "";
  return fmt::format("{}: the velocity field isn't free of divergence, which is {:.0f}% of its "
                     "gradient on average: a vesicle keeps its volume all the same",
    name, 100 * divergence);
}

VelocitySample::VelocitySample(vtkSmartPointer<vtkDataSet> data, std::string name)
  : name_(std::move(name)), data_(std::move(data))
{
  check_places(data_, name_);
  if (data_->GetNumberOfPoints() == 0 || data_->GetNumberOfCells() == 0)
    fail(name_, "has no cells", "give an image or a grid with velocities");
  check_finite(data_, name_);
  vtkDataArray* of_cells = velocity_in(data_->GetCellData());
  if (of_cells && !velocity_in(data_->GetPointData()))
    data_ = at_points(data_, of_cells, name_);
  velocity_ = velocity_in(data_->GetPointData());
  if (!velocity_ || velocity_->GetNumberOfComponents() != 3)
    fail(name_,
      fmt::format("doesn't say which of its arrays is the velocity (of points: {})",
        names_of(data_->GetPointData())),
      "keep one array of three components, or make it the active vectors");
  if (velocity_->GetNumberOfTuples() != data_->GetNumberOfPoints())
    fail(name_,
      fmt::format("has {} velocities for {} points", velocity_->GetNumberOfTuples(),
        data_->GetNumberOfPoints()),
      "give every point one");
  for (vtkIdType i = 0; i < velocity_->GetNumberOfTuples(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!std::isfinite(velocity_->GetComponent(i, c)))
        fail(
          name_, fmt::format("the velocity of point {} is not finite", i), "give every point one");
  data_->ComputeBounds();
  tolerance_ = std::pow(slack * data_->GetLength(), 2);
  if (vtkPointSet::SafeDownCast(data_))
  {
    locator_ = vtkSmartPointer<vtkStaticCellLocator>::New();
    locator_->SetDataSet(data_);
    locator_->BuildLocator();
  }
  weights_.resize(data_->GetMaxCellSize());
}

void VelocitySample::add(const Points& points, double factor, Points& velocities)
{
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    double x[3] = { points(i, 0), points(i, 1), points(i, 2) }, in_cell[3];
    int piece = 0;
    const vtkIdType number = locator_
      ? locator_->FindCell(x, tolerance_, cell_, in_cell, weights_.data())
      : data_->FindCell(x, nullptr, cell_, -1, tolerance_, piece, in_cell, weights_.data());
    if (number < 0)
      leave(x);
    data_->GetCell(number, cell_);
    for (vtkIdType k = 0; k < cell_->GetNumberOfPoints(); ++k)
    {
      double u[3];
      velocity_->GetTuple(cell_->GetPointId(k), u);
      for (int c = 0; c < 3; ++c)
        velocities(i, c) += factor * weights_[k] * u[c];
    }
  }
}

VelocitySample::Rates VelocitySample::rates() const
{
  vtkNew<vtkGradientFilter> filter;
  vtkSmartPointer<vtkDataSet> named = vtk::TakeSmartPointer(data_->NewInstance());
  named->CopyStructure(data_);
  vtkSmartPointer<vtkDataArray> velocity = vtk::TakeSmartPointer(velocity_->NewInstance());
  velocity->DeepCopy(velocity_);
  velocity->SetName(velocity_name);
  named->GetPointData()->AddArray(velocity);
  filter->SetInputData(named);
  filter->SetInputScalars(vtkDataObject::FIELD_ASSOCIATION_POINTS, velocity_name);
  filter->SetResultArrayName("Gradient");
  {
    const VtkMessages messages;
    filter->Update();
    if (messages.any_error())
      fail(name_, "a cell has no gradient: " + messages.first_error(), "mend it");
  }
  vtkDataArray* gradients =
    vtkDataSet::SafeDownCast(filter->GetOutput())->GetPointData()->GetArray("Gradient");
  Rates rates;
  double sum = 0, divergence = 0;
  for (vtkIdType i = 0; i < gradients->GetNumberOfTuples(); ++i)
  {
    Eigen::Matrix3d gradient;
    gradients->GetTuple(i, gradient.data());
    const double rate = Eigen::JacobiSVD<Eigen::Matrix3d>(gradient).singularValues()[0];
    rates.largest = std::max(rates.largest, rate);
    sum += rate;
    divergence += std::abs(gradient.trace());
  }
  rates.divergence = sum > 0 ? divergence / sum : 0;
  return rates;
}

void VelocitySample::leave(const double x[3]) const
{
  const double* b = data_->GetBounds();
  throw NumericalError(fmt::format(
    "({:.4g}, {:.4g}, {:.4g}) isn't in the velocity field {} (x {:.4g} to {:.4g}, y {:.4g} to "
    "{:.4g}, z {:.4g} to {:.4g})",
    x[0], x[1], x[2], name_, b[0], b[1], b[2], b[3], b[4], b[5]));
}

}
