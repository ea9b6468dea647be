"""A run's last frame in ParaView, with the velocity as arrows; no plugin is needed for that:

    pvpython paraview_run.py RUN/NAME.pvd [PICTURE.png]
"""

import sys

from paraview import simple


def main(series, picture):
    frames = simple.OpenDataFile(series)
    frames.UpdatePipelineInformation()
    end = frames.TimestepValues[-1]
    view = simple.CreateRenderView(ViewSize=[800, 600], ViewTime=end)
    shape = simple.Show(frames, view)
    simple.ColorBy(shape, ("POINTS", "Mean_Curvature"))
    shape.RescaleTransferFunctionToDataRange()
    shape.SetScalarBarVisibility(view, True)
    arrows = simple.Glyph(Input=frames, GlyphType="Arrow", OrientationArray=["POINTS", "Velocity"],
                          ScaleArray=["POINTS", "Velocity"], ScaleFactor=0.2)
    simple.Show(arrows, view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -1, 0], [0, 0, 0], [0, 0, 1]
    simple.ResetCamera(view)
    simple.SaveScreenshot(picture, view)
    print(f"t = {end:g}: {picture}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "run.png")
