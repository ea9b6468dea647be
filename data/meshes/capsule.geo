// A rod with round ends, radius 1, length 4 between the ends' centres, in micrometres: written in
// metres.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, -2, 0, 0, 4, 1};
Sphere(2) = {0, 0, -2, 1};
Sphere(3) = {0, 0, 2, 1};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
Mesh.MeshSizeMin = 0.3;
Mesh.MeshSizeMax = 0.3;
Mesh.ScalingFactor = 1e-6;
Mesh.Algorithm = 5; // Delaunay
