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


def wheel(side="left", **sections):
    """S1002 on 60E1 canted 1:40, under 50 kN."""
    given = {
        "normal": {"model": "wheel-rail", "load": "50 kN"},
        "wheel": {"profile": "S1002", "radius_x": "460 mm"},
        "rail": {"profile": "60E1", "cant": 0.025},
        "wheelset": {"side": side},
        "kinematics": {"speed": "20 m/s"},
        "friction": {"model": "constant", "coefficient": 0.3},
        "solver": {"method": "table"},
    }
    return schlupf.Case(**given | sections)


@pytest.fixture(scope="session")
def contacts(tmp_path_factory):
    """A table of few nodes, and its errors."""
    path = tmp_path_factory.mktemp("contacts") / "new" / "contacts.npz"
    angles = {"largest_roll_angle": "5 mrad", "largest_yaw_angle": 0.01}
    with pytest.warns(schlupf.SchlupfWarning, match=r"contacts\.npz is not within the tolerance"):
        errors = schlupf.contact_table(wheel(), path, **angles, most_nodes=1, poses=20)
    return path, errors


@pytest.fixture(autouse=True)
def close_figures():
    """No figure outlives its test."""
    yield
    import matplotlib.pyplot as plt

    plt.close("all")
