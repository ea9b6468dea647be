// A body of revolution about z with a waist, r² = 1 + 0.7 cos 2θ (an oval of Cassini's kind), turned
// off the axes.
SetFactory("OpenCASCADE");
n = 24;
For i In {0:n}
  t = Pi * i / n;
  r = Sqrt(1 + 0.7 * Cos(2 * t));
  Point(i + 1) = {r * Sin(t), 0, r * Cos(t)};
EndFor
Spline(1) = {1:n + 1};
Extrude {{0, 0, 1}, {0, 0, 0}, 2 * Pi} { Curve{1}; }
Rotate {{1, 1, 0}, {0, 0, 0}, Pi / 5} { Surface{:}; }
Translate {-2, 3, 1} { Surface{:}; }
Mesh.MeshSizeMin = 0.17;
Mesh.MeshSizeMax = 0.17;
Mesh.Algorithm = 1; // MeshAdapt
