"""Look-up tables from Python: forces, derivatives, standstill, files."""

import numpy as np
import pytest

import schlupf


def test_forces_are_those_of_the_method():
    """`solver.method = "table"` has the same forces, in the same units."""
    case = schlupf.Case(
        normal={"model": "ellipse", "semi_axis_x": "6 mm", "semi_axis_y": "4 mm", "load": "80 kN"},
        friction={"model": "constant", "coefficient": 0.3},
        kinematics={"creepage_x": 0.001, "creepage_y": -0.0005, "spin": "0.3 1/m"},
        solver={"method": "table"},
    )
    result = case.solve()
    found = schlupf.LookUpTable().forces(6e-3, 4e-3, 24e3, 0.001, -0.0005, 0.3)
    expected = [result.force.x, result.force.y, result.force.moment_z]
    assert found.force == pytest.approx(expected, rel=1e-4)
    assert found.in_range


def test_derivatives_are_those_of_differences():
    """Central differences, over steps of 0.1 % of the creepages."""
    table = schlupf.LookUpTable()
    at = np.array([0.001, -0.0005, 0.3])
    found = table.forces(6e-3, 4e-3, 24e3, *at)
    for k in range(3):
        step = np.zeros(3)
        step[k] = 1e-3 * abs(at[k])
        plus = table.forces(6e-3, 4e-3, 24e3, *(at + step)).force
        minus = table.forces(6e-3, 4e-3, 24e3, *(at - step)).force
        difference = (plus - minus) / (2.0 * step[k])
        scale = np.abs(found.derivatives[:, k]).max()
        assert np.abs(found.derivatives[:, k] - difference).max() < 2e-3 * scale


def test_arrays_broadcast_and_are_flagged_outside():
    table = schlupf.LookUpTable()
    low, high = table.axis_ratios
    ratios = np.array([[0.5 * low], [1.0], [2.0 * high]])
    found = table.normalised(ratios, creepage_x=np.linspace(0.0, 1.0, 5))
    assert found.force.shape == (3, 5, 3)
    assert found.derivatives.shape == (3, 5, 3, 3)
    assert found.in_range.tolist() == [[False] * 5, [True] * 5, [False] * 5]
    assert np.hypot(found.force[..., 0], found.force[..., 1]).max() <= 1.0 + 1e-12


def test_standstill_has_finite_derivatives():
    table = schlupf.LookUpTable()
    slip = (np.array([0.0, 1e-9, 0.5]), 0.0, 0.0)
    found = table.standstill_forces(6e-3, 4e-3, 24e3, slip, speed=0.0, standstill_speed=0.01)
    assert np.isfinite(found.derivatives).all()
    assert (found.force[0] == 0.0).all()
    assert found.force[2, 0] == pytest.approx(-24e3, rel=1e-3)
    ahead, still, back = (
        table.standstill_forces(6e-3, 4e-3, 24e3, (0.0, 0.0, 2.0), speed, 0.01).force
        for speed in (5.0, 0.0, -5.0)
    )
    np.testing.assert_allclose(back, ahead * [-1.0, -1.0, 1.0], atol=1e-6)
    assert abs(ahead[1]) > 1e3 > 1e-6 > abs(still[1])
    rolling = table.standstill_forces(6e-3, 4e-3, 24e3, (0.02, 0.01, 4.0), 20.0, 0.01)
    plain = table.forces(6e-3, 4e-3, 24e3, 1e-3, 5e-4, 0.2)
    assert rolling.force == pytest.approx(plain.force, rel=1e-5)
    assert rolling.derivatives == pytest.approx(plain.derivatives / 20.0, rel=1e-4, abs=1e-6)


def test_files_that_are_no_tables_are_refused(tmp_path):
    with pytest.raises(FileNotFoundError):
        schlupf.LookUpTable(tmp_path / "missing.npz")
    other = tmp_path / "other.npz"
    np.savez(other, a=np.zeros(3))
    with pytest.raises(ValueError, match=r"other\.npz must be a look-up table"):
        schlupf.LookUpTable(other)
    with pytest.raises(ValueError, match="friction_limit must be above 0"):
        schlupf.LookUpTable().forces(6e-3, 4e-3, 0.0)
    with pytest.raises(ValueError, match="standstill_speed must be above 0"):
        schlupf.LookUpTable().standstill_forces(6e-3, 4e-3, 1.0, (0.0, 0.0, 0.0), 0.0, 0.0)
