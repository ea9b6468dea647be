#include "render/Ffmpeg.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace vesicle
{
namespace
{

constexpr double shortest_film = 5;
constexpr double longest_film = 15;
constexpr int usual_rate = 25;
constexpr int highest_rate = 60;

/// What the new process does: calls that are allowed after a fork only.
[[noreturn]] void become(char* const* words, pid_t parent, int input, int error_output) noexcept
{
  // The film is the parent's: without it nobody would give the file its name.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nothing = open("/dev/null", O_RDWR);
  if (getppid() == parent && nothing >= 0 && dup2(input, STDIN_FILENO) >= 0 &&
    dup2(nothing, STDOUT_FILENO) >= 0 && dup2(error_output, STDERR_FILENO) >= 0)
  {
    std::signal(SIGPIPE, SIG_DFL);
    execv(words[0], words);
  }
  _exit(127);
}

/// Starts a program without a shell; it ends with this thread. −1 where that fails.
pid_t start_program(std::vector<std::string> words, int input, int error_output)
{
  std::vector<char*> arguments;
  for (auto& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0)
  {
    become(arguments.data(), parent, input, error_output);
  }
  return child;
}

void close_once(int& descriptor)
{
  if (descriptor >= 0)
  {
    close(std::exchange(descriptor, -1));
  }
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

Film::Film(const std::filesystem::path& ffmpeg, const std::array<int, 2>& size, FrameRate rate,
  std::filesystem::path film)
  : ffmpeg_(ffmpeg), film_(std::move(film)),
    partial_(unfinished_name(std::filesystem::absolute(film_)))
{
  start(size, rate);
}

void Film::start(const std::array<int, 2>& size, FrameRate rate)
{
  // A pair of sockets, since a pipe that nobody reads any more would end this program.
  std::array<int, 2> ends{ -1, -1 };
  complaints_ = memfd_create("ffmpeg", MFD_CLOEXEC);
  if (complaints_ >= 0 && socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0)
  {
    pictures_ = ends[0];
    process_ = start_program(
      { ffmpeg_.string(), "-nostdin", "-hide_banner", "-loglevel", "error", "-xerror", "-y", "-f",
        "rawvideo", "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", size[0], size[1]),
        "-framerate", fmt::format("{}/{}", rate.frames, rate.seconds), "-i", "pipe:0", "-vf",
        "vflip,pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264", "-preset", "veryfast",
        "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4",
        partial_.string() },
      ends[1], complaints_);
  }
  const int reason = errno;
  close_once(ends[1]);
  if (process_ < 0)
  {
    close_once(pictures_);
    close_once(complaints_);
    throw IoError(fmt::format("can't start {}: {}", ffmpeg_.string(), std::strerror(reason)));
  }
}

Film::~Film()
{
  if (process_ >= 0)
  {
    kill(process_, SIGKILL);
    wait();
    remove_partial();
  }
  close_once(complaints_);
}

void Film::add(vtkImageData* picture)
{
  const auto* bytes = static_cast<const char*>(picture->GetScalarPointer());
  auto left = static_cast<std::size_t>(picture->GetNumberOfPoints()) * 3;
  while (left > 0 && pictures_ >= 0)
  {
    const ssize_t sent = send(pictures_, bytes, left, MSG_NOSIGNAL);
    if (sent >= 0)
    {
      bytes += sent;
      left -= static_cast<std::size_t>(sent);
    }
    else if (errno != EINTR)
    {
      close_once(pictures_);
    }
  }
}

/// The exit status; −1 if it didn't run to its end.
int Film::wait()
{
  close_once(pictures_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR)
  {
  }
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string Film::words() const
{
  std::array<char, 4096> text;
  const ssize_t length = pread(complaints_, text.data(), text.size(), 0);
  return { text.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0)) };
}

void Film::remove_partial() const
{
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

std::optional<std::string> Film::finish()
{
  const int status = wait();
  const std::string complaints = words();
  if (status == 0 && complaints.empty())
  {
    finish_file(film_);
    return {};
  }
  remove_partial();
  if (complaints.find("Unknown encoder") != std::string::npos)
  {
    return fmt::format("no film: {} can't encode H.264", ffmpeg_.string());
  }
  throw IoError(fmt::format("{}: can't be written: {}", film_.string(),
    complaints.empty() ? "ffmpeg stopped" : "ffmpeg says: " + complaints));
}

}
