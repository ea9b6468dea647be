#include "VelocitySample.h"

#include "GridCheck.h"
#include "VtkMessages.h"

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
  check_grid(data_, name_);
  if (data_->GetNumberOfPoints() == 0 || data_->GetNumberOfCells() == 0)
    fail(name_, "has no cells", "give an image or a grid with velocities");
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
