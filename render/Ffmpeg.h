#pragma once
// A film from pictures, by the ffmpeg program where it is installed.

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include <sys/types.h>

class vtkImageData;

namespace vesicle
{

/// The program on PATH.
std::optional<std::filesystem::path> find_ffmpeg();

/// Pictures a second, as a fraction, so that the film of that many frames lasts 5 to 15 s: 25
/// where that does it, and never more than 60.
struct FrameRate
{
  int frames = 25;
  int seconds = 1;
  double per_second() const { return static_cast<double>(frames) / seconds; }
};
FrameRate frame_rate(int frames);

/// An MP4 (H.264, yuv420p, even sides), which ffmpeg encodes picture by picture while the next ones
/// are drawn. It appears under its name only when complete.
class Film
{
public:
  /// Of pictures of `size` pixels. The thread that calls this has to be there until the film is
  /// finished: ffmpeg ends with it. Throws IoError where ffmpeg can't be started.
  Film(const std::filesystem::path& ffmpeg, const std::array<int, 2>& size, FrameRate rate,
    std::filesystem::path film);
  /// Gives up what isn't finished, and leaves nothing of it.
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// The next picture, RGB. Waits while ffmpeg is behind. Where that has stopped, finish() tells.
  void add(vtkImageData* picture);
  /// Returns a note when this ffmpeg can't encode H.264; throws IoError with ffmpeg's own words for
  /// any other failure.
  std::optional<std::string> finish();

private:
  void start(const std::array<int, 2>& size, FrameRate rate);
  int wait();
  std::string words() const;
  void remove_partial() const;

  std::filesystem::path ffmpeg_, film_, partial_;
  pid_t process_ = -1;  ///< −1: it has ended
  int pictures_ = -1;   ///< ffmpeg's standard input
  int complaints_ = -1; ///< its standard error, a file in memory
};

}
