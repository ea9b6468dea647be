#include "VtkMessages.h"

#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <mutex>

namespace vesicle
{
namespace
{

thread_local VtkMessages::Kept* kept_here = nullptr;

/// In the place of the process's one output window: what a thread wants kept is kept for it, the
/// rest is said as before.
class Sorter : public vtkOutputWindow
{
public:
  static Sorter* New();
  vtkTypeMacro(Sorter, vtkOutputWindow);

  void DisplayText(const char* text) override
  {
    if (!kept_here)
    {
      before->DisplayText(text);
    }
  }
  void DisplayWarningText(const char* text) override
  {
    kept_here ? kept_here->warn(text) : before->DisplayWarningText(text);
  }
  void DisplayGenericWarningText(const char* text) override
  {
    if (!kept_here)
    {
      before->DisplayGenericWarningText(text);
    }
  }
  void DisplayDebugText(const char* text) override
  {
    if (!kept_here)
    {
      before->DisplayDebugText(text);
    }
  }
  void DisplayErrorText(const char* text) override
  {
    kept_here ? kept_here->fail(text) : before->DisplayErrorText(text);
  }

  vtkSmartPointer<vtkOutputWindow> before;
};
vtkStandardNewMacro(Sorter);

/// The process's output window while there is any VtkMessages.
class Sorting
{
public:
  void begin()
  {
    const std::lock_guard lock(mutex_);
    if (++users_ > 1)
    {
      return;
    }
    auto sorter = vtkSmartPointer<Sorter>::New();
    sorter->before = vtkOutputWindow::GetInstance();
    before_ = sorter->before;
    verbosity_ = vtkLogger::GetCurrentVerbosityCutoff();
    vtkOutputWindow::SetInstance(sorter);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // it prints errors a second time
  }
  void end()
  {
    const std::lock_guard lock(mutex_);
    if (--users_ > 0)
    {
      return;
    }
    vtkOutputWindow::SetInstance(before_);
    before_ = nullptr;
    vtkLogger::SetStderrVerbosity(verbosity_);
  }

private:
  std::mutex mutex_;
  int users_ = 0;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_ = vtkLogger::VERBOSITY_OFF;
};

Sorting& sorting()
{
  static Sorting one;
  return one;
}

/// "… line 12\nvtkClass (0x55…): what happened\nmore" without what only a debugger needs.
std::string what_happened(std::string text)
{
  const auto where = text.find("): ");
  text = where == std::string::npos ? text : text.substr(where + 3);
  return text.substr(0, text.find('\n'));
}

}

VtkMessages::VtkMessages() : outer_(kept_here)
{
  sorting().begin();
  kept_here = &kept_;
}

VtkMessages::~VtkMessages()
{
  kept_here = outer_;
  sorting().end();
}

std::string VtkMessages::first_warning() const
{
  const auto all = warnings();
  return all.empty() ? "" : all.front();
}

std::vector<std::string> VtkMessages::warnings() const
{
  std::vector<std::string> result = kept_.warnings;
  std::transform(result.begin(), result.end(), result.begin(), what_happened);
  return result;
}

std::string VtkMessages::first_error() const
{
  return what_happened(kept_.first_error);
}

}
