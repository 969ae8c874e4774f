"""What the tests share."""

import matplotlib
import pytest
from hypothesis import settings

import schlupf

matplotlib.use("agg")

# No files of its own.
settings.register_profile("plain", database=None, deadline=None)
settings.load_profile("plain")

COARSE = {"cells_x": 12, "cells_y": 12}


@pytest.fixture
def case() -> schlupf.Case:
    """Braking on a coarse grid."""
    return schlupf.Case(grid=COARSE, kinematics={"creepage_x": 0.002, "creepage_y": 0.001})


@pytest.fixture(scope="session")
def result() -> schlupf.Result:
    """The solution of such a case."""
    return schlupf.Case(grid=COARSE, kinematics={"creepage_x": 0.002, "creepage_y": 0.001}).solve()


@pytest.fixture(autouse=True)
def close_figures():
    """No figure outlives its test."""
    yield
    import matplotlib.pyplot as plt

    plt.close("all")
