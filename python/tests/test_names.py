"""Wrong names and values: what users are told."""

from __future__ import annotations

import copy
import pickle
import re

import numpy as np
import pytest

import schlupf


@pytest.fixture(scope="module")
def case():
    grid = {"cells_x": 8, "cells_y": 8}
    return schlupf.Case(kinematics={"creepage_x": 0.005}, grid=grid)


@pytest.fixture(scope="module")
def result(case):
    return case.solve(warn=False)


def test_fields_are_told_by_those_like_them(case):
    asked = [
        (lambda: case["wheel.radios_x"], KeyError, "no field wheel.radios_x; did you mean wheel."),
        (lambda: case.wheel["radios_x"], KeyError, "did you mean wheel.radius_x"),
        (lambda: case.wheel.radios_x, AttributeError, "did you mean wheel.radius_x"),
        (lambda: case["weel"], KeyError, "no section weel; did you mean wheel"),
        (lambda: case.weel, AttributeError, "no section weel; did you mean wheel"),
        (lambda: case["load"], KeyError, "no section load; did you mean normal.load"),
        (lambda: case.with_(wheel={"radios_x": 1.0}), ValueError, "radius_x"),
        (lambda: case.with_(**{"wheel.radios_x": 1.0}), ValueError, "radius_x"),
        (lambda: setattr(case.wheel, "radios_x", 1.0), ValueError, "radius_x"),
        (lambda: schlupf.Case(weel={"radius_x": 1.0}), ValueError, "did you mean `?wheel"),
        (
            lambda: case.curve(creepage_x=(0, 0.01), over={"kinematics.sped": [1]}),
            KeyError,
            "speed",
        ),
        (lambda: schlupf.materials["stel"], KeyError, "no preset stel; "),
        (lambda: schlupf.materials.stel, AttributeError, "no preset stel; "),
    ]
    for ask, error, told in asked:
        with pytest.raises(error, match=told):
            ask()


def test_results_are_told_by_those_like_them(result):
    asked = [
        (lambda: result["forse"], KeyError, "no result forse; did you mean force"),
        (lambda: result.forse, AttributeError, "no result forse; did you mean force"),
        (lambda: result["force"]["z"], KeyError, "no result z; there are x, y, moment_z"),
        (lambda: result[0], KeyError, "no result 0; there are "),
        (lambda: result.fields["presure"], KeyError, "pressure"),
        (lambda: result.plot.surface("presure"), KeyError, "no field presure; did you mean press"),
        (lambda: result.plot.cut("presure"), KeyError, "no field presure; did you mean press"),
        (lambda: schlupf.plot_comparison([result], "presure"), KeyError, "did you mean pressure"),
        (lambda: schlupf.animate([result], "presure"), KeyError, "did you mean pressure"),
    ]
    for ask, error, told in asked:
        with pytest.raises(error, match=told):
            ask()
    with pytest.raises(KeyError) as caught:
        result["forse"]
    assert str(caught.value) == "no result forse; did you mean force?"
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(copy.copy(caught.value)) == str(caught.value)


@pytest.mark.parametrize(
    ("section", "value", "told"),
    [
        (
            "wheel",
            {"profile": np.zeros((3, 2))},
            "wheel.profile must be .*an array of shape (3, 2)",
        ),
        ("rail", {"profile": [[0.0, 1.0]]}, "rail.profile must be the path of a file, but is [[0."),
        ("normal", {"model": "tabulated", "file": np.ones(4)}, "normal.file must be the path of a"),
        ("normal", {"model": ["hertz"]}, "normal.model must be one of several names, but is ['he"),
        ("friction", {"model": 3}, "friction.model must be one of several names, but is 3"),
        ("solver", {"extrapolate": 1.5}, "solver.extrapolate must be True or False, but is 1.5"),
        ("normal", {"load": np.array([8e4, 9e4])}, "normal.load must be"),
        ("normal", {"load": np.nan}, "normal.load must be"),
        ("normal", {"load": {"kN": 80}}, "normal.load"),
        ("normal", {"load": object()}, "normal.load must be a number, text, a sequence or a quant"),
        ("grid", {"cells_x": 8.5}, "grid.cells_x must be"),
        ("grid", {"cells_x": "many"}, "grid.cells_x must be"),
    ],
)
def test_values_of_a_wrong_kind_are_named(section, value, told):
    with pytest.raises((ValueError, TypeError)) as caught:
        schlupf.Case(**{section: value})
    parts = [re.escape(part) for part in told.split(".*")]
    assert re.search(".*".join(parts), str(caught.value)), str(caught.value)


def test_a_flag_may_be_one_of_numpy():
    case = schlupf.Case(solver={"extrapolate": np.bool_(True)})
    assert case.solver.extrapolate is True
