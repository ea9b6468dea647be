#pragma once
// How many triangles there are, and how large.

#include <cmath>
#include <numbers>

namespace vesicle
{

/// The icosahedron's.
constexpr int fewest_triangles = 20;

/// Of the number of triangles asked for, relatively, where a better mesh has another one.
constexpr double allowed_deviation = 0.01;

/// The side of `triangles` equilateral triangles of area `area` in all.
inline double equilateral_edge(double area, int triangles)
{
  return std::sqrt(4 * area / (std::numbers::sqrt3 * triangles));
}

}
