#pragma once
// Words and numbers out of a text, the same under every locale.

#include <charconv>
#include <limits>
#include <system_error>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace vesicle
{

/// A number in the C locale's form, whatever the process's locale, with or without a plus sign; the
/// whole word must be one. Too small for the type: 0; too large: infinite, nothing for integers.
template<typename T>
std::optional<T> number_of(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+')
    word.remove_prefix(1);
  T value{};
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || word.empty() || error == std::errc::invalid_argument)
    return {};
  if (error == std::errc())
    return value;
  if constexpr (std::is_floating_point_v<T>)
  {
    // Out of range either way: 1e-400 or 1e+400.
    const auto exponent = word.find_last_of("eE");
    const bool small = exponent != std::string_view::npos
      ? word.substr(exponent).find('-') != std::string_view::npos
      : word.find('.') <= 2;
    const T magnitude = small ? T(0) : std::numeric_limits<T>::infinity();
    return word[0] == '-' ? -magnitude : magnitude;
  }
  return {};
}

/// A place in a text that belongs to the caller. Words are parted by blanks and ends of lines (LF,
/// CR or both); a byte order mark at the start is passed over. `name` stands for the file in
/// messages. Throws InputError "name:line: …".
class TextScanner
{
public:
  enum class Comments
  {
    none,
    hash ///< from # to the end of the line
  };
  TextScanner(std::string_view text, std::string name, Comments comments = Comments::none);

  /// The next word, on this line or a later one; empty at the end of the text.
  std::string_view word();
  /// As word(), without going past it.
  std::string_view peek() const;
  /// The next word on this line; empty where the line has no more.
  std::string_view word_on_line();
  /// What this line still has, without its end, comments included; the place is then the next line.
  std::string_view rest_of_line();
  /// Past this line if it has no more words. Throws InputError if it has.
  void require_end_of_line();
  /// To the next line that has a word.
  void skip_empty_lines() { skip_blanks_and_lines(); }
  bool at_end() const; ///< no more words

  /// Throws InputError unless the word is a number of that type; `what` says what it should be.
  template<typename T>
  T number(std::string_view what)
  {
    return to_number<T>(word(), what);
  }
  template<typename T>
  T number_on_line(std::string_view what)
  {
    return to_number<T>(word_on_line(), what);
  }

  /// Throws InputError if `count` numbers can't be in what is left of the text.
  void require_words(std::uint64_t count, std::string_view what) const;

  std::size_t position() const { return position_; }
  std::size_t left() const { return text_.size() - position_; }
  /// Goes on `bytes` later; for what is in between that isn't text.
  void skip(std::size_t bytes) { position_ += bytes; }

  [[noreturn]] void fail(std::string_view problem) const;

private:
  template<typename T>
  T to_number(std::string_view word, std::string_view what) const
  {
    const auto value = number_of<T>(word);
    if (!value)
      fail_number(word, what);
    return *value;
  }
  [[noreturn]] void fail_number(std::string_view word, std::string_view what) const;
  void skip_blanks();
  void skip_blanks_and_lines();
  bool at_line_end() const;
  std::string_view take_word();

  std::string_view text_;
  std::size_t position_ = 0;
  std::string name_;
  Comments comments_;
  int line_ = 1;
};

}
