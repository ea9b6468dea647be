#pragma once
// With what the program was built, and what it runs on.

#include <string>
#include <utility>
#include <vector>

namespace vesicle
{

/// Name and version, in order: vesicle, the libraries, the compiler with its kind of build, OpenBLAS's kernel.
std::vector<std::pair<std::string, std::string>> build_facts();

/// The same for `vesicle --version`: "vesicle 1.2.3" alone in the first line.
std::string version_text();

}
