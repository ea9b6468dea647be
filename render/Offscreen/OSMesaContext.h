#pragma once
// Mesa's software renderer without a window system (libOSMesa, loaded at run time).

#include "OffscreenContext.h"

#include <memory>
#include <string>

namespace vesicle
{

/// A new OpenGL core context; null, with the reason in why_not, when libOSMesa can't be used.
std::unique_ptr<OffscreenContext> make_osmesa_context(std::string& why_not);

}
