#include "render/Movie.h"

#include "render/Ffmpeg.h"
#include "render/FlowWays.h"
#include "render/MembraneMarkers.h"
#include "render/PngFile.h"
#include "render/VelocityArrows.h"
#include "solver/Doing.h"
#include "solver/Errors.h"
#include "solver/flow/ImposedFlow.h"
#include "solver/files/FileBytes.h"
#include "solver/files/WriteQueue.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <fmt/format.h>
#include <future>
#include <memory>
#include <spdlog/spdlog.h>
#include <utility>

namespace vesicle
{
namespace
{

namespace fs = std::filesystem;

/// Arrows of a frame whose fastest point is slower than this share of the movie's fastest are drawn
/// shorter: at rest there is nothing to see but noise.
constexpr double least_arrow_speed = 0.01;

/// Pictures that are encoded and written while the next are drawn.
constexpr std::size_t most_waiting = 2;

/// Of frames that are kept from being measured until they are drawn; the others are asked for twice.
constexpr unsigned long most_kept = 128 * 1024; // KiB

struct FrameSurvey
{
  Framing framing;
  RangeFinder values;
  double neutral = 0;
  double speed = 0;                               ///< of arrows
  double flow_speed = 0;                          ///< of flow lines
  std::vector<std::vector<Point3>> markers;       ///< of each frame, if there are any
  std::vector<vtkSmartPointer<vtkPolyData>> kept; ///< the first frames
};

using FrameName = std::function<std::string(int)>;

/// A frame that was listed and is gone is not the scene's fault.
vtkSmartPointer<vtkPolyData> read_frame(const fs::path& file)
{
  std::error_code ignored;
  if (!fs::exists(file, ignored))
  {
    throw IoError("can't read " + file.string());
  }
  return read_mesh(file);
}

/// The field data TimeValue, where there is one.
std::optional<double> time_of(vtkPolyData* surface)
{
  vtkDataArray* time = surface->GetFieldData()->GetArray("TimeValue");
  return time && time->GetNumberOfValues() > 0 ? std::optional(time->GetComponent(0, 0))
                                               : std::nullopt;
}

vtkSmartPointer<vtkPolyData> frame_of(const FrameSource& frames, int i)
{
  auto surface = frames(i);
  if (!surface)
  {
    throw InputError("there is no surface");
  }
  return surface;
}

/// Does the work on a frame; an error then says which frame it was.
template<typename Work>
decltype(auto) with_frame(const std::string& name, Work&& work)
{
  try
  {
    return doing("drawing " + name, std::forward<Work>(work));
  }
  catch (const InputError& error)
  {
    throw InputError(name + ": " + error.what());
  }
}

/// Calls work(i) for each frame.
template<typename Work>
void for_each_frame(int count, const FrameName& name, Work&& work)
{
  for (int i = 0; i < count; ++i)
  {
    with_frame(name(i), [&] { work(i); });
  }
}

/// About what a picture of this frame shows.
FlowPlane plane_about(vtkPolyData* surface, const MovieSettings& settings)
{
  constexpr double room = 1.7;
  const View view = View::named(settings.picture.view);
  Framing framing;
  framing.include(surface, view);
  const double half = room * framing.radius;
  return { view, surface_centroid(surface), half, half, settings.follow,
    flow_at(settings.picture.field, time_of(surface).value_or(0)) };
}

double time_for_markers(vtkPolyData* surface)
{
  const auto time = time_of(surface);
  if (!time)
  {
    throw InputError("markers take frames that know their time (field data TimeValue)");
  }
  return *time;
}

FrameSurvey survey_frames(
  const FrameSource& frames, int count, const FrameName& name, const MovieSettings& settings)
{
  FrameSurvey survey;
  unsigned long memory = 0;
  Passage passage;
  MembraneMarkers markers(settings.markers);
  const PictureSettings& picture = settings.picture;
  const View view = View::named(picture.view);
  for_each_frame(count, name,
    [&](int i)
    {
      const auto surface = frame_of(frames, i);
      survey.framing.include(surface, view);
      passage.include(surface, view);
      survey.values.include(finite_point_array(surface, picture.color));
      survey.neutral = i == 0 ? neutral_value(picture.color, surface) : survey.neutral;
      if (picture.arrows)
      {
        survey.speed = std::max(survey.speed, VelocityArrows::largest_speed(surface));
      }
      if (picture.flow_lines)
      {
        survey.flow_speed =
          std::max(survey.flow_speed, largest_flow_speed(surface, plane_about(surface, settings)));
      }
      if (settings.markers > 0)
      {
        survey.markers.push_back(markers.at(surface, time_for_markers(surface)));
      }
      if (memory < most_kept)
      {
        memory += surface->GetActualMemorySize();
        survey.kept.push_back(surface);
      }
    });
  if (!settings.follow)
  {
    survey.framing = passage.framing(view);
  }
  return survey;
}

/// frame_, six or more digits, .png.
bool is_picture_name(const std::string& name)
{
  const std::string before = "frame_";
  const std::string after = ".png";
  constexpr std::size_t least_digits = 6;
  if (name.size() < before.size() + least_digits + after.size() || !name.starts_with(before) ||
    !name.ends_with(after))
  {
    return false;
  }
  return std::all_of(name.begin() + static_cast<long>(before.size()),
    name.end() - static_cast<long>(after.size()), [](char c) { return c >= '0' && c <= '9'; });
}

void prepare_folder(const fs::path& folder)
{
  make_folder(folder);
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder, failure))
  {
    if (is_picture_name(entry.path().filename().string()))
    {
      fs::remove(entry.path(), failure);
      if (failure)
      {
        throw IoError(fmt::format(
          "can't remove the old picture {}: {}", entry.path().string(), failure.message()));
      }
    }
  }
}

