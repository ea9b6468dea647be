#include "VelocityFieldData.h"

#include "VelocitySample.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/flow/FieldFlow.h"

#include "vtkDataSet.h"

#include <mutex>

namespace vesicle
{
namespace
{

constexpr const char* name = "the velocity field of the second input";

class VelocityFieldData final : public VelocityField
{
public:
  VelocityFieldData(vtkDataSet* data, std::string& notes) : sample_(copy_of(data), name)
  {
    const VelocitySample::Rates rates = sample_.rates();
    rate_ = rates.largest;
    notes = divergence_note(name, rates.divergence);
  }

  double largest_rate() const override { return rate_; }
  const std::vector<double>& times() const override { return times_; }

  Points velocities(const Points& points, double /*time*/) const override
  {
    Points result = Points::Zero(points.rows(), 3);
    const std::scoped_lock lock(mutex_);
    sample_.add(points, 1, result);
    return result;
  }

private:
  /// What comes after it in its pipeline may change the input's own.
  static vtkSmartPointer<vtkDataSet> copy_of(vtkDataSet* data)
  {
    vtkSmartPointer<vtkDataSet> copy = vtk::TakeSmartPointer(data->NewInstance());
    copy->ShallowCopy(data);
    return copy;
  }

  const std::vector<double> times_{ 0 };
  mutable std::mutex mutex_;
  mutable VelocitySample sample_;
  double rate_ = 0;
};

}

std::shared_ptr<const ImposedFlow> flow_with_field(
  const std::shared_ptr<const ImposedFlow>& scene_flow, vtkDataObject* data, std::string& notes)
{
  if (!data)
    return scene_flow;
  auto* field = vtkDataSet::SafeDownCast(data);
  if (!field)
    throw InputError(std::string(name) + ": is no image or grid; extract one of its blocks");
  if (scene_flow)
    throw InputError("there is a flow beside " + std::string(name) + "; choose one of them");
  auto flow = std::make_shared<FieldFlow>();
  flow->file = name;
  std::string told;
  flow->field = std::make_shared<const VelocityFieldData>(field, told);
  notes = lines({ notes, told });
  return flow;
}

}
