/**
 * @class   vtkVesicleSeriesWriter
 * @brief   surfaces as a time series of files, a frame a Write()
 *
 * Leaves what `vesicle run` leaves of its frames: frames/NAME_000000.vtu, …, listed in NAME.pvd and
 * NAME.vtu.series, and the same as .h5 files, listed in NAME.xdmf. The series on the disk is a valid one
 * after every Write(). The frame's time is the field data array TimeValue, which vtkVesicleStepper gives
 * its output, or else DATA_TIME_STEP. What can't be written is reported as an error, and GetErrorCode()
 * isn't 0 then.
 */

#ifndef vtkVesicleSeriesWriter_h
#define vtkVesicleSeriesWriter_h

#include "VesicleFiltersModule.h" // for the export macro
#include "vtkWriter.h"

#ifndef __VTK_WRAP__
#include <memory> // for the series
namespace vesicle
{
class SeriesWriter;
}
#endif

class VESICLEFILTERS_EXPORT vtkVesicleSeriesWriter : public vtkWriter
{
public:
  static vtkVesicleSeriesWriter* New();
  vtkTypeMacro(vtkVesicleSeriesWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The series, DIR/NAME.pvd; folders are made where they are missing. Another one
   * begins another series, whose first frame takes the place of a series that is there. Default: none;
   * one is needed.
   */
  virtual void SetFileName(const char* name);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkVesicleSeriesWriter();
  ~vtkVesicleSeriesWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;

private:
  vtkVesicleSeriesWriter(const vtkVesicleSeriesWriter&) = delete;
  void operator=(const vtkVesicleSeriesWriter&) = delete;

#ifndef __VTK_WRAP__
  std::unique_ptr<vesicle::SeriesWriter> Series;
#endif
};

#endif
