"""What a case can be asked besides its solution."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pint
import pytest
import xarray as xr

import schlupf

GRID = {"cells_x": 10, "cells_y": 10}
SMALL = schlupf.Case(grid=GRID)
ROUGH = {
    "rms_height": "1 um",
    "hurst": 0.8,
    "longest_wavelength": "100 um",
    "shortest_wavelength": "30 um",
    "cells": 64,
    "pressures": ["400 MPa", "800 MPa"],
}


def test_a_family_of_creep_curves_has_its_values_in_si_units():
    speeds = ["36 km/h", 20.0]
    curves = SMALL.curve(creepage_x=(0.0, 0.01), over={"kinematics.speed": speeds}, points=4)
    points = curves.points
    assert points["force_x"].dims == ("speed", "point") and points["force_x"].shape == (2, 4)
    np.testing.assert_allclose(points["speed"], [10.0, 20.0], rtol=1e-12)
    assert points["speed"].attrs["field"] == "kinematics.speed"
    alone = SMALL.with_(kinematics={"speed": 20.0}).curve(creepage_x=(0.0, 0.01), points=4)
    np.testing.assert_allclose(points["force_x"][1], alone.points["force_x"], rtol=1e-6)
    labels = [text.get_text() for text in curves.plot().get_legend().get_texts()]
    assert labels == ["$F_x$, 10 m/s", "$F_x$, 20 m/s"]


def test_a_family_of_methods_has_names():
    curves = SMALL.curve(
        creepage_x=(0.0, 0.01), points=3, over={"solver.method": ["full", "fastsim"]}, warn=False
    )
    assert curves.points["solver_method"].values.tolist() == ["full", "fastsim"]


def test_ranges_and_lengths_have_units():
    one = SMALL.curve(spin=("0 1/m", "1 1/m"), points=3).points
    np.testing.assert_array_equal(one["spin"], SMALL.curve(spin=(0, 1), points=3).points["spin"])
    hot = SMALL.with_(kinematics={"creepage_x": 0.02})
    places = [
        hot.temperature(x=x, wake=wake).rows["x"] for x, wake in (("-1 mm", "5 mm"), (-1e-3, 5e-3))
    ]
    np.testing.assert_array_equal(*places)
    with pytest.raises(schlupf.CaseError, match="x must be a length with its unit"):
        hot.temperature(x="1 kN")


def test_the_total_creepage_varies_in_a_direction():
    curve = SMALL.curve(creepage=(0.0, 0.01), direction="90 deg", points=3)
    np.testing.assert_allclose(curve.points["creepage_y"][-1], 0.01, rtol=1e-12)
    assert curve.varied == "creepage_y"
    same = SMALL.curve(creepage=(0.0, 0.01), direction=np.pi / 2, points=3)
    np.testing.assert_allclose(same.points["force_y"], curve.points["force_y"], rtol=1e-9)


@pytest.mark.parametrize(
    ("arguments", "error", "part"),
    [
        ({}, schlupf.CaseError, "one of creepage_x, .* or moment_z must be given"),
        ({"creepage": (0, 0.1)}, ValueError, "must be given together with direction"),
        ({"creepage_x": (0, 0.1), "points": 1}, ValueError, "must be a whole number between 2 and"),
        ({"creepage_x": (0.1, 0.1)}, ValueError, "must differ from its start"),
        ({"creepage_x": 0.1}, schlupf.CaseError, "creepage_x must be"),
        ({"creepage_x": (0, 0.1), "points": -1}, ValueError, "points must be a whole number"),
        ({"creepage_x": (0, 0.1), "over": {"kinematics.sped": [1]}}, KeyError, "sped"),
        (
            {"creepage_x": (0, 0.1), "over": {"kinematics.creepage_x": [0.1]}},
            ValueError,
            "over must not vary kinematics.creepage_x, in place of which creepage_x varies",
        ),
        (
            {"creepage_x": (0, 0.1), "over": {"normal.load": ["1 m"]}},
            schlupf.CaseError,
            "normal.load must be a force",
        ),
        ({"creepage_y": (0, 2.0)}, ValueError, "creepage_y"),
        (
            {"force_x": (0, 1.0), "spin": (0, 1.0)},
            ValueError,
            "force_x must not be given together with spin",
        ),
        (
            {"force_x": (0, 1.0), "force_y": (0, 1.0)},
            ValueError,
            "force_x must not be given together with force_y",
        ),
        ({"force_x": (0, "-20 m")}, schlupf.CaseError, "force_x .* must be a force"),
        ({"force_y": (0, "-90 kN")}, schlupf.CaseError, "force_y cannot be"),
    ],
)
def test_wrong_curves_are_refused(arguments, error, part):
    with pytest.raises(error, match=part):
        SMALL.curve(**arguments)


def test_temperatures_below_the_surface_and_in_the_wake():
    case = SMALL.with_(kinematics={"creepage_x": 0.01})
    found = case.temperature(depth=(0.0, 1e-3), points=11)
    of_array = case.temperature(depth=np.linspace(0.0, 1e-3, 11))
    xr.testing.assert_allclose(of_array.profile, found.profile, rtol=1e-12)
    assert found.profile.sizes["depth"] == 11
    surface = found.rows.isel(depth=0)
    hottest = case.solve().temperature.max_wheel
    assert float(found.profile["temperature_wheel"][0]) == pytest.approx(hottest, abs=2.0)
    assert float(found.rows["depth"][0]) == 0.0
    ax = found.plot()
    np.testing.assert_allclose(ax.lines[0].get_ydata(), surface["temperature_wheel"])
    with pytest.raises(ValueError, match="y must lie in the contact"):
        case.temperature(y=0.1)
    wrong = [{"depth": (0, -1)}, {"wake": np.inf}, {"wake": -1.0}, {"depth": (0, 1e9)}, {"x": "a"}]
    for arguments in wrong:
        (name,) = arguments
        with pytest.raises(schlupf.CaseError, match=f"{name} .* must be"):
            case.temperature(**arguments)


def test_the_contact_alone_has_its_cells():
    """Hertz 1882: the largest pressure is 3/2 of the mean; so it is for such a function."""
    found = SMALL.patch()
    assert type(found) is schlupf.Report
    (contact,) = found.contacts
    assert contact.normal.peak_pressure == pytest.approx(1.5 * contact.mean_pressure)
    (cells,) = found.tables["cells"]
    assert cells["pressure"].attrs["units"] == "Pa" and cells.sizes["row"] == contact.cells
    area = 4.0 * contact.normal.semi_axis_x * contact.normal.semi_axis_y / 100.0
    assert float(cells["pressure"].sum()) * area == pytest.approx(contact.normal.load)
    assert float(cells["covered"].sum()) * area == pytest.approx(contact.area)
    assert "pressure_across" in found.drawings()

    def pressure(x, y):
        return 1e9 * np.sqrt(np.maximum(0.0, 1.0 - (x / 6e-3) ** 2 - (y / 4e-3) ** 2))

    extent = ((-6e-3, 6e-3), (-4e-3, 4e-3))
    (contact,) = SMALL.with_laws(pressure=pressure, extent=extent).patch(warn=False).contacts
    assert contact.area == pytest.approx(np.pi * 24e-6, rel=0.01)
    assert contact.mean_pressure == pytest.approx(1e9 / 1.5, rel=0.01)


def test_the_bulk_temperature_needs_cooling():
    case = SMALL.with_(kinematics={"creepage_x": 0.002})
    with pytest.raises(schlupf.CaseError, match="cooling.film_coefficient is missing"):
        case.bulk_temperature()
    cooled = case.with_(cooling={"film_coefficient": "40 W/(m^2 K)", "area": "1.5 m^2"})
    found = cooled.bulk_temperature()
    assert found.converged and found.temperature.wheel > 20.0


def test_a_comparison_has_a_row_for_each_method():
    case = SMALL.with_(kinematics={"creepage_x": 0.001})
    comparison = case.compare(warn=False)
    table = comparison.methods
    assert {"FASTSIM", "Polach"} <= set(table["model"].values.tolist())
    alone = case.with_(solver={"method": "polach"}).solve(warn=False)
    polach = table["force_x"].sel(model="Polach").item()
    assert polach == pytest.approx(alone.force.x, rel=1e-9)
    assert len(comparison.plot().get_yticks()) == table.sizes["model"]


def test_a_calibration_of_the_layer():
    found = SMALL.calibrate(cells=10)
    assert found.converged
    assert "bedding_x" in found.summary()
    with pytest.raises(ValueError, match="cells must be a whole number between 10 and 80"):
        SMALL.calibrate(cells=5)


def test_a_calibration_makes_a_case():
    found = SMALL.calibrate()
    layer = found.case.elasticity
    assert layer.model == "elastic-layer"
    assert layer.bedding_x == pytest.approx(found.table.x.bedding, rel=1e-3)
    assert found.case.kinematics.given() == SMALL.kinematics.given()


def test_a_fit_that_does_not_converge_is_raised_with_its_result():
    model = SMALL.with_(heat={"model": "none"}, friction={"model": "constant"})
    truth = model.with_(friction={"coefficient": 0.31}, contact_law={"stiffness": 3e6})
    creepage = np.array([0.001, 0.002, 0.004, 0.006, 0.01])
    measured = -schlupf.forces(truth, creepage_x=creepage)["force_x"].values / 80e3
    data = {"creepage_x": creepage, "force_ratio": measured, "load": 80e3}
    parameters = ["friction.coefficient", "contact_law.stiffness"]
    with pytest.raises(schlupf.NotConverged) as caught:
        model.fit(parameters, data, max_steps=2)
    assert isinstance(caught.value.result, schlupf.Fit)
    found = model.fit(parameters, data, max_steps=2, strict=False, warn=False)
    assert not found.converged
    assert found.case.friction.coefficient == pytest.approx(0.31, rel=0.05)


def test_a_fit_finds_the_friction_that_made_the_data():
    creepage = np.array([0.001, 0.002, 0.004, 0.006, 0.01])
    model = SMALL.with_(heat={"model": "none"}, friction={"model": "constant"})
    truth = model.with_(friction={"coefficient": 0.31})
    measured = -schlupf.forces(truth, creepage_x=creepage)["force_x"].values / 80e3
    data = {"creepage_x": creepage, "force_ratio": measured, "load": 80e3}
    found = model.fit("friction.coefficient", data, warn=False)
    assert found.converged
    assert found.case.friction.coefficient == pytest.approx(0.31, rel=1e-4)
    np.testing.assert_allclose(found.points["fitted"], measured, atol=1e-4)
    assert len(found.plot().lines) == 2
    # A line for each speed.
    both = {name: np.concatenate([creepage, creepage]) for name in ("creepage_x",)}
    both |= {"force_ratio": np.concatenate([measured, measured])}
    both |= {"speed": np.repeat([20.0, 30.0], creepage.size)}
    assert len(model.fit("friction.coefficient", both, warn=False).plot().lines) == 4
    with pytest.raises(schlupf.CaseError, match="did you mean `friction.coefficient`"):
        model.fit("friction.coeficient", data)
    with pytest.raises(schlupf.CaseError, match="creepge_x"):
        model.fit("friction.coefficient", {"creepge_x": creepage, "force_ratio": measured})


def test_a_rough_contact():
    case = SMALL.with_(contact_law={"roughness": ROUGH})
    found = case.roughness(warn=False)
    assert found.fields["height"].dims == ("y", "x") and "pressure" in found.fields
    mean = float(found.fields["pressure"].mean())
    assert mean == pytest.approx(800e6, rel=1e-3)
    assert len(found.curves) == 2
    heights = found.fields["height"]
    assert float(heights.std()) == pytest.approx(1e-6, rel=0.05)
    for plot in ("spectrum", "surface", "spots", "curves"):
        getattr(found.plot, plot)()
        plt.close("all")
    with pytest.raises(ValueError, match="there is no surface: name one with surface"):
        SMALL.roughness()


def test_numbers_and_quantities_stand_for_text_with_units():
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    surface = ["rms_height=1 um", "longest=100 um", "shortest=30 um"]
    arguments = {"synthetic": surface, "cells": 64, "friction": 0.3, "warn": False}
    pressures = [[4e8, 8e8], ["400 MPa", "0.8 GPa"], [0.4 * unit.GPa, 800 * unit.MPa]]
    found = [SMALL.roughness(pressure=each, hardness=20e9, **arguments) for each in pressures]
    for other in found[1:]:
        np.testing.assert_allclose(other.loads["mean_gap"], found[0].loads["mean_gap"], rtol=1e-12)
    with pytest.raises(schlupf.CaseError, match="hardness must be given in Pa"):
        SMALL.roughness(hardness=1 * unit.mm, **arguments)
    place = {"x": [0.0, 1e-3], "y": [0.0, 0.0], "depth": 1e-3 * np.ones(2)}
    case = SMALL.with_(subsurface={"layers": 3, "margin": "1 mm"})
    stresses = case.subsurface(points=place, warn=False)
    assert len(stresses.points["x"]) == 2


def test_a_flag_is_true_or_false_and_nothing_else_is_one():
    assert SMALL.calibrate(direct=np.bool_(False), cells=10).converged
    with pytest.raises(schlupf.CaseError, match='direct must be true or false, but is "yes"'):
        SMALL.calibrate(direct="yes")
    with pytest.raises(schlupf.CaseError, match="cells must be a whole number .* but is false"):
        SMALL.calibrate(cells=False)
    with pytest.raises(schlupf.CaseError, match="displacements must not be given together with"):
        SMALL.calibrate(direct=True, displacements="displacements.csv")


def test_curves_over_numbers_have_a_map():
    speeds = np.array([30.0, 10.0, 20.0])
    curves = SMALL.curve(creepage_x=(0.0, 0.01), over={"kinematics.speed": speeds}, points=4)
    found = curves.map
    assert found["traction_coefficient"].dims == ("speed", "creepage_x")
    assert found["speed"].values.tolist() == [10.0, 20.0, 30.0]
    assert found["force_x"].attrs["units"] == "N"
    np.testing.assert_array_equal(found["force_x"][0], curves.points["force_x"].isel(speed=1))
    assert curves.plot_map().get_ylabel() == "speed (m/s)"
    with pytest.raises(KeyError, match="no field friction"):
        curves.plot_map("friction")
    with pytest.raises(ValueError, match="at least three numbers"):
        _ = SMALL.curve(creepage_x=(0.0, 0.01), points=3).map


def test_creepage_over_a_prescribed_force():
    curve = SMALL.curve(force_x=(0.0, "-12 kN"), points=4, warn=False)
    points = curve.points
    np.testing.assert_allclose(points["force_x"], [0.0, -4e3, -8e3, -12e3], atol=1.0)
    assert np.all(np.diff(points["creepage_x"]) > 0.0)
    last = {"creepage_x": float(points["creepage_x"][3])}
    assert SMALL.with_(kinematics=last).solve().force.x == pytest.approx(-12e3, rel=1e-4)
    assert curve.plot().get_xlabel().startswith("longitudinal creepage")
    over = {"kinematics.speed": [10.0, 20.0, 30.0]}
    curves = SMALL.curve(traction_coefficient=(0.05, 0.15), over=over, points=3, warn=False)
    assert curves.map["creepage_x"].dims == ("speed", "force_over_load")


def test_two_fields_make_a_map_of_the_largest_forces():
    over = {"kinematics.speed": [10.0, 20.0], "normal.load": ["60 kN", "70 kN", "80 kN"]}
    curves = SMALL.curve(creepage_x=(0.0, 0.05), over=over, points=6)
    assert curves.points["force_x"].dims == ("speed", "normal_load", "point")
    assert curves.points["normal_load"].values.tolist() == [6e4, 7e4, 8e4]
    found = curves.map
    assert found["force_x"].dims == ("normal_load", "speed")
    alone = SMALL.with_(kinematics={"speed": 20.0}, normal={"load": 7e4})
    (curve,) = alone.curve(creepage_x=(0.0, 0.05), points=6)["curves"]
    peak = curve["maximum"]["traction_coefficient"]
    largest = found["traction_coefficient"].sel(normal_load=7e4, speed=20.0)
    assert float(largest) == pytest.approx(peak, rel=1e-5)
    assert curves.plot().get_xlabel() == "speed (m/s)"


def test_a_case_with_a_history_has_no_curve():
    rolled = SMALL.with_(history={"time": [0.0, 1e-3], "creepage_x": [0.0, 0.002]})
    with pytest.raises(schlupf.CaseError, match="steady rolling"):
        rolled.curve(creepage_x=(0.0, 0.01))


def test_figures_of_the_command_are_at_hand():
    drawings = SMALL.curve(creepage_x=(0.0, 0.01), points=3).drawings()
    assert drawings["creep_curve"].rstrip().endswith("</svg>")


def test_a_surface_of_the_paper(result):
    ax = result.plot.surface("pressure")
    assert ax.get_zlabel() == "normal pressure (GPa)"
    with pytest.raises(TypeError, match="three-dimensional"):
        result.plot.surface(ax=plt.subplots()[1])


INPUT = """\
% A ball that brakes
 3  MODULE
  203100    P-B-T-N-F-S
  022020    L-D-C-M-Z-E
 0000111    H-G-I-A-O-W-R
  999 100 30 1 1e-5   MAXGS, MAXIN, MAXNR, MAXOUT, EPS
 52359.878 0.001 0.0 0.0    FN, CKSI, CETA, CPHI
 0.3 0.3   FSTAT, FKIN
 0d 0.25 30000.   CHI, DQ, VELOC
 0.28 0.28 82031.25 82031.25   POISS 1,2, GG 1,2
 -3
 22 22 5.0 5.0 1.1   MX, MY, AA, BB, SCALE
 3  MODULE
  213100    P-B-T-N-F-S
  100000    L-D-C-M-Z-E
 0100111    H-G-I-A-O-W-R
 52359.878 0.002 0.0 0.0    FN, CKSI, CETA, CPHI
 0  MODULE
