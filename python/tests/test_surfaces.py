"""Surfaces of instruments: what other packages read is a surface as any other."""

import re

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import schlupf

surfalize = pytest.importorskip("surfalize")
SurfaceTopography = pytest.importorskip("SurfaceTopography")

OPTIONS = {"pressure": [0.4e9, 0.8e9], "warn": False}


@pytest.fixture(scope="module")
def heights():
    """Heights (m) with a tilt, rows along x, 1 µm apart."""
    rng = np.random.default_rng(7)
    spectrum = np.fft.rfft2(rng.standard_normal((48, 64)))
    waves = np.hypot(np.fft.fftfreq(48)[:, None], np.fft.rfftfreq(64))
    rough = np.fft.irfft2(spectrum / (0.05 + waves) ** 1.8, (48, 64))
    rough *= 0.5e-6 / rough.std()
    x, y = np.arange(64) * 1e-6, np.arange(48) * 1e-6
    return rough + 0.02 * x - 0.01 * y[:, None]


@pytest.fixture(scope="module")
def expected(heights):
    return schlupf.roughness(heights, spacing=1e-6, **OPTIONS)


def alike(found, expected, tolerance):
    assert found.contact_law.stiffness == pytest.approx(expected.contact_law.stiffness, tolerance)
    assert found.surface.spacing_x == pytest.approx(1e-6, rel=1e-6)
    assert found.surface.columns == 64 and found.surface.rows == 48


def test_a_tilt_is_removed(heights, expected):
    assert expected.surface.root_mean_square_height == pytest.approx(0.5e-6, rel=0.2)
    assert heights.std() > 0.6e-6
    (remark,) = expected.remarks
    assert re.fullmatch(r"surface: a tilt of 1\.\d+ deg was removed", remark)
    plane = np.stack([np.ones(heights.shape), *np.indices(heights.shape)], -1).reshape(-1, 3)
    level = heights - (plane @ np.linalg.lstsq(plane, heights.ravel())[0]).reshape(heights.shape)
    assert not schlupf.roughness(level, spacing=1e-6, **OPTIONS).remarks


# In single precision, or in steps of the range of heights.
@pytest.mark.parametrize(("ending", "tolerance"), [("sur", 1e-3), ("al3d", 1e-3), ("sdf", 1e-9)])
def test_files_of_instruments_are_surfaces(tmp_path, heights, expected, ending, tolerance):
    path = tmp_path / f"rail.{ending}"
    surfalize.Surface(heights * 1e6, 1.0, 1.0).save(path)
    alike(schlupf.roughness(path, **OPTIONS), expected, tolerance)
    opened = schlupf.open_surface(path)
    assert opened.dims == ("y", "x") and opened.attrs["units"] == "m"
    np.testing.assert_allclose(opened, heights, atol=1e-5 * np.ptp(heights))
    roughness = {"file": path, "pressures": OPTIONS["pressure"]}
    of_file = schlupf.Case(contact_law={"roughness": roughness})
    of_array = schlupf.Case(contact_law={"roughness": {**roughness, "file": opened}})
    assert of_file == of_array
    elsewhere = schlupf.Case.from_toml("", tmp_path)
    assert elsewhere.with_(contact_law={"roughness": {**roughness, "file": path.name}}) == of_file
    alike(elsewhere.roughness(surface=path.name, **OPTIONS), expected, tolerance)


def test_objects_of_other_packages_are_surfaces(heights, expected):
    surface = surfalize.Surface(heights * 1e6, 1.0, 1.0)
    alike(schlupf.roughness(surface, **OPTIONS), expected, 1e-9)
    sizes = {"physical_sizes": (64.0, 48.0), "unit": "µm"}
    topography = SurfaceTopography.Topography(heights.T * 1e6, **sizes)
    alike(schlupf.roughness(topography, **OPTIONS), expected, 1e-9)
    line = SurfaceTopography.UniformLineScan(heights[0] * 1e6, 64.0, unit="µm")
    array = xr.DataArray(heights[0], {"x": np.arange(64) * 1e-6})
    of_line, of_array = (schlupf.roughness(each, seed=3, **OPTIONS) for each in (line, array))
    assert of_line.contact_law.stiffness == pytest.approx(of_array.contact_law.stiffness, 1e-6)


def test_octave_bands_are_a_surface_in_whatever_form(tmp_path):
    """Levels of bands as a file, a mapping, a data frame, and over their wavelengths."""
    wavelength, level = [16e-6, 20e-6, 25e-6, 31.5e-6], [-14.0, -12.0, -10.0, -8.0]
    (tmp_path / "rail.csv").write_text(
        "wavelength [mm],level [dB]\n"
        + "".join(f"{1e3 * w},{v}\n" for w, v in zip(wavelength, level, strict=True))
    )
    table = {"wavelength": wavelength, "level": level}
    over = xr.DataArray(level, {"wavelength": wavelength}, name="level")
    frame = pd.DataFrame({"wavelength [mm]": [1e3 * w for w in wavelength], "level [dB]": level})
    kept = [
        schlupf.roughness(each, cells=64, **OPTIONS)
        for each in (tmp_path / "rail.csv", table, pd.DataFrame(table), frame, over)
    ]
    for found in kept:
        assert "from a spectrum of waves from 0.014" in found.remarks[0]
        assert found.contact_law.stiffness == pytest.approx(kept[0].contact_law.stiffness, 1e-9)
    case = schlupf.Case(contact_law={"roughness": {"file": table, "cells": 64}})
    assert case.contact_law.stiffness is None
    with pytest.raises(schlupf.CaseError, match="centres of one-third octave bands"):
        schlupf.roughness({"wavelength": [9e-3], "level": [0.0]})


