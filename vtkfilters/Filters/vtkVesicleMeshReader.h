/**
 * @class   vtkVesicleMeshReader
 * @brief   surface meshes from .vtu .vtp .vtk .stl .ply .obj .off and .msh files
 *
 * Reads a surface and its arrays (of .obj, .off and .msh the points and faces alone). Polygons and strips
 * come out as triangles; points that an .stl file repeats are merged. A file that is missing,
 * broken or holds no surface fails the update with an error that names it and says what to do.
 */

#ifndef vtkVesicleMeshReader_h
#define vtkVesicleMeshReader_h

#include "VesicleFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VESICLEFILTERS_EXPORT vtkVesicleMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkVesicleMeshReader* New();
  vtkTypeMacro(vtkVesicleMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file; its ending says the format. Default: none; one is needed.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkVesicleMeshReader();
  ~vtkVesicleMeshReader() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  char* FileName = nullptr;

private:
  vtkVesicleMeshReader(const vtkVesicleMeshReader&) = delete;
  void operator=(const vtkVesicleMeshReader&) = delete;
};

#endif
