#include "render/PngFile.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <fmt/format.h>

namespace vesicle
{

void write_png(const std::filesystem::path& file, vtkImageData* image)
{
  constexpr int zlib_level = 3;
  // Through memory: VTK's writer doesn't notice a full disk.
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetCompressionLevel(zlib_level);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* png = writer->GetResult();
  if (!png || png->GetNumberOfValues() == 0)
  {
    throw IoError(fmt::format("can't encode the picture for {}", file.string()));
  }
  const auto* bytes = reinterpret_cast<const char*>(png->GetPointer(0));
  replace_file(file, { bytes, static_cast<std::size_t>(png->GetNumberOfValues()) });
}

}
