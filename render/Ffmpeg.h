#pragma once
// A film from numbered pictures, by the ffmpeg program where it is installed.

#include <filesystem>
#include <optional>
#include <string>

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

/// Makes an MP4 (H.264, yuv420p, even sides) of folder/frame_000000.png, … The film appears under
/// its name only when complete. Returns a note when this ffmpeg can't encode H.264; throws IoError
/// with ffmpeg's own words for any other failure.
std::optional<std::string> encode_film(const std::filesystem::path& ffmpeg,
  const std::filesystem::path& folder, FrameRate rate, const std::filesystem::path& film);

}
