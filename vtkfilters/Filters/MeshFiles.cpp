#include "MeshFiles.h"

#include "MeshConversion.h"
#include "VtkMessages.h"
#include "XmlSurfaceFile.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/mesh/io/GmshFile.h"
#include "solver/mesh/io/LegacyVtkFile.h"
#include "solver/mesh/io/ObjFile.h"
#include "solver/mesh/io/OffFile.h"
#include "solver/mesh/io/PlyFile.h"
#include "solver/mesh/io/PlyWriter.h"
#include "solver/mesh/io/StlFile.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <limits>
#include <map>

namespace vesicle
{
namespace
{

using std::filesystem::path;
using Surface = vtkSmartPointer<vtkPolyData>;

std::string ending(const path& file)
{
  std::string text = file.extension().string();
  std::transform(
    text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

[[noreturn]] void unreadable(const path& file, const std::string& what)
{
  throw InputError(fmt::format("{}: {}", file.string(), what));
}

using Read = SurfaceFile (*)(std::string_view, const std::string&);

/// By a reader of bytes.
template<Read read>
Surface read_by(const path& file)
{
  return triangulated(read(read_file(file), file.string()), file.string());
}

Surface read_xml(const path& file)
{
  return triangulated(read_xml_surface(file), file.string());
}

template<class Writer>
void require_written(bool written, Writer* writer, const VtkMessages& messages, const path& file)
{
  if (!written || writer->GetErrorCode() != 0 || messages.any_error())
  {
    const auto code = writer->GetErrorCode();
    throw IoError(
      fmt::format("{}: can't be written: {}; check the folder and the space left", file.string(),
        code != 0 ? vtkErrorCode::GetStringFromErrorCode(code) : messages.first_error()));
  }
}

std::string text_of(vtkXMLWriter* writer)
{
  return writer->GetOutputString();
}
std::string text_of(vtkDataWriter* writer)
{
  return writer->GetOutputStdString();
}

/// Has VTK's writer write to memory: on a full disk some of them crash.
template<class Writer>
void write_with(Writer* writer, vtkDataObject* data, const path& file)
{
  std::string text;
  {
    const VtkMessages messages;
    writer->SetInputDataObject(data);
    writer->SetWriteToOutputString(true);
    require_written(writer->Write() != 0, writer, messages, file);
    text = text_of(writer);
  }
  replace_file(file, text);
}

template<class Writer>
std::string write_xml(vtkDataObject* data, const path& file)
{
  vtkNew<Writer> writer;
  writer->SetHeaderTypeToUInt64();
  // Inline: meshio misreads some raw appended files, depending on how their arrays compress.
  writer->SetDataModeToBinary();
  write_with(writer.Get(), data, file);
  return "";
}

/// VTK's legacy writer counts tuples where it should count bits: several in a tuple are cut short,
/// none makes it read behind the array.
bool is_miswritten(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_BIT &&
    (array->GetNumberOfComponents() > 1 || array->GetNumberOfTuples() == 0);
}

/// The same arrays in the same places, those that would be miswritten as bytes.
void put_bytes_for_bits(vtkFieldData* arrays)
{
  vtkNew<vtkFieldData> old;
  old->ShallowCopy(arrays);
  auto* attributes = vtkDataSetAttributes::SafeDownCast(arrays);
  std::array<int, vtkDataSetAttributes::NUM_ATTRIBUTES> active;
  if (attributes)
  {
    attributes->GetAttributeIndices(active.data());
  }
  arrays->Initialize();
  for (int i = 0; i < old->GetNumberOfArrays(); ++i)
  {
    vtkSmartPointer<vtkAbstractArray> array = old->GetAbstractArray(i);
    if (is_miswritten(array))
    {
      vtkNew<vtkUnsignedCharArray> bytes;
      bytes->DeepCopy(array);
      array = bytes;
    }
    arrays->AddArray(array);
  }
  for (int type = 0; attributes && type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    attributes->SetActiveAttribute(active[type], type);
  }
}

std::string write_legacy(vtkPolyData* triangles, const path& file)
{
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(triangles);
  for (vtkFieldData* arrays : { static_cast<vtkFieldData*>(surface->GetPointData()),
         static_cast<vtkFieldData*>(surface->GetCellData()), surface->GetFieldData() })
  {
    put_bytes_for_bits(arrays);
  }
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetFileTypeToBinary();
  write_with(writer.Get(), surface.Get(), file);
  return "";
}

/// What a format can't hold, in one sentence; empty: it holds all.
std::string loss(const path& file, const std::vector<std::string>& arrays, const char* remedy)
{
  return arrays.empty()
    ? ""
    : fmt::format("{}: can't hold {}; {}", file.string(), fmt::join(arrays, ", "), remedy);
}

constexpr const char* keeps_all = ".vtu, .vtp and .vtk files do";

std::vector<std::string> names_of(vtkFieldData* arrays)
{
  std::vector<std::string> names;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    const char* name = arrays->GetAbstractArray(i)->GetName();
    names.emplace_back(name ? name : "(an array without a name)");
  }
  return names;
}

std::vector<std::string> all_names(vtkPolyData* surface)
{
  std::vector<std::string> names = names_of(surface->GetPointData());
  for (vtkFieldData* data :
    { static_cast<vtkFieldData*>(surface->GetCellData()), surface->GetFieldData() })
  {
    const auto more = names_of(data);
    names.insert(names.end(), more.begin(), more.end());
  }
  return names;
}

/// Shape is lost where coordinates are rounded by more than this part of the surface's size.
constexpr double harmless_rounding = 1e-6;

std::string rounding_loss(const path& file, const Points& points)
{
  if (points.rows() == 0)
  {
    return "";
  }
  const double size = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  const double rounding = (points - points.cast<float>().cast<double>()).cwiseAbs().maxCoeff();
  return rounding <= harmless_rounding * size
    ? ""
    : fmt::format("{}: holds single precision, which rounds these coordinates by up to {:.2g}, "
                  "{:.2g} of the surface's size; move it to the origin, or write .ply or .vtu",
        file.string(), rounding, rounding / size);
}

std::string write_stl(vtkPolyData* surface, const path& file)
{
  const TriangleMesh mesh = to_mesh(surface);
  if (!mesh.points.cast<float>().allFinite())
  {
    throw InputError(
      fmt::format("{}: holds single precision, which ends at {:.2g}, below these "
                  "coordinates; choose another unit of length, or write .ply or .vtu",
        file.string(), std::numeric_limits<float>::max()));
  }
  replace_file(file, stl_bytes(mesh));
  const std::string rounded = rounding_loss(file, mesh.points);
  const std::string lost = loss(file, all_names(surface), keeps_all);
  return rounded.empty() || lost.empty() ? rounded + lost : rounded + "; " + lost;
}

std::string write_ply(vtkPolyData* surface, const path& file)
{
  const PlyText ply = ply_text(to_surface_file(surface));
  replace_file(file, ply.bytes);
  return loss(file, ply.lost, keeps_all);
}

/// A row a point; none unless it has three components.
Points vectors_of(vtkDataArray* array)
{
  Points vectors(array && array->GetNumberOfComponents() == 3 ? array->GetNumberOfTuples() : 0, 3);
  for (Eigen::Index i = 0; i < vectors.rows(); ++i)
  {
    array->GetTuple(i, vectors.row(i).data());
  }
  return vectors;
}

/// From 0 to 1, as OBJ has them.
Points colours_of(vtkDataArray* array)
{
  const bool bytes = array && array->GetDataType() == VTK_UNSIGNED_CHAR;
  return vectors_of(array) / (bytes ? 255.0 : 1.0);
}

std::string write_obj(vtkPolyData* surface, const path& file)
{
  vtkPointData* arrays = surface->GetPointData();
  const Points normals = vectors_of(arrays->GetNormals());
  const Points colours = colours_of(arrays->GetArray("RGB"));
  replace_file(file, obj_text(to_mesh(surface), normals, colours));
  std::vector<std::string> lost = all_names(surface);
  if (const char* name = normals.rows() > 0 ? arrays->GetNormals()->GetName() : nullptr)
  {
    std::erase(lost, name);
  }
  if (colours.rows() > 0)
  {
    std::erase(lost, "RGB");
  }
  return loss(file, lost, keeps_all);
}

std::string write_off(vtkPolyData* surface, const path& file)
{
  replace_file(file, off_text(to_mesh(surface)));
  return loss(file, all_names(surface), keeps_all);
}

std::string write_msh(vtkPolyData* surface, const path& file)
{
  replace_file(file, gmsh_text(to_mesh(surface)));
  return loss(file, all_names(surface), keeps_all);
}

std::string write_grid(vtkPolyData* surface, const path& file)
{
  return write_xml<vtkXMLUnstructuredGridWriter>(to_unstructured_grid(surface), file);
}

std::string pieces_only(vtkPolyData*, const path& file)
{
  unreadable(file, "lists pieces and can only be read; meshes are written as one, .vtu or .vtp");
}

struct Format
{
  std::function<Surface(const path&)> read;
  std::function<std::string(vtkPolyData*, const path&)> write; ///< returns what is lost
  bool keeps_fields = false;
};

const std::map<std::string, Format>& formats()
{
  static const std::map<std::string, Format> known{
    { ".vtu", { read_xml, write_grid, true } },
    { ".vtp", { read_xml, write_xml<vtkXMLPolyDataWriter>, true } },
    { ".pvtu", { read_xml, pieces_only } },
    { ".pvtp", { read_xml, pieces_only } },
    { ".vtk", { read_by<read_legacy_vtk>, write_legacy, true } },
    { ".stl", { read_by<read_stl>, write_stl } },
    { ".ply", { read_by<read_ply>, write_ply } },
    { ".obj", { read_by<read_obj>, write_obj } },
    { ".off", { read_by<read_off>, write_off } },
    { ".msh", { read_by<read_gmsh>, write_msh } },
  };
  return known;
}

const Format& format_of(const path& file)
{
  const auto found = formats().find(ending(file));
  if (found == formats().end())
  {
    throw InputError(fmt::format(
      "{}: meshes end in {}, not in '{}'", file.string(), mesh_endings, file.extension().string()));
  }
  return found->second;
}

}

void require_mesh_ending(const path& file)
{
  format_of(file);
}

bool keeps_field_data(const path& file)
{
  return format_of(file).keeps_fields;
}

vtkSmartPointer<vtkPolyData> read_mesh(const path& file)
{
  const Format& format = format_of(file);
  require_file(file);
  const auto surface = format.read(file);
  if (surface->GetNumberOfPolys() == 0)
  {
    unreadable(file, "holds no triangles; a surface mesh is needed");
  }
  return surface;
}

std::string write_mesh(vtkPolyData* surface, const path& file)
{
  return format_of(file).write(surface, file);
}

}
