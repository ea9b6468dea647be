/**
 * @class   vtkVesicleMeshWriter
 * @brief   triangle meshes to .vtu .vtp .vtk .stl .ply .obj and .off files
 *
 * Writes the surface of a vtkPolyData as triangles (polygons and strips are cut, vertices and lines
 * dropped); .vtu, .vtp and .vtk keep the arrays. Coordinates are kept to the last bit but for .stl
 * and .ply, which hold single precision. The file appears when it is complete. What can't be
 * written is reported as an error, and GetErrorCode() isn't 0 then.
 */

#ifndef vtkVesicleMeshWriter_h
#define vtkVesicleMeshWriter_h

#include "VesicleFiltersModule.h" // for the export macro
#include "vtkWriter.h"

class VESICLEFILTERS_EXPORT vtkVesicleMeshWriter : public vtkWriter
{
public:
  static vtkVesicleMeshWriter* New();
  vtkTypeMacro(vtkVesicleMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file; its ending says the format. Default: none; one is needed.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkVesicleMeshWriter() = default;
  ~vtkVesicleMeshWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;

private:
  vtkVesicleMeshWriter(const vtkVesicleMeshWriter&) = delete;
  void operator=(const vtkVesicleMeshWriter&) = delete;
};

#endif