fs::path picture_file(const fs::path& folder, int i)
{
  return folder / fmt::format("frame_{:06}.png", i);
}

/// The film of a movie, if one is to be had.
struct FilmOrNote
{
  std::unique_ptr<Film> film;
  std::string note; ///< why there is none
};

FilmOrNote start_film(const MovieSettings& settings, FrameRate rate)
{
  std::error_code ignored;
  fs::remove(*settings.mp4, ignored); // of an earlier movie
  const auto ffmpeg = find_ffmpeg();
  if (!ffmpeg)
  {
    return { nullptr, "no film: the program ffmpeg is not installed" };
  }
  return { std::make_unique<Film>(*ffmpeg, settings.picture.size, rate, *settings.mp4), "" };
}

/// While a picture is drawn, the surface of the next is fetched and those before are written.
void draw_frames(Picture& picture, const FrameSource& frames, int count, const FrameName& name,
  const std::vector<double>& times, std::vector<std::vector<Point3>> markers,
  const MovieSettings& settings, Film* film)
{
  const auto fetch = [&frames](int i)
  { return std::async(std::launch::async, [&frames, i] { return frame_of(frames, i); }); };
  const auto write = [film](const fs::path& file, vtkImageData* image)
  {
    write_png(file, image);
    if (film)
    {
      film->add(image);
    }
  };
  WriteQueue writing(most_waiting);
  auto next = fetch(0);
  for_each_frame(count, name,
    [&](int i)
    {
      const auto surface = next.get();
      if (i + 1 < count)
      {
        next = fetch(i + 1);
      }
      if (!markers.empty())
      {
        picture.set_markers(std::move(markers[static_cast<std::size_t>(i)]));
      }
      picture.draw(
        surface, times.empty() ? std::nullopt : std::optional(times[static_cast<std::size_t>(i)]));
      writing.add([&write, file = picture_file(settings.directory, i), image = picture.image()]
        { doing("writing " + file.string(), [&] { write(file, image); }); });
      if (settings.progress)
      {
        settings.progress(i + 1, count);
      }
    });
  writing.wait();
}

void finish_film(const MovieSettings& settings, FilmOrNote& made, MovieReport& report)
{
  if (made.film)
  {
    made.note =
      doing("making " + settings.mp4->string(), [&] { return made.film->finish().value_or(""); });
    report.frames_per_second = frame_rate(report.frames).per_second();
  }
  if (made.note.empty())
  {
    report.mp4 = settings.mp4;
    return;
  }
  report.note = fmt::format("{}; the pictures are in {}", made.note, settings.directory.string());
  spdlog::info(report.note);
}

MovieReport draw_movie(const FrameSource& frames, int count, const FrameName& name,
  const std::vector<double>& times, const MovieSettings& settings)
{
  if (count == 0)
  {
    throw InputError("a movie needs at least one frame");
  }
  Picture picture(settings.picture);
  const auto first = with_frame(name(0), [&] { return frame_of(frames, 0); });
  auto surveying =
    std::async(std::launch::async, [&] { return survey_frames(frames, count, name, settings); });
  // The first picture takes as long as several, as the window's programs are compiled for it.
  with_frame(name(0), [&] { picture.draw(first); });
  FrameSurvey survey = surveying.get();
  // Reading the files gathered the times, unless one has none.
  const bool timed = times.size() == static_cast<std::size_t>(count);
  const Range range = settings.picture.range.value_or(survey.values.range());
  picture.set_range(range);
  picture.set_framing(survey.framing);
  picture.set_neutral(survey.neutral);
  picture.set_least_arrow_speed(least_arrow_speed * survey.speed);
  if (survey.flow_speed > 0)
  {
    picture.set_flow_speed(survey.flow_speed);
  }
  picture.set_time_format("t = " + number_format(times));
  prepare_folder(settings.directory);
  FilmOrNote film;
  if (settings.mp4)
  {
    film = start_film(settings, frame_rate(count));
  }
  const FrameSource kept_or_asked_for = [&](int i)
  {
    const auto k = static_cast<std::size_t>(i);
    return k < survey.kept.size() ? std::exchange(survey.kept[k], nullptr) : frames(i);
  };
  draw_frames(picture, kept_or_asked_for, count, name, timed ? times : std::vector<double>{},
    std::move(survey.markers), settings, film.film.get());
  MovieReport report;
  report.frames = count;
  report.color_range = range;
  report.framing = survey.framing;
  if (settings.mp4)
  {
    finish_film(settings, film, report);
  }
  return report;
}

}

MovieReport make_movie(
  const FrameSource& frames, const std::vector<double>& times, const MovieSettings& settings)
{
  const auto name = [&](int i) { return fmt::format("frame {} (t = {:.6g})", i, times[i]); };
  return draw_movie(frames, static_cast<int>(times.size()), name, times, settings);
}

MovieReport make_movie(const std::vector<fs::path>& files, const MovieSettings& settings)
{
  std::vector<double> times;
  const auto count = static_cast<int>(files.size());
  const FrameSource frames = [&](int i)
  {
    const auto surface = read_frame(files[static_cast<std::size_t>(i)]);
    const auto time = time_of(surface);
    if (time && times.size() == static_cast<std::size_t>(i))
    {
      times.push_back(*time);
    }
    return surface;
  };
  const auto name = [&](int i) { return files[static_cast<std::size_t>(i)].string(); };
  return draw_movie(frames, count, name, times, settings);
}

}
