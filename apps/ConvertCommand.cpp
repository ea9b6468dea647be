// vesicle convert: meshes and series of them from one format to another.

#include "apps/Commands.h"
#include "apps/FoundRun.h"
#include "apps/StandardOutput.h"
#include "apps/Warning.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SeriesFile.h"
#include "vtkfilters/Filters/SeriesWriter.h"

#include "vtkPolyData.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

namespace vesicle
{
namespace
{

using std::filesystem::path;

struct ConvertOptions
{
  std::vector<std::string> inputs;
  std::string output;
  std::vector<double> times;
  bool overwrite = false;
};

/// A series, a run's, or meshes at times 0, 1, 2 …
std::vector<SeriesFrame> frames_of(const std::vector<std::string>& inputs)
{
  std::vector<SeriesFrame> frames;
  for (const path input : inputs)
  {
    const bool run = is_folder(input);
    if (run || is_series(input))
    {
      const auto of_it = run ? run_in(input).frames : read_series(input);
      frames.insert(frames.end(), of_it.begin(), of_it.end());
      continue;
    }
    require_mesh_ending(input);
    frames.push_back({ static_cast<double>(frames.size()), input });
  }
  if (frames.empty())
  {
    throw InputError(inputs.front() + ": there are no frames to convert");
  }
  return frames;
}

void set_times(const std::vector<double>& times, std::vector<SeriesFrame>& frames)
{
  if (!times.empty() && times.size() != frames.size())
  {
    throw InputError(fmt::format(
      "--times: {} times for {} frames; give one a frame", times.size(), frames.size()));
  }
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    frames[i].time = times[i];
  }
  const auto later = [](const SeriesFrame& l, const SeriesFrame& r) { return l.time >= r.time; };
  if (std::adjacent_find(frames.begin(), frames.end(), later) != frames.end())
  {
    throw InputError("the frames' times don't ascend; give others by --times");
  }
}

void require_free(const path& file, bool overwrite)
{
  if (!overwrite && is_there(file))
  {
    throw InputError(
      file.string() + ": is there already; replace it by --overwrite, or choose another name");
  }
}

/// NAME of NAME.pvd and NAME.vtu.series.
std::string series_name(const path& file)
{
  path name = file.filename();
  name.replace_extension();
  return name.extension() == ".vtu" ? name.stem().string() : name.string();
}

int write_series(const std::vector<SeriesFrame>& frames, const path& file, bool overwrite)
{
  SeriesWriter series(file.parent_path(), series_name(file));
  for (const path& list : { series.pvd_file(), series.series_file(), series.xdmf_file() })
  {
    require_free(list, overwrite);
  }
  for (const SeriesFrame& frame : frames)
  {
    series.append(read_mesh(frame.file), frame.time);
  }
  print("{}, {}, {}: {} frames\n", series.pvd_file().string(), series.series_file().string(),
    series.xdmf_file().string(), frames.size());
  return exit_code::done;
}

/// NAME_000000.stl, … of NAME.stl.
path numbered(const path& file, std::size_t number)
{
  return file.parent_path() /
    fmt::format("{}_{:06}{}", file.stem().string(), number, file.extension().string());
}

int write_meshes(const std::vector<SeriesFrame>& frames, const path& file, bool overwrite)
{
  require_mesh_ending(file);
  std::vector<path> targets{ file };
  for (std::size_t i = 0; frames.size() > 1 && i < frames.size(); ++i)
  {
    targets.resize(frames.size());
    targets[i] = numbered(file, i);
  }
  for (const path& target : targets)
  {
    require_free(target, overwrite);
  }
  std::set<std::string> told; // once, of all frames
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const std::string lost = write_mesh(read_mesh(frames[i].file), targets[i]);
    const std::string what = lost.substr(std::min(lost.size(), lost.find(": ")));
    warn(told.insert(what).second ? lost : "");
  }
  print("{}{}\n", targets.front().string(),
    targets.size() > 1 ? fmt::format(" … {}", targets.back().string()) : "");
  return exit_code::done;
}

int convert(const ConvertOptions& options)
{
  auto frames = frames_of(options.inputs);
  set_times(options.times, frames);
  return is_series(options.output) ? write_series(frames, options.output, options.overwrite)
                                   : write_meshes(frames, options.output, options.overwrite);
}

}

void add_convert_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<ConvertOptions>();
  auto* command = app.add_subcommand(
    "convert", "Meshes and series from one format to another; meshes to a series and back");
  command
    ->add_option("input", options->inputs,
      "Series (.pvd .vtu.series), folder of a run, or meshes, a frame each")
    ->required();
  command
    ->add_option("-o,--output", options->output,
      "Mesh, numbered where there are several frames, or series (.pvd .vtu.series), which comes "
      "with "
      "its frames as .vtu and as .h5 with an .xdmf")
    ->required();
  command->add_option("--times", options->times, "Of the frames; 0,1,2 … for meshes if left out")
    ->delimiter(',');
  command->add_flag("--overwrite", options->overwrite, "Replace files that are there");
  command->footer("Example: vesicle convert pear/pear.pvd -o meshes/pear.stl\n"
                  "         vesicle convert a.stl b.stl -o both.pvd --times 0,0.5");
  command->callback([options, &action] { action = [options] { return convert(*options); }; });
}

}
