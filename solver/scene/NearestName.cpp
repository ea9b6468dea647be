#include "solver/scene/NearestName.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace vesicle
{
namespace
{

bool same_letter(char a, char b)
{
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}

// Wagner and Fischer, row by row: row[j] is the distance of a's first i letters to b's first j.
int edit_distance(std::string_view a, std::string_view b)
{
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const int substituted = diagonal + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({ substituted, row[j] + 1, row[j - 1] + 1 });
    }
  }
  return row.back();
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& known)
{
  std::string nearest;
  int smallest = std::max(1, static_cast<int>(name.size()) / 2) + 1;
  for (const auto& candidate : known)
  {
    const int distance = edit_distance(name, candidate);
    if (distance < smallest)
    {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}
