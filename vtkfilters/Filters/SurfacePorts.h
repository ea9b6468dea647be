#pragma once
// What the filters say of the surfaces that they take.

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace vesicle
{

/// A surface of either kind; of blocks the pipeline brings one after the other.
inline void take_surfaces(vtkInformation* port)
{
  port->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
}

/// The same, and blocks of them together: vesicles that feel each other.
inline void take_surfaces_together(vtkInformation* port)
{
  take_surfaces(port);
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

/// Whatever piece is asked for feels the whole vesicle.
inline void request_whole(vtkInformationVector* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (vtkInformation* info = input->GetInformationObject(0))
  {
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
}

/// The whole at its first time, whichever is asked for.
inline void request_start(vtkInformationVector* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  request_whole(input);
  vtkInformation* info = input->GetInformationObject(0);
  if (info && info->Has(Pipeline::TIME_STEPS()))
  {
    info->Set(Pipeline::UPDATE_TIME_STEP(), info->Get(Pipeline::TIME_STEPS())[0]);
  }
  else if (info)
  {
    info->Remove(Pipeline::UPDATE_TIME_STEP());
  }
}

/// Of what is made of the whole, the first piece has all and others nothing.
inline bool is_first_piece(vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = output->GetInformationObject(0);
  return !info->Has(Pipeline::UPDATE_PIECE_NUMBER()) ||
    info->Get(Pipeline::UPDATE_PIECE_NUMBER()) == 0;
}

}
