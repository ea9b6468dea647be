#pragma once
// Files of data/ that are part of the program.

#include <string>

namespace vesicle::validation
{

/// The text of data/<name>; the list is in CMakeLists.txt. Throws InputError if it isn't there.
const std::string& data_file(const std::string& name);

}
