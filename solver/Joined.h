#pragma once
// Lists as text.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace vesicle
{

/// The words, one after the other with the separator between them; fmt::join would compile fmt's
/// formatting of strings anew in each file.
inline std::string joined(const std::vector<std::string>& words, std::string_view separator)
{
  std::string text;
  for (const std::string& word : words)
  {
    if (&word != &words.front())
      text += separator;
    text += word;
  }
  return text;
}

/// Those of the texts that say something.
inline std::string joined_said(std::initializer_list<std::string> texts, std::string_view separator)
{
  std::vector<std::string> said;
  for (const std::string& text : texts)
    if (!text.empty())
      said.push_back(text);
  return joined(said, separator);
}

/// The same, one a line.
inline std::string lines(std::initializer_list<std::string> texts)
{
  return joined_said(texts, "\n");
}

}
