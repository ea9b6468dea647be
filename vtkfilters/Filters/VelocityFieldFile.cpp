#include "VelocityFieldFile.h"

#include "SeriesFile.h"
#include "VtkMessages.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/files/FileBytes.h"
#include "solver/flow/FieldFlow.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataSet.h"
#include "vtkDataSetReader.h"
#include "vtkGenericCell.h"
#include "vtkGradientFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"
#include "vtkXMLGenericDataObjectReader.h"

#include <Eigen/SVD>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

namespace vesicle
{
namespace
{

using std::filesystem::path;

// A point this share of the field's diagonal outside still counts as in it.
constexpr double slack = 1e-6;
// Of the divergence in the velocity's gradient, on average: more is told.
constexpr double told_divergence = 0.05;
constexpr const char* velocity_name = "Velocity";

[[noreturn]] void fail(const path& file, const std::string& problem, const std::string& remedy)
{
  throw InputError(fmt::format("{}: {}; {}", file.string(), problem, remedy));
}

vtkSmartPointer<vtkDataSet> read_data_set(const path& file)
{
  static const std::array<std::string, 5> endings{ ".vti", ".vtr", ".vts", ".vtu", ".vtk" };
  if (std::find(endings.begin(), endings.end(), file.extension()) == endings.end())
    fail(file, "is no file of a velocity field", "take .vti .vtr .vts .vtu .vtk .pvd or .series");
  if (!is_file(file))
    fail(file, "can't be read", "give the path of a velocity field, from the scene's folder");
  const VtkMessages messages;
  vtkSmartPointer<vtkDataSet> data;
  if (file.extension() == ".vtk")
  {
    vtkNew<vtkDataSetReader> reader;
    reader->SetFileName(file.c_str());
    reader->ReadAllVectorsOn();
    reader->Update();
    data = reader->GetOutput();
  }
  else
  {
    vtkNew<vtkXMLGenericDataObjectReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    data = vtkDataSet::SafeDownCast(reader->GetOutput());
  }
  if (messages.any_error())
    fail(file, messages.first_error(), "write it anew");
  if (!data || data->GetNumberOfPoints() == 0 || data->GetNumberOfCells() == 0)
    fail(file, "has no cells", "give an image or a grid with velocities");
  return data;
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

/// One moment of a field: a data set whose points have velocities.
class Sample
{
public:
  explicit Sample(const path& file) : file_(file), data_(read_data_set(file))
  {
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
      fail(file,
        fmt::format("doesn't say which of its arrays is the velocity (of points: {})",
          names_of(data_->GetPointData())),
        "keep one array of three components, or make it the active vectors");
    for (vtkIdType i = 0; i < velocity_->GetNumberOfTuples(); ++i)
      for (int c = 0; c < 3; ++c)
        if (!std::isfinite(velocity_->GetComponent(i, c)))
          fail(
            file, fmt::format("the velocity of point {} is not finite", i), "give every point one");
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

  const path& file() const { return file_; }

  void add(const Points& points, double factor, Points& velocities)
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

  struct Rates
  {
    double largest = 0;    ///< of the gradient's largest singular value
    double divergence = 0; ///< mean of |∇·u| over that of the singular value
  };

  Rates rates() const
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

private:
  [[noreturn]] void leave(const double x[3]) const
  {
    const double* b = data_->GetBounds();
    throw NumericalError(fmt::format(
      "({:.4g}, {:.4g}, {:.4g}) isn't in the velocity field {} (x {:.4g} to {:.4g}, y {:.4g} to "
      "{:.4g}, z {:.4g} to {:.4g})",
      x[0], x[1], x[2], file_.string(), b[0], b[1], b[2], b[3], b[4], b[5]));
  }

  path file_;
  vtkSmartPointer<vtkDataSet> data_;
  vtkSmartPointer<vtkDataArray> velocity_;
  vtkSmartPointer<vtkStaticCellLocator> locator_; ///< of points without a structure
  double tolerance_ = 0;
  vtkNew<vtkGenericCell> cell_;
  std::vector<double> weights_;
};

class VelocityFieldFile final : public VelocityField
{
public:
  VelocityFieldFile(const path& file, std::string& notes)
  {
    if (is_series(file))
      for (const SeriesFrame& frame : read_series(file))
      {
        if (!times_.empty() && !(frame.time > times_.back()))
          fail(file, fmt::format("time {} comes after {}", frame.time, times_.back()),
            "list the files by their times");
        times_.push_back(frame.time);
        files_.push_back(frame.file);
      }
    else
    {
      times_ = { 0 };
      files_ = { file };
    }
    double divergence = 0;
    for (const path& each : files_)
    {
      const Sample::Rates rates = sample(each).rates();
      rate_ = std::max(rate_, rates.largest);
      divergence = std::max(divergence, rates.divergence);
    }
    if (divergence > told_divergence)
      notes =
        fmt::format("{}: the velocity field isn't free of divergence, which is {:.0f}% of its "
                    "gradient on average: a vesicle keeps its volume all the same",
          file.string(), 100 * divergence);
  }

  double largest_rate() const override { return rate_; }
  const std::vector<double>& times() const override { return times_; }

  Points velocities(const Points& points, double time) const override
  {
    const auto after = std::upper_bound(times_.begin(), times_.end(), time);
    const auto next = static_cast<std::size_t>(after - times_.begin());
    Points result = Points::Zero(points.rows(), 3);
    const std::scoped_lock lock(mutex_);
    if (next == 0 || next == times_.size())
    {
      sample(files_[next == 0 ? 0 : next - 1]).add(points, 1, result);
      return result;
    }
    const double share = (time - times_[next - 1]) / (times_[next] - times_[next - 1]);
    sample(files_[next - 1]).add(points, 1 - share, result);
    sample(files_[next]).add(points, share, result);
    return result;
  }

private:
  // The two that were asked for last are kept.
  Sample& sample(const path& file) const
  {
    auto found = std::find_if(
      kept_.begin(), kept_.end(), [&](const auto& kept) { return kept->file() == file; });
    if (found == kept_.end())
    {
      if (kept_.size() == 2)
        kept_.erase(kept_.begin());
      kept_.push_back(std::make_unique<Sample>(file));
      found = kept_.end() - 1;
    }
    else if (found != kept_.end() - 1)
      std::swap(*found, kept_.back());
    return *kept_.back();
  }

  std::vector<double> times_;
  std::vector<path> files_;
  double rate_ = 0;
  mutable std::mutex mutex_; ///< VTK's cells and locators are for one thread
  mutable std::vector<std::unique_ptr<Sample>> kept_;
};

}

std::shared_ptr<const VelocityField> read_velocity_field(const path& file, std::string& notes)
{
  return std::make_shared<const VelocityFieldFile>(file, notes);
}

Scene with_velocity_field(Scene scene, std::string& notes)
{
  const auto* flow = dynamic_cast<const FieldFlow*>(scene.flow.get());
  if (!flow || flow->field)
    return scene;
  auto read = std::make_shared<FieldFlow>(*flow);
  read->field = read_velocity_field(flow->file, notes);
  scene.flow = read;
  return scene;
}

}
