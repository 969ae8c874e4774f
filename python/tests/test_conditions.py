"""A condition is the field of the case with that name, and nothing else, on every face.

Goal: `schlupf.forces`, `schlupf.Solver(case).solve`, `case.curve` and `schlupf.sweep` give what
``case.with_(…).solve()`` gives, for every source of the pressure and every condition.
"""

import numpy as np
import pytest

import schlupf

TOLERANCE = 2e-4

COARSE = {"cells_x": 12, "cells_y": 12}
COULOMB = {"model": "coulomb"}
CONSTANT = {"model": "constant", "coefficient": 0.35}


def wheel_on_rail(**fields):
    """The right wheel of the gallery, on coarse cells."""
    case = schlupf.examples.wheel_on_rail.with_(grid=COARSE, normal={"cells": 32})
    return case.with_(**fields) if fields else case


def roughness():
    """A law whose stiffness follows from the largest pressure."""
    spectrum = {"longest_wavelength": "1 mm", "shortest_wavelength": "50 um"}
    fields = {"rms_height": "1 um", "cells": 64, **spectrum}
    return schlupf.Case(grid=COARSE, contact_law={"roughness": fields})


CASES = {
    "hertz": schlupf.Case(grid=COARSE),
    "hertz, angular velocity": schlupf.Case(
        grid=COARSE, kinematics={"angular_velocity": 65.0, "yaw_angle": 0.002}
    ),
    "hertz, Kalker's bed": schlupf.Case(
        grid=COARSE, elasticity={"model": "winkler"}, contact_law=COULOMB, friction=CONSTANT
    ),
    "hertz, force": schlupf.Case(
        grid=COARSE, kinematics={"force_x": -1e4}, contact_law=COULOMB, friction=CONSTANT
    ),
    "hertz, roughness": roughness(),
    "hertz, fastsim": schlupf.Case(grid=COARSE, solver={"method": "fastsim"}, friction=CONSTANT),
    "hertz, modified fastsim": schlupf.Case(
        grid=COARSE, solver={"method": "modified-fastsim"}, friction=CONSTANT
    ),
    "ellipse": schlupf.Case(
        grid=COARSE,
        normal={"model": "ellipse", "semi_axis_x": 6e-3, "semi_axis_y": 5e-3, "load": 80e3},
    ),
    "ellipse, peak pressure": schlupf.Case(
        grid=COARSE,
        normal={"model": "ellipse", "semi_axis_x": 6e-3, "semi_axis_y": 5e-3, "peak_pressure": 1e9},
    ),
    "tabulated": schlupf.examples.pressure_table.with_(grid=COARSE),
    "tabulated, polach": schlupf.examples.pressure_table.with_(
        solver={"method": "polach"}, friction=CONSTANT, grid=None
    ),
    "profile": schlupf.examples.worn_profile.with_(grid=COARSE, normal={"cells": 32}),
    "wheel-rail": wheel_on_rail(),
    "wheel-rail, force": wheel_on_rail(kinematics={"angular_velocity": None, "force_x": -5e3}),
    "wheel-rail, flange": wheel_on_rail(
        wheelset={"lateral_position": -6.5e-3},
        kinematics={"angular_velocity": None, "creepage_x": 0.001},
    ),
}

CONDITIONS = {
    "creepage_x": ("kinematics.creepage_x", [0.001, 0.002]),
    "creepage_y": ("kinematics.creepage_y", [0.0, -0.0015]),
    "spin": ("kinematics.spin", [0.0, 0.3]),
    "speed": ("kinematics.speed", [20.0, 30.0]),
    "load": ("normal.load", [60e3, 100e3]),
    "normal__load": ("normal.load", [60e3, 100e3]),
    "friction__coefficient": ("friction.coefficient", [0.2, 0.3]),
    "wheelset__lateral_position": ("wheelset.lateral_position", [2e-3, 6e-3]),
}

OF_WHEEL = "wheelset__lateral_position"


def alone(case, path, value):
    """The state of the case with that field, or why there is none."""
    section, name = path.split(".")
    try:
        return case.with_(**{section: {name: value}}).solve(warn=False, strict=False)
    except schlupf.CaseError as error:
        return error


def near(found, expected, scale):
    assert found == pytest.approx(expected, abs=TOLERANCE * scale), (found, expected)


