#pragma once
// Functions of a shared library that is loaded at run time.

#include <dlfcn.h>

namespace vesicle
{

/// Points `function` at the library's symbol; false when it has none of that name.
template<typename Function>
bool find_symbol(void* library, const char* name, Function& function)
{
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

}
