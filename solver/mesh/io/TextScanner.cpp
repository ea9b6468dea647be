#include "solver/mesh/io/TextScanner.h"

#include "solver/Errors.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
/// A word's part that a message shows.
constexpr std::size_t shown = 40;

bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// Only what can be printed: a damaged file may have anything here.
std::string printable(std::string_view word)
{
  std::string result(word.substr(0, shown));
  for (char& c : result)
    c = c >= ' ' && c <= '~' ? c : '?';
  return word.size() > shown ? result + "…" : result;
}

}

TextScanner::TextScanner(std::string_view text, std::string name, Comments comments)
  : text_(text), name_(std::move(name)), comments_(comments)
{
  if (text_.starts_with(byte_order_mark))
    position_ = byte_order_mark.size();
}

bool TextScanner::at_line_end() const
{
  return position_ >= text_.size() || text_[position_] == '\n' || text_[position_] == '\r';
}

void TextScanner::skip_blanks()
{
  while (position_ < text_.size() && is_blank(text_[position_]))
    ++position_;
  if (comments_ == Comments::hash && position_ < text_.size() && text_[position_] == '#')
    while (!at_line_end())
      ++position_;
}

void TextScanner::skip_blanks_and_lines()
{
  for (skip_blanks(); position_ < text_.size() && at_line_end(); skip_blanks())
    rest_of_line();
}

std::string_view TextScanner::take_word()
{
  const std::size_t first = position_;
  while (!at_line_end() && !is_blank(text_[position_]))
    ++position_;
  return text_.substr(first, position_ - first);
}

std::string_view TextScanner::word()
{
  skip_blanks_and_lines();
  return take_word();
}

std::string_view TextScanner::peek() const
{
  TextScanner ahead(*this);
  return ahead.word();
}

std::string_view TextScanner::word_on_line()
{
  skip_blanks();
  return take_word();
}

std::string_view TextScanner::rest_of_line()
{
  const std::size_t first = position_;
  while (!at_line_end())
    ++position_;
  const auto rest = text_.substr(first, position_ - first);
  if (position_ < text_.size())
  {
    const bool two =
      text_[position_] == '\r' && position_ + 1 < text_.size() && text_[position_ + 1] == '\n';
    position_ += two ? 2 : 1;
    ++line_;
  }
  return rest;
}

void TextScanner::require_end_of_line()
{
  skip_blanks();
  if (!at_line_end())
    fail(fmt::format("'{}' is more than should be on this line", printable(take_word())));
  rest_of_line();
}

bool TextScanner::at_end() const
{
  return peek().empty();
}

void TextScanner::require_words(std::uint64_t count, std::string_view what) const
{
  // A word and a blank take two bytes.
  if (count > (left() + 1) / 2)
    fail(
      fmt::format("the file ends too early: {} would take {} words or more, but {} bytes are left",
        what, count, left()));
}

void TextScanner::fail(std::string_view problem) const
{
  throw InputError(
    fmt::format("{}:{}: {}; write the mesh again, or in another format", name_, line_, problem));
}

void TextScanner::fail_number(std::string_view word, std::string_view what) const
{
  if (word.empty() && position_ >= text_.size())
    fail(fmt::format("the file ends too early, where {} should be", what));
  if (word.empty())
    fail(fmt::format("the line ends where {} should be", what));
  fail(fmt::format("'{}' stands where {} should be", printable(word), what));
}

}
