#include "VelocityFieldFile.h"

#include "GridConversion.h"
#include "SeriesFile.h"
#include "VelocitySample.h"
#include "XmlGridFile.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/flow/FieldFlow.h"
#include "solver/mesh/io/LegacyVtkFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <mutex>

namespace vesicle
{
namespace
{

using std::filesystem::path;

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
  const GridFile grid = file.extension() == ".vtk"
    ? read_legacy_vtk_grid(read_file(file), file.string())
    : read_xml_grid(file);
  return to_data_set(grid, file.string());
}

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
      const VelocitySample::Rates rates = sample(each).rates();
      rate_ = std::max(rate_, rates.largest);
      divergence = std::max(divergence, rates.divergence);
    }
    notes = divergence_note(file.string(), divergence);
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
  VelocitySample& sample(const path& file) const
  {
    auto found = std::find_if(
      kept_.begin(), kept_.end(), [&](const auto& kept) { return kept->name() == file.string(); });
    if (found == kept_.end())
    {
      if (kept_.size() == 2)
        kept_.erase(kept_.begin());
      kept_.push_back(std::make_unique<VelocitySample>(read_data_set(file), file.string()));
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
  mutable std::vector<std::unique_ptr<VelocitySample>> kept_;
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
