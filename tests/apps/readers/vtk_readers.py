"""VTK's own readers, from Python, read the frames and what the command writes of a mesh."""
import subprocess
import sys

import common

io = common.module("vtkmodules.vtkIOXML")
core = common.module("vtkmodules.vtkCommonCore")
others = {".vtk": common.module("vtkmodules.vtkIOLegacy").vtkPolyDataReader,
          ".stl": common.module("vtkmodules.vtkIOGeometry").vtkSTLReader,
          ".ply": common.module("vtkmodules.vtkIOPLY").vtkPLYReader,
          ".vtp": io.vtkXMLPolyDataReader,
          ".vtu": io.vtkXMLUnstructuredGridReader}


def read(reader, file):
    complaints = []
    reader.AddObserver("ErrorEvent", lambda *_: complaints.append(file))
    reader.SetFileName(file)
    reader.Update()
    assert not complaints and reader.GetErrorCode() == 0, file
    return reader.GetOutput()


rows = [float(row["time"]) for row in common.table()]
for index in range(common.frames):
    grid = read(io.vtkXMLUnstructuredGridReader(), common.frame(index, ".vtu"))
    assert grid.GetNumberOfPoints() == common.points
    assert grid.GetNumberOfCells() == common.triangles
    assert grid.GetPoints().GetDataType() == core.VTK_DOUBLE
    data = grid.GetPointData()
    for names, components in ((common.vectors, 3), (common.scalars, 1)):
        for name in names:
            assert data.GetArray(name).GetNumberOfComponents() == components, name
    fields = grid.GetFieldData()
    assert all(isinstance(fields.GetAbstractArray(i), core.vtkDataArray)
               for i in range(fields.GetNumberOfArrays()))
    assert fields.GetArray("TimeValue").GetValue(0) in rows

for ending, reader in others.items():
    file = "curved" + ending
    subprocess.run([sys.argv[1], "curvature", common.frame(2, ".vtu"), "-o", file], check=True)
    surface = read(reader(), file)
    assert surface.GetNumberOfPoints() == common.points, file
    assert surface.GetNumberOfCells() == common.triangles, file
    if ending in (".vtu", ".vtp", ".vtk"):
        assert surface.GetPointData().HasArray("Mean_Curvature"), file
