"""Wrong names and values: what users are told."""

from __future__ import annotations

import copy
import errno
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
        (
            lambda: schlupf.study(case, vary={"normal": {"load": [1e3]}}),
            KeyError,
            "normal is a section: name its fields, such as normal.model",
        ),
        (lambda: schlupf.examples.half_spac, AttributeError, "did you mean half_space"),
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
            "solver",
            {"table": np.ones(4)},
            "solver.table must be the path of a file, but is an array",
        ),
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


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (
            lambda: schlupf.damage(np.zeros((2, 2))),
            "run must be the path of a file, but is an array of shape (2, 2)",
        ),
        (
            lambda: schlupf.study(schlupf.Case(), states=np.zeros((2, 3))),
            "states must be a path or columns named as fields, but is an array of shape (2, 3)",
        ),
        (
            lambda: schlupf.roughness(np.array([["a", "b"]]), spacing=1e-6),
            "surface must be numbers, but is array([['a', 'b']]",
        ),
        (
            lambda: schlupf.roughness(np.eye(8)),
            "surface: spacing must be given",
        ),
        (
            lambda: schlupf.forces(schlupf.Case(), creepage_x=[0, 0.01], load=[1e4, 2e4, 3e4]),
            "arrays must be of shapes that broadcast, but are creepage_x (2,), normal_load (3,)",
        ),
        (
            lambda: schlupf.Case().curve(creepage_x=0.01),
            "creepage_x must be a tuple of start and end, or at least two values in one dimension, "
            "but is 0.01",
        ),
    ],
)
def test_arguments_of_a_wrong_kind_are_named(ask, told):
    with pytest.raises(ValueError, match=re.escape(told)):
        ask()


def test_a_flag_may_be_one_of_numpy():
    case = schlupf.Case(solver={"extrapolate": np.bool_(True)})
    assert case.solver.extrapolate is True


MISSING = {
    "case": lambda path: schlupf.Case.from_file(path),
    "field": lambda path: schlupf.Case(history={"file": path}),
    "profile": lambda path: schlupf.Case(
        normal={"model": "wheel-rail"}, wheel={"profile": path}, rail={"profile": "60E1"}
    ),
    "heights": lambda path: schlupf.roughness(path, spacing=1e-6, unit="m"),
    "surface of an instrument": lambda path: schlupf.open_surface(path),
    "points": lambda path: schlupf.Case().subsurface(points=path),
    "displacements": lambda path: schlupf.Case().calibrate(displacements=path),
    "creep data": lambda path: schlupf.Case().fit(["friction.coefficient"], path),
    "study": lambda path: schlupf.Study.from_file(path),
    "states": lambda path: schlupf.study(schlupf.Case(), states=path),
    "sweep": lambda path: schlupf.sweep(path, path.with_name("table.csv")),
    "shard": lambda path: schlupf.merge([path], path.with_name("table.csv")),
    "table": lambda path: schlupf.open_table(path),
    "result": lambda path: schlupf.open_result(path),
    "run": lambda path: schlupf.damage(path),
    "look-up table": lambda path: schlupf.LookUpTable(path),
    "input of CONTACT": lambda path: schlupf.import_contact(path),
}


@pytest.mark.parametrize("what", MISSING)
def test_a_missing_file_is_told_as_python_tells_it(tmp_path, what):
    path = tmp_path / ("no.npy" if what == "heights" else "no.csv")
    with pytest.raises(FileNotFoundError) as caught:
        MISSING[what](path)
    assert caught.value.errno == errno.ENOENT
    assert caught.value.filename == str(path) and str(path) in str(caught.value)
    assert "os error" not in str(caught.value)
    again = pickle.loads(pickle.dumps(caught.value))
    assert (again.errno, again.filename, str(again)) == (
        errno.ENOENT,
        str(path),
        str(caught.value),
    )


def test_numbers_are_told_as_they_were_given():
    with pytest.raises(schlupf.CaseError) as caught:
        schlupf.Case(normal={"load": -5})
    assert str(caught.value).endswith("must be between 1e-9 and 1e12 N, but is -5.0 N")
    with pytest.raises(schlupf.CaseError, match='but is "-5"'):
        schlupf.Case(kinematics={"speed": "-5"})
    with pytest.raises(schlupf.CaseError, match='but is "2.0 parsec"'):
        schlupf.Case(kinematics={"speed": "2.0 parsec"})
    with pytest.raises(TypeError, match="no condition lod; did you mean load"):
        schlupf.forces(schlupf.Case(), lod=1.0)
    with pytest.raises(TypeError, match="did you mean wheel.radius_x"):
        schlupf.forces(schlupf.Case(), wheel__radios_x=1.0)


def test_names_of_data_sets_are_attributes(result):
    """None is a method of a data set: each is an attribute, too."""
    import xarray as xr

    table = schlupf.forces(schlupf.Case(solver={"method": "polach"}), load=[60e3, 80e3], warn=False)
    for dataset in (table, result.fields, result.history):
        for name in dataset.variables:
            assert str(name).isidentifier() and not hasattr(xr.Dataset, str(name)), name


def test_keys_complete(case, result):
    assert "normal.load" in case._ipython_key_completions_()
    assert "load" in case.normal._ipython_key_completions_()
    assert result._ipython_key_completions_()[:2] == ["program", "title"]
    assert "steel" in schlupf.materials._ipython_key_completions_()
    assert dict(result.force.items()) == dict(result.force)
