#pragma once
// Numbers as bytes in files, the lowest first whatever the machine.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

namespace vesicle
{

/// Appends `count` numbers of 8 bytes each.
template<class Number>
void append_numbers(std::string& bytes, const Number* numbers, std::size_t count)
{
  static_assert(sizeof(Number) == 8);
  const std::size_t begin = bytes.size();
  if (count == 0)
  {
    return;
  }
  bytes.resize(begin + 8 * count);
  std::memcpy(bytes.data() + begin, numbers, 8 * count);
  if constexpr (std::endian::native == std::endian::big)
  {
    for (auto at = bytes.begin() + static_cast<long>(begin); at != bytes.end(); at += 8)
    {
      std::reverse(at, at + 8);
    }
  }
}

/// The number of 8 bytes that begins at `place`, which is not too close to the end.
template<class Number>
Number number_at(std::string_view bytes, std::size_t place)
{
  static_assert(sizeof(Number) == 8);
  char number[8];
  std::copy_n(bytes.data() + place, 8, number);
  if constexpr (std::endian::native == std::endian::big)
  {
    std::reverse(number, number + 8);
  }
  return std::bit_cast<Number>(number);
}

}
