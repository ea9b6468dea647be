"""examples/paraview_run.py in pvpython, on a run of the command."""

import os
import pathlib
import runpy
import subprocess
import sys
import tempfile

source = pathlib.Path(os.environ["VESICLE_SOURCE_DIR"])
with tempfile.TemporaryDirectory() as folder:
    run, picture = pathlib.Path(folder, "pear"), pathlib.Path(folder, "pear.png")
    # ParaView's libraries are not the command's.
    clean = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    subprocess.run([os.environ["VESICLE_COMMAND"], "run", str(source / "data/scenes/pear.toml"), "-o", str(run),
                    "--set", "vesicle.triangles=80", "--set", "time.end=0.1", "--no-movie", "--no-plots", "--quiet"],
                   check=True, env=clean)
    sys.argv = ["paraview_run.py", str(run / "pear.pvd"), str(picture)]
    runpy.run_path(str(source / "examples/paraview_run.py"), run_name="__main__")
    assert picture.stat().st_size > 1000
