#include "Command.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vesicle::test
{
namespace
{

[[noreturn]] void become(const std::filesystem::path& program, const std::filesystem::path& folder,
  const std::vector<std::string>& arguments)
{
  std::vector<char*> words{ const_cast<char*>(program.c_str()) };
  for (const auto& argument : arguments)
  {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  const auto redirect = [](const char* file, int to)
  { return dup2(open(file, O_WRONLY | O_CREAT | O_TRUNC, 0644), to) >= 0; };
  if (chdir(folder.c_str()) == 0 && redirect("stdout.txt", 1) && redirect("stderr.txt", 2))
  {
    execv(program.c_str(), words.data());
  }
  _exit(127);
}

}

Command::Command(const std::filesystem::path& program, const std::filesystem::path& folder,
  const std::vector<std::string>& arguments)
  : process_(fork())
{
  if (process_ == 0)
  {
    become(program, folder, arguments);
  }
}

Command::~Command()
{
  if (running())
  {
    signal(SIGKILL);
    wait();
  }
}

void Command::signal(int number) const
{
  kill(process_, number);
}

bool Command::running()
{
  int status = 0;
  if (!ended_ && waitpid(process_, &status, WNOHANG) == process_)
  {
    ended_ = true;
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return !ended_;
}

int Command::wait()
{
  while (running())
  {
    usleep(1000);
  }
  return code_;
}

Outcome program(const std::filesystem::path& program, const std::filesystem::path& folder,
  const std::vector<std::string>& arguments)
{
  const int code = Command(program, folder, arguments).wait();
  return { code, bytes_of(folder / "stdout.txt"), bytes_of(folder / "stderr.txt") };
}

Outcome vesicle_command(
  const std::filesystem::path& folder, const std::vector<std::string>& arguments)
{
  return program(VESICLE_COMMAND, folder, arguments);
}

Outcome python_file(const std::filesystem::path& folder, const std::filesystem::path& script,
  const std::vector<std::string>& arguments)
{
  std::vector<std::string> words{ "-B", script.string() }; // -B: leave nothing beside the scripts
  words.insert(words.end(), arguments.begin(), arguments.end());
  return program("/usr/bin/python3", folder, words);
}

void expect_usage_errors(
  const std::filesystem::path& folder, const std::vector<std::vector<std::string>>& commands)
{
  for (const auto& arguments : commands)
  {
    const auto outcome = vesicle_command(folder, arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_FALSE(outcome.errors.empty());
  }
}

void write_scene_file(const std::filesystem::path& folder)
{
  std::ofstream(folder / "pear.toml") << R"(name = "pear"
[vesicle]
shape = "prolate"
reduced_volume = 0.95
triangles = 80
[membrane]
bending_rigidity = 1.0
[flow]
kind = "shear"
rate = 1.0
[time]
end = 0.5
output_every = 0.1
[movie]
size = [160, 120]
)";
}

std::string bytes_of(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in.good()) << file;
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

}
