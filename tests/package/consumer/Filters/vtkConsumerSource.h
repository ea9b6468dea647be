// A class derived from one of Vesicle's.

#ifndef vtkConsumerSource_h
#define vtkConsumerSource_h

#include "ConsumerFiltersModule.h" // for the export macro
#include "vtkVesicleSource.h"

class CONSUMERFILTERS_EXPORT vtkConsumerSource : public vtkVesicleSource
{
public:
  static vtkConsumerSource* New();
  vtkTypeMacro(vtkConsumerSource, vtkVesicleSource);

protected:
  vtkConsumerSource();
};

#endif
