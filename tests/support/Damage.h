#pragma once
// Files as accidents make them, the same ones each time.

#include <random>
#include <string>

namespace vesicle::test
{

/// So many changes, each a byte, a bit, bytes put in, left out or repeated; fewer where nothing is
/// left.
inline std::string damaged(std::string bytes, unsigned changes, std::mt19937& random)
{
  for (; changes > 0 && !bytes.empty(); --changes)
  {
    const std::size_t place = random() % bytes.size();
    switch (random() % 5)
    {
      case 0:
        bytes[place] = static_cast<char>(random());
        break;
      case 1:
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << random() % 8));
        break;
      case 2:
        bytes.insert(place, 1 + random() % 3, "0123456789-+.enai \n"[random() % 19]);
        break;
      case 3:
        bytes.erase(place, 1 + random() % 8);
        break;
      default:
        bytes.insert(random() % bytes.size(), bytes.substr(place, 1 + random() % 16));
    }
  }
  return bytes;
}

}
