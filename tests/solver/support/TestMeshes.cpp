#include "tests/solver/support/TestMeshes.h"

#include "solver/mesh/shapes/Shapes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>
#include <random>
#include <sstream>
#include <stdexcept>

namespace vesicle::test
{

TriangleMesh small_prolate()
{
  ShapeRequest request;
  request.kind = ShapeRequest::Kind::prolate;
  request.reduced_volume = 0.95;
  request.triangles = 80;
  return make_shape(request);
}

TriangleMesh torus(double R, double r, int around, int across)
{
  TriangleMesh mesh;
  mesh.points.resize(around * across, 3);
  mesh.triangles.resize(2 * around * across, 3);
  const auto index = [=](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j)
    {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double radius = R + r * std::cos(v);
      mesh.points.row(index(i, j)) << radius * std::cos(u), radius * std::sin(u), r * std::sin(v);
      mesh.triangles.row(2 * index(i, j)) << index(i, j), index(i + 1, j), index(i + 1, j + 1);
      mesh.triangles.row(2 * index(i, j) + 1) << index(i, j), index(i + 1, j + 1), index(i, j + 1);
    }
  return mesh;
}

TriangleMesh clifford_torus(int around, int across)
{
  return torus(std::numbers::sqrt2, 1, around, across);
}

Renumbered renumbered(const TriangleMesh& mesh)
{
  std::mt19937 random(7);
  Renumbered result{ mesh, std::vector<int>(mesh.points.rows()) };
  std::iota(result.order.begin(), result.order.end(), 0);
  std::shuffle(result.order.begin(), result.order.end(), random);
  std::vector<int> new_index(mesh.points.rows()), triangle_order(mesh.triangles.rows());
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    result.mesh.points.row(i) = mesh.points.row(result.order[i]);
    new_index[result.order[i]] = i;
  }
  std::iota(triangle_order.begin(), triangle_order.end(), 0);
  std::shuffle(triangle_order.begin(), triangle_order.end(), random);
  for (int e = 0; e < mesh.triangles.rows(); ++e)
    for (int c = 0; c < 3; ++c) // the first corner changes too
      result.mesh.triangles(e, c) = new_index[mesh.triangles(triangle_order[e], (c + e) % 3)];
  return result;
}

std::map<std::string, std::vector<double>> read_reference(const std::string& file)
{
  std::ifstream in(std::string(VESICLE_SOURCE_DIR) + "/data/reference/" + file);
  if (!in)
    throw std::runtime_error("missing reference " + file);
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;
  for (std::string line, cell; std::getline(in, line);)
  {
    if (line.starts_with('#'))
      continue;
    std::istringstream cells(line);
    for (std::size_t column = 0; std::getline(cells, cell, ','); ++column)
      if (names.size() <= column && columns.size() <= column)
        columns[cell], names.push_back(cell);
      else if (cell.find_first_not_of("+-.0123456789eE") == std::string::npos)
        columns[names[column]].push_back(std::stod(cell));
  }
  return columns;
}

double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x)
{
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < xs.size(); ++i)
    points.emplace_back(xs[i], ys[i]);
  std::sort(points.begin(), points.end());
  auto after = std::lower_bound(points.begin(), points.end(), std::pair(x, -HUGE_VAL));
  after = std::clamp(after, points.begin() + 1, points.end() - 1);
  const auto before = after - 1;
  return before->second +
    (after->second - before->second) * (x - before->first) / (after->first - before->first);
}

double order(double coarse_error, double fine_error)
{
  return std::log2(coarse_error / fine_error);
}

}
