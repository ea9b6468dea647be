#include "render/Movie.h"

#include "render/Ffmpeg.h"
#include "render/PngFile.h"
#include "render/VelocityArrows.h"
#include "solver/Doing.h"
#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <fmt/format.h>
#include <future>
#include <spdlog/spdlog.h>

namespace vesicle
{
namespace
{

namespace fs = std::filesystem;

/// Arrows of a frame whose fastest point is slower than this share of the movie's fastest are drawn
/// shorter: at rest there is nothing to see but noise.
constexpr double least_arrow_speed = 0.01;

struct FrameSurvey
{
  Framing framing;
  RangeFinder values;
  double neutral = 0;
  double speed = 0;
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

/// Calls work(i) for each frame; an error then says which frame it was.
template<typename Work>
void for_each_frame(int count, const FrameName& name, Work&& work)
{
  for (int i = 0; i < count; ++i)
  {
    try
    {
      doing("drawing " + name(i), [&] { work(i); });
    }
    catch (const InputError& error)
    {
      throw InputError(name(i) + ": " + error.what());
    }
  }
}

FrameSurvey survey_frames(
  const FrameSource& frames, int count, const FrameName& name, const MovieSettings& settings)
{
  FrameSurvey survey;
  Passage passage;
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

void draw_frames(Picture& picture, const FrameSource& frames, int count, const FrameName& name,
  const std::vector<double>& times, const MovieSettings& settings)
{
  // Encoding a PNG takes longer than drawing it: do the one while the next is drawn.
  std::future<void> writing;
  for_each_frame(count, name,
    [&](int i)
    {
      picture.draw(frame_of(frames, i),
        times.empty() ? std::nullopt : std::optional(times[static_cast<std::size_t>(i)]));
      auto image = picture.image();
      if (writing.valid())
      {
        writing.get();
      }
      writing = std::async(std::launch::async,
        [file = picture_file(settings.directory, i), image] { write_png(file, image); });
      if (settings.progress)
      {
        settings.progress(i + 1, count);
      }
    });
  writing.get();
}

void make_film(const MovieSettings& settings, int count, MovieReport& report)
{
  std::error_code ignored;
  fs::remove(*settings.mp4, ignored); // of an earlier movie
  const auto ffmpeg = find_ffmpeg();
  if (!ffmpeg)
  {
    report.note =
      fmt::format("no film: the program ffmpeg is not installed; the pictures are in {}",
        settings.directory.string());
  }
  else
  {
    const FrameRate rate = frame_rate(count);
    report.note = doing("making " + settings.mp4->string(),
      [&] { return encode_film(*ffmpeg, settings.directory, rate, *settings.mp4).value_or(""); });
    report.frames_per_second = rate.per_second();
  }
  if (report.note.empty())
  {
    report.mp4 = settings.mp4;
  }
  else
  {
    spdlog::info(report.note);
  }
}

MovieReport draw_movie(const FrameSource& frames, int count, const FrameName& name,
  const std::vector<double>& times, const MovieSettings& settings)
{
  if (count == 0)
  {
    throw InputError("a movie needs at least one frame");
  }
  PictureSettings of_picture = settings.picture;
  const FrameSurvey survey = survey_frames(frames, count, name, settings);
  // Reading the files gathered the times, unless one has none.
  const bool timed = times.size() == static_cast<std::size_t>(count);
  of_picture.range = of_picture.range.value_or(survey.values.range());
  Picture picture(of_picture);
  picture.set_framing(survey.framing);
  picture.set_neutral(survey.neutral);
  picture.set_least_arrow_speed(least_arrow_speed * survey.speed);
  picture.set_time_format("t = " + number_format(times));
  prepare_folder(settings.directory);
  draw_frames(picture, frames, count, name, timed ? times : std::vector<double>{}, settings);
  MovieReport report;
  report.frames = count;
  report.color_range = *of_picture.range;
  report.framing = survey.framing;
  if (settings.mp4)
  {
    make_film(settings, count, report);
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