@pytest.mark.parametrize("condition", CONDITIONS)
@pytest.mark.parametrize("name", CASES)
def test_every_face_gives_the_state_of_the_case_with_that_field(name, condition, tmp_path):
    case = CASES[name]
    is_of_wheel = name.startswith("wheel-rail")
    if condition == OF_WHEEL and not is_of_wheel:
        pytest.skip("the field has no effect")
    path, values = CONDITIONS[condition]
    expected = [alone(case, path, value) for value in values]
    if any(isinstance(one, schlupf.CaseError) for one in expected):
        with pytest.raises(schlupf.CaseError, match=expected[0].field.replace(".", r"\.")):
            schlupf.forces(case, warn=False, **{condition: values})
        with pytest.raises(schlupf.CaseError, match=expected[0].field.replace(".", r"\.")):
            schlupf.Solver(case).solve(**{condition: values[0]})
        return
    scale = [result.normal.load for result in expected]
    table = schlupf.forces(case, warn=False, **{condition: values})
    solver = schlupf.Solver(case)
    swept = sweep(case, path, values, tmp_path)
    for k, (value, result, load) in enumerate(zip(values, expected, scale, strict=True)):
        near(float(table["force_x"][k]), result.force.x, load)
        near(float(table["force_y"][k]), result.force.y, load)
        found = solver.solve(**{condition: value}, warn=False)
        near(found.force.x, result.force.x, load)
        near(found.normal.load, load, load)
        near(float(swept["force_x"][k]), result.force.x, load)
        own = "result_normal_load" if path == "normal.load" else "normal_load"
        near(float(swept[own][k]), load, load)
        if not is_of_wheel:
            continue
        for axis in "xyz":
            force = getattr(result.wheel_force, axis)
            near(float(table[f"wheel_force_{axis}"][k]), force, load)
            near(getattr(found.wheel_force, axis), force, load)
            near(float(swept[f"wheel_force_{axis}"][k]), force, load)
        for place, contact in enumerate(result.contacts[:3]):
            of = table.isel({table["force_x"].dims[0]: k, "contact": place})
            near(float(of["contact_rolling_radius"]), contact.rolling_radius, 1e-3)
            near(float(of["contact_position_y"]), contact.position.y, 1e-3)
            near(float(of["contact_force_y"]), contact.force.y, load)
            near(float(swept[f"contact_{place + 1}_angle"][k]), contact.angle, 1.0)
            near(float(swept[f"contact_{place + 1}_normal_load"][k]), contact.normal.load, load)


def sweep(case, path, values, folder):
    """The same states as a table."""
    (folder / "case.toml").write_text(case.to_toml(folder=folder))
    (folder / "states.csv").write_text(f"{header(path)}\n" + "\n".join(map(repr, values)) + "\n")
    study = folder / "study.toml"
    study.write_text('case = "case.toml"\n[states]\nfile = "states.csv"\n')
    return schlupf.sweep(study, folder / "table.parquet", warn=False).table


def header(path):
    units = {"kinematics.speed": "m/s", "kinematics.spin": "1/m", "normal.load": "N"}
    unit = "m" if path.startswith("wheelset") else units.get(path)
    return f"{path} [{unit}]" if unit else path


@pytest.mark.parametrize("name", ["hertz", "ellipse", "tabulated", "profile", "wheel-rail"])
def test_a_curve_is_made_of_states_of_the_case(name):
    case = CASES[name].with_(kinematics={"angular_velocity": None})
    points = case.curve(creepage_x=(0.001, 0.003), points=3, spacing="even", warn=False).points
    for creepage, force in zip((0.001, 0.002, 0.003), points["force_x"].values, strict=True):
        result = alone(case, "kinematics.creepage_x", creepage)
        own = result.wheel_force.x if name == "wheel-rail" else result.force.x
        near(float(force), own, result.normal.load)


def test_a_curve_of_a_wheel_varies_how_it_turns():
    with pytest.raises(ValueError, match="creepage_y must be left out"):
        CASES["wheel-rail"].curve(creepage_y=(0.0, 0.001))


@pytest.mark.parametrize("name", ["hertz", "ellipse", "tabulated"])
def test_the_derivative_by_the_load_is_that_of_the_field(name):
    """Central difference of states with other loads, and the derivative of the state."""
    case = CASES[name].with_(
        kinematics={"creepage_x": 0.001}, solver={"sensitivity": True, "tolerance": 1e-9}
    )
    load = case.solve(warn=False).normal.load
    less, more = (
        case.with_(normal={"load": load * (1 + step)}).solve(warn=False).force.x
        for step in (-1e-3, 1e-3)
    )
    expected = (more - less) / (2e-3 * load)
    for result in (case.solve(warn=False), schlupf.Solver(case).solve(warn=False)):
        assert result.sensitivity.load.x == pytest.approx(expected, rel=0.01)


def test_a_history_of_the_load_means_the_same():
    """An ellipse keeps its axes, whoever changes its load."""
    case = CASES["ellipse"].with_(kinematics={"creepage_x": 0.002})
    over_time = case.with_(
        history={"time": [0.0, 0.1], "load": [60e3, 60e3]}, solver={"driver": "marching"}
    )
    expected = case.with_(normal={"load": 60e3}).solve(warn=False)
    found = over_time.solve(warn=False)
    assert found.normal.semi_axis_x == expected.normal.semi_axis_x
    near(found.force.x, expected.force.x, 5 * expected.normal.load)


