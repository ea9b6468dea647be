// Completion and manual pages, as the build makes them.

#include "Command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

namespace vesicle::test
{
namespace
{

namespace fs = std::filesystem;

/// Made once for all tests.
const TemporaryFolder& pages()
{
  static const TemporaryFolder folder;
  static const auto outcome = vesicle_command(folder.path(), { "--help-pages", "share" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return folder;
}

/// As `vesicle --help` lists them.
std::set<std::string> commands()
{
  const std::string help = vesicle_command(pages().path(), { "--help" }).output;
  std::set<std::string> names;
  const std::regex line("\n  ([a-z]+) +[A-Z]");
  const std::string list = help.substr(help.find("Subcommands:"));
  for (auto match = std::sregex_iterator(list.begin(), list.end(), line);
       match != std::sregex_iterator(); ++match)
  {
    names.insert((*match)[1]);
  }
  return names;
}

std::set<std::string> long_options(const std::string& text)
{
  std::set<std::string> names;
  const std::regex option("--[a-z][a-z-]+");
  for (auto match = std::sregex_iterator(text.begin(), text.end(), option);
       match != std::sregex_iterator(); ++match)
  {
    names.insert(match->str());
  }
  return names;
}

/// What bash offers for words of a command line, of which the last is to be completed.
std::string completed(const std::string& words)
{
  std::ofstream(pages() / "try.sh") << "source share/bash-completion/completions/vesicle\n"
                                       "COMP_WORDS=("
                                    << words
                                    << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_vesicle\n"
                                       "echo \"${COMPREPLY[@]}\"\n";
  const auto outcome = program("/bin/bash", pages().path(), { "try.sh" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return outcome.output;
}

}

TEST(HelpPages, EachCommandHasAManualPageWithItsOptions)
{
  const auto names = commands();
  EXPECT_GE(names.size(), 12u);
  EXPECT_TRUE(names.contains("run"));
  const fs::path folder = pages() / "share" / "man" / "man1";
  for (const std::string& name : names)
  {
    const std::string page = bytes_of(folder / ("vesicle-" + name + ".1"));
    const std::string help = vesicle_command(pages().path(), { name, "--help" }).output;
    const std::string typed = std::regex_replace(page, std::regex("\\\\-"), "-");
    for (const std::string& option : long_options(help.substr(0, help.find("Example: "))))
    {
      EXPECT_NE(typed.find(option), std::string::npos) << name << ' ' << option;
    }
    EXPECT_NE(bytes_of(folder / "vesicle.1").find("vesicle\\-" + name), std::string::npos);
  }
}

TEST(HelpPages, TroffHasNothingToSayAgainstThem)
{
  if (!fs::exists("/usr/bin/groff"))
  {
    GTEST_SKIP() << "no groff";
  }
  for (const auto& page : fs::directory_iterator(pages() / "share" / "man" / "man1"))
  {
    const auto outcome =
      program("/usr/bin/groff", pages().path(), { "-man", "-Tutf8", "-ww", page.path().string() });
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.errors, "") << page.path();
  }
}

TEST(HelpPages, BashCompletesCommandsOptionsAndChoices)
{
  EXPECT_EQ(completed("vesicle equ"), "equilibrium\n");
  EXPECT_EQ(completed("vesicle curvature mesh.stl --sch"), "--scheme\n");
  EXPECT_EQ(completed("vesicle curvature --scheme ''"), "fit cotan loop\n");
  EXPECT_EQ(completed("vesicle run try"), "try.sh\n");
}

// The other shells need not be there.
TEST(HelpPages, ZshAndFishKnowAllCommands)
{
  const std::string zsh = bytes_of(pages() / "share" / "zsh" / "site-functions" / "_vesicle");
  const std::string fish =
    bytes_of(pages() / "share" / "fish" / "vendor_completions.d" / "vesicle.fish");
  for (const std::string& name : commands())
  {
    EXPECT_NE(zsh.find("    " + name + ")\n"), std::string::npos) << name;
    EXPECT_NE(fish.find("-a " + name + " -d "), std::string::npos) << name;
  }
  for (const char* shell : { "/usr/bin/zsh", "/usr/bin/fish" })
  {
    if (fs::exists(shell))
    {
      const std::string file = std::string(shell).ends_with("zsh")
        ? "share/zsh/site-functions/_vesicle"
        : "share/fish/vendor_completions.d/vesicle.fish";
      EXPECT_EQ(program(shell, pages().path(), { "-n", file }).code, 0);
    }
  }
}

}
