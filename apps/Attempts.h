#pragma once
// Several pieces of work of which a failing one must not lose the others.

#include "solver/Doing.h"

#include <string>
#include <vector>

namespace vesicle
{

class Attempts
{
public:
  /// Does the work; `what` is what is being done and to which file. Returns why it failed, or
  /// nothing.
  template<typename Work>
  std::string attempt(const std::string& what, Work&& work)
  {
    try
    {
      doing(what, std::forward<Work>(work));
      return "";
    }
    catch (const std::exception& error)
    {
      failures_.emplace_back(error.what());
      return failures_.back();
    }
  }

  /// Throws IoError with what failed, a line each, if anything did.
  void require_success() const;

private:
  std::vector<std::string> failures_;
};

}
