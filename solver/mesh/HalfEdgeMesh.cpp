#include "solver/mesh/HalfEdgeMesh.h"

#include "solver/mesh/EdgeUses.h"

namespace vesicle
{

FlippableMesh::FlippableMesh(const Triangles& triangles, int points)
  : corners(triangles), twins(3 * triangles.rows()), outgoing(points, -1), valences(points, 0)
{
  for (int h = 0; h < half_edges(); ++h)
  {
    outgoing[from(h)] = h;
    ++valences[from(h)];
  }
  const EdgeUses edges(triangles);
  for (int e = 0; e < edges.size(); ++e)
  {
    const auto half_edge = [&](const EdgeUse& use)
    {
      const int start = use.forward ? use.a : use.b;
      const int h = 3 * use.triangle;
      return from(h) == start ? h : from(h + 1) == start ? h + 1 : h + 2;
    };
    pair(half_edge(edges[e].front()), half_edge(edges[e].back()));
  }
}

void FlippableMesh::pair(int h, int g)
{
  twins[h] = g;
  twins[g] = h;
}

int FlippableMesh::find(int a, int b) const
{
  int h = outgoing[a];
  do
  {
    if (to(h) == b)
    {
      return h;
    }
    h = twins[previous(h)];
  } while (h != outgoing[a]);
  return -1;
}

// The triangles (a, b, c) of h and (b, a, d) of its twin become (a, d, c) and (d, b, c).
void FlippableMesh::flip(int h)
{
  const int g = twins[h];
  const int a = from(h), b = to(h), c = apex(h), d = apex(g);
  const int bc = twins[next(h)], ca = twins[previous(h)];
  const int ad = twins[next(g)], db = twins[previous(g)];
  const int t = h / 3, s = g / 3;
  corners.row(t) << a, d, c;
  corners.row(s) << d, b, c;
  pair(3 * t, ad);
  pair(3 * t + 1, 3 * s + 2);
  pair(3 * t + 2, ca);
  pair(3 * s, db);
  pair(3 * s + 1, bc);
  outgoing[a] = 3 * t;
  outgoing[b] = 3 * s + 1;
  outgoing[c] = 3 * t + 2;
  outgoing[d] = 3 * s;
  --valences[a];
  --valences[b];
  ++valences[c];
  ++valences[d];
}

}
