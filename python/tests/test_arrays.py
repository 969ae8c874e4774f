"""Arrays in place of files: the same case, whatever the numbers come in."""

import pickle
from pathlib import Path

import numpy as np
import pandas as pd
import pint
import pytest
import xarray as xr

import schlupf
from schlupf._fields import FIELDS
from schlupf._files import data_url

COARSE = {"cells_x": 8, "cells_y": 8}
EXAMPLES = Path(schlupf.examples.__file__).parent / "cases"
DATA = Path(__file__).parents[2] / "data"


def solved(**sections):
    return schlupf.Case(grid=COARSE, **sections).solve(warn=False).to_dict()


def by_file(folder, text):
    """A file with a text."""
    path = folder / "table.csv"
    path.write_text(text)
    return path


def test_every_table_that_a_case_names_has_columns():
    files = {path for path, field in FIELDS.items() if field.kind == "path"}
    archives = {"solver.table", "element.contact_table"}
    assert files - archives == {path for path, field in FIELDS.items() if field.columns}


PRESSURE = "x [mm],y [mm],pressure [MPa]\n" + "".join(
    f"{x},{y},{max(0.0, 1 - x * x / 25 - y * y / 16) ** 0.5 * 1000!r}\n"
    for y in range(-5, 6)
    for x in range(-6, 7)
)


def pressure():
    """The same over x and y, in SI units."""
    x, y = np.arange(-6, 7) * 1e-3, np.arange(-5, 6) * 1e-3
    values = np.sqrt(np.maximum(0, 1 - (x / 5e-3) ** 2 - (y[:, None] / 4e-3) ** 2)) * 1e9
    return xr.DataArray(values, {"y": y, "x": x}, ("y", "x"), "pressure", {"units": "Pa"})


def test_a_pressure_may_be_an_array(tmp_path):
    motion = {"creepage_x": 0.003, "spin": 1.0}
    path = by_file(tmp_path, PRESSURE)
    expected = solved(kinematics=motion, normal={"model": "tabulated", "file": path})
    array = pressure()
    frame = array.to_dataframe()
    uneven = array.assign_coords(x=array["x"] + np.where(array["x"] == 0, 1e-8, 0))
    spacing = {"spacing_x": 1e-3, "spacing_y": 1e-3}
    for file in (array, array.transpose(), array.to_dataset(), frame, frame.reset_index(), uneven):
        found = solved(kinematics=motion, normal={"model": "tabulated", "file": file})
        assert found["force"] == pytest.approx(expected["force"], rel=1e-6), type(file)
    normal = {"model": "tabulated", "file": array.values, **spacing}
    assert solved(kinematics=motion, normal=normal)["force"] == pytest.approx(
        expected["force"], rel=1e-12
    )


def test_where_a_map_starts_counts(tmp_path):
    """Of a distance that is that of a sphere the place of least distance is the contact."""
    x = np.linspace(-0.01, 0.03, 81)
    y = np.linspace(-0.02, 0.02, 81)
    distance = ((x - 0.008) ** 2 + (y[:, None] + 0.003) ** 2) / (2 * 0.3)
    array = xr.DataArray(distance, {"y": y, "x": x}, ("y", "x"))
    normal = {"model": "profile", "file": array, "load": 80e3}
    modulus = 210e9 / (2 * (1 - 0.28**2))
    radius = (3 * 80e3 * 0.3 / (4 * modulus)) ** (1 / 3)
    for file in (array, array.rename("distance").to_dataframe()):
        (found,) = schlupf.Case(normal={**normal, "file": file}).patch(warn=False).contacts
        assert found.normal.origin_x == pytest.approx(0.008, rel=1e-6)
        assert found.normal.origin_y == pytest.approx(-0.003, rel=1e-6)
        assert found.normal.semi_axis_x == pytest.approx(radius, rel=1e-2)


def test_a_profile_may_be_an_array(tmp_path):
    path = DATA / "profile_s1002.csv"
    y, z = np.loadtxt(path, delimiter=",", skiprows=header(path), unpack=True) * 1e-3
    rail = {"profile": "60E1", "cant": 0.025}
    normal = {"model": "wheel-rail", "load": 50e3, "method": "kik-piotrowski"}
    common = {"normal": normal, "rail": rail, "solver": {"method": "table"}}
    expected = solved(wheel={"profile": path}, **common)
    units = pint.UnitRegistry()
    for profile in (
        np.column_stack([y, z]),
        np.column_stack([y, z]).tolist(),
        np.column_stack([y, z]) * 1e3 * units.mm,
        {"y": y, "z": z},
        {"y [mm]": y * 1e3, "z": z},
        pd.DataFrame({"z": z, "y": y}, index=np.arange(len(y)) + 7),
        pd.Series(z, pd.Index(y, name="y")).to_frame("z"),
        xr.DataArray(z, {"y": y}),
    ):
        found = solved(wheel={"profile": profile}, **common)
        assert found["wheel_force"] == pytest.approx(expected["wheel_force"], rel=1e-6)


