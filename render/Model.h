#pragma once
// Coloured shapes for the pictures of other programs.

#include "render/ColorScale.h"

#include "solver/mesh/TriangleMesh.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace vesicle
{

struct Model
{
  Vector3 place; ///< that the points are seen from, so that single precision holds their shape
  Points points, normals;
  Points colors; ///< red, green, blue from 0 to 1, linear in the light
  Triangles triangles;
};

/// Throws InputError as finite_point_array() does.
Model model_of(vtkPolyData* triangles, const std::string& array, const ColorScale& scale);

/// glTF 2.0, all in one text: single precision, smooth, its z axis upwards.
std::string gltf_text(const Model& model, const std::string& name);

/// USD as text (.usda): frames are the time codes 0, 1, 2 …, 24 a second; what stays the same is there
/// once. There must be one or more.
std::string usd_text(const std::vector<Model>& frames, const std::string& name);

}
