"""The surface of a label in a segmented volume, as a mesh for `vesicle curvature` and `vesicle repair`:

    python3 segmentation.py VOLUME LABEL SURFACE.vtp

VOLUME: .mrc (tomograms), .mha, .nii or .tif. Lengths are the file's own, Å in an .mrc.
"""

import pathlib
import sys

from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkPolyDataConnectivityFilter
from vtkmodules.vtkImagingCore import vtkImageThreshold
from vtkmodules.vtkIOImage import vtkImageReader2Factory, vtkMRCReader

import vesicle


def reader_of(file):
    """VTK's factory knows no .mrc."""
    reader = vtkMRCReader() if pathlib.Path(file).suffix in (".mrc", ".rec", ".map") else \
        vtkImageReader2Factory.CreateImageReader2(file)
    if reader is None or not pathlib.Path(file).exists():
        raise vesicle.Error(f"{file}: can't be read as a volume")
    reader.SetFileName(file)
    return reader


def main(volume, label, surface):
    reader = reader_of(volume)
    mask = vtkImageThreshold()  # 1 inside, 0 outside
    mask.SetInputConnection(reader.GetOutputPort())
    mask.ThresholdBetween(label, label)
    mask.SetInValue(1)
    mask.SetOutValue(0)
    mask.SetOutputScalarTypeToFloat()
    contour = vtkFlyingEdges3D()
    contour.SetInputConnection(mask.GetOutputPort())
    contour.SetValue(0, 0.5)
    contour.ComputeNormalsOff()
    largest = vtkPolyDataConnectivityFilter()
    largest.SetInputConnection(contour.GetOutputPort())
    largest.SetExtractionModeToLargestRegion()
    frame = vesicle.Frame(vesicle.update(largest))
    if frame.surface.GetNumberOfPolys() == 0:
        raise vesicle.Error(f"{volume}: has no label {label:g}")
    vesicle.write_mesh(frame, surface)
    print(f"{surface}: {len(frame.points)} points, {len(frame.triangles)} triangles")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]), sys.argv[3])
