#pragma once
// How a target tells a fault that nothing else would notice.

#include <stdexcept>
#include <string>

namespace vesicle::fuzz
{

struct Fault : std::logic_error
{
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& what)
{
  if (!holds)
    throw Fault(what);
}

}
