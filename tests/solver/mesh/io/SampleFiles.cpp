#include "tests/solver/mesh/io/SampleFiles.h"

#include "solver/Errors.h"
#include "solver/mesh/Triangulation.h"
#include "solver/mesh/io/GmshFile.h"
#include "solver/mesh/io/LegacyVtkFile.h"
#include "solver/mesh/io/ObjFile.h"
#include "solver/mesh/io/OffFile.h"
#include "solver/mesh/io/PlyFile.h"
#include "solver/mesh/io/StlFile.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>

namespace vesicle::test
{
namespace
{

std::string number(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

std::string point_text(const Points& points, Eigen::Index i)
{
  return number(points(i, 0)) + ' ' + number(points(i, 1)) + ' ' + number(points(i, 2));
}

std::string point_lines(const Points& points, const std::string& before, const std::string& after)
{
  std::string text;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    text += before + point_text(points, i) + after + '\n';
  return text;
}

std::string face_lines(const Faces& faces)
{
  std::string text;
  for (const auto& face : faces)
  {
    text += std::to_string(face.size());
    for (const auto corner : face)
      text += ' ' + std::to_string(corner);
    text += '\n';
  }
  return text;
}

template<typename T>
void append(std::string& bytes, T value, std::endian order)
{
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order != std::endian::native)
    std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::size_t list_size(const Faces& faces)
{
  std::size_t size = 0;
  for (const auto& face : faces)
    size += face.size() + 1;
  return size;
}

std::string ply_header(
  const std::string& format, const std::string& real, std::size_t points, std::size_t faces)
{
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " +
    std::to_string(points) + "\nproperty " + real + " x\nproperty " + real + " y\nproperty " +
    real + " z\nelement face " + std::to_string(faces) +
    "\nproperty list uchar int vertex_indices\nend_header\n";
}

}

Points l_prism_points()
{
  Points points(12, 3);
  points << 2, 0, 0, 2, 1, 0, 1, 1, 0, 1, 2, 0, 0, 2, 0, 0, 0, 0, //
    2, 0, 1, 2, 1, 1, 1, 1, 1, 1, 2, 1, 0, 2, 1, 0, 0, 1;
  return points;
}

Faces l_prism_faces()
{
  Faces faces{ { 5, 4, 3, 2, 1, 0 }, { 6, 7, 8, 9, 10, 11 } };
  for (int i = 0; i < 6; ++i)
  {
    const int j = (i + 1) % 6;
    faces.push_back({ i, j, 6 + j, 6 + i });
  }
  return faces;
}

std::string off_sample(const Points& points, const Faces& faces, const std::string& keyword,
  const std::string& after_point)
{
  return keyword + '\n' + std::to_string(points.rows()) + ' ' + std::to_string(faces.size()) +
    " 0\n" + point_lines(points, "", after_point) + face_lines(faces);
}

std::string obj_sample(const Points& points, const Faces& faces)
{
  std::string text = point_lines(points, "v ", "");
  for (const auto& face : faces)
  {
    text += 'f';
    for (const auto corner : face)
      text += ' ' + std::to_string(corner + 1);
    text += '\n';
  }
  return text;
}

std::string ply_sample(const Points& points, const Faces& faces, const std::string& real)
{
  return ply_header("ascii", real, points.rows(), faces.size()) + point_lines(points, "", "") +
    face_lines(faces);
}

std::string binary_ply_sample(
  const Points& points, const Faces& faces, std::endian order, bool double_precision)
{
  std::string bytes =
    ply_header(order == std::endian::little ? "binary_little_endian" : "binary_big_endian",
      double_precision ? "double" : "float", points.rows(), faces.size());
  for (const double x : points.reshaped<Eigen::RowMajor>())
    double_precision ? append(bytes, x, order) : append(bytes, static_cast<float>(x), order);
  for (const auto& face : faces)
  {
    append(bytes, static_cast<std::uint8_t>(face.size()), order);
    for (const auto corner : face)
      append(bytes, static_cast<std::int32_t>(corner), order);
  }
  return bytes;
}

std::string stl_sample(const Points& points, const Faces& triangles)
{
  std::string text = "solid made by hand\n";
  for (const auto& triangle : triangles)
  {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const auto corner : triangle)
      text += "vertex " + point_text(points, corner) + '\n';
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid made by hand\n";
}

std::string binary_stl_sample(const Points& points, const Faces& triangles)
{
  std::string bytes = "solid, though binary";
  bytes.resize(80);
  append(bytes, static_cast<std::uint32_t>(triangles.size()), std::endian::little);
  for (const auto& triangle : triangles)
  {
    bytes.append(12, '\0');
    for (const auto corner : triangle)
      for (int k = 0; k < 3; ++k)
        append(bytes, static_cast<float>(points(corner, k)), std::endian::little);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string vtk_sample(const Points& points, const Faces& faces, const std::string& after)
{
  return "# vtk DataFile Version 3.0\nmade by hand\nASCII\nDATASET POLYDATA\nPOINTS " +
    std::to_string(points.rows()) + " double\n" + point_lines(points, "", "") + "POLYGONS " +
    std::to_string(faces.size()) + ' ' + std::to_string(list_size(faces)) + '\n' +
    face_lines(faces) + after;
}

std::string binary_vtk_sample(const Points& points, const Faces& faces, bool offsets)
{
  std::string bytes = "# vtk DataFile Version ";
  bytes += offsets ? "5.1" : "3.0";
  bytes += "\nmade by hand\nBINARY\nDATASET POLYDATA\nPOINTS ";
  bytes += std::to_string(points.rows()) + " float\n";
  for (const double x : points.reshaped<Eigen::RowMajor>())
    append(bytes, static_cast<float>(x), std::endian::big);
  const std::size_t corners = list_size(faces) - faces.size();
  bytes += "\nPOLYGONS ";
  if (offsets)
  {
    bytes +=
      std::to_string(faces.size() + 1) + ' ' + std::to_string(corners) + "\nOFFSETS vtktypeint64\n";
    std::int64_t offset = 0;
    append(bytes, offset, std::endian::big);
    for (const auto& face : faces)
      append(bytes, offset += static_cast<std::int64_t>(face.size()), std::endian::big);
    bytes += "\nCONNECTIVITY vtktypeint64\n";
    for (const auto& face : faces)
      for (const auto corner : face)
        append(bytes, corner, std::endian::big);
    return bytes + '\n';
  }
  bytes += std::to_string(faces.size()) + ' ' + std::to_string(list_size(faces)) + '\n';
  for (const auto& face : faces)
  {
    append(bytes, static_cast<std::int32_t>(face.size()), std::endian::big);
    for (const auto corner : face)
      append(bytes, static_cast<std::int32_t>(corner), std::endian::big);
  }
  return bytes + '\n';
}

std::vector<SampleFile> sample_files()
{
  const Points points = l_prism_points();
  const Faces faces = l_prism_faces();
  PolygonList polygons;
  for (const auto& face : faces)
    polygons.add(face, polygons.size());
  const Triangulation triangulation = triangulate(points, polygons, "prism");
  Faces triangles;
  for (const auto& row : triangulation.triangles.rowwise())
    triangles.push_back({ row[0], row[1], row[2] });
  const std::string fields = "CELL_DATA 8\nSCALARS side float 1\nLOOKUP_TABLE default\n"
                             "0 1 2 3 4 5 6 7\nPOINT_DATA 12\nFIELD FieldData 1\n"
                             "height 1 12 double\n0 0 0 0 0 0 1 1 1 1 1 1\n";
  const auto gmsh = [&](const GmshKind& kind) { return gmsh_sample(points, triangles, kind); };
  return { { "mesh.off", read_off, off_sample(points, faces) },
    { "colours.off", read_off, off_sample(points, faces, "COFF", " 255 0 0 255") },
    { "mesh.obj", read_obj, obj_sample(points, faces) },
    { "mesh.ply", read_ply, ply_sample(points, faces, "double") },
    { "little.ply", read_ply, binary_ply_sample(points, faces, std::endian::little, false) },
    { "big.ply", read_ply, binary_ply_sample(points, faces, std::endian::big, true) },
    { "mesh.stl", read_stl, stl_sample(points, triangles) },
    { "binary.stl", read_stl, binary_stl_sample(points, triangles) },
    { "mesh.vtk", read_legacy_vtk, vtk_sample(points, faces, fields) },
    { "binary.vtk", read_legacy_vtk, binary_vtk_sample(points, faces, false) },
    { "offsets.vtk", read_legacy_vtk, binary_vtk_sample(points, faces, true) },
    { "version2.msh", read_gmsh, gmsh({ false, false }) },
    { "binary2.msh", read_gmsh, gmsh({ false, true, std::endian::little }) },
    { "version4.msh", read_gmsh, gmsh({ true, false }) },
    { "binary4.msh", read_gmsh, gmsh({ true, true, std::endian::big }) } };
}

namespace
{

/// Numbers as text, or as bytes of the width that gmsh gives them.
class GmshNumbers
{
public:
  explicit GmshNumbers(const GmshKind& kind) : kind_(kind) {}

  GmshNumbers& integer(std::int64_t value)
  {
    return put(static_cast<std::int32_t>(value), std::to_string(value));
  }
  GmshNumbers& size(std::int64_t value)
  {
    return kind_.version_4 ? put(value, std::to_string(value)) : integer(value);
  }
  GmshNumbers& real(double value) { return put(value, number(value)); }
  GmshNumbers& line()
  {
    text_ += kind_.binary ? "" : "\n";
    return *this;
  }
  GmshNumbers& words(const std::string& text)
  {
    text_ += text;
    return *this;
  }
  const std::string& text() const { return text_; }

private:
  template<typename T>
  GmshNumbers& put(T value, const std::string& text)
  {
    if (kind_.binary)
      append(text_, value, kind_.order);
    else
      text_ += text + ' ';
    return *this;
  }

  GmshKind kind_;
  std::string text_;
};

struct GmshElements
{
  int type;
  Faces nodes; ///< tags
};

void write_nodes(GmshNumbers& to, const Points& points, bool version_4)
{
  const std::int64_t count = points.rows() + 1; // with the centre of an arc, tag 1
  if (version_4)
  {
    to.size(2).size(count).size(1).size(10 + points.rows()).line();
    to.integer(0).integer(1).integer(0).size(1).line();
    to.size(1).line().real(100).real(100).real(100).line();
    to.integer(2).integer(7).integer(1).size(points.rows()).line(); // with parameters
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      to.size(10 + i).line();
  }
  else
  {
    to.words(std::to_string(count) + '\n');
    to.integer(1).real(100).real(100).real(100).line();
  }
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (!version_4)
      to.integer(10 + i);
    for (int k = 0; k < 3; ++k)
      to.real(points(i, k));
    if (version_4)
      to.real(.25).real(.5);
    to.line();
  }
}

void write_elements(GmshNumbers& to, const std::vector<GmshElements>& blocks, const GmshKind& kind)
{
  std::int64_t count = 0, tag = 0;
  for (const auto& block : blocks)
    count += static_cast<std::int64_t>(block.nodes.size());
  if (kind.version_4)
    to.size(static_cast<std::int64_t>(blocks.size())).size(count).size(1).size(count).line();
  else
    to.words(std::to_string(count) + '\n');
  for (const auto& [type, elements] : blocks)
  {
    const auto size = static_cast<std::int64_t>(elements.size());
    if (kind.version_4)
      to.integer(2).integer(7).integer(type).size(size).line();
    else if (kind.binary)
      to.integer(type).integer(size).integer(2);
    for (const auto& nodes : elements)
    {
      to.size(++tag);
      if (!kind.version_4 && !kind.binary)
        to.integer(type).integer(2);
      if (!kind.version_4)
        to.integer(1).integer(7);
      for (const auto node : nodes)
        to.size(node);
      to.line();
    }
  }
}

}

std::string gmsh_sample(const Points& points, const Faces& triangles, const GmshKind& kind)
{
  Faces tags = triangles;
  for (auto& triangle : tags)
    for (auto& node : triangle)
      node += 10;
  GmshNumbers to(kind);
  to.words(kind.version_4 ? "$MeshFormat\n4.1 " : "$MeshFormat\n2.2 ");
  to.words(kind.binary ? "1 8\n" : "0 8\n");
  if (kind.binary)
    to.integer(1).words("\n");
  to.words("$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"skin\"\n$EndPhysicalNames\n$Nodes\n");
  write_nodes(to, points, kind.version_4);
  to.words("\n$EndNodes\n$Elements\n");
  write_elements(to,
    { { 15, { { 1 } } }, { 1, { { 10, 11 } } }, { 2, tags }, { 4, { { 10, 11, 12, 1 } } } }, kind);
  return to.words("\n$EndElements\n").text();
}

TriangleMesh mesh_of(const SurfaceFile& file, const std::string& name)
{
  check_points(file.points, name);
  check_corners(file.polygons, file.points.rows(), name);
  return { file.points, triangulate(file.points, file.polygons, name).triangles };
}

std::string message_of(const Reader& read, std::string_view bytes)
{
  try
  {
    mesh_of(read(bytes, "mesh"));
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no InputError";
}

}
