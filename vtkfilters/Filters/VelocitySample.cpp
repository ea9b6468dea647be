#include "VelocitySample.h"

#include "CellList.h"

#include "solver/Errors.h"
#include "solver/Joined.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGradientFilter.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/SVD>

#include <fmt/format.h>

#include <cmath>

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

/// Nothing follows a cell's number before it is known to be one of a point.
void check_cells(vtkUnstructuredGrid* grid, const std::string& name)
{
  const CellList cells(grid->GetCells(), "cells", name);
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (!types || types->GetNumberOfValues() != cells.size())
    fail(name, "hasn't a type for each of its cells", "write it anew");
  vtkNew<vtkGenericCell> form;
  for (std::int64_t i = 0; i < cells.size(); ++i)
  {
    form->SetCellType(types->GetValue(i));
    const auto points = static_cast<std::size_t>(form->GetNumberOfPoints()); // 0: any
    if (points > 0 && points != cells[i].size())
      fail(
        name, fmt::format("cell {} has {} points, not {}", i, cells[i].size(), points), "mend it");
    for (const std::int64_t point : cells[i])
      if (point < 0 || point >= grid->GetNumberOfPoints())
        fail(name, fmt::format("cell {} has a point {} that there isn't", i, point), "mend it");
  }
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
  if (data_->GetNumberOfPoints() == 0 || data_->GetNumberOfCells() == 0)
    fail(name_, "has no cells", "give an image or a grid with velocities");
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data_))
    check_cells(grid, name_);
  if (!velocity_in(data_->GetPointData()) && velocity_in(data_->GetCellData()))
  {
    vtkNew<vtkCellDataToPointData> to_points;
    to_points->SetInputData(data_);
    to_points->Update();
    data_ = to_points->GetOutput();
    data_->GetCellData()->Initialize();
  }
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
  filter->Update();
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
