#include "apps/ChildRun.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vesicle
{
namespace
{

constexpr int not_started = 126;

[[noreturn]] void fail(const char* what)
{
  throw IoError(std::string(what) + ": " + std::generic_category().message(errno));
}

/// In the child, where nothing may be allocated any more.
[[noreturn]] void become(char* const* words, int output)
{
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  setpgid(0, 0); // a terminal's Ctrl-C goes to the parent alone, which passes on one
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
    dup2(output, STDERR_FILENO) >= 0)
    execv("/proc/self/exe", words);
  _exit(not_started);
}

}

int threads_a_run(int jobs)
{
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / jobs);
}

ChildRun::ChildRun(const std::vector<std::string>& arguments)
{
  std::vector<std::string> words{ "vesicle" };
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    fail("can't make a pipe");
  process_ = fork();
  if (process_ == 0)
    become(pointers.data(), ends[1]);
  close(ends[1]);
  pipe_ = ends[0];
  if (process_ < 0)
  {
    close(pipe_);
    fail("can't start a process");
  }
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

ChildRun::~ChildRun()
{
  if (running())
  {
    interrupt();
    waitpid(process_, nullptr, 0);
  }
  close(pipe_);
}

bool ChildRun::running()
{
  if (process_ < 0)
    return false;
  int status = 0;
  const bool ended = waitpid(process_, &status, WNOHANG) == process_;
  read_output();
  if (ended)
  {
    process_ = -1;
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return !ended;
}

void ChildRun::read_output()
{
  std::array<char, 4096> buffer;
  for (ssize_t n = 0; (n = read(pipe_, buffer.data(), buffer.size())) > 0;)
    output_.append(buffer.data(), static_cast<std::size_t>(n));
}

std::string ChildRun::last_words() const
{
  const auto end = output_.find_last_not_of('\n');
  if (end == std::string::npos)
    return fmt::format("ended with code {}", code_);
  const auto before = output_.rfind('\n', end);
  const auto begin = before == std::string::npos ? 0 : before + 1;
  return output_.substr(begin, end + 1 - begin);
}

double ChildRun::cpu_seconds() const
{
  clockid_t clock{};
  timespec used{};
  if (process_ < 0 || clock_getcpuclockid(process_, &clock) != 0 ||
    clock_gettime(clock, &used) != 0)
    return 0;
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

void ChildRun::interrupt() const
{
  if (process_ > 0)
    kill(process_, SIGINT);
}

}
