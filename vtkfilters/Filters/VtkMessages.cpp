#include "VtkMessages.h"

#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>

namespace vesicle
{
namespace
{

class Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayWarningText(const char* text) override { warnings.emplace_back(text); }
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    if (first_error.empty())
    {
      first_error = text;
    }
  }

  std::string first_error;
  std::vector<std::string> warnings;
};
vtkStandardNewMacro(Collector);

/// The output window is one for the whole process.
std::recursive_mutex& turns()
{
  static std::recursive_mutex mutex;
  return mutex;
}

/// "… line 12\nvtkClass (0x55…): what happened\nmore" without what only a debugger needs.
std::string what_happened(std::string text)
{
  const auto where = text.find("): ");
  text = where == std::string::npos ? text : text.substr(where + 3);
  return text.substr(0, text.find('\n'));
}

}

VtkMessages::VtkMessages()
  : lock_(turns()), before_(vtkOutputWindow::GetInstance()),
    collector_(vtk::TakeSmartPointer<vtkOutputWindow>(Collector::New()))
{
  vtkOutputWindow::SetInstance(collector_);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // it prints errors a second time
}

VtkMessages::~VtkMessages()
{
  vtkOutputWindow::SetInstance(before_);
  vtkLogger::SetStderrVerbosity(verbosity_);
}

bool VtkMessages::any_error() const
{
  return !static_cast<Collector*>(collector_.Get())->first_error.empty();
}

std::string VtkMessages::first_warning() const
{
  const auto all = warnings();
  return all.empty() ? "" : all.front();
}

std::vector<std::string> VtkMessages::warnings() const
{
  std::vector<std::string> result = static_cast<Collector*>(collector_.Get())->warnings;
  std::transform(result.begin(), result.end(), result.begin(), what_happened);
  return result;
}

std::string VtkMessages::first_error() const
{
  return what_happened(static_cast<Collector*>(collector_.Get())->first_error);
}

}
