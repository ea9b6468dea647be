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

/// Appends `count` numbers.
template<class Number>
void append_numbers(std::string& bytes, const Number* numbers, std::size_t count)
{
  const std::size_t begin = bytes.size(), size = sizeof(Number);
  if (count == 0)
  {
    return;
  }
  bytes.resize(begin + size * count);
  std::memcpy(bytes.data() + begin, numbers, size * count);
  if constexpr (std::endian::native == std::endian::big)
  {
    for (auto at = bytes.begin() + static_cast<long>(begin); at != bytes.end(); at += size)
    {
      std::reverse(at, at + size);
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
