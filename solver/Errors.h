#pragma once
// The three ways in which something can go wrong. A message says what, where (vertex, triangle,
// time, file and line) and what to try.

#include <stdexcept>

namespace vesicle
{

/// The scene, mesh or argument can't be used: missing, malformed or impossible (exit code 2).
struct InputError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The computation can't go on; the last good state is still valid (exit code 3).
struct NumericalError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file can't be read or written while working (exit code 4).
struct IoError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

}
