#pragma once
// Tells a file's bytes from damaged ones.

#include <cstdint>
#include <string_view>

namespace vesicle
{

/// CRC-64/XZ (polynomial of ECMA-182, reflected): no error within 64 successive bits goes unnoticed,
/// any other one with a chance of 2⁻⁶⁴. Of bytes in pieces: `before` is the checksum of those that
/// came before.
std::uint64_t checksum(std::string_view bytes, std::uint64_t before = 0);

}
