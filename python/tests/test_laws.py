"""Laws as functions of arrays."""

import pickle

import numpy as np
import pytest

import schlupf

SMALL = schlupf.Case(grid={"cells_x": 10, "cells_y": 10}, kinematics={"creepage_x": 0.006})


def falling(temperature, slip_speed, y):
    """Polach's decay with slip, times the linear fall with temperature of the case."""
    return 0.4 * (0.6 * np.exp(-0.5 * slip_speed) + 0.4) * np.maximum(1 - temperature / 700, 0)


def constant(temperature, slip_speed, y):
    return 0.25


def fails(*arguments):
    raise LookupError("no such law")


def test_a_friction_law_in_python_is_that_of_the_library():
    law = {"speed_model": "polach", "limit_ratio": 0.4, "decay": 0.5}
    own = SMALL.with_(friction=law).solve()
    found = SMALL.with_laws(friction=falling).solve()
    assert found.force.x == pytest.approx(own.force.x, rel=1e-6)
    assert found.temperature.max_rise == pytest.approx(own.temperature.max_rise, rel=1e-6)
    # Derivatives are differences.
    assert found.sensitivity["creepage_x"]["x"] == pytest.approx(
        own.sensitivity["creepage_x"]["x"], rel=1e-4
    )


def test_laws_hold_for_curves_and_many_conditions():
    exact = SMALL.with_(solver={"tolerance": 1e-9})
    case = exact.with_laws(friction=constant)
    cold = exact.with_(friction={"model": "constant", "coefficient": 0.25})
    creepage = [0.001, 0.01]
    expected = schlupf.forces(cold, creepage_x=creepage)["force_x"]
    np.testing.assert_allclose(schlupf.forces(case, creepage_x=creepage)["force_x"], expected, 1e-6)
    curve = case.curve(creepage_x=(0.0, 0.01), points=3)
    assert float(curve.points["force_x"][-1]) == pytest.approx(float(expected[-1]), rel=1e-6)
    solver = schlupf.Solver(case)
    solved = solver.solve(creepage_x=0.01)
    assert solved.force.x == pytest.approx(float(expected[-1]), rel=1e-5)
    assert case.with_(normal={"load": 60e3})._laws["friction"] is constant


@pytest.mark.parametrize("law", ["friction", "partition"])
def test_an_exception_of_a_law_comes_back(law):
    case = SMALL.with_laws(**{law: fails})
    for solve in (
        case.solve,
        lambda: case.curve(creepage_x=(0.0, 0.01), points=3),
        lambda: schlupf.forces(case, creepage_x=[0.001, 0.002]),
        lambda: schlupf.Solver(case).solve(),
        case.compare,
    ):
        with pytest.raises(LookupError, match="no such law"):
            solve()


def test_an_exception_in_the_middle_of_a_solution_comes_back():
    calls = []

    def tired(temperature, slip_speed, y):
        calls.append(1)
        if len(calls) > 500:
            raise RuntimeError("tired")
        return constant(temperature, slip_speed, y)

    with pytest.raises(RuntimeError, match="tired"):
        SMALL.with_laws(friction=tired).solve()


@pytest.mark.parametrize(
    ("law", "part"),
    [
        (lambda t, v, y: -0.1 + 0 * t, "friction must be finite and not negative, but is -0.1"),
        (lambda t, v, y: np.nan * t, "but is nan"),
        (lambda t, v, y: [0.3, 0.3, 0.3], "as many values as it is given"),
        (lambda t, v, y: "slippery", "could not convert"),
    ],
)
def test_wrong_values_are_refused(law, part):
    with pytest.raises(ValueError, match=part):
        SMALL.with_laws(friction=law).solve()


