#pragma once
// What a command has to say beside its result.

#include <iostream>
#include <string>

namespace vesicle
{

/// A line on standard error; nothing of an empty text.
inline void warn(const std::string& text)
{
  if (!text.empty())
  {
    std::cerr << "vesicle: " << text << '\n';
  }
}

}
