#pragma once
// An OpenGL context without a window system, as our off-screen windows use it.

namespace vesicle
{

class OffscreenContext
{
public:
  virtual ~OffscreenContext() = default;

  /// Makes it the calling thread's OpenGL context; false when another window system's context
  /// (GLX) is current there and can't be replaced.
  virtual bool make_current() = 0;
  virtual bool is_current() const = 0;
  virtual void release_current() = 0;

protected:
  OffscreenContext() = default;
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;
};

}
