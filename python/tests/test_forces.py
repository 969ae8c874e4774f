"""Forces under many conditions: values, shapes, threads, interrupts, memory."""

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import schlupf

POLACH = schlupf.Case(friction={"model": "constant"}, solver={"method": "polach"})


def test_conditions_are_broadcast_as_in_numpy():
    creepage = np.array([[0.0], [0.001], [0.01]])
    table = schlupf.forces(POLACH, creepage_x=creepage, load=[60e3, 80e3])
    assert table["force_x"].shape == (3, 2)
    assert table["force_x"].dims == ("creepage_x", "normal_load")
    assert float(table.creepage_x[2]) == 0.01 and float(table.normal_load[0]) == 60e3
    for i in range(3):
        for j in range(2):
            case = POLACH.with_(
                kinematics={"creepage_x": creepage[i, 0]}, normal={"load": [60e3, 80e3][j]}
            )
            alone = case.solve(warn=False)
            assert float(table["force_x"][i, j]) == pytest.approx(
                alone.force.x, rel=1e-12, abs=1e-9
            )
    assert bool(np.isnan(table["moment_z"]).all())
    assert int(table["status"].sum()) == 0


def test_a_force_in_place_of_its_creepage():
    case = schlupf.Case(
        grid={"cells_x": 12, "cells_y": 12},
        contact_law={"model": "coulomb"},
        friction={"model": "constant"},
        kinematics={"force_x": -20e3},
    )
    result = case.solve()
    assert result.force.x == pytest.approx(-20e3, rel=1e-4)
    assert result.kinematics.creepage_x > 0
    table = schlupf.forces(case, kinematics__force_x=[-10e3, -20e3])
    np.testing.assert_allclose(table["force_x"], [-10e3, -20e3], rtol=1e-4)
    with pytest.raises(schlupf.CaseError, match=r"kinematics\.force_x"):
        schlupf.forces(case, creepage_x=[0.001, 0.002])
    with pytest.raises(schlupf.CaseError, match=r"kinematics\.force_x"):
        case.with_(kinematics={"creepage_x": 0.001}).solve()


def test_a_condition_is_given_once():
    with pytest.raises(TypeError, match="must be given once"):
        schlupf.forces(POLACH, load=60e3, normal__load=70e3)


def test_data_arrays_are_broadcast_by_name():
    creepages = [0.001, 0.002]
    creepage = xr.DataArray(creepages, dims="creepage_x", coords={"creepage_x": creepages})
    load = xr.DataArray([60e3, 70e3, 80e3], dims="load", coords={"load": [60e3, 70e3, 80e3]})
    table = schlupf.forces(POLACH, creepage_x=creepage, load=load)
    assert table["force_x"].dims == ("creepage_x", "normal_load")
    single = schlupf.forces(POLACH, creepage_x=0.002, load=70e3)
    chosen = table["force_x"].sel(creepage_x=0.002, normal_load=70e3)
    assert float(chosen) == pytest.approx(float(single["force_x"]), rel=1e-12)


def test_a_series_without_names_is_an_array():
    series = pd.Series([0.001, 0.002], index=["a", "b"])
    xr.testing.assert_identical(
        schlupf.forces(POLACH, creepage_x=series), schlupf.forces(POLACH, creepage_x=[0.001, 0.002])
    )


def test_the_full_method_gives_what_single_solutions_give(case):
    creepages = np.linspace(0.0005, 0.003, 5)
    table = schlupf.forces(case, creepage_x=creepages)
    alone = [case.with_(kinematics={"creepage_x": c}).solve().force.x for c in creepages]
    np.testing.assert_allclose(table["force_x"], alone, rtol=1e-4)
    assert not np.isnan(table["moment_z"]).any()


def test_other_numbers_of_the_case():
    table = schlupf.forces(POLACH, creepage_x=0.01, friction__coefficient=[0.2, 0.4])
    alone = [
        POLACH.with_(friction={"coefficient": mu}, kinematics={"creepage_x": 0.01})
        .solve(warn=False)
        .force.x
        for mu in (0.2, 0.4)
    ]
    np.testing.assert_allclose(table["force_x"], alone, rtol=1e-12)


