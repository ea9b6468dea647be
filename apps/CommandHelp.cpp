#include "apps/CommandHelp.h"

#include <CLI/CLI.hpp>

#include <sstream>

namespace vesicle
{
namespace
{

/// CLI::IsMember tells its words as "{fit,cotan,loop}" in the type's name.
std::vector<std::string> choices_in(const std::string& type)
{
  const auto begin = type.find('{'), end = type.find('}', begin);
  if (begin == std::string::npos || end == std::string::npos)
  {
    return {};
  }
  std::vector<std::string> choices;
  std::istringstream words(type.substr(begin + 1, end - begin - 1));
  for (std::string word; std::getline(words, word, ',');)
  {
    choices.push_back(word);
  }
  return choices;
}

OptionHelp help_of(const CLI::Option& option)
{
  OptionHelp help;
  help.positional = !option.nonpositional();
  if (help.positional)
  {
    help.names.push_back(option.get_name(true));
  }
  for (const std::string& name : option.get_snames())
  {
    help.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames())
  {
    help.names.push_back("--" + name);
  }
  help.description = option.get_description();
  help.takes_value = option.get_items_expected_max() > 0;
  help.default_value = help.takes_value ? option.get_default_str() : "";
  help.choices = choices_in(option.get_type_name());
  help.required = option.get_required();
  help.repeats = option.get_expected_max() > 1;
  return help;
}

CommandHelp help_of(const CLI::App& app, const std::string& name)
{
  CommandHelp help{ name, app.get_description(), app.get_footer(), {} };
  for (const CLI::Option* option : app.get_options())
  {
    if (!option->get_group().empty())
    {
      help.options.push_back(help_of(*option));
    }
  }
  return help;
}

}

std::vector<CommandHelp> command_help(const CLI::App& app)
{
  std::vector<CommandHelp> all{ help_of(app, "") };
  for (const CLI::App* command : app.get_subcommands({}))
  {
    all.push_back(help_of(*command, command->get_name()));
  }
  return all;
}

}
