"""A wheelset of two force elements: at rest, its gravitational stiffness, and its hunting."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import wheel

import schlupf

SIDES = ("left", "right")
POSITIONS = ("lateral_position", "wheelset_height", "roll_angle", "wheelset_yaw_angle")
RATES = ("lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate")
FORCES = ("force_y", "force_z", "moment_x", "moment_z", "moment_y")
MASS = np.array([1813.0, 1813.0, 1120.0, 1120.0, 112.0])
RADIUS, WEIGHT, SPEED = 0.46, 100e3, 2.0


class Wheelset:
    """Both wheels, straight ahead in the middle of the track, at the height of their weight."""

    def __init__(self, path, **inputs):
        case = {"element": {"contact_table": path}}
        self.wheels = [schlupf.element(wheel(side, **case)) for side in SIDES]
        self.inputs = [signal.name for signal in self.wheels[0].inputs]
        self.outputs = [signal.name for signal in self.wheels[0].outputs]
        free = self.columns(["wheelset_height", "angular_velocity"])
        given = {"speed": SPEED, "angular_velocity": SPEED / RADIUS} | inputs
        at = np.array([one.array(**given) for one in self.wheels])
        for _ in range(8):
            self.found = [one.evaluate(row) for one, row in zip(self.wheels, at, strict=True)]
            force = sum(self.by(found.outputs) for found in self.found)
            slopes = self.slopes([1, 4], free)
            at[:, free] -= np.linalg.solve(slopes, force[[1, 4]] - [WEIGHT, 0.0])
        self.force = force

    def columns(self, names):
        return [self.inputs.index(name) for name in names]

    def rows(self):
        return [self.outputs.index(f"wheel_{name}") for name in FORCES]

    def by(self, outputs):
        return outputs[self.rows()]

    def slopes(self, forces, inputs):
        rows = np.array(self.rows())[forces]
        return sum(found.derivatives[np.ix_(rows, inputs)] for found in self.found)


@pytest.fixture(scope="module")
def exact():
    """Rolling radii and lateral forces of both wheels near the middle, nearly without friction."""
    case = wheel(friction={"model": "constant", "coefficient": 1e-6}, solver={"method": "polach"})
    return case.wheelset(lateral_position=("-0.1 mm", "0.1 mm"), points=3, warn=False).contacts


def slope(exact, name):
    """Of the sum of a column of both wheels by the lateral position."""
    totals = exact[name].groupby("lateral_position").sum()
    return float((totals[-1] - totals[0]) / 0.2e-3)


def test_a_wheelset_rests_in_the_middle(contacts):
    """Vertical forces are its weight, and all others cancel."""
    of = Wheelset(contacts[0])
    assert of.force[1] == pytest.approx(WEIGHT, rel=1e-12)
    lateral, _, roll, turning, driving = of.force
    assert np.abs([lateral, roll, turning, driving]).max() < 1e-6 * WEIGHT


def test_gravitational_stiffness_is_that_of_exact_contacts(contacts, exact):
    """Normal forces turn as the contacts move across, both wheels loaded by the same weight."""
    of = Wheelset(contacts[0], friction_factor=1e-6)
    y, height, roll = of.columns(POSITIONS[:3])
    lateral, vertical = (of.outputs.index(f"wheel_force_{axis}") for axis in "yz")
    loads = np.array([found.derivatives[vertical, [y, height, roll]] for found in of.found])
    following = np.r_[1.0, np.linalg.solve(loads[:, 1:], -loads[:, 0])]
    stiffness = -sum(
        found.derivatives[lateral, [y, height, roll]] @ following for found in of.found
    )
    assert stiffness == pytest.approx(-slope(exact, "wheel_force_y"), rel=0.01)
    assert stiffness > 1e6


def test_hunting_has_the_wavelength_of_the_equivalent_conicity(contacts, exact):
    """Klingel (1883): (2π/λ)² = 2 γ/(e r), with the slope of the rolling radii of elastic wheels.

    Spin and gravity, which he leaves out, count for one per cent.
    """
    of = Wheelset(contacts[0])
    motion = np.zeros((9, 9))
    motion[:4, 4:8] = np.eye(4)
    motion[4:] = of.slopes(range(5), of.columns([*POSITIONS, *RATES, "angular_velocity"]))
    motion[4:] /= MASS[:, None]
    modes = np.linalg.eigvals(motion)
    hunting = modes[(modes.imag > 0.1 * SPEED) & (modes.imag < 5.0 * SPEED)]
    assert len(hunting) == 1
    middle = exact.where(exact.lateral_position == 0.0, drop=True)
    distance = float(np.abs(middle["position_y"]).sum())
    conicity = (hunting[0].imag / SPEED) ** 2 * distance * RADIUS / 2.0
    radii = exact.where(exact.side == "left", drop=True)["rolling_radius_difference"]
    expected = float(radii[-1] - radii[0]) / 0.2e-3 / 2.0
    assert conicity == pytest.approx(expected, rel=0.02)
