#pragma once
// An OpenGL context from libEGL (loaded at run time) on Mesa's surfaceless platform: needs neither
// an X server nor a graphics device, and uses one where Mesa drives it.

#include "OffscreenContext.h"
#include "VesicleOffscreenModule.h"

#include <memory>
#include <string>

namespace vesicle
{

/// A new OpenGL core context; null, with the reason in why_not, when libEGL can't be used.
VESICLEOFFSCREEN_EXPORT std::unique_ptr<OffscreenContext> make_egl_context(std::string& why_not);

}
