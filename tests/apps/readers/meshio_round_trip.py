"""A frame written again by meshio, in every format, gives the same curvature as the frame itself;
and meshio reads a mesh that the command writes, in every format but .vtk, which holds polygonal data
(meshio knows grids there)."""
import subprocess
import sys

import common

meshio = common.module("meshio")
numpy = common.module("numpy")
program = sys.argv[1]


def curvature(file):
    subprocess.run([program, "curvature", file, "-o", "curvature.vtu"], check=True)
    return meshio.read("curvature.vtu")


frame = meshio.read(common.frame(2, ".vtu"))
expected = curvature(common.frame(2, ".vtu"))
arrays = ["Mean_Curvature", "Gauss_Curvature", "Normals", "Laplacian_Mean_Curvature"]
for ending in ("vtu", "vtk", "obj", "off", "ply", "stl"):
    file = "again." + ending
    meshio.Mesh(frame.points, frame.cells).write(file)
    found = curvature(file)
    single = ending == "stl"
    assert found.points.shape == expected.points.shape, ending
    # .stl has no points of its own: those that come back may be in another order.
    distance = numpy.linalg.norm(found.points[:, None] - expected.points[None], axis=2)
    order = distance.argmin(axis=1)
    assert sorted(order) == list(range(len(order))), ending
    assert distance.min(axis=1).max() <= (2e-7 if single else 0), ending
    for name in arrays:
        a, b = found.point_data[name], expected.point_data[name][order]
        tolerance = 1e-5 * abs(b).max() if single else 0  # points rounded to 1e-7: up to 9e-7
        assert abs(a - b).max() <= tolerance, (ending, name, abs(a - b).max())

for ending in ("vtu", "obj", "off", "ply", "stl"):
    file = "shape." + ending
    subprocess.run([program, "shape", "oblate", "--reduced-volume", "0.9", "--triangles", "320",
                    "--basis", "linear", "-o", file], check=True, stdout=subprocess.DEVNULL)
    mesh = meshio.read(file)
    assert mesh.points.shape == (162, 3), file
    corners = mesh.points[mesh.cells_dict["triangle"]]
    volume = numpy.linalg.det(corners).sum() / 6
    assert abs(volume - 4 * numpy.pi / 3) < 1e-6, (file, volume)
