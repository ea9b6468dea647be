#include "solver/files/Checksum.h"

#include <array>

namespace vesicle
{
namespace
{

constexpr std::uint64_t polynomial = 0xC96C5795D7870F42; // of ECMA-182, lowest power first

constexpr std::array<std::uint64_t, 256> remainders()
{
  std::array<std::uint64_t, 256> table{};
  for (std::uint64_t byte = 0; byte < table.size(); ++byte)
  {
    std::uint64_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit)
    {
      remainder = (remainder >> 1) ^ (remainder & 1 ? polynomial : 0);
    }
    table[byte] = remainder;
  }
  return table;
}

}

std::uint64_t checksum(std::string_view bytes, std::uint64_t before)
{
  static constexpr auto table = remainders();
  std::uint64_t remainder = ~before;
  for (const char c : bytes)
  {
    remainder = table[(remainder ^ static_cast<unsigned char>(c)) & 0xFF] ^ (remainder >> 8);
  }
  return ~remainder;
}

}
