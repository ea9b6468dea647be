#include "solver/surface/LimitTriangles.h"

#include "solver/surface/LimitSurface.h"

namespace vesicle
{

TriangleMesh limit_triangles(const TriangleMesh& mesh, int cuts)
{
  const LimitSurface surface(mesh);
  const int corners = (cuts + 1) * (cuts + 2) / 2;
  const int elements = static_cast<int>(mesh.triangles.rows());
  TriangleMesh fine;
  fine.points.resize(elements * corners, 3);
  fine.triangles.resize(elements * cuts * cuts, 3);
  // Row i of an element's grid has cuts + 1 − i points.
  const auto place = [cuts](int i, int j) { return i * (cuts + 1) - i * (i - 1) / 2 + j; };
  int next = 0;
  for (int e = 0; e < elements; ++e)
  {
    const int first = e * corners;
    for (int i = 0; i <= cuts; ++i)
      for (int j = 0; i + j <= cuts; ++j)
      {
        const Vector3 weights = Vector3(cuts - i - j, j, i) / cuts;
        fine.points.row(first + place(i, j)) = surface.at({ e, weights }).position;
        if (i + j < cuts)
          fine.triangles.row(next++) << first + place(i, j), first + place(i, j + 1),
            first + place(i + 1, j);
        if (i + j + 1 < cuts)
          fine.triangles.row(next++) << first + place(i, j + 1), first + place(i + 1, j + 1),
            first + place(i + 1, j);
      }
  }
  return fine;
}

}
