"""meshio reads every .vtu frame, its arrays and its time."""
import common

meshio = common.module("meshio")
rows = [float(row["time"]) for row in common.table()]
for index in range(common.frames):
    mesh = meshio.read(common.frame(index, ".vtu"))
    assert mesh.points.dtype == "float64" and mesh.points.shape == (common.points, 3)
    assert mesh.cells_dict["triangle"].shape == (common.triangles, 3)
    assert sorted(mesh.point_data) == sorted(common.vectors + common.scalars)
    for name in common.vectors:
        assert mesh.point_data[name].shape == (common.points, 3), name
    for name in common.scalars:
        assert mesh.point_data[name].shape == (common.points,), name
    assert set(common.numbers) <= set(mesh.field_data)
    assert mesh.field_data["TimeValue"][0] in rows
