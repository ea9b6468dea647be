"""What the readers' scripts share. They run beside the finished run pear/; a missing module ends
them with code 77."""
import csv
import importlib
import sys


def module(name):
    try:
        return importlib.import_module(name)
    except ImportError as error:
        print(error, file=sys.stderr)
        sys.exit(77)


def table():
    with open("pear/pear.csv", newline="") as file:
        return list(csv.DictReader(file))


def frame(index, ending):
    return f"pear/frames/pear_{index:06}{ending}"


frames = 3
points, triangles = 42, 80
vectors = ["Bending_Force", "Membrane_Force", "Normals", "Tension_Force", "Velocity"]
scalars = ["Gauss_Curvature", "Laplacian_Mean_Curvature", "Mean_Curvature", "Surface_Divergence",
           "Tension"]
numbers = ["Area", "Area_Drift", "Bending_Energy", "Reduced_Volume", "TimeValue", "Volume",
           "Volume_Drift"]
