// Movies: one zoom and one range, numbered pictures, the film.

#include "TestSurfaces.h"

#include "render/Ffmpeg.h"
#include "render/Movie.h"
#include "solver/Errors.h"

#include "vtkXMLPolyDataWriter.h"

#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>

using namespace vesicle;
using namespace vesicle::test;
namespace fs = std::filesystem;

namespace
{

const std::vector<double> three_times{ 0, 0.1, 0.2 };

vtkSmartPointer<vtkPolyData> moving_frame(int i)
{
  return make_surface(0.7 * i, 1 + i);
}

MovieSettings small_movie(const fs::path& folder)
{
  MovieSettings settings;
  settings.picture.size = { 320, 180 };
  settings.directory = folder;
  return settings;
}

std::string output_of(const std::string& command)
{
  std::string text;
  if (FILE* pipe = popen(command.c_str(), "r"))
  {
    char line[256];
    while (std::fgets(line, sizeof line, pipe))
    {
      text += line;
    }
    pclose(pipe);
  }
  return text;
}

void touch(const fs::path& file)
{
  std::ofstream(file) << "x";
}

/// PATH as on a machine without ffmpeg.
class EmptyPath
{
public:
  EmptyPath() { setenv("PATH", "/nonexistent", 1); }
  ~EmptyPath() { setenv("PATH", path_.c_str(), 1); }

private:
  std::string path_ = std::getenv("PATH");
};

}

TEST(Movie, WritesNumberedPicturesOfTheSizeAskedFor)
{
  const TemporaryFolder folder;
  std::vector<int> told;
  MovieSettings settings = small_movie(folder / "deep/movie");
  settings.progress = [&](int done, int total)
  {
    EXPECT_EQ(total, 3);
    told.push_back(done);
  };
  const auto report = make_movie(moving_frame, three_times, settings);
  EXPECT_EQ(report.frames, 3);
  EXPECT_FALSE(report.mp4);
  EXPECT_EQ(told, (std::vector{ 1, 2, 3 }));
  for (const char* name : { "frame_000000.png", "frame_000001.png", "frame_000002.png" })
  {
    const auto image = read_png(settings.directory / name);
    EXPECT_EQ(size_of(image), (std::array{ 320, 180 }));
    EXPECT_GT(colors_of(image).size(), 100u);
  }
}

TEST(Movie, RangeAndZoomAreThoseOfTheWholeMovie)
{
  const TemporaryFolder folder;
  const auto report = make_movie(moving_frame, three_times, small_movie(folder.path()));
  // Mean_Curvature is strength (1 ± 0.75), strength up to 3.
  EXPECT_NEAR(report.color_range[1], 3 * 1.75, 0.2);
  EXPECT_NEAR(report.color_range[0], 0.25, 0.05);
  EXPECT_NEAR(report.framing.half_width, 1.5, 0.02);
  EXPECT_NEAR(report.framing.half_height, 1, 0.02);
  // The colour bar is the same in every picture; the vesicle's colours are not.
  const auto first = read_png(folder / "frame_000000.png");
  const auto last = read_png(folder / "frame_000002.png");
  EXPECT_EQ(difference(first, last, 0.87, 1), 0);
  EXPECT_GT(difference(first, last, 0, 0.85), 0.1);
}

TEST(Movie, AFixedCameraSeesTheWholeWay)
{
  const TemporaryFolder folder;
  MovieSettings settings = small_movie(folder.path());
  settings.follow = false;
  const auto report = make_movie(moving_frame, three_times, settings);
  // The frames are about (0.7 i, 0, 1.4 i), i = 0, 1, 2, with half axes 1.5 and 1.
  EXPECT_NEAR(report.framing.half_width, (1.4 + 3) / 2, 0.02);
  EXPECT_NEAR(report.framing.half_height, (2.8 + 2) / 2, 0.02);
  ASSERT_TRUE(report.framing.center);
  EXPECT_NEAR((*report.framing.center)[0], 0.7, 0.02);
  EXPECT_NEAR((*report.framing.center)[2], 1.4, 0.02);
}

