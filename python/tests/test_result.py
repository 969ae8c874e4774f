"""Results: scalars, data sets, files, warnings."""

import copy
import json
import pickle
import re
import warnings
from itertools import product

import numpy as np
import pytest
import xarray as xr

import schlupf


def test_scalars_are_those_of_the_json(result):
    document = json.loads(result.to_json())
    assert result.force.x == document["force"]["x"]
    assert result.to_dict() == document
    assert result.converged and result.status == "converged"
    assert "force" in dir(result) and list(result.force) == ["x", "y", "moment_z"]
    with pytest.raises(AttributeError, match="friction"):
        result.power.fricton
    with pytest.raises(AttributeError, match="not changed"):
        result.force.x = 0.0


def test_what_a_result_lacks_is_none(case, result):
    assert result.contacts is None and result.wheelset is None and result.wheel_force is None
    assert result.extrapolation is None and result.contact_law.fit is None
    assert "contacts" not in list(result) and "contacts" not in result.to_dict()
    with pytest.raises(KeyError, match="no result contacts"):
        result["contacts"]
    with pytest.raises(AttributeError, match="no result rms_hight; "):
        result.contact_law.rms_hight
    assert case.with_(contact_law={"model": "coulomb"}).solve().contact_law.stiffness is None
    assert case.with_(solver={"method": "polach"}).solve(warn=False).contact_law is None


def test_fields_add_up_to_the_forces(result):
    fields = result.fields
    assert fields["traction_x"].dims == ("y", "x")
    area = float(fields["x"].diff("x")[0] * fields["y"].diff("y")[0])
    for axis in "xy":
        total = float(fields[f"traction_{axis}"].sum() * area)
        assert total == pytest.approx(result.force[axis], rel=1e-9)
    assert float(fields["pressure"].sum() * area) == pytest.approx(result.normal.load, rel=1e-9)
    assert fields["pressure"].attrs["units"] == "Pa"
    assert fields["pressure"].attrs["long_name"] == "normal pressure"
    assert "Eqs. (8), (13)-(16)" in fields["traction_x"].attrs["source"]
    assert fields["x"].attrs["units"] == "m"
    assert int(fields["contact"].sum()) == result.work.cells
    assert bool(np.isnan(fields["pressure"].where(~fields["contact"])).all())


def test_files(result, tmp_path):
    result.to_netcdf(tmp_path / "result.nc", engine="h5netcdf")
    with xr.open_dataset(tmp_path / "result.nc", engine="h5netcdf") as read:
        np.testing.assert_array_equal(read["pressure"], result.fields["pressure"])
        assert json.loads(read.attrs["result"])["force"]["x"] == result.force.x
    frame = result.to_dataframe()
    assert len(frame) == result.work.cells and frame["pressure"].gt(0).all()
    result.to_csv(tmp_path / "cells.csv")
    assert (tmp_path / "cells.csv").read_text().splitlines()[1].startswith("x,y,pressure")
    result.to_vtk(tmp_path / "cells.vtk")
    assert (tmp_path / "cells.vtk").read_bytes().startswith(b"# vtk DataFile")
    result.to_json(tmp_path / "result.json")
    assert json.loads((tmp_path / "result.json").read_text())["force"]["x"] == result.force.x


def test_notebooks_show_a_summary_and_a_map(result):
    shown = result._repr_html_()
    assert "data:image/png;base64," in shown
    cells = re.findall(r"<td[^>]*>([^<]*)</td>", shown)
    row = cells[cells.index("longitudinal force") :]
    # Four digits are shown.
    assert float(row[1]) == float(f"{result.force.x / 1e3:.3e}") and row[2] == "kN"
    assert shown.count("<tr>") > 10
    assert "<table>" in polach_curve()._repr_html_()


def polach_curve():
    return schlupf.Case(solver={"method": "polach"}).curve(
        creepage_x=(0, 0.01), points=3, warn=False
    )


