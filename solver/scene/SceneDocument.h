#pragma once
// A scene's TOML as a list of "table.key = value" that knows where each of them stands: in a line
// of the file or on the command line. What the keys mean is the schema's matter.

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace vesicle
{

struct SceneValue
{
  using Array = std::vector<SceneValue>;
  /// A TOML value that no key of a scene takes (a date, a table).
  struct Other
  {
    std::string what;
  };
  std::variant<bool, std::int64_t, double, std::string, Array, Other> data;
  std::string where; ///< "pear.toml:12" or "--set flow.rate=2"
  std::string text;  ///< as typed after --set; empty for values from the file

  /// For messages: `the string "abc"`, `the integer 3`, `an array of 2` …
  std::string description() const;
};

struct SceneDocument
{
  struct Entry
  {
    std::string table; ///< empty: at the top
    std::string key;
    SceneValue value;
  };
  struct Table
  {
    std::string name;
    std::string where;
  };

  std::string name;             ///< of the file, for messages
  std::filesystem::path folder; ///< that relative paths start from
  std::vector<Table> tables;    ///< in the order of the file
  std::vector<Entry> entries;   ///< in the order of the file

  const SceneValue* find(const std::string& table, const std::string& key) const;
  const Table* find_table(const std::string& table) const;
};

/// Throws InputError "name:line: …" where the text isn't TOML, "--set …: …" where an override isn't
/// of the form table.key=value.
SceneDocument parse_document(const std::string& text, const std::string& name,
  const std::filesystem::path& folder, const std::vector<std::string>& overrides);

}
