#pragma once
// Numbers out of the bytes of a file, none of them past the end.

#include "solver/Errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace vesicle
{

/// A place in bytes that belong to the caller. `name` stands for the file in messages. All
/// functions throw InputError where fewer bytes are left than asked for, before memory is taken.
class ByteReader
{
public:
  ByteReader(std::string_view bytes, std::string name, std::endian order = std::endian::native)
    : bytes_(bytes), name_(std::move(name)), order_(order)
  {
  }

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }

  /// `what` names what is read in the message: "the coordinates of 12 points".
  void require(std::uint64_t count, std::uint64_t bytes_each, std::string_view what) const
  {
    if (bytes_each > 0 && count > left() / bytes_each)
      fail(fmt::format("the file ends too early: {} would take {} × {} bytes, but {} are left",
        what, count, bytes_each, left()));
  }
  std::string_view take(std::uint64_t count, std::string_view what)
  {
    require(count, 1, what);
    const auto result = bytes_.substr(position_, count);
    position_ += count;
    return result;
  }

  template<typename T>
  T read(std::string_view what)
  {
    return value<T>(take(sizeof(T), what).data());
  }
  template<typename T>
  std::vector<T> read_array(std::uint64_t count, std::string_view what)
  {
    require(count, sizeof(T), what);
    std::vector<T> result(count);
    const char* from = take(count * sizeof(T), what).data();
    if (count > 0)
      std::memcpy(result.data(), from, count * sizeof(T));
    if (order_ != std::endian::native && sizeof(T) > 1)
      for (T& x : result)
        x = value<T>(reinterpret_cast<const char*>(&x));
    return result;
  }

  [[noreturn]] void fail(std::string_view problem) const
  {
    throw InputError(
      fmt::format("{}: {} (byte {} of {}); write the mesh again, or in another format", name_,
        problem, position_, bytes_.size()));
  }

private:
  template<typename T>
  T value(const char* from) const
  {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), from, sizeof(T));
    if (order_ != std::endian::native)
      std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
  }

  std::string_view bytes_;
  std::size_t position_ = 0;
  std::string name_;
  std::endian order_;
};

}
