#pragma once
// VTK prints what goes wrong; here it is caught, to become part of an exception.

#include "VesicleFiltersModule.h"

#include "vtkLogger.h"
#include "vtkSmartPointer.h"

#include <mutex>
#include <string>
#include <vector>

class vtkOutputWindow;

namespace vesicle
{

/// While in scope, VTK's messages of all objects and threads are kept instead of printed. Another
/// thread that wants the same waits.
class VESICLEFILTERS_EXPORT VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool any_error() const;
  /// What happened, in one line; empty: nothing.
  std::string first_error() const;
  std::string first_warning() const;
  std::vector<std::string> warnings() const;

private:
  std::unique_lock<std::recursive_mutex> lock_;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkSmartPointer<vtkOutputWindow> collector_;
  vtkLogger::Verbosity verbosity_ = vtkLogger::GetCurrentVerbosityCutoff();
};

}
