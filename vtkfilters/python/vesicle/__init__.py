"""Lipid vesicles by the boundary element method, as VTK algorithms.

All classes vtkVesicle… of the C++ module are here and take their place in any pipeline of vtkmodules.
A few functions make scripts short:

    run(scene)                  simulates a scene; frames and diagnostics as numpy arrays
    open_run(folder)            the same of what `vesicle run` left in a folder
    update(algorithm, time)     brings an algorithm up to date; errors become exceptions; numpy arrays
    times(algorithm)            the times that it offers
    read_mesh, write_mesh       .vtu .vtp .vtk .stl .ply .obj .off .msh
    make_mesh, triangles        a mesh from numpy arrays, and its triangles as one

All that fails raises vesicle.Error. Numbers are in the units of the scene, or of the mesh.

vesicle.rendering draws, with or without a screen. See help(vesicle.vtkVesicleStepper) and so on for
properties, units and defaults.
"""

from . import blas

blas.choose_kernel()  # before anything loads OpenBLAS

from .VesicleFilters import *
from .errors import Error, InputError
from .frames import Frame
from .meshes import make_mesh, read_mesh, triangles, write_mesh
from .pipeline import times, update
from .runs import Run, open_run
from .simulate import Step, run
from .tables import Table, read_table
from .version import __version__
