#include "OSMesaContext.h"

#include "GLDispatch.h"
#include "SharedLibrary.h"

#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <vector>

namespace vesicle
{
namespace
{

// From GL/osmesa.h and GL/gl.h, so that neither is needed to build.
constexpr int gl_rgba = 0x1908;
constexpr unsigned gl_unsigned_byte = 0x1401;
constexpr int osmesa_format = 0x22;
constexpr int osmesa_depth_bits = 0x30;
constexpr int osmesa_stencil_bits = 0x31;
constexpr int osmesa_accum_bits = 0x32;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_context_major_version = 0x36;
constexpr int osmesa_context_minor_version = 0x37;

struct OSMesa
{
  void* (*create_context)(const int* attributes, void* share);
  void (*destroy_context)(void*);
  unsigned char (*make_current)(void* context, void* buffer, unsigned type, int width, int height);
  void* (*get_current_context)();
  void* (*get_proc_address)(const char*);
  void (*finish)(); ///< glFinish
  GLDispatchVendor* vendor;
  std::atomic<bool> ended;
};
OSMesa osmesa{};

bool load(std::string& why_not)
{
  void* library = dlopen("libOSMesa.so.8", RTLD_NOW);
  if (!library)
  {
    why_not = "libOSMesa.so.8 is missing (Debian package libosmesa6)";
    return false;
  }
  if (!find_symbol(library, "OSMesaCreateContextAttribs", osmesa.create_context) ||
    !find_symbol(library, "OSMesaDestroyContext", osmesa.destroy_context) ||
    !find_symbol(library, "OSMesaMakeCurrent", osmesa.make_current) ||
    !find_symbol(library, "OSMesaGetCurrentContext", osmesa.get_current_context) ||
    !find_symbol(library, "OSMesaGetProcAddress", osmesa.get_proc_address))
  {
    why_not = "libOSMesa.so.8 is too old";
    return false;
  }
  osmesa.finish = reinterpret_cast<void (*)()>(osmesa.get_proc_address("glFinish"));
  osmesa.vendor = GLDispatchVendor::create(
    [](const char* name, void*) { return osmesa.get_proc_address(name); }, why_not);
  return osmesa.vendor != nullptr;
}

class OSMesaContext : public OffscreenContext
{
public:
  explicit OSMesaContext(void* context) : context_(context)
  {
    const std::lock_guard lock(list_mutex);
    living.push_back(this);
  }

  ~OSMesaContext() override
  {
    {
      const std::lock_guard lock(list_mutex);
      if (osmesa.ended)
      {
        return;
      }
      std::erase(living, this);
    }
    release_current();
    osmesa.destroy_context(context_);
  }

  /// Waits for what the contexts that are left still draw. From here on OpenGL's functions do
  /// nothing and libOSMesa isn't called any more.
  static void end()
  {
    const std::lock_guard lock(list_mutex);
    osmesa.ended = true;
    for (OSMesaContext* context : living)
    {
      if (context->bind())
      {
        osmesa.finish();
      }
    }
    osmesa.make_current(nullptr, nullptr, 0, 0, 0);
    osmesa.vendor->release_current();
  }

  bool make_current() override
  {
    return osmesa.ended || is_current() || (osmesa.vendor->make_current() && bind());
  }

  bool is_current() const override
  {
    return !osmesa.ended && osmesa.vendor->is_current() && osmesa.get_current_context() == context_;
  }

  void release_current() override
  {
    if (is_current())
    {
      osmesa.make_current(nullptr, nullptr, 0, 0, 0);
      osmesa.vendor->release_current();
    }
  }

private:
  bool bind()
  {
    return osmesa.make_current(
      context_, buffer_.data(), gl_unsigned_byte, buffer_side, buffer_side);
  }

  inline static std::mutex list_mutex;
  inline static std::vector<OSMesaContext*> living;

  // Never seen: VTK draws into framebuffer objects of its own.
  static constexpr int buffer_side = 16;
  std::array<unsigned char, 4 * buffer_side * buffer_side> buffer_{};
  void* context_;
};

void* create_context()
{
  constexpr int attributes[] = { osmesa_format, gl_rgba, osmesa_depth_bits, 24, osmesa_stencil_bits,
    0, osmesa_accum_bits, 0, osmesa_profile, osmesa_core_profile, osmesa_context_major_version, 3,
    osmesa_context_minor_version, 2, 0 };
  return osmesa.create_context(attributes, nullptr);
}

/// Windows may outlive libOSMesa: ParaView's last until the process ends. At exit libOSMesa joins
/// its rasteriser's threads, and some of them wait for ever for the others if something is still
/// being drawn. Its handler is registered with the first context; ours, registered after it, runs
/// before.
void watch_for_exit()
{
  [[maybe_unused]] static const int watching = std::atexit(OSMesaContext::end);
}

}

std::unique_ptr<OffscreenContext> make_osmesa_context(std::string& why_not)
{
  static std::string failure;
  static const bool loaded = load(failure);
  if (!loaded)
  {
    why_not = failure;
    return nullptr;
  }
  if (osmesa.ended)
  {
    why_not = "the process is ending";
    return nullptr;
  }
  void* context = create_context();
  if (!context)
  {
    why_not = "libOSMesa offers no OpenGL 3.2 core context";
    return nullptr;
  }
  watch_for_exit();
  return std::make_unique<OSMesaContext>(context);
}

}
