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
    std::string shown; ///< what messages call the table: "vesicle.1.membrane"
  };
  struct Table
  {
    std::string name;
    std::string where;
    std::string shown; ///< as above
  };
  /// The tables of one vesicle: its own [vesicle], and those in it, which stand in place of the
  /// scene's tables of their names.
  struct Vesicle
  {
    std::string
      shown; ///< "vesicle" where it is the only one, "vesicle.1" with its number otherwise
    std::vector<Table> tables;
    std::vector<Entry> entries;
  };

  std::string name;              ///< of the file, for messages
  std::filesystem::path folder;  ///< that relative paths start from
  std::vector<Table> tables;     ///< in the order of the file, without the vesicles'
  std::vector<Entry> entries;    ///< in the order of the file, without the vesicles'
  std::vector<Vesicle> vesicles; ///< at least one, which may be empty

  const SceneValue* find(const std::string& table, const std::string& key) const;
  const Entry* find_entry(const std::string& table, const std::string& key) const;
  const Table* find_table(const std::string& table) const;
  /// What the scene says of one vesicle, as if it were the only one; `vesicles` is empty there. What
  /// a vesicle's own table can't say (the viscosity outside) is the scene's.
  SceneDocument of_vesicle(std::size_t number) const;
};

/// The tables that a vesicle may have of its own.
const std::vector<std::string>& own_tables();
/// Of a key of such a table: one for all vesicles.
bool is_of_the_scene(const std::string& table, const std::string& key);

/// Throws InputError "name:line: …" where the text isn't TOML, "--set …: …" where an override isn't
/// of the form table.key=value. Of several vesicles vesicle.key is every one's, vesicle.1.key that of
/// number 1, and so with vesicle.1.membrane.key.
SceneDocument parse_document(const std::string& text, const std::string& name,
  const std::filesystem::path& folder, const std::vector<std::string>& overrides);

}
