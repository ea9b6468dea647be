"""What the tests share."""

import contextlib
import os
import pathlib
import tempfile

source_folder = pathlib.Path(os.environ["VESICLE_SOURCE_DIR"])


@contextlib.contextmanager
def temporary_folder():
    """The current folder within `with`, with the data of the source tree."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(source_folder / "data", pathlib.Path(folder, "data"))
        os.chdir(folder)
        try:
            yield pathlib.Path(folder)
        finally:
            os.chdir(before)


def sphere(radius=1.0, triangles=320):
    import vesicle

    source = vesicle.vtkVesicleSource()
    source.SetRadius(radius)
    source.SetTriangles(triangles)
    return source
