#pragma once
// VTK prints what goes wrong; here it is caught, to become part of an exception.

#include "VesicleFiltersModule.h"

#include "vtkLogger.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkOutputWindow;

namespace vesicle
{

/// While in scope, VTK's messages of all objects are kept instead of printed. For one thread at a
/// time.
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

private:
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkSmartPointer<vtkOutputWindow> collector_;
  vtkLogger::Verbosity verbosity_ = vtkLogger::GetCurrentVerbosityCutoff();
};

}
