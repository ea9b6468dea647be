#pragma once
// "Did you mean": the known name that is nearest to a mistyped one.

#include <string>
#include <string_view>
#include <vector>

namespace vesicle
{

/// Fewest insertions, deletions and substitutions of a character that turn `a` into `b`, capitals
/// taken as small letters.
int edit_distance(std::string_view a, std::string_view b);

/// The first of `known` at the smallest edit distance to `name`; empty if none shares about half of
/// its letters with it.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

}
