#include "render/Ffmpeg.h"

#include "solver/Errors.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

extern char** environ;

namespace vesicle
{
namespace
{

constexpr double shortest_film = 5;
constexpr double longest_film = 15;
constexpr int usual_rate = 25;
constexpr int highest_rate = 60;

struct Outcome
{
  int status = -1;   ///< exit status; −1: it didn't run to its end
  std::string words; ///< what it wrote to its standard error
};

std::string read_all(int descriptor)
{
  std::string text;
  std::array<char, 4096> chunk;
  for (;;)
  {
    const ssize_t got = read(descriptor, chunk.data(), chunk.size());
    if (got > 0)
    {
      text.append(chunk.data(), static_cast<std::size_t>(got));
    }
    else if (got == 0 || errno != EINTR)
    {
      return text;
    }
  }
}

/// Runs a program without a shell in that folder and waits for it.
Outcome run_program(std::vector<std::string> words, const std::filesystem::path& folder)
{
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
  {
    throw IoError(fmt::format("can't start {}: {}", words[0], std::strerror(errno)));
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::vector<char*> arguments;
  for (auto& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failure =
    posix_spawn(&child, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (failure != 0)
  {
    close(ends[0]);
    throw IoError(fmt::format("can't start {}: {}", words[0], std::strerror(failure)));
  }
  Outcome outcome;
  outcome.words = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

}

std::optional<std::filesystem::path> find_ffmpeg()
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    std::error_code ignored;
    const auto program = std::filesystem::path(folder.empty() ? "." : folder) / "ffmpeg";
    if (std::filesystem::is_regular_file(program, ignored) && access(program.c_str(), X_OK) == 0)
    {
      return std::filesystem::absolute(program);
    }
  }
  return {};
}

FrameRate frame_rate(int frames)
{
  if (frames > usual_rate * longest_film)
  {
    const int needed = static_cast<int>((frames + longest_film - 1) / longest_film);
    return { std::min(highest_rate, needed), 1 };
  }
  if (frames < usual_rate * shortest_film)
  {
    return { std::max(1, frames), static_cast<int>(shortest_film) };
  }
  return { usual_rate, 1 };
}

std::optional<std::string> encode_film(const std::filesystem::path& ffmpeg,
  const std::filesystem::path& folder, FrameRate rate, const std::filesystem::path& film)
{
  const auto target = std::filesystem::absolute(film);
  const auto partial =
    target.parent_path() / fmt::format(".{}.partial.mp4", target.stem().string());
  const Outcome outcome = run_program(
    { ffmpeg.string(), "-nostdin", "-hide_banner", "-loglevel", "error", "-y", "-framerate",
      fmt::format("{}/{}", rate.frames, rate.seconds), "-i", "frame_%06d.png", "-vf",
      "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264", "-preset", "medium", "-crf",
      "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", partial.string() },
    folder);
  std::error_code failure;
  if (outcome.status == 0)
  {
    std::filesystem::rename(partial, target, failure);
    if (!failure)
    {
      return {};
    }
  }
  std::error_code ignored;
  std::filesystem::remove(partial, ignored);
  if (outcome.words.find("Unknown encoder") != std::string::npos)
  {
    return fmt::format(
      "no film: {} can't encode H.264; the pictures are in {}", ffmpeg.string(), folder.string());
  }
  throw IoError(fmt::format("can't write {}: {}", target.string(),
    failure                   ? failure.message()
      : outcome.words.empty() ? "ffmpeg stopped"
                              : "ffmpeg says: " + outcome.words));
}

}