def test_a_pressure_in_python():
    a, b, peak = 6e-3, 5e-3, 1e9

    def hertz(x, y):
        return peak * np.sqrt(np.maximum(1 - (x / a) ** 2 - (y / b) ** 2, 0))

    case = SMALL.with_laws(pressure=hertz, extent=((-a, a), (-b, b)))
    result = case.solve(warn=False)
    assert result.normal.load == pytest.approx(2 / 3 * np.pi * a * b * peak, rel=1e-3)
    ellipse = {"model": "ellipse", "semi_axis_x": a, "semi_axis_y": b, "peak_pressure": peak}
    own = SMALL.with_(normal=ellipse).solve()
    assert result.force.x == pytest.approx(own.force.x, rel=5e-3)
    with pytest.raises(TypeError, match="belong together"):
        SMALL.with_laws(pressure=hertz)
    with pytest.raises(ValueError, match="extent must contain the contact"):
        SMALL.with_laws(pressure=hertz, extent=((-0.5 * a, 0.5 * a), (-b, b)))
    with pytest.raises(ValueError, match="extent must be"):
        SMALL.with_laws(pressure=hertz, extent=(1, 2))
    with pytest.raises(ValueError, match="must be positive somewhere"):
        SMALL.with_laws(pressure=lambda x, y: 0 * x, extent=((-a, a), (-b, b)))
    assert case.with_(normal={"load": 50e3}).solve(warn=False).normal.load == pytest.approx(50e3)


def test_what_a_law_replaces_is_not_varied():
    case = SMALL.with_laws(friction=constant)
    with pytest.raises(schlupf.CaseError, match="has no effect"):
        schlupf.forces(case, friction__coefficient=[0.1, 0.5])
    with pytest.raises(schlupf.CaseError, match="has no effect"):
        case.curve(creepage_x=(0.0, 0.01), over={"friction.coefficient": [0.1, 0.5]})
    assert "friction.coefficient" not in case.effective()


def test_a_heat_partition_in_python():
    given = SMALL.with_(heat={"partition": 0.3}).solve()
    seen = []

    def share(wheel_speed, speed):
        seen.append((float(wheel_speed[0]), float(speed[0])))
        return 0.3 + 0 * speed

    found = SMALL.with_laws(partition=share).solve()
    assert found.force.x == pytest.approx(given.force.x, rel=1e-9)
    assert found.power.into_wheel == pytest.approx(0.3 * found.power.friction, rel=1e-9)
    wheel_speed, speed = seen[0]
    assert speed == pytest.approx(30.0)
    assert wheel_speed == pytest.approx(30.0 * (1 - 0.006), rel=1e-3)


def test_a_law_must_be_a_function_and_use_no_solver():
    with pytest.raises(TypeError, match="friction must be a function, but is 0.3"):
        schlupf.Case().with_laws(friction=0.3)
    solvers = []

    def friction(temperature, slip_speed, y):
        if solvers:
            solvers[0].solve()
        return 0.3 + 0.0 * slip_speed

    case = schlupf.Case(grid={"cells_x": 8, "cells_y": 8}).with_laws(friction=friction)
    solvers.append(schlupf.Solver(case))
    with pytest.raises(RuntimeError, match="a law must not use a solver"):
        solvers[0].solve()


def test_a_case_with_laws_can_be_pickled():
    case = SMALL.with_laws(friction=constant)
    again = pickle.loads(pickle.dumps(case))
    assert again == case
    assert again != SMALL
    assert again.solve().force.x == case.solve().force.x


def test_laws_add_up():
    case = SMALL.with_laws(friction=constant).with_laws(partition=lambda w, v: 0.3 + 0 * v)
    result = case.solve()
    expected = SMALL.with_(
        friction={"model": "constant", "coefficient": 0.25}, heat={"partition": 0.3}
    ).solve()
    assert result.force.x == pytest.approx(expected.force.x, rel=1e-6)
    assert "friction=<function constant" in repr(case)
    with pytest.warns(schlupf.SchlupfWarning, match="left out of the text: friction, partition"):
        case.to_toml()
