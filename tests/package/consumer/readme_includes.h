#pragma once
// What the README's C++ uses.

#include "vtkVesicleCurvatureFilter.h"
#include "vtkVesicleSource.h"
#include "vtkVesicleStepper.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