def test_results_can_be_pickled(result):
    for found in (result, polach_curve()):
        again = pickle.loads(pickle.dumps(found))
        assert type(again) is type(found) and again.to_json() == found.to_json()
        assert again.summary() == found.summary() and again.messages == found.messages
        # A second time as well.
        assert pickle.loads(pickle.dumps(again)).to_dict() == found.to_dict()
    again = pickle.loads(pickle.dumps(result))
    xr.testing.assert_identical(again.fields, result.fields)
    assert again.state == result.state
    curve = polach_curve()
    xr.testing.assert_identical(pickle.loads(pickle.dumps(curve)).points, curve.points)


def test_fields_over_time(case):
    history = {"time": [0.0, 2e-3], "creepage_x": [0.0, 0.004]}
    moving = case.with_(kinematics={"creepage_x": None}, history=history)
    result = moving.solve(fields_every=3)
    fields, table = result.field_history, result.history
    assert fields["traction_x"].dims == ("time", "y", "x")
    steps = fields["step"].values
    assert (np.diff(steps)[:-1] == 3).all() and steps[-1] == result.work.steps
    # Step 1 is the first of the table.
    np.testing.assert_array_equal(fields["time"], table["time"].values[steps - 1])
    area = float(fields["x"].diff("x")[0] * fields["y"].diff("y")[0])
    forces = fields["traction_x"].sum(("x", "y")) * area
    np.testing.assert_allclose(forces, table["force_x"].values[steps - 1], rtol=1e-9, atol=1e-6)
    xr.testing.assert_allclose(fields.isel(time=-1, drop=True), result.fields)
    with pytest.raises(ValueError, match="no fields over time"):
        _ = moving.solve().field_history
    with pytest.raises(ValueError, match="fields_every must not be negative"):
        moving.solve(fields_every=-1)


def test_a_history_is_over_time_and_can_be_carried_on(case):
    history = {"time": [0.0, 1e-3], "creepage_x": [0.0, 0.002]}
    result = case.with_(kinematics={"creepage_x": None}, history=history).solve()
    table = result.history
    assert table["time"].attrs["units"] == "s" and table.sizes["time"] > 10
    assert float(table["force_x"][-1]) == result.force.x
    assert table["newton_iterations"].dtype.kind == "i"
    further = case.with_(solver={"driver": "marching"}).solve(initial_state=result.state)
    assert further.force.x == pytest.approx(case.solve().force.x, rel=2e-3)
    with pytest.raises(ValueError, match="initial_state"):
        case.solve(initial_state=b"{}")


def test_what_does_not_converge_is_raised_with_its_result(case):
    hard = case.with_(solver={"max_iterations": 1, "driver": "steady"})
    with pytest.raises(schlupf.NotConverged) as caught:
        hard.solve()
    assert caught.value.result.status == "not-converged"
    with pytest.warns(schlupf.SchlupfWarning):
        assert not hard.solve(strict=False).converged


def test_a_warning_has_the_category_of_its_code():
    linear = schlupf.Case(solver={"method": "kalker-linear"}, kinematics={"creepage_x": 0.02})
    with pytest.warns(schlupf.SchlupfWarning) as caught:
        result = linear.solve()
    assert schlupf.warnings.BeyondFrictionWarning in {warning.category for warning in caught}
    codes = {warning.message.code for warning in caught}
    assert codes == {code for code, _, _ in result.messages}
    assert all(warning.filename == __file__ for warning in caught)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        linear.solve(warn=False)


def test_a_fast_method_has_no_fields():
    result = schlupf.Case(solver={"method": "polach"}).solve(warn=False)
    assert result.fields.sizes["x"] == 0
    assert result.temperature.max_rise is None and result.force.moment_z is None
    with pytest.raises(ValueError, match="polach"):
        result.plot.traction()
    assert "by the fast method" in result._repr_html_() and "<img" not in result._repr_html_()