TEST(Movie, AGivenRangeIsKept)
{
  const TemporaryFolder folder;
  MovieSettings settings = small_movie(folder.path());
  settings.picture.range = Range{ -1, 7 };
  EXPECT_EQ(make_movie(moving_frame, three_times, settings).color_range, (Range{ -1, 7 }));
}

TEST(Movie, RemovesPicturesOfALongerOne)
{
  const TemporaryFolder folder;
  touch(folder / "frame_000003.png");
  touch(folder / "frame_000999.png");
  touch(folder / "my_frame.png");
  make_movie(moving_frame, three_times, small_movie(folder.path()));
  EXPECT_FALSE(fs::exists(folder / "frame_000003.png"));
  EXPECT_FALSE(fs::exists(folder / "frame_000999.png"));
  EXPECT_TRUE(fs::exists(folder / "my_frame.png"));
}

TEST(Movie, TheFilmHasEveryFrame)
{
  if (!find_ffmpeg())
  {
    GTEST_SKIP() << "ffmpeg is not installed";
  }
  const TemporaryFolder folder;
  // Odd sides, and a name that a careless command line would trip over.
  MovieSettings settings = small_movie(folder / "100% odd");
  settings.picture.size = { 321, 181 };
  settings.mp4 = folder / "my film; it's new.mp4";
  const auto report = make_movie(moving_frame, three_times, settings);
  ASSERT_TRUE(report.mp4) << report.note;
  EXPECT_EQ(report.note, "");
  EXPECT_NEAR(report.frames / report.frames_per_second, 5, 1e-9);
  EXPECT_TRUE(fs::exists(*settings.mp4));
  const auto probe = output_of("ffprobe -v error -show_entries "
                               "stream=codec_name,width,height,pix_fmt,nb_frames -of csv=p=0 \"" +
    settings.mp4->string() + "\"");
  if (!probe.empty())
  {
    EXPECT_EQ(probe, "h264,322,182,yuv420p,3\n");
  }
}

