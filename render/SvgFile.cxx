#include "render/SvgFile.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkSVGExporter.h"

namespace vesicle
{

void write_svg(const std::filesystem::path& file, vtkRenderWindow* window)
{
  const auto unfinished = unfinished_name(file);
  vtkNew<vtkSVGExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFileName(unfinished.c_str());
  exporter->SetTitle(file.stem().c_str());
  exporter->SetDescription("");  // VTK would say that it is VTK's
  exporter->SetTextAsPath(true); // the reader may lack the font
  exporter->Write();
  if (!is_there(unfinished))
    throw IoError(file.string() + ": can't be written");
  finish_file(file);
}

}
