#pragma once
// Small surfaces in every format, as other programs write them.

#include "solver/mesh/PolygonMesh.h"
#include "solver/mesh/io/SurfaceFile.h"

#include <bit>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace vesicle::test
{

using Faces = std::vector<std::vector<std::int64_t>>;

/// A prism on an L: area 14, volume 3, two concave faces.
Points l_prism_points();
Faces l_prism_faces();

std::string off_sample(const Points& points, const Faces& faces, const std::string& keyword = "OFF",
  const std::string& after_point = "");
std::string obj_sample(const Points& points, const Faces& faces);
std::string ply_sample(const Points& points, const Faces& faces, const std::string& real);
std::string binary_ply_sample(
  const Points& points, const Faces& faces, std::endian order, bool double_precision);
/// Of triangles.
std::string stl_sample(const Points& points, const Faces& triangles);
std::string binary_stl_sample(const Points& points, const Faces& triangles);
std::string vtk_sample(const Points& points, const Faces& faces, const std::string& after = "");
/// Version 3, or with offsets version 5.1.
std::string binary_vtk_sample(const Points& points, const Faces& faces, bool offsets);

/// Of triangles, as gmsh 4 writes them: beside them a point's and a line's element, a tetrahedron, and
/// the centre of an arc among the nodes, whose tags have gaps.
struct GmshKind
{
  bool version_4, binary;
  std::endian order = std::endian::native;
};
std::string gmsh_sample(const Points& points, const Faces& triangles, const GmshKind& kind);

using Reader = std::function<SurfaceFile(std::string_view, const std::string&)>;

/// One file of each kind and what reads it.
struct SampleFile
{
  std::string name;
  Reader read;
  std::string bytes;
};
inline void PrintTo(const SampleFile& sample, std::ostream* out)
{
  *out << sample.name;
}
std::vector<SampleFile> sample_files();

/// Checks and triangles as every reading has them. Throws InputError.
TriangleMesh mesh_of(const SurfaceFile& file, const std::string& name = "mesh");

/// The text of the InputError that reading gives; "no InputError" if there is none.
std::string message_of(const Reader& read, std::string_view bytes);

}
