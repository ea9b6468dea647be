"""h5py reads the checkpoint, whose series is the table, and the frames; no number is a NaN."""
import common

h5py = common.module("h5py")
numpy = common.module("numpy")
rows = common.table()


def check(name, item):
    if isinstance(item, h5py.Dataset):
        for field in item.dtype.names or [...]:
            if item.dtype.kind in "fV":
                assert numpy.isfinite(item[field]).all(), name


with h5py.File("pear/pear.h5", "r") as run:
    run.visititems(check)
    assert run["triangles/vesicle_0"].shape == (common.triangles, 3)
    assert run["committed"][()] == len(rows)
    assert run.attrs["length_scale"] > 0
    series = run["series"]
    assert list(series.dtype.names) == list(rows[0])
    for name in series.dtype.names:
        values = series[name]
        assert len(values) == len(rows), name
        for row, value in zip(rows, values):
            missing = value == series.attrs["missing_value"]
            assert row[name] == "" if missing else float(row[name]) == value, (name, value)
for index in range(common.frames):
    with h5py.File(common.frame(index, ".h5"), "r") as frame:
        frame.visititems(check)
        assert sorted(frame["point_data"]) == sorted(common.vectors + common.scalars)
        assert set(common.numbers) <= set(frame["field_data"])
        assert frame.attrs["time"] == frame["field_data/TimeValue"][0]
        assert frame["points"].shape == (common.points, 3)
        assert frame["points"].compression == "gzip"