def test_conditions_are_real_numbers():
    nothing = np.ma.masked_array([0.0, 0.5], [False, True])
    found = schlupf.forces(POLACH, creepage_x=nothing, warn=False)
    assert found["status"].values.tolist() == [schlupf.Status.CONVERGED, schlupf.Status.FAILED]
    for wrong in (np.array([10, 20], "timedelta64[ns]"), np.array([1j]), [None, 1j]):
        with pytest.raises(schlupf.CaseError, match="kinematics.speed must be"):
            schlupf.forces(POLACH, speed=wrong)


def test_wrong_conditions_are_named():
    with pytest.raises(TypeError, match="creep_x"):
        schlupf.forces(POLACH, creep_x=0.1)
    with pytest.raises(schlupf.CaseError, match="condition 1"):
        schlupf.forces(POLACH, strict=True, load=[1.0, np.nan])
    with pytest.raises(ValueError, match="broadcast"):
        schlupf.forces(POLACH, load=[1.0, 2.0], creepage_x=[0.0, 0.1, 0.2])


def test_a_solver_keeps_what_it_has_set_up(case):
    solver = schlupf.Solver(case)
    first = solver.solve(creepage_x=0.001)
    again = solver.solve(creepage_x=0.001)
    assert again.work.operator_products < first.work.operator_products
    assert again.force.x == pytest.approx(first.force.x, rel=1e-4)
    assert solver.solve(load=60e3).normal.load == 60e3
    assert solver.solve().normal.load == 80e3
    with pytest.raises(TypeError, match="creepage_x"):
        solver.solve(creep=1.0)


