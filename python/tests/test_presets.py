"""Data to start with, and the command."""

import pickle
import subprocess
import sys
from pathlib import Path

import pytest

import schlupf

GROUPS = {
    "materials": lambda preset: {"wheel": preset},
    "roughnesses": lambda preset: {"contact_law": {"roughness": preset}},
    "friction": lambda preset: {"friction": preset},
    "layers": lambda preset: {"layer": preset},
    "methods": lambda preset: preset,
    "conditions": lambda preset: preset,
}


@pytest.mark.parametrize("group", GROUPS)
def test_every_preset_makes_a_case(group):
    presets = getattr(schlupf, group)
    assert len(presets) > 0
    for name in presets:
        preset = presets[name]
        assert preset.source
        assert preset.doc
        case = schlupf.Case(**GROUPS[group](preset))
        assert case.given()
    assert name in repr(presets)
    with pytest.raises(AttributeError, match="there are"):
        presets.nothing


def test_presets_are_dictionaries_with_a_source():
    steel = schlupf.materials.steel
    assert steel["young_modulus"] == "210 GPa"
    assert pickle.loads(pickle.dumps(steel)) == steel
    # Polach, Wear 258 (2005) 992-1000: the largest adhesion of a locomotive on dry rails.
    case = schlupf.Case(friction=schlupf.friction.polach_dry, **schlupf.methods.polach_dry)
    assert case.friction.coefficient == 0.55
    assert case.solver.polach_area_slip == 0.4


def test_every_example_is_a_case():
    names = dir(schlupf.examples)
    assert len(names) > 15
    for name in names:
        assert isinstance(getattr(schlupf.examples, name), schlupf.Case)
    result = schlupf.examples.pressure_table.solve(warn=False)
    assert result.normal.load == pytest.approx(70e3)
    with pytest.raises(AttributeError, match="steel_wheel_braking"):
        schlupf.examples.nothing


def test_an_example_is_a_new_case_each_time():
    case = schlupf.examples.steel_wheel_braking
    case.normal.load = 50e3
    assert schlupf.examples.steel_wheel_braking.normal.load == 80e3


def command(*arguments):
    run = [sys.executable, "-m", "schlupf", *arguments]
    return subprocess.run(run, capture_output=True, text=True, encoding="utf-8", check=False)


def test_the_command_is_in_the_wheel():
    small = ["--set", "grid.cells_x=10", "--set", "grid.cells_y=10"]
    run = command("solve", *small)
    assert run.returncode == 0
    assert "longitudinal force" in run.stdout
    run = command("solve", *small, "--set", "normal.load=80")
    assert run.returncode == 2
    assert "normal.load must be a force" in run.stderr
    assert command("--version").stdout.strip() == f"schlupf {schlupf.__version__}"
    assert command("solve", "--none").returncode == 2
    program = Path(sys.executable).with_name("schlupf")
    assert subprocess.run([program, "schema"], capture_output=True, check=True).stdout
