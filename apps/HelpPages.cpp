#include "apps/HelpPages.h"

#include "solver/Joined.h"
#include "solver/files/FileBytes.h"

#include <fmt/format.h>

#include <sstream>

namespace vesicle
{
namespace
{

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
  {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// In single quotes of a POSIX shell.
std::string quoted(const std::string& text)
{
  return "'" + replaced(text, "'", "'\\''") + "'";
}

std::string names_of(const std::vector<CommandHelp>& commands)
{
  std::vector<std::string> names;
  for (const CommandHelp& command : commands)
  {
    if (!command.name.empty())
    {
      names.push_back(command.name);
    }
  }
  return joined(names, " ");
}

std::string option_names(const CommandHelp& command)
{
  std::vector<std::string> names;
  for (const OptionHelp& option : command.options)
  {
    if (!option.positional)
    {
      names.insert(names.end(), option.names.begin(), option.names.end());
    }
  }
  return joined(names, " ");
}

}

std::string bash_completion(const std::vector<CommandHelp>& commands)
{
  std::string choices, options;
  for (const CommandHelp& command : commands)
  {
    if (!command.name.empty())
    {
      options +=
        fmt::format("    {}) options={} ;;\n", command.name, quoted(option_names(command)));
    }
    for (const OptionHelp& option : command.options)
    {
      for (const std::string& name : option.names)
      {
        if (!option.choices.empty() && !option.positional)
        {
          choices += fmt::format("    {}) words={} ;;\n", quoted(command.name + " " + name),
            quoted(joined(option.choices, " ")));
        }
      }
    }
  }
  return fmt::format(R"(# bash completion for vesicle
_vesicle()
{{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}}
  local command=${{COMP_WORDS[1]}} options='' words=''
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W {} -- "$current"))
    return
  fi
  case "$command $previous" in
{}  esac
  case "$command" in
{}  esac
  if [ -n "$words" ]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
  elif [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
  else
    local IFS=$'\n'
    compopt -o filenames 2> /dev/null
    COMPREPLY=($(compgen -f -- "$current"))
  fi
}}
complete -F _vesicle vesicle
)",
    quoted(names_of(commands) + " " + option_names(commands.front())), choices, options);
}

namespace
{

/// In a description between brackets of _arguments, within single quotes.
std::string zsh_text(const std::string& text)
{
  std::string safe;
  for (const char c : text)
  {
    safe +=
      c == '[' || c == ']' || c == ':' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return replaced(safe, "'", "'\\''");
}

std::string zsh_option(const OptionHelp& option)
{
  const std::string value = !option.takes_value ? ""
    : option.choices.empty()                    ? ":value:_files"
                             : fmt::format(":value:({})", joined(option.choices, " "));
  std::string text;
  for (const std::string& name : option.names)
  {
    text += fmt::format(" \\\n        '{}[{}]{}'", name, zsh_text(option.description), value);
  }
  return text;
}

}

std::string zsh_completion(const std::vector<CommandHelp>& commands)
{
  std::string list, cases;
  for (const CommandHelp& command : commands)
  {
    if (command.name.empty())
    {
      continue;
    }
    list += fmt::format(
      "    {}\n", quoted(command.name + ":" + replaced(command.description, ":", "\\:")));
    cases += fmt::format("    {})\n      _arguments", command.name);
    for (const OptionHelp& option : command.options)
    {
      cases += option.positional ? "" : zsh_option(option);
    }
    cases += " \\\n        '*:file:_files'\n      ;;\n";
  }
  return fmt::format(R"(#compdef vesicle
# zsh completion for vesicle
_vesicle()
{{
  local -a commands
  commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{}  esac
}}
_vesicle "$@"
)",
    list, cases);
}

