#include "solver/Doing.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <memory>
#include <new>
#include <system_error>
#include <typeinfo>

#include <cxxabi.h>

namespace vesicle
{
namespace
{

std::string type_name(const std::exception& error)
{
  const char* mangled = typeid(error).name();
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
    abi::__cxa_demangle(mangled, nullptr, nullptr, &status), std::free);
  return status == 0 ? name.get() : mangled;
}

}

void rethrow_while(const std::string& what)
{
  try
  {
    throw;
  }
  catch (const InputError&)
  {
    throw;
  }
  catch (const NumericalError&)
  {
    throw;
  }
  catch (const IoError&)
  {
    throw;
  }
  catch (const UnforeseenError&)
  {
    throw;
  }
  catch (const std::system_error& error)
  {
    throw IoError(fmt::format("{} failed: {}", what, error.what()));
  }
  catch (const std::bad_alloc&)
  {
    throw UnforeseenError(what + " failed: out of memory");
  }
  catch (const std::exception& error)
  {
    throw UnforeseenError(fmt::format("{} failed: {} ({})", what, error.what(), type_name(error)));
  }
}

}