"""


def test_inputs_of_contact_are_cases(tmp_path):
    path = tmp_path / "ball.inp"
    path.write_text(INPUT)
    with pytest.raises(schlupf.CaseError, match="B = 1: a compressible layer") as caught:
        schlupf.import_contact(path)
    assert caught.value.field == "B"
    assert caught.value.place == f"{path}:14:4"
    left_out = pytest.warns(schlupf.warnings.SettingsLeftOutWarning)
    with left_out, pytest.warns(schlupf.SchlupfWarning, match="B = 1: a compressible layer"):
        (case,) = schlupf.import_contact(path, available_only=True)
    assert case.title == "A ball that brakes"
    assert case.normal.load == pytest.approx(52359.878)
    # CONTACT, over μN, on 320 x 80 cells.
    force = case.solve().force.x / (0.3 * 52359.878)
    assert force == pytest.approx(-0.46379, abs=0.008)
    path.write_text(INPUT.replace("213100", "203100"))
    with pytest.warns(schlupf.warnings.SettingsLeftOutWarning):
        first, second = schlupf.import_contact(path, wheel_body=2)
    assert (first.kinematics.creepage_x, second.kinematics.creepage_x) == (-0.001, -0.002)
    with pytest.raises(ValueError, match="wheel_body must be 1 or 2"):
        schlupf.import_contact(path, wheel_body=3)


def test_a_wheelset_has_contacts_over_its_lateral_position():
    case = schlupf.Case(
        wheel={"profile": "S1002"},
        rail={"profile": "60E1", "cant": 0.025},
        normal={"model": "wheel-rail", "load": 20e3},
        elasticity={"model": "half-space"},
        heat={"model": "none"},
        friction={"model": "constant", "coefficient": 0.3},
        grid=GRID,
    )
    found = case.wheelset(lateral_position=("-3 mm", 3e-3), points=3, warn=False)
    of_array = case.wheelset(lateral_position=np.linspace(-3e-3, 3e-3, 3), warn=False)
    assert of_array.to_dict() == found.to_dict()
    contacts = found.contacts
    assert np.unique(contacts["lateral_position"]).tolist() == [-3e-3, 0.0, 3e-3]
    assert set(contacts["side"].values.tolist()) == {"left", "right"}
    radii = contacts["rolling_radius_difference"]
    assert radii.attrs["units"] == "m"
    # To the left the left wheel runs on the larger radius.
    assert float(radii.values[0]) < -1e-4 < 1e-4 < float(radii.values[-1])
    # Without roll: by the wavelength of the nonlinear motion, and by harmonic linearisation.
    at = found.conicity.sel(amplitude=3e-3)
    assert at["equivalent_conicity"] == pytest.approx(0.1742, abs=0.001)
    assert at["harmonic_conicity"] == pytest.approx(0.1757, abs=0.001)
    rigid = contacts["rigid_rolling_radius_difference"]
    assert float(rigid.values[-1]) == pytest.approx(float(radii.values[-1]), rel=0.1)
    assert found.plot().get_title() == found.title
    plt.close("all")
    with pytest.raises(schlupf.CaseError, match='normal.model must be "wheel-rail"'):
        SMALL.wheelset()
    with pytest.raises(schlupf.CaseError, match="lateral_position"):
        case.wheelset(lateral_position=(-8.0, 8.0))


def test_stresses_below_the_surface_are_those_of_hertz():
    """Hertz 1882 on the axis of a circle, σzz = −p0/(1 + (z/a)²); 0.310 p0 in shear (ν = 0.3)."""
    radius, peak = 6e-3, 1e9
    ellipse = {"semi_axis_x": radius, "semi_axis_y": radius, "peak_pressure": peak}
    case = schlupf.Case(
        kinematics={"creepage_x": 0.0},
        wheel={"poisson_ratio": 0.3},
        rail={"poisson_ratio": 0.3},
        normal={"model": "ellipse", **ellipse},
        heat={"model": "none"},
        grid=GRID,
        subsurface={"layers": 9, "margin": "1 mm"},
    )
    found = case.subsurface()
    shear = found.largest.shear
    assert shear.largest_shear_stress == pytest.approx(0.310 * peak, rel=0.01)
    assert shear.depth == pytest.approx(0.48 * radius, abs=0.01 * radius)
    depth = np.linspace(0.0, 2.0 * radius, 7)
    axis = found.at(0.0, 0.0, depth)
    expected = -peak / (1.0 + (depth / radius) ** 2)
    np.testing.assert_allclose(axis["stress_zz"], expected, atol=0.01 * peak)
    assert axis["stress_zz"].attrs["units"] == "Pa"
    volume = found.volume
    assert volume["von_mises_stress"].dims == ("depth", "y", "x")
    assert volume.sizes["depth"] == 9
    row = volume.isel(depth=3, y=4)
    again = found.at(row["x"], row["y"], row["depth"])
    np.testing.assert_allclose(again["stress_xx"], row["stress_xx"], rtol=1e-9)
    assert found.profile["depth"][-1] == pytest.approx(2.0 * radius)
    assert found.plot().get_xlabel().startswith("$x$")
    with pytest.raises(ValueError, match="depth"):
        found.at(0.0, 0.0, -1e-3)


def test_methods_without_fields_have_no_stresses_below():
    with pytest.raises(schlupf.CaseError, match="polach"):
        SMALL.with_(solver={"method": "polach"}).subsurface()


def test_wear_of_a_passage_is_that_of_its_cells():
    """Volumes of cells and profile agree; Burstow (2004), 175 N: no damage, wear beyond."""
    case = SMALL.with_(kinematics={"creepage_x": 0.004, "spin": "0.3 1/m"})
    found = case.wear(warn=False)
    profile, cells = found.profile, found.cells
    width = float(profile["y"][1] - profile["y"][0])
    assert float(profile["archard"].sum()) * width == pytest.approx(found.wear.archard_volume)
    area = found.normal.semi_axis_x * found.normal.semi_axis_y * np.pi
    assert cells.sizes["cell"] > 50
    assert float(cells["archard"].max()) * area > found.wear.archard_volume
    assert cells["slip_speed"].attrs["units"] == "m/s"
    assert (found.crack_damage < 0) == (found.t_gamma.without_spin > 175)
    assert found.fatigue_index == pytest.approx(
        found.shakedown.traction_coefficient - 1 / found.shakedown.load_factor, rel=1e-3
    )
    assert found.melting.share == 0
    assert found.plot().get_ylabel().startswith("depth")
    hot = case.with_(damage={"melting_temperature": "25 degC"})
    with pytest.warns(schlupf.SchlupfWarning, match="melts"):
        assert hot.wear().melting.share > 0.1
    fast = schlupf.Case(solver={"method": "polach"}).wear(warn=False)
    assert "no-wear" in [warning.code for warning in fast.warnings]
    assert fast.wear is None
    assert fast.profile is None
    with pytest.raises(ValueError, match="no wear to draw"):
        fast.plot()


def test_the_points_of_a_curve_may_be_an_array():
    places = np.array([0.0, 0.0005, 0.002, 0.01])
    points = SMALL.curve(creepage_x=places).points
    np.testing.assert_array_equal(points["creepage_x"], places)
    alone = schlupf.forces(SMALL, creepage_x=places)
    np.testing.assert_allclose(points["force_x"], alone["force_x"], rtol=1e-4, atol=1.0)
    for same in (
        list(places),
        xr.DataArray(places, dims="creepage"),
        pint.UnitRegistry().Quantity(places * 100, "percent"),
    ):
        np.testing.assert_allclose(SMALL.curve(creepage_x=same).points["creepage_x"], places)
    forces = SMALL.curve(force_x=["0 kN", "-1 kN", "-10 kN"], warn=False).points["force_x"]
    np.testing.assert_allclose(forces, [0.0, -1e3, -10e3], rtol=1e-4, atol=1.0)
    assert SMALL.temperature(depth=[0.0, 1e-4, 2e-3], warn=False).profile.sizes["depth"] == 3
    single = places.astype(np.float32)
    both = SMALL.curve(creepage_x=single, creepage_y=3 * single, warn=False).points
    np.testing.assert_allclose(both["creepage_y"], 3 * places, rtol=1e-6)
    for wrong, told in (
        ({"creepage_y": np.linspace(0.0, 0.01, 3)}, "creepage_y must have 4 points, .* but has 3"),
        ({"creepage_y": 2 * np.sqrt(places)}, "creepage_y must vary linearly with creepage_x"),
        ({"points": 4}, "points must be left out"),
        ({"spacing": "refined"}, "spacing must be left out"),
    ):
        with pytest.raises(schlupf.CaseError, match=told):
            SMALL.curve(creepage_x=places, **wrong)
    with pytest.raises(schlupf.CaseError, match="increase or decrease .* but 1e-3 follows 2e-3"):
        SMALL.curve(creepage_x=[0.0, 0.002, 0.001])
    with pytest.raises(schlupf.CaseError, match="must be larger than the one before, but is 1e-4"):
        SMALL.temperature(depth=[2e-3, 1e-4, 0.0])


def test_a_tuple_of_two_is_a_range_and_a_list_the_points():
    two = [0.0, 0.01]
    for points in (two, np.array(two), xr.DataArray(two, dims="a"), pd.Series(two), "0, 0.01"):
        assert SMALL.curve(creepage_x=points).points["creepage_x"].values.tolist() == two
    for ends in (tuple(two), "0..0.01"):
        assert SMALL.curve(creepage_x=ends, points=3).points.sizes["point"] == 3


@pytest.mark.parametrize(
    ("points", "told"),
    [
        ([], "at least two values in one dimension"),
        (0.01, "must be a tuple of start and end"),
        (b"0,0.01", "must be real numbers"),
        ({0.0, 0.01}, "must be a tuple of start and end"),
        ({"from": 0.0, "to": 0.01}, "must be a tuple of start and end"),
        (np.zeros((2, 3)), "an array of shape"),
        ([[0.0, 0.001], [0.002, 0.01]], "must be a tuple of start and end"),
        ([0.0, 0.01j], "must be real numbers"),
        (np.ma.masked_array([0.0, 0.001, 0.01], [0, 1, 0]), "must be finite"),
        (np.array([1, 2], "timedelta64[s]"), "must be real numbers"),
        (np.linspace(0.0, 0.01, 10_001), "must have at most 10000 values, but has 10001"),
    ],
)
def test_what_is_no_points_is_refused(points, told):
    with pytest.raises(schlupf.CaseError, match=told):
        SMALL.curve(creepage_x=points)