namespace
{

/// In single quotes of fish, which knows backslashes there.
std::string fish_quoted(const std::string& text)
{
  return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::string fish_option(const std::string& condition, const OptionHelp& option)
{
  std::string line = "complete -c vesicle -n " + fish_quoted(condition);
  for (const std::string& name : option.names)
  {
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (option.takes_value)
  {
    line += option.choices.empty() ? " -r" : " -x -a " + fish_quoted(joined(option.choices, " "));
  }
  return line + " -d " + fish_quoted(option.description) + "\n";
}

}

std::string fish_completion(const std::vector<CommandHelp>& commands)
{
  std::string text = "# fish completion for vesicle\n";
  for (const CommandHelp& command : commands)
  {
    const std::string condition = command.name.empty()
      ? "__fish_use_subcommand"
      : "__fish_seen_subcommand_from " + command.name;
    if (!command.name.empty())
    {
      text += fmt::format("complete -c vesicle -n __fish_use_subcommand -f -a {} -d {}\n",
        command.name, fish_quoted(command.description));
    }
    for (const OptionHelp& option : command.options)
    {
      text += option.positional ? "" : fish_option(condition, option);
    }
  }
  return text;
}

namespace
{

/// Letters beyond ASCII, as UTF-8, by their numbers, which troff knows in any locale.
std::string in_ascii(const std::string& text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const auto first = static_cast<unsigned char>(text[i]);
    if (first < 0x80)
    {
      result += text[i];
      continue;
    }
    const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    unsigned letter = first & (0x3Fu >> more);
    for (int k = 0; k < more && i + 1 < text.size(); ++k)
    {
      letter = letter << 6 | (static_cast<unsigned char>(text[++i]) & 0x3Fu);
    }
    result += fmt::format("\\[u{:04X}]", letter);
  }
  return result;
}

/// As text between troff's requests: no line is one, and dashes are those to be typed.
std::string troff(const std::string& text)
{
  std::string safe = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  safe = replaced(safe, "\n.", "\n\\&.");
  safe = replaced(safe, "\n'", "\n\\&'");
  safe = in_ascii(safe);
  return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

std::string synopsis(const CommandHelp& command)
{
  if (command.name.empty())
  {
    return ".B vesicle\n.I command\n.RI [ options ]\n";
  }
  std::string text = ".B vesicle " + troff(command.name) + "\n";
  for (const OptionHelp& option : command.options)
  {
    if (option.positional)
    {
      const std::string name = troff(option.names.front()) + (option.repeats ? " ..." : "");
      text += option.required ? ".I " + name + "\n" : ".RI [ \"" + name + "\" ]\n";
    }
    else if (option.required)
    {
      text += fmt::format(".BI \"{} \" value\n", troff(option.names.front()));
    }
  }
  return text + ".RI [ options ]\n";
}

std::string option_paragraph(const OptionHelp& option)
{
  std::string text = ".TP\n";
  const std::string names = troff(joined(option.names, ", "));
  text += option.positional ? ".I " + names + "\n"
    : option.takes_value    ? fmt::format(".BI \"{} \" value\n", names)
                            : ".B " + names + "\n";
  text += troff(option.description);
  if (!option.choices.empty())
  {
    text += troff("; one of " + joined(option.choices, ", "));
  }
  if (!option.default_value.empty())
  {
    text += troff(fmt::format(" (default: {})", option.default_value));
  }
  return text + "\n";
}

/// "Example: vesicle …" and the lines below it, as they are to be typed.
std::string examples(const std::string& footer)
{
  std::string text = ".SH EXAMPLES\n.nf\n";
  std::istringstream lines(replaced(footer, "Example: ", ""));
  for (std::string line; std::getline(lines, line);)
  {
    const auto begin = line.find_first_not_of(' ');
    if (begin != std::string::npos)
    {
      text += troff(line.substr(begin)) + "\n";
    }
  }
  return text + ".fi\n";
}

constexpr const char* exit_status = R"(.SH EXIT STATUS
0 done; 1 a row of
.B vesicle validate
failed; 2 bad usage, scene or mesh; 3 the simulation can't go on; 4 a file can't be read or written;
130 interrupted.
)";

std::string page_name(const CommandHelp& command)
{
  return command.name.empty() ? "vesicle" : "vesicle-" + command.name;
}

}

std::string manual_page(const CommandHelp& command, const std::vector<CommandHelp>& all)
{
  std::string text =
    fmt::format(".TH {} 1 \"\" \"vesicle " VESICLE_VERSION "\" \"\"\n.SH NAME\n{} \\- {}\n"
                ".SH SYNOPSIS\n{}.SH OPTIONS\n",
      troff(page_name(command)), troff(page_name(command)), troff(command.description),
      synopsis(command));
  for (const OptionHelp& option : command.options)
  {
    text += option_paragraph(option);
  }
  if (command.name.empty())
  {
    text += ".SH COMMANDS\n";
    for (const CommandHelp& other : all)
    {
      text += other.name.empty()
        ? ""
        : fmt::format(".TP\n.BR {} (1)\n{}\n", troff(page_name(other)), troff(other.description));
    }
  }
  return text + exit_status + examples(command.footer) +
    (command.name.empty() ? "" : ".SH SEE ALSO\n.BR vesicle (1)\n");
}

void write_help_pages(const CLI::App& app, const std::filesystem::path& share)
{
  const auto write = [&](const std::filesystem::path& file, const std::string& text)
  {
    make_folder((share / file).parent_path());
    replace_file(share / file, text);
  };
  const std::vector<CommandHelp> commands = command_help(app);
  write("bash-completion/completions/vesicle", bash_completion(commands));
  write("zsh/site-functions/_vesicle", zsh_completion(commands));
  write("fish/vendor_completions.d/vesicle.fish", fish_completion(commands));
  for (const CommandHelp& command : commands)
  {
    write(std::filesystem::path("man/man1") / (page_name(command) + ".1"),
      manual_page(command, commands));
  }
}

}
