#!/usr/bin/env python3
"""Stokes' flow past a rigid sphere of radius 1 at the origin, velocity 1 along x far away, as an image.

    python3 data/fields/past-a-sphere.py [FILE.vti [SPACING]]

Inside the sphere the fluid is at rest. Writes past-a-sphere.vti with a spacing of 0.25, if left out.
"""

import base64
import struct
import sys
import zlib

LOW, HIGH = (-6.0, -3.0, -3.0), (6.0, 3.0, 3.0)


def velocity(x, y, z):
    """u = e_x − (3/4)(e_x/r + x x_1/r³) − (1/4)(e_x/r³ − 3 x x_1/r⁵)."""
    r = (x * x + y * y + z * z) ** 0.5
    if r <= 1:
        return 0.0, 0.0, 0.0
    along = 0.75 * x * (1 / r**5 - 1 / r**3)
    return 1 - 0.75 / r - 0.25 / r**3 + along * x, along * y, along * z


def encoded(values):
    """Single precision in one compressed block, as VTK's XML files hold it."""
    raw = struct.pack(f"<{len(values)}f", *values)
    packed = zlib.compress(raw, 9)
    head = struct.pack("<4Q", 1, len(raw), 0, len(packed))
    return base64.b64encode(head).decode() + base64.b64encode(packed).decode()


def image(spacing):
    counts = [round((high - low) / spacing) for low, high in zip(LOW, HIGH)]
    places = [[low + i * spacing for i in range(n + 1)] for low, n in zip(LOW, counts)]
    values = [c for z in places[2] for y in places[1] for x in places[0] for c in velocity(x, y, z)]
    extent = " ".join(f"0 {n}" for n in counts)
    origin = " ".join(map(str, LOW))
    return f"""<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64" compressor="vtkZLibDataCompressor">
  <ImageData WholeExtent="{extent}" Origin="{origin}" Spacing="{spacing} {spacing} {spacing}">
    <Piece Extent="{extent}">
      <PointData Vectors="Velocity">
        <DataArray type="Float32" Name="Velocity" NumberOfComponents="3" format="binary">{encoded(values)}</DataArray>
      </PointData>
    </Piece>
  </ImageData>
</VTKFile>
"""


def main():
    file = sys.argv[1] if len(sys.argv) > 1 else "past-a-sphere.vti"
    spacing = float(sys.argv[2]) if len(sys.argv) > 2 else 0.25
    with open(file, "w", encoding="utf-8") as out:
        out.write(image(spacing))


if __name__ == "__main__":
    main()