def test_units_of_arrays_of_heights_count(heights, expected):
    axes = {"y": np.arange(48) * 1e-6, "x": np.arange(64) * 1e-6}
    micrometres = xr.DataArray(heights * 1e6, axes, attrs={"units": "um"})
    with pytest.raises(schlupf.CaseError, match="surface must be in m, but its attribute `units`"):
        schlupf.roughness(micrometres, **OPTIONS)
    pint = pytest.importorskip("pint")
    quantity = pint.UnitRegistry().Quantity(heights * 1e6, "um")
    alike(schlupf.roughness(quantity, spacing=1e-6, **OPTIONS), expected, 1e-9)
    metres = xr.DataArray(heights, axes, attrs={"units": "m"})
    for surface in (quantity, surfalize.Surface(heights * 1e6, 1.0, 1.0), metres):
        with pytest.raises(schlupf.CaseError, match="unit must be left out, because surface has"):
            schlupf.roughness(surface, unit="um", spacing=1e-6, **OPTIONS)
    with pytest.raises(schlupf.CaseError, match="spacing must be left out, because surface has"):
        schlupf.roughness(metres, spacing=2e-6, **OPTIONS)


def test_a_map_has_its_own_places_or_a_spacing(heights, expected):
    plain = xr.DataArray(heights, dims=("y", "x"))
    for same in (plain, plain.T, plain.to_dataset(name="height")):
        alike(schlupf.roughness(same, spacing=1e-6, **OPTIONS), expected, 1e-9)
        with pytest.raises(schlupf.CaseError, match="spacing must be given"):
            schlupf.roughness(same, **OPTIONS)
    for other in (
        plain.rename(x="column"),
        plain.assign_coords(x=np.arange(64) * 1e-6),
        plain.expand_dims(t=1),
    ):
        with pytest.raises(schlupf.CaseError, match="must have the dimensions y and x"):
            schlupf.roughness(other, spacing=1e-6, **OPTIONS)
    for wrong in (heights > 0, heights + 0j, heights.astype("timedelta64[s]")):
        with pytest.raises(schlupf.CaseError, match="surface must be (real )?numbers, but is"):
            schlupf.roughness(wrong, spacing=1e-6, **OPTIONS)


def test_bands_of_long_waves_are_no_roughness():
    wavelength = [4e-3, 5e-3, 6.3e-3, 8e-3, 10e-3]
    with pytest.raises(schlupf.CaseError, match="^surface: .*lacks waves shorter than .* mm"):
        schlupf.roughness({"wavelength": wavelength, "level": [-20.0] * 5}, cells=64)


def test_holes_units_and_cells_are_checked_as_in_files_of_the_library(tmp_path, heights):
    holed = heights.copy()
    holed[3, 4:7] = np.nan
    path = tmp_path / "holes.sur"
    surfalize.Surface(holed * 1e6, 1.0, 1.0).save(path)
    mask = np.isnan(holed).T
    masked = SurfaceTopography.Topography(
        np.ma.masked_array(heights.T * 1e6, mask), (64.0, 48.0), unit="µm"
    )
    for surface in (path, masked):
        with pytest.raises(schlupf.CaseError, match="3 of 3072 are missing, the first in row 3, c"):
            schlupf.roughness(surface, **OPTIONS)
        filled = schlupf.roughness(surface, fill_holes=True, **OPTIONS)
        assert any("had no height and were filled" in remark for remark in filled.remarks)
    without_unit = SurfaceTopography.Topography(heights.T, (64.0, 48.0))
    with pytest.raises(schlupf.CaseError, match="surface must have a unit of length"):
        schlupf.roughness(without_unit)
    in_wrong_unit = SurfaceTopography.Topography(heights.T * 1e9, (64.0, 48.0), unit="m")
    with pytest.raises(schlupf.CaseError, match="must have heights of at most 1 m"):
        schlupf.roughness(in_wrong_unit)
    oblong = SurfaceTopography.Topography(heights.T * 1e6, (64.0, 96.0), unit="µm")
    with pytest.raises(schlupf.CaseError, match="must have square cells, but they are 1 µm by 2"):
        schlupf.roughness(oblong)


def test_what_nobody_reads_is_told(tmp_path):
    (tmp_path / "no.sur").write_bytes(b"nothing")
    with pytest.raises(ValueError, match="must be a file of a surface, but is not: surfalize"):
        schlupf.open_surface(tmp_path / "no.sur")
    with pytest.raises(FileNotFoundError) as caught:
        schlupf.roughness(tmp_path / "missing.sur")
    assert caught.value.errno == 2 and caught.value.filename == str(tmp_path / "missing.sur")
