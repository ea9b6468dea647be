#include "solver/stokes/LayerModes.h"

namespace vesicle
{

namespace
{

Vector3 gradient_p2(const Vector3& x) // p = x y
{
  return { x.y(), x.x(), 0 };
}

}

const std::vector<LayerMode>& sphere_layer_modes()
{
  static const std::vector<LayerMode> modes{
    { "translation", [](const Vector3&) { return Vector3(1, 2, -1); }, 2. / 3 },
    { "rotation", [](const Vector3& x) -> Vector3 { return Vector3(1, 2, -1).cross(x); }, 1. / 3 },
    { "strain",
      [](const Vector3& x) -> Vector3 {
        return { x.x(), 2 * x.y(), -3 * x.z() };
      },
      1. / 5 },
    { "toroidal", [](const Vector3& x) -> Vector3 { return x.cross(gradient_p2(x)); }, 1. / 5 },
    { "V2", [](const Vector3& x) -> Vector3 { return gradient_p2(x) - 5 * x.x() * x.y() * x; },
      2. / 35 },
    { "W2", gradient_p2, 3. / 15 },
  };
  return modes;
}

}
