#pragma once
// Charts as SVG.

#include <filesystem>

class vtkRenderWindow;

namespace vesicle
{

/// What the window's charts (vtkContextActor) show, as lines and letters' outlines; nothing of a scene in
/// three dimensions. The window has been rendered. Throws IoError.
void write_svg(const std::filesystem::path& file, vtkRenderWindow* window);

}
