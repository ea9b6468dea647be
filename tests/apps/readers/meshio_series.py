"""meshio's reader of XDMF time series sees what the .vtu frames hold, bit for bit."""
import common

meshio = common.module("meshio")
common.module("h5py")
with meshio.xdmf.TimeSeriesReader("pear/pear.xdmf") as reader:
    points, cells = reader.read_points_cells()
    assert reader.num_steps == common.frames
    assert (points == meshio.read(common.frame(0, ".vtu")).points).all()
    for index in range(common.frames):
        time, point_data, cell_data = reader.read_data(index)
        mesh = meshio.read(common.frame(index, ".vtu"))
        assert time == mesh.field_data["TimeValue"][0]
        assert (cells[0].data == mesh.cells_dict["triangle"]).all() and cells[0].type == "triangle"
        assert (point_data.pop("Position") == mesh.points).all()
        assert sorted(point_data) == sorted(mesh.point_data) and not cell_data
        for name, values in mesh.point_data.items():
            assert values.shape == point_data[name].shape and (values == point_data[name]).all()
