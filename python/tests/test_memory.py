"""Memory of many conditions, each in a process of its own: a peak is that of a process."""

import subprocess
import sys

import pytest

#: Most memory that a million values of a field take, in bytes.
MOST = 200e6

SCRIPT = """
import sys
import warnings

import numpy as np

import schlupf

warnings.simplefilter("ignore")
kind, field, start, end, few, many, method = sys.argv[1:]
grid = {"cells_x": 4, "cells_y": 4}
case = schlupf.Case(friction={"model": "constant"}, solver={"method": method}, grid=grid)


def peak():
    lines = open("/proc/self/status").read().splitlines()
    return 1024 * int(next(line.split()[1] for line in lines if line.startswith("VmHWM")))


def run(count):
    values = np.linspace(float(start), float(end), int(count))
    if kind == "forces":
        schlupf.forces(case, **{field: values})
    else:
        schlupf.study(case, **{kind: {field: values}})


run(few)
before = peak()
run(many)
print(peak() - before)
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the peak is that of Linux")
@pytest.mark.parametrize(
    ("field", "ends", "counts", "method"),
    [
        # What a solver takes as it is.
        ("creepage_x", (0.0, 0.01), (1000, 1_000_000), "polach"),
        ("load", (50e3, 90e3), (1000, 1_000_000), "polach"),
        # Each value is a case of its own: the growth with the number counts.
        ("friction__coefficient", (0.1, 0.5), (10_000, 30_000), "polach"),
        ("wheel__radius_x", (0.4, 0.5), (10_000, 30_000), "polach"),
        ("friction__coefficient", (0.1, 0.5), (2000, 42_000), "full"),
    ],
)
def test_a_million_values_of_a_field_take_little(field, ends, counts, method):
    assert growth("forces", field, ends, counts, method) * 1e6 / (counts[1] - counts[0]) < MOST


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the peak is that of Linux")
@pytest.mark.parametrize("design", ["vary", "states"])
def test_a_study_of_a_million_rows_takes_little(design):
    counts = (1000, 1_000_000)
    assert growth(design, "kinematics.creepage_x", (0.0, 0.01), counts, "polach") < MOST


def growth(kind, field, ends, counts, method):
    """How much more memory (in bytes) the second number of values takes than the first."""
    arguments = [kind, field, *map(str, ends), *map(str, counts), method]
    found = subprocess.run(
        [sys.executable, "-c", SCRIPT, *arguments], capture_output=True, text=True, check=True
    )
    return int(found.stdout)
