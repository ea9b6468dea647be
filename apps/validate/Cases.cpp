#include "apps/validate/Cases.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace vesicle::validation
{
namespace
{

bool is_called(const Case& item, const std::string& name)
{
  return item.name == name || item.name.starts_with(name + "/");
}

std::string list_of_names()
{
  std::string names;
  for (const Case& item : all_cases())
  {
    names += "\n  " + item.name;
  }
  return names;
}

}

std::vector<Case> all_cases()
{
  std::vector<Case> all;
  for (const auto& family :
    { curvature_cases(), segmented_cases(), sphere_cases(), shear_cases(), two_fluid_cases(),
      several_cases(), wall_cases(), capsule_cases(), membrane_viscosity_cases(),
      equilibrium_cases(), buoyancy_cases(), relaxation_cases(), operator_cases(), mesh_cases() })
  {
    all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

std::vector<Case> chosen_cases(const std::vector<std::string>& names, bool full)
{
  const std::vector<Case> all = all_cases();
  for (const std::string& name : names)
  {
    if (std::none_of(
          all.begin(), all.end(), [&](const Case& item) { return is_called(item, name); }))
    {
      throw InputError(
        fmt::format("validate: there is no '{}'. A name or the part before its / is one of:{}",
          name, list_of_names()));
    }
  }
  std::vector<Case> chosen;
  for (const Case& item : all)
  {
    const bool named = std::any_of(
      names.begin(), names.end(), [&](const std::string& name) { return is_called(item, name); });
    if (named || (names.empty() && (full || item.set == Case::Set::fast)))
    {
      chosen.push_back(item);
    }
  }
  return chosen;
}

void run_case(const Case& item, Report& report)
{
  report.begin(item.name, item.about);
  try
  {
    item.run(report);
  }
  catch (const IoError&) // of the files that this command writes
  {
    throw;
  }
  catch (const std::runtime_error& error)
  {
    report.add(stopped("stopped", error.what()));
  }
}

}
