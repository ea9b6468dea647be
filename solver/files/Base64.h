#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace vesicle
{

/// Bytes as text, RFC 4648.
std::string base64(std::span<const std::byte> bytes);

}
