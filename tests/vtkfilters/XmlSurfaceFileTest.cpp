#include "vtkfilters/Filters/XmlSurfaceFile.h"

#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/support/TemporaryFolder.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"
#include "vtkZLibDataCompressor.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <random>
#include <sstream>

namespace vesicle::test
{
namespace
{

/// A sphere with a vertex, a line, a strip over two of its triangles and arrays of many types.
vtkSmartPointer<vtkPolyData> sample()
{
  const TriangleMesh mesh = geodesic_sphere(1);
  auto surface = to_polydata(mesh);
  vtkNew<vtkCellArray> verts, lines, strips;
  verts->InsertNextCell({ 0 });
  lines->InsertNextCell({ 0, 1 });
  strips->InsertNextCell({ 0, 1, 2, 3 });
  surface->SetVerts(verts);
  surface->SetLines(lines);
  surface->SetStrips(strips);
  surface->GetPointData()->SetNormals(to_array("Normals", mesh.points));
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("cells");
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i));
  }
  surface->GetCellData()->SetScalars(numbers);
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkBitArray> bits;
  ids->SetName("ids");
  bits->SetName("bits");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    ids->InsertNextValue(i);
    bits->InsertNextValue(i % 3 == 0);
  }
  surface->GetPointData()->SetGlobalIds(ids);
  surface->GetPointData()->AddArray(bits);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->InsertNextValue("vesicle");
  words->InsertNextValue("");
  surface->GetFieldData()->AddArray(words);
  return surface;
}

void expect_sample(const std::filesystem::path& file)
{
  const auto expected = sample();
  const auto surface = read_mesh(file);
  const vtkIdType triangles = expected->GetNumberOfPolys();
  ASSERT_EQ(surface->GetNumberOfPolys(), triangles + 2);
  EXPECT_EQ(to_mesh(surface).points, to_mesh(expected).points);
  EXPECT_EQ(to_mesh(surface).triangles.topRows(triangles), to_mesh(expected).triangles);
  vtkDataArray* cells = surface->GetCellData()->GetScalars();
  ASSERT_NE(cells, nullptr);
  EXPECT_EQ(cells->GetComponent(0, 0), 2) << "after a vertex and a line";
  EXPECT_EQ(cells->GetComponent(triangles + 1, 0), triangles + 2) << "the strip";
  ASSERT_NE(surface->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(surface->GetPointData()->GetNormals()->GetComponent(5, 1),
    expected->GetPointData()->GetNormals()->GetComponent(5, 1));
  ASSERT_NE(surface->GetPointData()->GetGlobalIds(), nullptr);
  EXPECT_EQ(surface->GetPointData()->GetGlobalIds()->GetComponent(7, 0), 7);
  ASSERT_NE(surface->GetPointData()->GetArray("bits"), nullptr);
  EXPECT_EQ(surface->GetPointData()->GetArray("bits")->GetComponent(3, 0), 1);
  EXPECT_EQ(surface->GetPointData()->GetArray("bits")->GetComponent(4, 0), 0);
  auto* words = vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray("words"));
  ASSERT_NE(words, nullptr);
  EXPECT_EQ(words->GetValue(0), "vesicle");
}

/// All ways in which VTK writes.
template<class Use>
void for_each_encoding(Use use)
{
  for (const int mode : { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended })
  {
    for (const int compressor :
      { vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA })
    {
      for (const int variant : { 0, 1, 2, 3, 4, 5, 6, 7 })
      {
        vtkNew<vtkXMLPolyDataWriter> writer;
        writer->SetDataMode(mode);
        writer->SetCompressorType(compressor);
        writer->SetBlockSize(96);
        writer->SetByteOrder(variant & 1 ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
        writer->SetHeaderType(variant & 2 ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
        writer->SetEncodeAppendedData(variant & 4);
        use(writer.Get());
      }
    }
  }
}

std::string read_all(const std::filesystem::path& file)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write_all(const std::filesystem::path& file, const std::string& text)
{
  std::ofstream(file, std::ios::binary) << text;
}

/// The number of triangles, −1 if it is refused.
vtkIdType triangles_of(const std::filesystem::path& file)
{
  try
  {
    return read_mesh(file)->GetNumberOfPolys();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos)
      << error.what();
    return -1;
  }
}

/// Half of a sphere's triangles and, marked as the other piece's, those that touch them.
SurfaceFile half(const TriangleMesh& mesh, int side)
{
  std::vector<bool> touched(mesh.points.rows(), false);
  const auto owner = [&](int t) { return t < mesh.triangles.rows() / 2 ? 0 : 1; };
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (const int corner : mesh.triangles.row(t))
    {
      touched[corner] = touched[corner] || owner(t) == side;
    }
  }
  SurfaceFile piece;
  piece.points = mesh.points;
  std::vector<std::uint8_t> ghosts;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto row = mesh.triangles.row(t);
    if (touched[row[0]] || touched[row[1]] || touched[row[2]])
    {
      piece.polygons.add(std::array<std::int64_t, 3>{ row[0], row[1], row[2] },
        static_cast<std::int64_t>(ghosts.size()));
      ghosts.push_back(owner(t) == side ? 0 : vtkDataSetAttributes::DUPLICATECELL);
    }
  }
  piece.cell_data.push_back({ "vtkGhostType", 1, ghosts, DataArray::Role::none, {}, false });
  return piece;
}

}