TEST(Movie, OfAFilmThatIsGivenUpNothingIsLeft)
{
  const auto ffmpeg = find_ffmpeg();
  if (!ffmpeg)
  {
    GTEST_SKIP() << "ffmpeg is not installed";
  }
  const TemporaryFolder folder;
  {
    Picture picture(small_movie(folder.path()).picture);
    picture.draw(moving_frame(0));
    Film film(*ffmpeg, picture.settings().size, frame_rate(100), folder / "film.mp4");
    film.add(picture.image());
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Movie, AProgramThatReadsNoPictureIsAnError)
{
  const TemporaryFolder folder;
  Picture picture(small_movie(folder.path()).picture);
  picture.draw(moving_frame(0));
  Film film("/bin/false", picture.settings().size, frame_rate(100), folder / "film.mp4");
  for (int i = 0; i < 10; ++i)
  {
    film.add(picture.image());
  }
  const auto message = message_of<IoError>([&] { film.finish(); });
  EXPECT_NE(message.find("film.mp4: can't be written: ffmpeg stopped"), std::string::npos)
    << message;
}

TEST(Movie, WithoutFfmpegThereIsANote)
{
  const EmptyPath no_programs;
  const TemporaryFolder folder;
  MovieSettings settings = small_movie(folder.path());
  settings.mp4 = folder / "film.mp4";
  touch(*settings.mp4);
  const auto report = make_movie(moving_frame, three_times, settings);
  EXPECT_FALSE(report.mp4);
  EXPECT_NE(report.note.find("ffmpeg"), std::string::npos);
  EXPECT_FALSE(fs::exists(*settings.mp4)); // not of these pictures
  EXPECT_TRUE(fs::exists(folder / "frame_000002.png"));
}

TEST(Movie, AFilmThatCannotBeWrittenIsAnError)
{
  if (!find_ffmpeg())
  {
    GTEST_SKIP() << "ffmpeg is not installed";
  }
  const TemporaryFolder folder;
  MovieSettings settings = small_movie(folder.path());
  settings.mp4 = folder / "no such folder/film.mp4";
  const auto message =
    message_of<IoError>([&] { make_movie(moving_frame, three_times, settings); });
  EXPECT_NE(message.find("film.mp4"), std::string::npos) << message;
}

TEST(Movie, AFolderThatCannotBeMadeIsAnError)
{
  const TemporaryFolder folder;
  touch(folder / "file");
  for (const fs::path& bad : { folder / "file", folder / "file/movie", fs::path("/proc/movie") })
  {
    const auto message =
      message_of<IoError>([&] { make_movie(moving_frame, three_times, small_movie(bad)); });
    EXPECT_NE(message.find(bad.string()), std::string::npos) << message;
  }
}

TEST(Movie, ABadFrameIsNamedAndNothingIsRemoved)
{
  const TemporaryFolder folder;
  touch(folder / "frame_000007.png");
  const FrameSource frames = [](int i)
  {
    const auto surface = moving_frame(i);
    if (i == 2)
    {
      surface->GetPointData()
        ->GetArray("Mean_Curvature")
        ->SetComponent(3, 0, std::numeric_limits<double>::infinity());
    }
    return surface;
  };
  const auto message =
    message_of<InputError>([&] { make_movie(frames, three_times, small_movie(folder.path())); });
  EXPECT_NE(message.find("frame 2 (t = 0.2)"), std::string::npos) << message;
  EXPECT_NE(message.find("Tension"), std::string::npos) << message;
  EXPECT_TRUE(fs::exists(folder / "frame_000007.png"));
}

TEST(Movie, NoFrameIsAnError)
{
  const TemporaryFolder folder;
  EXPECT_THROW(make_movie(moving_frame, {}, small_movie(folder.path())), InputError);
}

TEST(Movie, ReadsFilesAndTheirTimes)
{
  const TemporaryFolder folder;
  std::vector<fs::path> files;
  for (int i = 0; i < 3; ++i)
  {
    const auto surface = moving_frame(i);
    vtkNew<vtkDoubleArray> time;
    time->SetName("TimeValue");
    time->InsertNextValue(0.5 * i);
    surface->GetFieldData()->AddArray(time);
    files.push_back(folder / ("f" + std::to_string(i) + ".vtp"));
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(surface);
    writer->SetFileName(files.back().c_str());
    writer->Write();
  }
  EXPECT_EQ(make_movie(files, small_movie(folder / "movie")).frames, 3);
  const auto from_files = read_png(folder / "movie/frame_000001.png");
  make_movie(moving_frame, { 0, 0.5, 1 }, small_movie(folder / "movie"));
  EXPECT_LT(difference(from_files, read_png(folder / "movie/frame_000001.png")), 0.01);
}

TEST(Movie, RefusesFilesThatItCannotDraw)
{
  const TemporaryFolder folder;
  const auto draw = [&](const char* file)
  { make_movie(std::vector<fs::path>{ folder / file }, small_movie(folder / "movie")); };
  for (const char* file : { "mesh.txt", "broken.vtp", "broken.vtk" })
  {
    touch(folder / file);
    EXPECT_THROW(draw(file), InputError) << file;
  }
  EXPECT_THROW(draw("missing.vtu"), IoError);
}

TEST(FrameRate, AFilmLastsFiveToFifteenSeconds)
{
  for (const int frames : { 1, 3, 40, 124, 125, 200, 375, 376, 700, 900 })
  {
    const double seconds = frames / frame_rate(frames).per_second();
    EXPECT_GE(seconds, 5 - 1e-9) << frames;
    EXPECT_LE(seconds, 15 + 1e-9) << frames;
  }
  EXPECT_EQ(frame_rate(200).per_second(), 25);
  EXPECT_EQ(frame_rate(5000).per_second(), 60);
}
