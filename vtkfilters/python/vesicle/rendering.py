"""Pictures, with or without a screen.

Importing this makes vtkRenderWindow usable everywhere: where DISPLAY names no screen, windows draw into
memory (libOSMesa, or else libEGL; the environment variable VESICLE_RENDER_BACKEND, osmesa, egl or x,
tries that one alone). Import it before the first window is made.
"""

from __future__ import annotations

import os
import typing

import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingContextOpenGL2
import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkPolyDataMapper,
                                         vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor,
                                         vtkTextActor, vtkWindowToImageFilter)

from .VesicleOffscreen import *
from .errors import InputError
from .meshes import polydata_of
from .pipeline import Messages

with Messages():
    vtkVesicleOffscreen.UseWithoutScreen()


class View:
    """A window that shows one surface after the other, on the screen or, where there is none, in memory.

    color: the point array that colours the surface, a vector by its magnitude
    size: pixels
    range: lowest and highest value of the colours; None: of each surface
    Renderer and window are VTK's own, for whatever else should be changed.
    """

    def __init__(self, color: str = "Mean_Curvature", size: tuple[int, int] = (800, 600),
                 range: tuple[float, float] | None = None) -> None:
        self.color = color
        self.range = range
        self.mapper = vtkPolyDataMapper()
        self.mapper.SetScalarModeToUsePointFieldData()
        self.mapper.SelectColorArray(color)
        self.mapper.SetInterpolateScalarsBeforeMapping(True)
        self.mapper.SetLookupTable(_cool_to_warm())
        self.mapper.UseLookupTableScalarRangeOn()
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        bar = vtkScalarBarActor()
        bar.SetLookupTable(self.mapper.GetLookupTable())
        bar.SetTitle(color.replace("_", " "))
        bar.UnconstrainedFontSizeOn()
        self.text = vtkTextActor()
        self.text.SetPosition(10, 10)
        for text in (self.text.GetTextProperty(), bar.GetTitleTextProperty(),
                     bar.GetLabelTextProperty()):
            text.SetColor(0, 0, 0)
            text.SetFontSize(16)
            text.ShadowOff()
            text.ItalicOff()
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        for prop in (actor, bar, self.text):
            self.renderer.AddViewProp(prop)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -1, 0)
        camera.SetViewUp(0, 0, 1)
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.on_screen = not self.window.GetClassName().startswith("vtkVesicle")

    def show(self, surface: typing.Any, text: str = "") -> None:
        """Draws a vtkPolyData, as it is, wrapped as `update` gives it, or a Frame, with a line of text."""
        surface = polydata_of(surface)
        array = surface.GetPointData().GetArray(self.color)
        if array is None:
            data = surface.GetPointData()
            names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
            raise InputError(f"the surface has no point array {self.color!r}; there are: "
                             f"{', '.join(names) or 'none'}")
        first = self.mapper.GetInput() is None
        self.mapper.SetInputData(surface)
        colors = self.mapper.GetLookupTable()
        low, high = self.range or array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0)
        _stretch(colors, low, high)
        self.text.SetInput(text)
        if first:
            self.interactor.Initialize()
        self.renderer.ResetCamera()
        with Messages():
            self.window.Render()
        if self.on_screen:
            self.interactor.ProcessEvents()

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes what is shown as a .png file."""
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        writer = vtkPNGWriter()
        writer.SetCompressionLevel(1)
        writer.SetInputConnection(grab.GetOutputPort())
        writer.SetFileName(os.fspath(file))
        with Messages():
            writer.Write()

    def wait(self) -> None:
        """Leaves the window to the mouse until it is closed; returns at once where there is no screen."""
        if self.on_screen:
            self.interactor.Start()


def _cool_to_warm() -> vtkColorTransferFunction:
    colors = vtkColorTransferFunction()
    colors.SetColorSpaceToDiverging()
    colors.SetVectorModeToMagnitude()
    return colors


def _stretch(colors: vtkColorTransferFunction, low: float, high: float) -> None:
    colors.RemoveAllPoints()
    colors.AddRGBPoint(low, 0.23, 0.30, 0.75)
    colors.AddRGBPoint(high if high > low else low + 1, 0.71, 0.02, 0.15)
