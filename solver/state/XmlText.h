#pragma once
// Text within XML.

#include <string>

namespace vesicle
{

/// With the characters that mean something to XML as entities; as content and as an attribute's
/// value.
std::string xml_text(const std::string& text);

}
