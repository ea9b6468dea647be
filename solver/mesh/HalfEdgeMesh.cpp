#include "solver/mesh/HalfEdgeMesh.h"

#include "solver/mesh/EdgeUses.h"

namespace vesicle
{

HalfEdgeMesh::HalfEdgeMesh(const Triangles& triangles, int points)
  : corners_(triangles), twins_(3 * triangles.rows()), outgoing_(points, -1), valences_(points, 0)
{
  for (int h = 0; h < half_edges(); ++h)
  {
    outgoing_[from(h)] = h;
    ++valences_[from(h)];
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

void HalfEdgeMesh::pair(int h, int g)
{
  twins_[h] = g;
  twins_[g] = h;
}

int HalfEdgeMesh::find(int a, int b) const
{
  int h = outgoing_[a];
  do
  {
    if (to(h) == b)
      return h;
    h = twins_[previous(h)];
  } while (h != outgoing_[a]);
  return -1;
}

// The triangles (a, b, c) of h and (b, a, d) of its twin become (a, d, c) and (d, b, c).
void HalfEdgeMesh::flip(int h)
{
  const int g = twins_[h];
  const int a = from(h), b = to(h), c = apex(h), d = apex(g);
  const int bc = twins_[next(h)], ca = twins_[previous(h)];
  const int ad = twins_[next(g)], db = twins_[previous(g)];
  const int t = h / 3, s = g / 3;
  corners_.row(t) << a, d, c;
  corners_.row(s) << d, b, c;
  pair(3 * t, ad);
  pair(3 * t + 1, 3 * s + 2);
  pair(3 * t + 2, ca);
  pair(3 * s, db);
  pair(3 * s + 1, bc);
  outgoing_[a] = 3 * t;
  outgoing_[b] = 3 * s + 1;
  outgoing_[c] = 3 * t + 2;
  outgoing_[d] = 3 * s;
  --valences_[a];
  --valences_[b];
  ++valences_[c];
  ++valences_[d];
}

}
