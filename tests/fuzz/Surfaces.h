#pragma once

class vtkPolyData;

namespace vesicle::fuzz
{

/// Throws a Fault unless the surface has finite points, no cells but triangles of them, and a value
/// of each array for each point and triangle.
void require_sound(vtkPolyData* surface);

}