@pytest.mark.filterwarnings("ignore")
def test_rows_that_fail_are_rows():
    """Not a number, a wheel that lifts, and one that is locked, among many conditions."""
    case = schlupf.Case(solver={"method": "polach"}, friction=CONSTANT)
    creepage = np.full(1000, 0.002)
    load = np.full(1000, 80e3)
    creepage[3], creepage[5] = np.nan, 1.5
    load[7], load[8], load[9] = 0.0, np.nan, -1.0
    with pytest.warns(UserWarning, match="4 of 1000 conditions"):
        table = schlupf.forces(case, creepage_x=creepage, load=load)
    status = table["status"].values
    assert [int(status[k]) for k in (3, 5, 7, 8, 9)] == [3, 3, 2, 3, 3]
    assert (np.delete(status, [3, 5, 7, 8, 9]) == 0).all()
    force = table["force_x"].values
    assert force[7] == 0.0 and np.isnan(force[[3, 5, 8, 9]]).all()
    assert np.isfinite(np.delete(force, [3, 5, 8, 9])).all()
    assert table["status"].attrs["flag_meanings"] == "converged not-converged no-contact failed"
    with pytest.raises(schlupf.CaseError, match="condition 3"):
        schlupf.forces(case, strict=True, creepage_x=creepage, load=load)


def test_coordinates_are_those_of_their_own_dimensions():
    """Data arrays and arrays together: each keeps the dimension along which it was given."""
    import xarray as xr

    case = schlupf.Case(solver={"method": "polach"}, friction=CONSTANT)
    named = xr.DataArray([0.001, 0.002, 0.003], dims="xi")
    for order in (("creepage_x", "load"), ("load", "creepage_x")):
        given = {"creepage_x": named, "load": np.array([60e3, 70e3, 80e3])}
        table = schlupf.forces(case, warn=False, **{name: given[name] for name in order})
        assert table["creepage_x"].dims == ("xi",) and table["normal_load"].dims == ("normal_load",)
        np.testing.assert_array_equal(table["normal_load"], [60e3, 70e3, 80e3])
        one = schlupf.forces(case, warn=False, creepage_x=0.002, load=80e3)
        assert float(table["force_x"].isel(xi=1, normal_load=2)) == float(one["force_x"])


def test_memory_does_not_grow_with_the_values_of_a_field():
    """Each value is a case of its own, but not all of them are kept: 13 kB each were."""
    resource = pytest.importorskip("resource")
    case = schlupf.Case(solver={"method": "polach"}, friction=CONSTANT)
    used = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # noqa: E731
    values = np.linspace(0.2, 0.5, 20_000)
    schlupf.forces(case, creepage_x=0.002, friction__coefficient=values[:100])
    before = used()
    table = schlupf.forces(case, creepage_x=0.002, friction__coefficient=values)
    assert used() - before < 60_000
    one = case.with_(friction={"coefficient": 0.5}, kinematics={"creepage_x": 0.002})
    assert float(table["force_x"][-1]) == pytest.approx(one.solve(warn=False).force.x, rel=1e-12)


def test_the_wheel_of_the_gallery_under_other_conditions():
    """Forces that acted on the largest contact: load, flange and creepage (in N)."""
    wheel = schlupf.examples.wheel_on_rail
    heavy = schlupf.forces(wheel, load=120e3, warn=False)
    assert float(heavy["force_x"]) == pytest.approx(-9130, rel=0.02)
    flange = schlupf.forces(wheel, load=120e3, wheelset__lateral_position=-6.5e-3, warn=False)
    alone = wheel.with_(normal={"load": 120e3}, wheelset={"lateral_position": -6.5e-3})
    assert float(flange["force_x"]) == pytest.approx(alone.solve(warn=False).force.x, rel=1e-3)
    rolling = wheel.with_(kinematics={"angular_velocity": None})
    braking = schlupf.forces(rolling, creepage_x=0.002, warn=False)
    assert float(braking["force_x"]) == pytest.approx(-19701, rel=0.02)


def test_two_conditions_at_once(case):
    """One that a solver takes and one that makes another case."""
    loads, frictions = [60e3, 100e3], [0.2, 0.4]
    found = schlupf.forces(case, load=np.array(loads)[:, None], friction__coefficient=frictions)
    for i, load in enumerate(loads):
        for k, friction in enumerate(frictions):
            alone = case.with_(normal={"load": load}, friction={"coefficient": friction})
            near(float(found["force_x"][i, k]), alone.solve(warn=False).force.x, load)
