#pragma once
// What the program was doing when a library threw something that nobody foresaw.

#include <stdexcept>
#include <string>
#include <utility>

namespace vesicle
{

/// Out of memory, or a defect of the program. The message says what was being done and to which
/// file.
struct UnforeseenError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// To be called while an exception is handled. The errors of Errors.h and UnforeseenError are
/// passed on, since they say what and where; of the system's errors (files) it makes an IoError, of
/// any other std::exception an UnforeseenError, with a message that begins with `what`.
[[noreturn]] void rethrow_while(const std::string& what);

/// Does the work and returns what it returns. `what` is what is being done and to which file
/// ("drawing pear/plots/velocity.png"); see rethrow_while for what becomes of exceptions.
template<typename Work>
decltype(auto) doing(const std::string& what, Work&& work)
{
  try
  {
    return std::forward<Work>(work)();
  }
  catch (...)
  {
    rethrow_while(what);
  }
}

}
