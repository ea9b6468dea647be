// A triaxial ellipsoid, semi-axes 15, 10, 7.5, its centre away from the origin.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 1};
Dilate {{0, 0, 0}, {15, 10, 7.5}} { Volume{1}; }
Translate {120, -70, 40} { Volume{1}; }
Mesh.MeshSizeMin = 2.4;
Mesh.MeshSizeMax = 2.4;
