#pragma once
// VTK prints what goes wrong; here it is caught, to become part of an exception.

#include "VesicleFiltersModule.h"

#include <string>
#include <vector>

namespace vesicle
{

/// While in scope, what VTK says on this thread is kept instead of printed. In the scope of another
/// one that is the inner one's. What other threads say is theirs: kept by their own, or printed.
class VESICLEFILTERS_EXPORT VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool any_error() const { return !kept_.first_error.empty(); }
  /// What happened, in one line; empty: nothing.
  std::string first_error() const;
  std::string first_warning() const;
  std::vector<std::string> warnings() const;

  /// As VTK says them.
  struct Kept
  {
    std::string first_error;
    std::vector<std::string> warnings;

    void fail(const char* text) { first_error = first_error.empty() ? text : first_error; }
    void warn(const char* text) { warnings.emplace_back(text); }
  };

private:
  Kept kept_;
  Kept* outer_; ///< of this thread
};

}
