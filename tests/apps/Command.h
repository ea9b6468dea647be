#pragma once
// Running `vesicle` as a user does.

#include "tests/support/TemporaryFolder.h"

#include <string>
#include <vector>

#include <sys/types.h>

namespace vesicle::test
{

/// The program, started in a folder; what it prints goes to files there.
class Command
{
public:
  Command(const std::filesystem::path& program, const std::filesystem::path& folder,
    const std::vector<std::string>& arguments);
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  void signal(int number) const;
  bool running();
  /// Exit code once it has ended; 128 + signal if a signal ended it.
  int wait();

private:
  pid_t process_ = -1;
  int code_ = -1;
  bool ended_ = false;
};

struct Outcome
{
  int code;
  std::string output; ///< standard output
  std::string errors; ///< standard error
};

/// Runs `vesicle arguments…` in the folder to its end.
Outcome vesicle_command(
  const std::filesystem::path& folder, const std::vector<std::string>& arguments);
/// Runs any program in the folder to its end.
Outcome program(const std::filesystem::path& program, const std::filesystem::path& folder,
  const std::vector<std::string>& arguments);
/// Runs Debian's Python with this script; exit code 77 stands for a missing module.
Outcome python_file(const std::filesystem::path& folder, const std::filesystem::path& script,
  const std::vector<std::string>& arguments);

/// Each ends with exit code 2 and says why.
void expect_usage_errors(
  const std::filesystem::path& folder, const std::vector<std::vector<std::string>>& commands);
/// A scene of a few seconds at most; writes it as pear.toml.
void write_scene_file(const std::filesystem::path& folder);
std::string bytes_of(const std::filesystem::path& file);

}
