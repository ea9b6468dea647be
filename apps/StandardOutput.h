#pragma once
// What the commands print. It may fail like any file: full, or a pipe that nobody reads any more.

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace vesicle
{

/// To be called before anything is opened: no file of ours takes the place of a standard stream that
/// was closed, and a closed pipe is an error like others instead of the program's end.
void prepare_standard_streams();

/// Never throws: what is being done goes on, and the failure is told at the end.
void write_to_standard_output(std::string_view text);
void flush_standard_output();

/// As fmt::print, to the standard output.
template<class... Values>
void print(fmt::format_string<Values...> format, Values&&... values)
{
  write_to_standard_output(fmt::format(format, std::forward<Values>(values)...));
}

/// Flushes. 0, or the system's error number of what failed first since the program began.
int standard_output_error();

}
