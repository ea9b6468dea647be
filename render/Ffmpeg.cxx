#include "render/Ffmpeg.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sstream>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

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

/// What the new process does: calls that are allowed after a fork only.
[[noreturn]] void become(
  char* const* words, const char* folder, pid_t parent, int error_output) noexcept
{
  // The film is the parent's: without it nobody would give the file its name.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nothing = open("/dev/null", O_RDWR);
  if (getppid() == parent && nothing >= 0 && chdir(folder) == 0 &&
    dup2(nothing, STDIN_FILENO) >= 0 && dup2(nothing, STDOUT_FILENO) >= 0 &&
    dup2(error_output, STDERR_FILENO) >= 0)
  {
    std::signal(SIGPIPE, SIG_DFL);
    execv(words[0], words);
  }
  _exit(127);
}

/// Runs a program without a shell in that folder and waits for it. It ends with this program.
Outcome run_program(std::vector<std::string> words, const std::filesystem::path& folder)
{
  std::vector<char*> arguments;
  for (auto& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
  {
    throw IoError(fmt::format("can't start {}: {}", words[0], std::strerror(errno)));
  }
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0)
  {
    become(arguments.data(), folder.c_str(), parent, ends[1]);
  }
  const int failure = errno;
  close(ends[1]);
  if (child < 0)
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
    const auto program = std::filesystem::path(folder.empty() ? "." : folder) / "ffmpeg";
    if (is_file(program) && access(program.c_str(), X_OK) == 0)
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
  const auto partial = unfinished_name(std::filesystem::absolute(film));
  const Outcome outcome = run_program(
    { ffmpeg.string(), "-nostdin", "-hide_banner", "-loglevel", "error", "-xerror", "-y",
      "-framerate", fmt::format("{}/{}", rate.frames, rate.seconds), "-i", "frame_%06d.png", "-vf",
      "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264", "-preset", "medium", "-crf",
      "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4", partial.string() },
    folder);
  if (outcome.status == 0 && outcome.words.empty())
  {
    finish_file(film);
    return {};
  }
  std::error_code ignored;
  std::filesystem::remove(partial, ignored);
  if (outcome.words.find("Unknown encoder") != std::string::npos)
  {
    return fmt::format(
      "no film: {} can't encode H.264; the pictures are in {}", ffmpeg.string(), folder.string());
  }
  throw IoError(fmt::format("{}: can't be written: {}", film.string(),
    outcome.words.empty() ? "ffmpeg stopped" : "ffmpeg says: " + outcome.words));
}

}
