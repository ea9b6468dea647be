#pragma once
// Takes the numbers that a target needs out of any bytes.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <string_view>

namespace vesicle::fuzz
{

class Bytes
{
public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}

  bool empty() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }
  /// Of the next bytes, the machine's way round; zeros follow the last one.
  template<class Number>
  Number take()
  {
    Number number = 0;
    const std::size_t size = std::min(sizeof(Number), rest_.size());
    std::memcpy(&number, rest_.data(), size);
    rest_.remove_prefix(size);
    return number;
  }
  /// 0 to count − 1.
  int below(int count) { return take<std::uint8_t>() % count; }

private:
  std::string_view rest_;
};

/// Numbers that programs trip over.
inline double special_number(std::uint8_t which)
{
  using Limits = std::numeric_limits<double>;
  constexpr double numbers[] = { 0, -0.0, 1, -1, 0.5, 1e-300, 1e300, -1e300, 1e160, 1e-160, 1e20,
    Limits::denorm_min(), Limits::min(), Limits::max(), Limits::lowest(), Limits::infinity(),
    -Limits::infinity(), Limits::quiet_NaN(), Limits::signaling_NaN(), 2147483647, 2147483648.0,
    -2147483649.0, 9223372036854775808.0, 1e9, 1 + Limits::epsilon(), 3e38, 4e38, 1e-46 };
  return numbers[which % std::size(numbers)];
}

}
