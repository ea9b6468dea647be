"""The mean curvature of a mesh, drawn by PyVista without a screen:

    python3 pyvista_curvature.py MESH.ply [PICTURE.png]

PyVista brings a VTK of its own where it is installed by pip; it must be the one that vesicle was built for.
"""

import sys

import pyvista

import vesicle


def main(file, picture):
    mesh = pyvista.wrap(vesicle.read_mesh(file))
    curvature = vesicle.vtkVesicleCurvatureFilter()
    curvature.SetInputData(mesh)  # a pyvista.PolyData is a vtkPolyData
    surface = pyvista.wrap(vesicle.Frame(vesicle.update(curvature)).surface)
    print(f"{surface.n_points} points, H from {surface['Mean_Curvature'].min():.3f} "
          f"to {surface['Mean_Curvature'].max():.3f}")
    plotter = pyvista.Plotter(off_screen=True)
    plotter.add_mesh(surface, scalars="Mean_Curvature", cmap="coolwarm", smooth_shading=True)
    plotter.screenshot(picture)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "curvature.png")
