// vesicle render: pictures and a film of a series or of meshes.

#include "apps/Commands.h"
#include "apps/Progress.h"

#include "render/Movie.h"
#include "solver/Errors.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SeriesFile.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVesicleCurvatureFilter.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <charconv>
#include <memory>

namespace vesicle
{
namespace
{

using std::filesystem::path;

struct RenderOptions
{
  std::vector<std::string> inputs;
  std::string folder;
  std::string color = "Mean_Curvature";
  std::vector<double> range;
  std::string size = "1280x720";
  std::string mp4;
};

std::array<int, 2> parse_size(const std::string& text)
{
  std::array<int, 2> size{};
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size[0]);
  const bool separated = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = separated ? std::from_chars(width.ptr + 1, end, size[1]) : width;
  if (!separated || height.ec != std::errc() || height.ptr != end || size[0] < 1 || size[1] < 1)
  {
    throw InputError(
      fmt::format("--size {}: give width and height in pixels, as in 1280x720", text));
  }
  return size;
}

std::vector<SeriesFrame> frames_of(const std::vector<std::string>& inputs)
{
  std::vector<SeriesFrame> frames;
  for (const path input : inputs)
  {
    if (is_series(input))
    {
      const auto series = read_series(input);
      frames.insert(frames.end(), series.begin(), series.end());
      continue;
    }
    require_mesh_ending(input);
    frames.push_back({ static_cast<double>(frames.size()), input });
  }
  return frames;
}

/// With its curvature, should the array to show be missing.
vtkSmartPointer<vtkPolyData> surface_of(const path& file, const std::string& color)
{
  const auto surface = read_mesh(file);
  if (surface->GetPointData()->HasArray(color.c_str()))
  {
    return surface;
  }
  const VtkMessages quiet;
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

int draw(const RenderOptions& options)
{
  spdlog::set_level(spdlog::level::warn);
  const auto frames = frames_of(options.inputs);
  std::vector<double> times;
  for (const auto& frame : frames)
  {
    times.push_back(frame.time);
  }
  MovieSettings settings;
  settings.picture.color = options.color;
  if (!options.range.empty())
  {
    settings.picture.range = { options.range[0], options.range[1] };
  }
  settings.picture.size = parse_size(options.size);
  settings.directory = options.folder;
  if (!options.mp4.empty())
  {
    settings.mp4 = options.mp4;
  }
  Progress progress(false, 0, {});
  settings.progress = [&](int done, int total) { progress.count("frame", done, total); };
  const auto report =
    make_movie([&](int i) { return surface_of(frames[i].file, options.color); }, times, settings);
  if (!report.note.empty())
  {
    progress.say(report.note);
  }
  return exit_code::done;
}

}

void add_render_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<RenderOptions>();
  auto* command = app.add_subcommand("render", "Pictures and a film of a series or of meshes");
  command->add_option("input", options->inputs, "Series (.pvd .vtu.series) or meshes, a frame each")
    ->required();
  command->add_option("-o,--output", options->folder, "Folder of the pictures")->required();
  command
    ->add_option("--color", options->color,
      "Point array to show; curvatures and the bending force are computed where missing")
    ->capture_default_str();
  command->add_option("--range", options->range, "Smallest and largest value of the colours")
    ->expected(2);
  command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  command->add_option("--mp4", options->mp4, "Film to write (takes the program ffmpeg)");
  command->footer(
    "Example: vesicle render pear/pear.pvd -o pictures --color Tension --mp4 pear.mp4");
  command->callback([options, &action] { action = [options] { return draw(*options); }; });
}

}
