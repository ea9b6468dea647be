#include "apps/StandardOutput.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

namespace vesicle
{
namespace
{

int first_error = 0;

void note_error()
{
  if (first_error == 0)
  {
    first_error = errno ? errno : EIO;
  }
}

}

void prepare_standard_streams()
{
  // Writing to a standard output that isn't there fails, writing to such an error output is lost.
  constexpr std::array<int, 3> modes{ O_RDONLY, O_RDONLY, O_WRONLY };
  for (int stream = 0; stream < 3; ++stream)
  {
    if (::fcntl(stream, F_GETFD) < 0)
    {
      ::open("/dev/null", modes[static_cast<std::size_t>(stream)]); // takes the lowest number
    }
  }
  std::signal(SIGPIPE, SIG_IGN);
  if (!::isatty(STDOUT_FILENO))
  {
    // What std::cout prints (help) is then written by our own flush, which learns why it failed.
    std::setvbuf(stdout, nullptr, _IOFBF, 1 << 16);
  }
}

void write_to_standard_output(std::string_view text)
{
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
  {
    note_error();
  }
}

void flush_standard_output()
{
  errno = 0;
  if (std::fflush(stdout) != 0)
  {
    note_error();
  }
}

int standard_output_error()
{
  flush_standard_output();
  if (std::ferror(stdout)) // of std::cout too
  {
    note_error();
  }
  return first_error;
}

}
