#include "solver/state/XmlText.h"

namespace vesicle
{

std::string xml_text(const std::string& text)
{
  std::string encoded;
  for (const char c : text)
  {
    switch (c)
    {
      case '&':
        encoded += "&amp;";
        break;
      case '<':
        encoded += "&lt;";
        break;
      case '>':
        encoded += "&gt;";
        break;
      case '"':
        encoded += "&quot;";
        break;
      case '\'':
        encoded += "&apos;";
        break;
      default:
        encoded += c;
    }
  }
  return encoded;
}

}
