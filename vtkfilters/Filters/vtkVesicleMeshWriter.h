/**
 * @class   vtkVesicleMeshWriter
 * @brief   triangle meshes to .vtu .vtp .vtk .stl .ply .obj .off and .msh files
 *
 * Writes a surface (vtkPolyData, vtkUnstructuredGrid, or blocks of them, joined) as triangles (polygons and strips are cut, vertices and lines
 * dropped); .vtu, .vtp and .vtk keep the arrays, .ply the numbers of points and triangles, .obj the
 * normals. Coordinates are kept to the last bit but for .stl, which holds single precision. What the
 * format can't hold is named in a warning. The file appears when it is complete. What can't be
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
