#include "MeshFiles.h"

#include "MeshConversion.h"
#include "VtkMessages.h"
#include "XmlSurfaceFile.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/mesh/io/LegacyVtkFile.h"
#include "solver/mesh/io/ObjFile.h"
#include "solver/mesh/io/OffFile.h"
#include "solver/mesh/io/PlyFile.h"
#include "solver/mesh/io/StlFile.h"

#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLWriter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
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
void write_xml(vtkDataObject* data, const path& file)
{
  vtkNew<Writer> writer;
  writer->SetHeaderTypeToUInt64();
  // Inline: meshio misreads some raw appended files, depending on how their arrays compress.
  writer->SetDataModeToBinary();
  write_with(writer.Get(), data, file);
}

void write_legacy(vtkPolyData* surface, const path& file)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetFileTypeToBinary();
  write_with(writer.Get(), surface, file);
}

/// For writers that can't write to memory: to the unfinished name, then the file gets its own. Not
/// all of them notice a full disk, but the file then has fewer bytes than its numbers take.
template<class Writer>
void write_binary(vtkPolyData* surface, const path& file, vtkIdType least_bytes)
{
  const VtkMessages messages;
  const path unfinished = unfinished_name(file);
  vtkNew<Writer> writer;
  writer->SetFileTypeToBinary();
  writer->SetInputData(surface);
  writer->SetFileName(unfinished.c_str());
  try
  {
    require_written(writer->Write() != 0, writer.Get(), messages, file);
    std::error_code unknown;
    const auto bytes = std::filesystem::file_size(unfinished, unknown);
    if (!unknown && bytes < static_cast<std::uintmax_t>(least_bytes))
    {
      throw IoError(file.string() + ": can't be written: no space left");
    }
  }
  catch (const IoError&)
  {
    std::error_code ignored;
    if (unfinished != file)
    {
      std::filesystem::remove(unfinished, ignored);
    }
    throw;
  }
  finish_file(file);
}

void write_stl(vtkPolyData* surface, const path& file)
{
  write_binary<vtkSTLWriter>(surface, file, 50 * surface->GetNumberOfPolys());
}

void write_ply(vtkPolyData* surface, const path& file)
{
  write_binary<vtkPLYWriter>(
    surface, file, 12 * surface->GetNumberOfPoints() + 13 * surface->GetNumberOfPolys());
}

void pieces_only(vtkPolyData*, const path& file)
{
  unreadable(file, "lists pieces and can only be read; meshes are written as one, .vtu or .vtp");
}

struct Format
{
  std::function<Surface(const path&)> read;
  std::function<void(vtkPolyData*, const path&)> write;
};

const std::map<std::string, Format>& formats()
{
  static const std::map<std::string, Format> known{
    { ".vtu",
      { read_xml,
        [](vtkPolyData* surface, const path& file)
        { write_xml<vtkXMLUnstructuredGridWriter>(to_unstructured_grid(surface), file); } } },
    { ".vtp", { read_xml, write_xml<vtkXMLPolyDataWriter> } },
    { ".pvtu", { read_xml, pieces_only } },
    { ".pvtp", { read_xml, pieces_only } },
    { ".vtk", { read_by<read_legacy_vtk>, write_legacy } },
    { ".stl", { read_by<read_stl>, write_stl } },
    { ".ply", { read_by<read_ply>, write_ply } },
    { ".obj",
      { read_by<read_obj>,
        [](vtkPolyData* surface, const path& file)
        { replace_file(file, obj_text(to_mesh(surface))); } } },
    { ".off",
      { read_by<read_off>,
        [](vtkPolyData* surface, const path& file)
        { replace_file(file, off_text(to_mesh(surface))); } } },
  };
  return known;
}

const Format& format_of(const path& file)
{
  const auto found = formats().find(ending(file));
  if (found == formats().end())
  {
    throw InputError(
      fmt::format("{}: meshes end in .vtu .vtp .vtk .stl .ply .obj or .off, not in '{}'",
        file.string(), file.extension().string()));
  }
  return found->second;
}

}

void require_mesh_ending(const path& file)
{
  format_of(file);
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

void write_mesh(vtkPolyData* surface, const path& file)
{
  format_of(file).write(surface, file);
}

}
