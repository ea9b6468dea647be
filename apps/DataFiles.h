#pragma once
// Files of data/ that are part of the program, which so needs no folder at run time.

#include <string>
#include <vector>

namespace vesicle
{

/// The text of data/<name>; the list is in CMakeLists.txt. Throws InputError if it isn't there.
const std::string& data_file(const std::string& name);

/// The built-in names that begin with this, in ascending order: "scenes/".
std::vector<std::string> data_files(const std::string& beginning);

}
