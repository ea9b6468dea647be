#pragma once
// What the command line says of itself, as data: shells' completion and manual pages are made of
// it.

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace vesicle
{

struct OptionHelp
{
  std::vector<std::string> names; ///< "-o", "--output"; of a positional one "scene"
  std::string description;
  std::string default_value;
  std::vector<std::string> choices; ///< all that it takes; empty: anything
  bool takes_value = false;
  bool positional = false;
  bool required = false;
  bool repeats = false; ///< takes several values
};

struct CommandHelp
{
  std::string name; ///< empty: the program itself
  std::string description;
  std::string footer; ///< examples
  std::vector<OptionHelp> options;
};

/// The program first, then its commands in their order; hidden options are left out.
std::vector<CommandHelp> command_help(const CLI::App& app);

}
