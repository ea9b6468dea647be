#include "render/SmoothSurface.h"

#include "solver/Errors.h"
#include "solver/surface/LoopBasis.h"
#include "solver/surface/Collocation.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vesicle
{
namespace
{

constexpr int most_parts = 16;

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::MatrixXd values_of(vtkDataArray* array)
{
  Eigen::MatrixXd values(array->GetNumberOfTuples(), array->GetNumberOfComponents());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    for (Eigen::Index k = 0; k < values.cols(); ++k)
    {
      values(i, k) = array->GetComponent(i, static_cast<int>(k));
    }
  }
  return values;
}

/// One row of the table's coefficients a point.
SparseMatrix matrix_of(const BasisTable& table, const std::vector<double>& coefficient)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < table.rows(); ++row)
  {
    for (int k = table.start[row]; k < table.start[row + 1]; ++k)
    {
      entries.emplace_back(row, table.node[k], coefficient[k]);
    }
  }
  SparseMatrix matrix(table.rows(), table.nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}

/// Every triangle cut into parts² equal ones of its parameters. The points: first the vertices of
/// the coarse mesh, then those that were added on edges and inside.
struct SmoothSurface::Lattice
{
  Lattice(const Triangles& coarse, int points, int wanted_triangles);

  /// Adds the point in an element, or finds it where a neighbour has added it on their edge.
  int point(int element, int i, int j);
  void cut(int element);

  Rows refined(const Eigen::MatrixXd& values) const;
  Rows normals(const Points& points) const;

  LoopBasis basis;
  int vertices;
  int parts;
  std::vector<ParametricPoint> added;
  std::map<std::array<int, 3>, int> on_edges; ///< smaller end, larger end, steps from the smaller
  std::map<std::array<vtkIdType, 2>, std::vector<vtkIdType>> edges;
  // Objects that stay the same from frame to frame: VTK then needn't look at them again.
  vtkNew<vtkCellArray> triangles, lines;
  SparseMatrix value, du, dv;
  Collocation collocation;
};

SmoothSurface::Lattice::Lattice(const Triangles& coarse, int points, int wanted_triangles)
  : basis(coarse, points), vertices(points),
    parts(std::clamp(
      static_cast<int>(std::ceil(std::sqrt(wanted_triangles / static_cast<double>(coarse.rows())))),
      1, most_parts)),
    collocation(basis)
{
  for (int element = 0; element < coarse.rows(); ++element)
  {
    cut(element);
  }
  for (const auto& [ends, line] : edges)
  {
    lines->InsertNextCell(static_cast<vtkIdType>(line.size()), line.data());
  }
  const BasisTable table = basis.tabulate(added);
  value = matrix_of(table, table.value);
  du = matrix_of(table, table.du);
  dv = matrix_of(table, table.dv);
}

int SmoothSurface::Lattice::point(int element, int i, int j)
{
  const std::array<int, 3> steps{ parts - i - j, i, j }; // towards each corner
  const auto corner = [&](int c) { return basis.elements()(element, c % 3); };
  for (int c = 0; c < 3; ++c)
  {
    if (steps[c] == parts)
    {
      return corner(c);
    }
  }
  const int next = vertices + static_cast<int>(added.size());
  const ParametricPoint here{ element, static_cast<double>(i) / parts,
    static_cast<double>(j) / parts, 0 };
  for (int c = 0; c < 3; ++c)
  {
    if (steps[c] == 0)
    {
      int a = corner(c + 1);
      int b = corner(c + 2);
      int from_a = steps[(c + 2) % 3];
      if (a > b)
      {
        std::swap(a, b);
        from_a = parts - from_a;
      }
      const auto [found, is_new] = on_edges.try_emplace({ a, b, from_a }, next);
      if (is_new)
      {
        added.push_back(here);
      }
      return found->second;
    }
  }
  added.push_back(here);
  return next;
}

void SmoothSurface::Lattice::cut(int element)
{
  std::vector<std::vector<vtkIdType>> rows(parts + 1);
  for (int j = 0; j <= parts; ++j)
  {
    for (int i = 0; i + j <= parts; ++i)
    {
      rows[j].push_back(point(element, i, j));
    }
  }
  for (int j = 0; j < parts; ++j)
  {
    for (int i = 0; i + j < parts; ++i)
    {
      triangles->InsertNextCell({ rows[j][i], rows[j][i + 1], rows[j + 1][i] });
      if (i + j + 1 < parts)
      {
        triangles->InsertNextCell({ rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i] });
      }
    }
  }
  std::vector<vtkIdType> first = rows[0], second, third;
  for (int j = 0; j <= parts; ++j)
  {
    second.push_back(rows[j][parts - j]);
    third.push_back(rows[j][0]);
  }
  for (auto& line : { first, second, third })
  {
    edges.try_emplace(
      { std::min(line.front(), line.back()), std::max(line.front(), line.back()) }, line);
  }
}

Rows SmoothSurface::Lattice::refined(const Eigen::MatrixXd& values) const
{
  const Eigen::MatrixXd c = collocation.fit(values);
  Rows all(vertices + value.rows(), values.cols());
  all.topRows(vertices) = values;
  all.bottomRows(value.rows()) = value * c;
  return all;
}

Rows SmoothSurface::Lattice::normals(const Points& points) const
{
  const Eigen::MatrixXd at_vertices = points;
  const Eigen::MatrixXd solved = collocation.fit(at_vertices);
  const Points c = solved;
  const Points along_u = du * c;
  const Points along_v = dv * c;
  Rows all(vertices + value.rows(), 3);
  all.topRows(vertices) = basis.vertex_normals(c);
  for (Eigen::Index i = 0; i < along_u.rows(); ++i)
  {
    const Vector3 u = along_u.row(i), v = along_v.row(i);
    all.row(vertices + i) = u.cross(v).normalized();
  }
  return all;
}

SmoothSurface::SmoothSurface(int wanted_triangles) : wanted_triangles_(wanted_triangles) {}
SmoothSurface::~SmoothSurface() = default;

SmoothMesh SmoothSurface::refine(vtkPolyData* coarse, const std::vector<std::string>& arrays)
{
  const TriangleMesh mesh = to_mesh(coarse);
  if (!lattice_ || lattice_->vertices != mesh.points.rows() ||
    lattice_->basis.elements().rows() != mesh.triangles.rows() ||
    lattice_->basis.elements() != mesh.triangles)
  {
    lattice_ = std::make_unique<Lattice>(
      mesh.triangles, static_cast<int>(mesh.points.rows()), wanted_triangles_);
  }
  SmoothMesh fine;
  const Points points = lattice_->refined(mesh.points);
  fine.surface = vtkSmartPointer<vtkPolyData>::New();
  fine.surface->SetPoints(to_vtk_points(points));
  fine.surface->SetPolys(lattice_->triangles);
  fine.surface->GetPointData()->SetNormals(to_array("Normals", lattice_->normals(mesh.points)));
  for (const auto& name : arrays)
  {
    if (vtkDataArray* array = coarse->GetPointData()->GetArray(name.c_str()))
    {
      fine.surface->GetPointData()->AddArray(to_array(name, lattice_->refined(values_of(array))));
    }
  }
  fine.edges = vtkSmartPointer<vtkPolyData>::New();
  fine.edges->SetPoints(fine.surface->GetPoints());
  fine.edges->SetLines(lattice_->lines);
  return fine;
}

}