def header(path):
    """Lines before the numbers."""
    lines = path.read_text().splitlines()
    return next(k for k, line in enumerate(lines) if line[:1] in "-0123456789")


def test_histories_friction_and_wear_may_be_tables(tmp_path):
    time, creepage = np.linspace(0, 2e-3, 5), np.array([0, 1, 2, 2, 1]) * 1e-3
    history = {"time": time, "creepage_x": creepage}
    expected = solved(history=history)
    for file in (pd.DataFrame(history), pd.DataFrame(history).set_index("time"), history):
        assert solved(history={"file": file}) == expected
    run = xr.Dataset({"creepage_x": ("time", creepage)}, {"time": time, "step": ("time", range(5))})
    assert solved(history={"file": run}) == expected

    variation = [[-4e-3, 0.5], [0, 1.0], [4e-3, 0.7]]
    y, factor = np.transpose(variation)
    arrays = {"variation_y": y, "variation_factor": factor}
    motion = {"creepage_x": 0.003}
    expected = solved(kinematics=motion, friction=arrays)
    for file in (variation, pd.Series(factor, pd.Index(y, name="y"), name="factor")):
        assert solved(kinematics=motion, friction={"variation_file": file}) == expected
    with pytest.raises(schlupf.CaseError, match="has a column `0`"):
        schlupf.Case(friction={"variation_file": pd.Series(factor, y)})


def test_heights_may_be_arrays(tmp_path):
    heights = np.load(EXAMPLES / "rough_surface.npy")
    spacing = 1e-6
    np.save(tmp_path / "h.npy", heights)
    options = {"pressure": ["0.4 GPa", "0.8 GPa"], "warn": False}
    case = schlupf.Case()
    of_file = case.roughness(surface=tmp_path / "h.npy", unit="m", spacing=spacing, **options)
    expected = of_file.contact_law.stiffness
    places = {"y": np.arange(len(heights)) * spacing, "x": np.arange(heights.shape[1]) * spacing}
    array = xr.DataArray(heights, places, ("y", "x"))
    for found in (
        case.roughness(surface=heights, spacing=spacing, **options),
        case.roughness(surface=array, **options),
        case.roughness(surface=array.assign_attrs(units="m").T, **options),
    ):
        assert found.contact_law.stiffness == pytest.approx(expected, rel=1e-9)
    roughness = {"file": array, "pressures": [0.4e9, 0.8e9]}
    for given in (roughness, {**roughness, "file": heights, "spacing": spacing}):
        law = schlupf.Case(contact_law={"roughness": given}, grid=COARSE).solve(warn=False)
        assert law.contact_law.stiffness == pytest.approx(expected, rel=1e-6)
    assert schlupf.Case(contact_law={"roughness": array}).contact_law.roughness.file
    # Rows of three heights are no points.
    narrow = case.roughness(surface=heights[:, :3], spacing=spacing, form="none", warn=False)
    assert (narrow.surface.rows, narrow.surface.columns) == (len(heights), 3)


def test_data_survive_text_pickle_and_other_fields():
    case = schlupf.Case(normal={"model": "tabulated", "file": pressure()}, grid=COARSE)
    expected = case.solve(warn=False).force.x
    for again in (
        schlupf.Case.from_toml(case.to_toml()),
        schlupf.Case.from_toml(case.to_toml("/"), "/"),
        pickle.loads(pickle.dumps(case)),
        case.with_(title="other").with_(title=None),
    ):
        assert again == case and again.solve(warn=False).force.x == expected
    assert len(repr(case)) < 300 and len(repr(case.normal)) < 300


def test_a_case_of_many_heights_is_read_from_its_file(tmp_path):
    heights = 1e-6 * np.random.default_rng(1).standard_normal((700, 700))
    case = schlupf.Case(contact_law={"roughness": {"file": heights, "spacing": 1e-6}})
    path = by_file(tmp_path, case.to_toml())
    assert path.stat().st_size > 4 << 20 and schlupf.Case.from_file(path) == case


