#pragma once
// What the C++ of the documentation uses.

#include "vtkVesicleCurvatureFilter.h"
#include "vtkVesicleForceFilter.h"
#include "vtkVesicleProbeFilter.h"
#include "vtkVesicleSource.h"
#include "vtkVesicleStepper.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
