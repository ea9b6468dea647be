#include "apps/RunMovie.h"

#include "apps/Interrupt.h"
#include "apps/Progress.h"
#include "apps/RunFolder.h"
#include "apps/RunPlots.h"

#include "render/RenderBackend.h"
#include "render/SceneGuides.h"
#include "solver/Errors.h"
#include "solver/flow/FlowKind.h"
#include "vtkfilters/Filters/VelocityFieldFile.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

/// Thrown by our own observer on Ctrl-C; no error, so nothing on the way takes it for one.
struct Stopped
{
};

MovieSettings settings_of(
  const Scene& scene, const RunFolder& folder, const RunTable& table, Progress& progress)
{
  MovieSettings settings = movie_settings(scene.movie);
  settings.picture.guides = scene_guides(scene, View::named(scene.movie.view));
  if (scene.movie.flow_lines)
  {
    settings.picture.field = field_of(scene);
  }
  if (scene.movie.chart != "none")
  {
    settings.picture.chart = run_chart(scene.movie.chart, table, scene.units);
    if (!settings.picture.chart)
    {
      progress.say(fmt::format("no chart beside the movie: this run has no {}", scene.movie.chart));
    }
  }
  settings.directory = folder.pictures();
  settings.mp4 = folder.film();
  settings.progress = [&progress](int done, int total)
  {
    progress.count("movie: frame", done, total);
    if (interrupted() && done < total)
    {
      throw Stopped{};
    }
  };
  return settings;
}

/// `what`: the setting that takes it.
void require_array(
  const Scene& scene, vtkPointData* arrays, const std::string& name, const std::string& what)
{
  if (arrays->HasArray(name.c_str()))
  {
    return;
  }
  std::string names;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    names += fmt::format(" {}", arrays->GetArrayName(i));
  }
  throw InputError(fmt::format("{}: {} is not an array of this run (output.fields); there are:{}",
    scene.file.string(), what, names));
}

}

MovieSettings movie_settings(const Scene::Movie& movie)
{
  MovieSettings settings;
  settings.picture.color = movie.color;
  settings.picture.range = movie.range;
  settings.picture.size = movie.size;
  settings.picture.view = movie.view;
  settings.picture.smooth = movie.smooth;
  settings.picture.arrows = movie.arrows;
  settings.picture.flow_lines = movie.flow_lines;
  settings.picture.edges = movie.edges;
  settings.markers = movie.markers;
  settings.follow = movie.camera == "follow";
  return settings;
}

std::shared_ptr<const ImposedFlow> field_of(const Scene& scene)
{
  if (!scene.flow || !is_from_file(scene.flow->kind()))
  {
    return {};
  }
  std::string told; // when the run began
  return imposed_flow(with_velocity_field(scene, told));
}

void require_arrays(const Scene& scene, vtkPolyData* surface)
{
  const Scene::Movie& movie = scene.movie;
  const auto require = [&](const std::string& name, const std::string& what)
  { require_array(scene, surface->GetPointData(), name, what); };
  require(movie.color, fmt::format("movie.color = \"{}\"", movie.color));
  if (movie.flow_lines)
  {
    require("Membrane_Force", "Membrane_Force, which movie.flow_lines takes,");
  }
  for (const auto& [wanted, key] : { std::pair(movie.flow_lines, "flow_lines"),
         std::pair(movie.markers > 0, "markers"), std::pair(movie.arrows, "arrows") })
  {
    if (wanted)
    {
      require("Velocity", fmt::format("Velocity, which movie.{} takes,", key));
    }
  }
}

void prepare_to_draw()
{
  try
  {
    render_backend();
  }
  catch (const NothingToDrawWith&) // told when there is something to draw
  {
  }
}

std::string make_run_movie(const Scene& scene, const RunFolder& folder,
  const std::vector<std::filesystem::path>& frames, const RunTable& table, Progress& progress)
{
  const auto none = [&progress](const std::string& why)
  {
    const auto note = "no movie: " + why;
    progress.say(note);
    return note;
  };
  try
  {
    const auto report = make_movie(frames, settings_of(scene, folder, table, progress));
    return report.note.empty()
      ? fmt::format("{} frames, {}", report.frames, report.mp4->filename().string())
      : report.note;
  }
  catch (const Stopped&)
  {
    return none("interrupted");
  }
  catch (const InputError& error)
  {
    return none(error.what());
  }
  catch (const NothingToDrawWith& error)
  {
    return none(error.what());
  }
  catch (const IoError& error)
  {
    if (!interrupted()) // Ctrl-C reaches ffmpeg too, which then fails.
    {
      throw;
    }
    return none(error.what());
  }
}

}