TEST(XmlSurfaceFile, ReadsAllEncodings)
{
  const TemporaryFolder folder;
  const auto file = folder / "mesh.vtp";
  const auto surface = sample();
  for_each_encoding(
    [&](vtkXMLWriter* writer)
    {
      writer->SetInputDataObject(surface);
      writer->SetFileName(file.c_str());
      ASSERT_EQ(writer->Write(), 1);
      expect_sample(file);
    });
}

TEST(XmlSurfaceFile, CutOrDamagedIsRefusedOrAMesh)
{
  const TemporaryFolder folder;
  const auto file = folder / "mesh.vtp";
  const auto surface = to_polydata(geodesic_sphere(1));
  surface->GetPointData()->SetNormals(to_array("Normals", geodesic_sphere(1).points));
  std::mt19937 random(1);
  for_each_encoding(
    [&](vtkXMLWriter* writer)
    {
      writer->SetInputDataObject(surface);
      writer->SetFileName(file.c_str());
      ASSERT_EQ(writer->Write(), 1);
      const std::string whole = read_all(file);
      const std::string end = "</VTKFile>";
      for (int round = 0; round < 8; ++round)
      {
        const std::size_t bytes = random() % whole.rfind(end);
        write_all(file, whole.substr(0, bytes));
        EXPECT_EQ(triangles_of(file), -1) << bytes << " of " << whole.size() << " bytes";
      }
      for (int round = 0; round < 16; ++round)
      {
        std::string damaged = whole;
        for (int k = 0; k <= round % 3; ++k)
        {
          const std::size_t place = random() % damaged.size();
          round % 2 == 0 ? damaged[place] = static_cast<char>(random())
                         : damaged[place] ^= static_cast<char>(1 << random() % 8);
        }
        write_all(file, damaged);
        triangles_of(file);
      }
    });
}

// Of which each is within what compression can do, all together being gigabytes.
TEST(XmlSurfaceFile, ArraysThatShareACompressedBlockAreRefusedBeforeTheyFillTheMemory)
{
  const TemporaryFolder folder;
  const auto file = folder / "mesh.vtp";
  constexpr std::uint32_t block = 100 << 20;
  const std::string zeros(block, '\0');
  vtkNew<vtkZLibDataCompressor> compressor;
  const auto compressed = vtk::TakeSmartPointer(
    compressor->Compress(reinterpret_cast<const unsigned char*>(zeros.data()), zeros.size()));
  const std::array<std::uint32_t, 4> sizes{ 1, block, 0,
    static_cast<std::uint32_t>(compressed->GetNumberOfTuples()) };
  std::string text =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" "
    "compressor=\"vtkZLibDataCompressor\"><PolyData><FieldData>";
  for (int i = 0; i < 100; ++i)
  {
    text += "<DataArray type=\"Float64\" Name=\"zeros " + std::to_string(i) +
      "\" format=\"appended\" offset=\"0\"/>";
  }
  text += "</FieldData><Piece NumberOfPoints=\"0\"/></PolyData><AppendedData encoding=\"raw\">_";
  text.append(reinterpret_cast<const char*>(sizes.data()), sizeof sizes);
  text.append(reinterpret_cast<const char*>(compressed->GetPointer(0)), sizes[3]);
  text += "</AppendedData></VTKFile>";
  write_all(file, text);
  try
  {
    read_mesh(file);
    FAIL() << "no error";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("is too much for a file of"), std::string::npos)
      << error.what();
  }
}

TEST(XmlSurfaceFile, GhostCellsDontCount)
{
  const TemporaryFolder folder;
  const TriangleMesh mesh = geodesic_sphere(4);
  const auto name = [](int side) { return "piece_" + std::to_string(side) + ".vtu"; };
  double owned = 0;
  for (const int side : { 0, 1 })
  {
    const auto piece = triangulated(half(mesh, side), "piece");
    EXPECT_GT(flat_area(to_mesh(piece)), flat_area(mesh) / 2);
    owned += flat_area(to_mesh(without_ghosts(piece)));
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(to_unstructured_grid(piece));
    writer->SetFileName((folder / name(side)).c_str());
    ASSERT_EQ(writer->Write(), 1);
  }
  EXPECT_NEAR(owned, flat_area(mesh), 1e-12);
  const auto list = folder / "whole.pvtu";
  write_all(list,
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid>"
    "<Piece Source=\"piece_0.vtu\"/><Piece Source=\"piece_1.vtu\"/>"
    "</PUnstructuredGrid></VTKFile>");
  const TriangleMesh whole = to_mesh(read_mesh(list));
  EXPECT_EQ(whole.points.rows(), mesh.points.rows());
  EXPECT_EQ(whole.triangles.rows(), mesh.triangles.rows());
  EXPECT_TRUE(topology(whole).closed);
  EXPECT_NEAR(flat_area(whole), flat_area(mesh), 1e-12);
  std::filesystem::remove(folder / name(1));
  EXPECT_EQ(triangles_of(list), -1);
}

}