def test_two_solutions_at_once(case):
    expected = case.solve().force.x
    found = []
    solve = lambda: found.append(case.solve().force.x)  # noqa: E731
    threads = [threading.Thread(target=solve) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 4


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_an_interrupt_ends_a_long_run():
    program = """
        import signal
        import schlupf
        # A shell may have started the tests with this signal ignored.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        case = schlupf.Case(grid={"cells_x": 300, "cells_y": 300})
        print("ready", flush=True)
        try:
            case.curve(creepage_x=(0, 0.02), points=200)
        except KeyboardInterrupt:
            print("interrupted")
    """
    command = [sys.executable, "-c", textwrap.dedent(program)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "ready\n"
        time.sleep(1.0)
        process.send_signal(signal.SIGINT)
        start = time.monotonic()
        try:
            assert process.communicate(timeout=60)[0] == "interrupted\n"
        finally:
            process.kill()
    assert process.returncode == 0
    assert time.monotonic() - start < 30


@pytest.mark.skipif(sys.platform != "linux", reason="units of ru_maxrss")
def test_memory_stays_flat():
    import resource

    solver = schlupf.Solver(POLACH)

    def solve(count):
        for k in range(count):
            solver.solve(creepage_x=1e-6 * k, warn=False)

    solve(2000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    solve(10_000)
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < 8_000, f"{grown} KiB"


@pytest.mark.skipif(sys.platform != "linux", reason="units of ru_maxrss")
def test_memory_stays_flat_with_fields_and_many_conditions():
    import resource

    case = schlupf.Case(grid={"cells_x": 8, "cells_y": 8}, kinematics={"creepage_x": 0.002})
    creepages = np.linspace(0.0, 0.02, 10_000)

    def work(count):
        for _ in range(count):
            assert case.solve(warn=False).fields["pressure"].sizes["x"] > 8
            schlupf.forces(POLACH, creepage_x=creepages)

    work(20)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    work(300)
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < 8_000, f"{grown} KiB"


@pytest.mark.skipif("SCHLUPF_MANY_FORCES" not in os.environ, reason="`cargo xtask test` builds it")
def test_many_forces_take_as_long_as_in_rust():
    """A million forces in an array: processor time beside that of examples/many_forces.rs.

    What the kernel takes for new memory, up to a quarter, differs between the two and between
    machines; work of Python for each force would be many times all of it.
    """
    resource = pytest.importorskip("resource")
    rounds = 5
    creepages = np.linspace(0.0, 0.02, 1_000_000)

    def in_rust():
        subprocess.run([os.environ["SCHLUPF_MANY_FORCES"]], capture_output=True, check=True)

    def in_python():
        for _ in range(rounds):
            schlupf.forces(POLACH, creepage_x=creepages)

    def taken(work, who):
        before = resource.getrusage(who)
        work()
        after = resource.getrusage(who)
        return (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime) / rounds

    rust = min(taken(in_rust, resource.RUSAGE_CHILDREN) for _ in range(10))
    python = min(taken(in_python, resource.RUSAGE_SELF) for _ in range(10))
    print(f"a million forces: Rust {rust:.3f} s, Python {python:.3f} s of processor time")
    assert python <= 1.5 * rust


def test_the_speed_of_a_turning_wheel_changes_its_creepage():
    turning = POLACH.with_(kinematics={"angular_velocity": "64.7 rad/s"})
    with pytest.raises(schlupf.CaseError, match="angular_velocity determines|determines the long"):
        schlupf.forces(turning, creepage_x=[0.001, 0.002])
    forces = schlupf.forces(turning, speed=[29.0, 30.0])["force_x"].values
    alone = [turning.with_(kinematics={"speed": v}).solve(warn=False).force.x for v in (29.0, 30.0)]
    np.testing.assert_allclose(forces, alone, rtol=1e-9)


def test_the_order_of_loads_does_not_matter():
    loads, creepages = np.array([80e3, 60e3, 70e3]), np.linspace(0.0, 0.01, 4)
    one = schlupf.forces(POLACH, load=loads[:, None], creepage_x=creepages)["force_x"]
    other = schlupf.forces(POLACH, creepage_x=creepages[:, None], load=loads)["force_x"]
    np.testing.assert_array_equal(one.values, other.values.T)


def test_coordinates_that_do_not_fit_are_refused_before_the_work():
    creepage = xr.DataArray([0.001, 0.002], dims="t", coords={"t": [1, 2]})
    load = xr.DataArray([6e4, 8e4], dims="t", coords={"t": [2, 1]})
    with pytest.raises(ValueError, match="coordinates of the same dimension"):
        schlupf.forces(POLACH, creepage_x=creepage, load=load)
    with pytest.raises(ValueError, match="name of a result: force_x"):
        schlupf.forces(POLACH, creepage_x=creepage.drop_vars("t").rename(t="force_x"))


def test_a_solver_reads_units():
    solver = schlupf.Solver(POLACH)
    expected = solver.solve(load=60e3, warn=False).force.x
    assert solver.solve(load="60 kN", warn=False).force.x == expected
    with pytest.raises(schlupf.CaseError, match="load must be in N"):
        solver.solve(load=xr.DataArray(60.0, attrs={"units": "kN"}))


def test_a_warning_of_conditions_is_issued_once():
    linear = schlupf.Case(solver={"method": "kalker-linear"})
    with pytest.warns(schlupf.warnings.BeyondFrictionWarning) as caught:
        schlupf.forces(linear, creepage_x=[0.0, 1e-3, 0.02, 0.04])
    assert len(caught) == 1 and caught[0].filename == __file__
    assert "(2 of 4 conditions; worst: number 3)" in str(caught[0].message)


def test_conditions_have_units():
    expected = schlupf.forces(POLACH, load=[60e3, 80e3], creepage_x=0.002)["force_x"]
    ureg = pytest.importorskip("pint").UnitRegistry()
    for load in (ureg.Quantity([60.0, 80.0], "kN"), ["60 kN", "80 kN"]):
        found = schlupf.forces(POLACH, load=load, creepage_x=0.002)["force_x"]
        np.testing.assert_allclose(found, expected)
    kilo = xr.DataArray([60.0, 80.0], dims="load", attrs={"units": "kN"})
    with pytest.raises(schlupf.CaseError, match="load must be in N, but its attribute `units`"):
        schlupf.forces(POLACH, load=kilo)
    with pytest.raises(schlupf.CaseError, match="load must be given in N, but is"):
        schlupf.forces(POLACH, load=ureg.Quantity(1.0, "m"))
    with pytest.raises(ValueError, match="there must be conditions"):
        schlupf.forces(POLACH, creepage_x=[])


def test_a_path_is_the_field_of_the_case():
    ellipse = {"model": "ellipse", "semi_axis_x": 6e-3, "semi_axis_y": 5e-3, "load": 80e3}
    case = POLACH.with_(normal=ellipse, kinematics={"creepage_x": 0.002})
    found = schlupf.forces(case, normal__load=[20e3])["force_x"].item()
    assert found == pytest.approx(case.with_(normal={"load": 20e3}).solve(warn=False).force.x)
    with pytest.raises(schlupf.CaseError, match="grid.cells_x"):
        schlupf.forces(schlupf.Case(), grid__cells_x=[8.7])