def test_a_creep_curve(case):
    curve = case.curve(creepage_x=(0.0, 0.01), points=7)
    points = curve.points
    assert points.sizes["point"] == 7 and "creepage_x" in points.coords
    # Braking: the force opposes the creepage.
    assert (points["force_x"][1:] < 0).all()
    assert curve.varied == "creepage_x"
    assert set(points["status"].values) == {schlupf.Status.CONVERGED}
    with pytest.raises(schlupf.CaseError, match="creepage_x"):
        case.curve()
    with pytest.raises(schlupf.CaseError):
        case.curve(creepage_x=(0.0, 2.0))


def test_a_creep_curve_takes_what_does_not_vary_from_the_motion_of_the_wheel():
    coarse = {"cells_x": 12, "cells_y": 12}
    yawed = schlupf.Case(grid=coarse, kinematics={"yaw_angle": "2 mrad"})
    assert yawed.kinematics.creepage_y is None
    points = yawed.curve(creepage_x=(0.0, 0.002), points=3).points
    # η = −sin α, docs/conventions.md.
    assert float(points["creepage_y"][0]) == pytest.approx(-np.sin(2e-3), rel=1e-12)


@pytest.mark.filterwarnings("ignore:Consolidated metadata")
def test_fields_are_written_to_zarr(result, tmp_path):
    pytest.importorskip("zarr")
    result.to_zarr(tmp_path / "fields.zarr")
    read = xr.open_zarr(tmp_path / "fields.zarr")
    np.testing.assert_array_equal(read["pressure"], result.fields["pressure"])
    assert json.loads(read.attrs["result"])["force"]["x"] == result.force.x


@pytest.mark.filterwarnings("ignore:Consolidated metadata")
@pytest.mark.parametrize("suffix", ["nc", "zarr"])
def test_a_written_result_is_opened_again(tmp_path, suffix):
    case = schlupf.Case(
        grid={"cells_x": 8, "cells_y": 8},
        history={"time": [0.0, 1e-3, 2e-3], "creepage_x": [0.0, 0.002, 0.001]},
    )
    result = case.solve(fields_every=4, warn=False)
    path = tmp_path / f"new/result.{suffix}"
    encoding = {"pressure": {"_FillValue": -1.0}}
    if suffix == "nc":
        result.to_netcdf(path, encoding=encoding)
    else:
        result.to_zarr(path, encoding=encoding)
    again = schlupf.open_result(path)
    assert again == result and again.force.x == result.force.x and again.converged
    again.to_netcdf(tmp_path / "twice.nc")
    twice = schlupf.open_result(tmp_path / "twice.nc")
    copies = (pickle.loads(pickle.dumps(again)), copy.deepcopy(again), twice)
    for found, name in product((again, *copies), ("fields", "history", "field_history")):
        xr.testing.assert_identical(getattr(found, name), getattr(result, name))
    assert again.summary() == result.summary() and again.messages == result.messages
    assert again.state == result.state and again._repr_html_() == result._repr_html_()
    for written in (again.to_vtk, result.to_vtk):
        written(tmp_path / written.__self__.title)
    again.plot.history()
    assert all(found == result for found in copies)


def test_a_result_that_cannot_be_written_leaves_no_file(result, tmp_path):
    path = tmp_path / "result.nc"
    with pytest.raises(ValueError, match="group"):
        result.to_netcdf(path, engine="scipy")
    assert not list(tmp_path.iterdir())
    result.to_netcdf(path)
    with pytest.raises(ValueError, match="group"):
        result.to_netcdf(path, engine="scipy")
    assert schlupf.open_result(path) == result and list(tmp_path.iterdir()) == [path]


def test_what_is_no_result_is_told(tmp_path):
    with pytest.raises(FileNotFoundError) as caught:
        schlupf.open_result(tmp_path / "missing.nc")
    assert caught.value.filename == str(tmp_path / "missing.nc")
    xr.Dataset({"a": 1.0}).to_netcdf(tmp_path / "other.nc", engine="h5netcdf")
    (tmp_path / "table.csv").write_text("a,b")
    for name in ("other.nc", "table.csv", "."):
        with pytest.raises(ValueError, match="must be a result that schlupf has written"):
            schlupf.open_result(tmp_path / name)