def test_arrays_that_vary_have_short_names(tmp_path):
    case = schlupf.Case(
        kinematics={"creepage_x": 0.002}, grid=COARSE, friction={"model": "constant"}
    )
    y = [-4e-3, 0.0, 4e-3]
    vary = {"friction.variation_file": [xr.DataArray([f, 1.0, f], {"y": y}) for f in (0.5, 0.8)]}
    names = ["friction.variation_file[0]", "friction.variation_file[1]"]
    study = schlupf.study(case, vary=vary)
    table = schlupf.sweep(study, tmp_path / "table.csv", warn=False).table
    assert table["friction_variation_file"].values.tolist() == names
    curve = case.curve(creepage_x=(0.0, 0.01), points=3, over=vary, warn=False)
    assert curve.points["friction_variation_file"].values.tolist() == names
    assert "variation_file[1]" in curve.summary() and "data:" not in curve.summary()


def test_points_below_the_surface_may_be_rows():
    rows = [[0.0, 0.0, 1e-3], [0.0, 0.0, 2e-3]]
    case = schlupf.Case(grid=COARSE)
    expected = case.subsurface(points=np.array(rows)).points
    columns = {"x": [0.0, 0.0], "y": 0.0, "depth": [1e-3, 2e-3]}
    for points in (rows, [tuple(row) for row in rows], columns):
        assert case.subsurface(points=points).points == expected


@pytest.mark.parametrize(
    ("points", "told"),
    [
        ([[0.0, 0.0, pint.Quantity(1, "mm")]], "points must be numbers, but is"),
        ({"x": [0.0, 0.0], "y": 0.0, "depth": [1e-3] * 3}, "must have columns of one length"),
        ({"x": [0.0, 1j], "y": 0.0, "depth": 1e-3}, "x of points must be real numbers"),
        ({"x": [0.0, None], "y": 0.0, "depth": 1e-3}, "x of points must be numbers, but has None"),
        (
            {"x": np.ma.masked_array([0.0, 1e-3], [0, 1]), "y": 0.0, "depth": 1e-3},
            "x must be a finite number",
        ),
    ],
)
def test_what_is_no_number_is_refused(points, told):
    with pytest.raises(schlupf.CaseError, match=told):
        schlupf.Case(grid=COARSE).subsurface(points=points)


@pytest.mark.filterwarnings("error::pint.UnitStrippedWarning")
def test_columns_are_quantities_and_durations():
    history = {"time": np.linspace(0, 2e-3, 5), "creepage_x": np.linspace(0, 2e-3, 5)}
    expected = solved(history=history)
    quantity = pint.Quantity(history["time"] * 1e3, "ms")
    for time in (quantity, pd.to_timedelta(history["time"], unit="s")):
        assert solved(history={"file": history | {"time": time}}) == expected
        assert solved(history=history | {"time": time}) == expected
    date = pd.to_datetime(["2026-01-01"] * 5)
    with pytest.raises(schlupf.CaseError, match="history.file must be real numbers, but is of"):
        solved(history={"file": history | {"time": date}})


def test_no_digit_is_lost():
    numbers = np.random.default_rng(1).standard_normal((50, 2)) * 1e-3
    text = data_url(numbers, [{"y": "m", "z": "m"}], "wheel.profile").partition(",")[2]
    rows = [[float(cell) for cell in row.split(",")[1:]] for row in text.splitlines()[1:]]
    assert np.array_equal(rows, numbers)


def test_the_row_of_a_data_frame_is_told_by_its_index():
    frame = pd.DataFrame({"time": [0.0, 1.0, 0.5]}, index=["start", "late", "early"])
    for table, row in ((frame, "early"), (frame.reset_index(drop=True), "2"), (frame + 0, "early")):
        with pytest.raises(schlupf.CaseError, match=f"history.file, row {row}: time must ascend"):
            schlupf.Case(history={"file": table})


@pytest.mark.parametrize(
    ("section", "value", "told"),
    [
        ("wheel", np.zeros((3, 3)), "the columns y (m), z (m), but is an array of shape (3, 3)"),
        ("wheel", {"x": [1.0], "y": [2.0]}, "has no column `z`"),
        ("wheel", xr.DataArray([1.0], dims="t"), "has no column `y`"),
        ("wheel", {"y": ["a"], "z": [1.0]}, 'y must be a finite number, but is "a"'),
        ("wheel", xr.DataArray([1.0], {"y": [0.0]}, attrs={"units": "mm"}), "must be in m"),
    ],
)
def test_what_is_no_table_is_refused(section, value, told):
    with pytest.raises(ValueError) as caught:
        schlupf.Case(
            normal={"model": "wheel-rail"}, rail={"profile": "60E1"}, wheel={"profile": value}
        )
    assert told in str(caught.value), str(caught.value)
