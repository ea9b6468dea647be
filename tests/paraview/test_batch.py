"""pvbatch draws without a screen as well."""

import tempfile
from pathlib import Path

from paraview import simple
from pictures import pixels

simple.VesicleSource(Shape="Discocyte", ReducedVolume=0)  # the starter has loaded the plugin
simple.LoadPalette("WhiteBackground")
view = simple.CreateRenderView(ViewSize=[300, 300])
simple.Show()
simple.Render()
with tempfile.TemporaryDirectory() as folder:
    file = Path(folder, "batch.png")
    simple.SaveScreenshot(str(file), view)
    picture = pixels(file)
assert picture.shape == (300, 300, 3), picture.shape
assert tuple(picture[0, 0]) == (255, 255, 255), picture[0, 0]
assert picture[150, 150].max() < 250, picture[150, 150]
