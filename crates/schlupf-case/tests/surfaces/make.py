"""Writes the sample surfaces of this folder, all the same: with 24 points along x (1.5 um apart) and 16
along y, heights of 0.4 um sin(x / 3 um) + 0.1 um cos(y / 2 um), x and y counted from the first point.

The X3P files keep to ISO 25178-72; zipfile, hashlib and NumPy write them, not schlupf.
"""

import hashlib
import pathlib
import zipfile

import numpy as np

HERE = pathlib.Path(__file__).parent
STEP = 1.5e-6
x, y = np.meshgrid(STEP * np.arange(24), STEP * np.arange(16))
heights = 0.4e-6 * np.sin(x / 3e-6) + 0.1e-6 * np.cos(y / 2e-6)

HEADER = """<?xml version="1.0" encoding="UTF-8"?>
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2">
  <Record1>
    <Revision>ISO5436 - 2000</Revision>
    <FeatureType>{feature}</FeatureType>
    <Axes>
      <CX><AxisType>I</AxisType><DataType>D</DataType><Increment>{dx}</Increment><Offset>0</Offset></CX>
      <CY><AxisType>I</AxisType><DataType>D</DataType><Increment>{dy}</Increment><Offset>0</Offset></CY>
      <CZ><AxisType>A</AxisType><DataType>{kind}</DataType>{scale}</CZ>
    </Axes>
  </Record1>
  <Record2>
    <Date>2024-01-01T00:00:00Z</Date>
    <Creator>schlupf tests</Creator>
  </Record2>
  <Record3>
    <MatrixDimension><SizeX>{nx}</SizeX><SizeY>{ny}</SizeY><SizeZ>1</SizeZ></MatrixDimension>
    {data}
  </Record3>
  <Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4>
</p:ISO5436_2>
"""


def write(name, header, members=()):
    digest = hashlib.md5(header.encode()).hexdigest()
    contents = [("main.xml", header.encode()), *members]
    contents.append(("md5checksum.hex", f"{digest} *main.xml\n".encode()))
    with zipfile.ZipFile(HERE / name, "w", zipfile.ZIP_DEFLATED) as archive:
        for member, content in contents:
            info = zipfile.ZipInfo(member, date_time=(2024, 1, 1, 0, 0, 0))
            info.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(info, content)


def link(data, valid=None):
    text = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>"
    text += f"<MD5ChecksumPointData>{hashlib.md5(data).hexdigest()}</MD5ChecksumPointData>"
    if valid is not None:
        text += "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>"
        text += f"<MD5ChecksumValidPoints>{hashlib.md5(valid).hexdigest()}</MD5ChecksumValidPoints>"
    return text + "</DataLink>"


def surface(name, kind, numbers, scale="", valid=None, dy=STEP):
    data = numbers.tobytes()
    ny, nx = numbers.shape
    header = HEADER.format(
        feature="SUR", dx=STEP, dy=dy, kind=kind, scale=scale, nx=nx, ny=ny, data=link(data, valid)
    )
    members = [("bindata/data.bin", data)]
    if valid is not None:
        members.append(("bindata/valid.bin", valid))
    write(name, header, members)


surface("wave.x3p", "D", heights.astype("<f8"))
surface("wave_not_square.x3p", "D", heights[::2].astype("<f8"), dy=2 * STEP)
scale = "<Increment>1e-11</Increment><Offset>-2e-7</Offset>"
integers = np.round((heights + 2e-7) / 1e-11).astype("<i4")
valid = np.ones(heights.shape, bool)
valid[5, 7] = valid[15, 23] = False
integers[~valid] = 0
bits = np.packbits(valid.ravel(), bitorder="little").tobytes()
surface("wave_integers_holes.x3p", "L", integers, scale, bits)
holes = heights.astype("<f4")
holes[5, 7] = np.nan
surface("wave_single_holes.x3p", "F", holes)
surface("flat.x3p", "D", np.full((16, 24), 1e-6))

along = 0.4e-6 * np.sin(STEP * np.arange(100) / 3e-6)
datums = "".join(f"<Datum>0;0;{z!r}</Datum>" for z in along.tolist())
data = f"<DataList>{datums}</DataList>"
write(
    "profile.x3p",
    HEADER.format(feature="PRF", dx=STEP, dy=0, kind="D", scale="", nx=100, ny=1, data=data),
)

np.save(HERE / "wave.npy", heights * 1e6)
rows = zip(x.ravel() * 1e6, y.ravel() * 1e6, heights.ravel() * 1e9)
lines = [f"{a:.3f},{b:.3f},{c:.6f}" for a, b, c in rows]
(HERE / "wave.csv").write_text("# made up\nx [um],y [um],height [nm]\n" + "\n".join(lines) + "\n")
rows = zip(x.ravel() * 1e6, y.ravel() * 1e6, heights.ravel() * 1e6)
lines = [f"{a:.3f} {b:.3f} {c:.9f}" for a, b, c in rows]
lines[5 * 24 + 7] = " ".join(lines[5 * 24 + 7].split()[:2]) + " No Data"
(HERE / "wave_holes.xyz").write_text("\n".join(lines) + "\n")
