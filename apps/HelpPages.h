#pragma once
// Completion for shells and manual pages, made of what the commands say of themselves.

#include "apps/CommandHelp.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle
{

/// Each of the whole command line.
std::string bash_completion(const std::vector<CommandHelp>& commands);
std::string zsh_completion(const std::vector<CommandHelp>& commands);
std::string fish_completion(const std::vector<CommandHelp>& commands);
/// vesicle(1) for the program itself, vesicle-run(1) and so on for its commands; the former lists
/// all.
std::string manual_page(const CommandHelp& command, const std::vector<CommandHelp>& all);

/// All of them, where they belong below a share/ folder: bash-completion/completions/vesicle,
/// zsh/site-functions/_vesicle, fish/vendor_completions.d/vesicle.fish, man/man1/*.1. Throws
/// IoError.
void write_help_pages(const CLI::App& app, const std::filesystem::path& share);

}
