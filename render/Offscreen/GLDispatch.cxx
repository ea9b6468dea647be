#include "GLDispatch.h"

#include "SharedLibrary.h"

namespace vesicle
{
namespace
{

constexpr int abi_version = 1;

/// Neither 0 (GLX) nor 1 (EGL): libGLX and libEGL then leave our state alone.
constexpr int our_tag = 7;

/// __GLdispatchThreadState: one a thread, since a context may move between threads.
struct ThreadState
{
  int tag;
  void (*thread_destroyed)(ThreadState*);
  void* dispatcher_private;
};
thread_local ThreadState thread_state{ our_tag, nullptr, nullptr };

struct Dispatcher
{
  int (*get_abi_version)();
  void (*init)();
  int (*new_vendor_id)();
  void* (*create_table)(GLDispatchVendor::GetProcAddress, void*);
  unsigned char (*make_current)(ThreadState*, void* table, int vendor, const void* patch);
  void (*lose_current)();
  ThreadState* (*current_thread_state)();
};

bool load(Dispatcher& d, std::string& why_not)
{
  void* library = dlopen("libGLdispatch.so.0", RTLD_NOW);
  if (!library)
  {
    why_not = "libGLdispatch.so.0 is missing (Debian package libglvnd0)";
    return false;
  }
  const bool complete = find_symbol(library, "__glDispatchGetABIVersion", d.get_abi_version) &&
    find_symbol(library, "__glDispatchInit", d.init) &&
    find_symbol(library, "__glDispatchNewVendorID", d.new_vendor_id) &&
    find_symbol(library, "__glDispatchCreateTable", d.create_table) &&
    find_symbol(library, "__glDispatchMakeCurrent", d.make_current) &&
    find_symbol(library, "__glDispatchLoseCurrent", d.lose_current) &&
    find_symbol(library, "__glDispatchGetCurrentThreadState", d.current_thread_state);
  if (!complete || d.get_abi_version() != abi_version)
  {
    why_not = "libGLdispatch.so.0 has an interface other than version 1";
    return false;
  }
  d.init();
  return true;
}

Dispatcher dispatcher{};

}

GLDispatchVendor* GLDispatchVendor::create(GetProcAddress get_proc_address, std::string& why_not)
{
  static std::string failure;
  static const bool loaded = load(dispatcher, failure);
  if (!loaded)
  {
    why_not = failure;
    return nullptr;
  }
  auto* vendor = new GLDispatchVendor;
  vendor->id_ = dispatcher.new_vendor_id();
  vendor->table_ = dispatcher.create_table(get_proc_address, nullptr);
  return vendor;
}

bool GLDispatchVendor::make_current() const
{
  if (is_current())
  {
    return true;
  }
  // The dispatcher asserts when a foreign state is replaced.
  return dispatcher.current_thread_state() == nullptr &&
    dispatcher.make_current(&thread_state, table_, id_, nullptr);
}

bool GLDispatchVendor::is_current() const
{
  return dispatcher.current_thread_state() == &thread_state;
}

void GLDispatchVendor::release_current() const
{
  if (is_current())
  {
    dispatcher.lose_current();
  }
}

}
