"""Tables of the contacts of a wheel, and the force element of that wheel."""

from __future__ import annotations

import json
import pickle
import signal
import subprocess
import sys
import textwrap
import time
import zipfile

import numpy as np
import pytest
from conftest import wheel

import schlupf


def element_of(path, side="left", **sections):
    return schlupf.element(wheel(side, element={"contact_table": path}, **sections))


@pytest.fixture(scope="module")
def element(contacts):
    return element_of(contacts[0])


def output(element, found, name):
    return found.outputs[..., [signal.name for signal in element.outputs].index(name)]


def test_errors_are_those_that_the_file_states(contacts):
    path, errors = contacts
    with zipfile.ZipFile(path) as archive:
        stated = json.loads(archive.read("metadata.json"))
    _places, rolls, yaws, _depths = np.load(path)["axes"]
    assert [path.name] == [file.name for file in path.parent.iterdir()]
    assert errors.poses == stated["poses"] > 10
    assert errors.is_within_tolerance is stated["is_within_tolerance"]
    assert errors.failed_nodes == stated["failed_nodes"]
    for spread, of in zip(errors[3:], stated["errors"], strict=True):
        assert spread._asdict() == {name: of[name] for name in spread._fields}
        assert 0.0 < spread.median <= spread.ninety_percent <= spread.largest
    assert -rolls[0] == pytest.approx(5e-3)
    assert yaws[1] * (stated["nodes"][2] - 1) == pytest.approx(0.01)


def test_a_wheel_carries_the_load_of_its_case(element):
    """At the height that the exact solution of the case finds, within the error of the table."""
    exact = wheel().solve(warn=False)
    found = element.evaluate(element.array())
    assert found.status == schlupf.Status.CONVERGED
    assert output(element, found, "wheel_force_z") == pytest.approx(50e3, rel=0.02)
    contact = exact.contacts[0]
    assert output(element, found, "contact_1.rail_position") == pytest.approx(
        contact.rail_position, abs=5e-5
    )
    assert output(element, found, "contact_1.contact_angle") == pytest.approx(
        contact.angle, abs=5e-4
    )
    assert exact.wheelset.height == element.array()[1]


def test_derivatives_are_those_of_differences(element):
    inputs = element.array(lateral_position=1.3e-3, wheelset_yaw_angle=8e-4, yaw_rate=0.01)
    at = element.evaluate(inputs)
    steps = dict.fromkeys((signal.name for signal in element.inputs), 1e-5)
    steps |= dict.fromkeys(("lateral_position", "wheelset_height"), 1e-8)
    steps |= dict.fromkeys(("rail_displacement_y", "rail_displacement_z"), 1e-8)
    steps |= dict.fromkeys(("roll_angle", "wheelset_yaw_angle"), 1e-7)
    steps |= dict.fromkeys(("wheel_bulk_temperature", "rail_bulk_temperature"), 1e-2)
    both = np.array(list(steps.values()))
    moved = element.evaluate(inputs + np.array([np.diag(both), -np.diag(both)])).outputs
    differences = (moved[0] - moved[1]).T / (2.0 * both)
    noise = 1e-6 * np.abs(at.outputs)[:, None] / both
    assert (np.abs(differences - at.derivatives) <= 2e-3 * np.abs(differences) + noise + 1e-9).all()


def test_wheels_of_an_array_are_those_one_by_one(element):
    random = np.random.default_rng(1)
    inputs = element.array(
        lateral_position=random.uniform(-6e-3, 6e-3, (30, 30)),
        wheelset_yaw_angle=random.uniform(-5e-3, 5e-3, (30, 30)),
        rail_displacement_z=random.uniform(-1e-4, 1e-4, (30, 30)),
    )
    rows = element.evaluate(inputs)
    assert rows.derivatives.shape == (30, 30, len(element.outputs), len(element.inputs))
    for k in range(0, 30, 7):
        one = element.evaluate(inputs[k, k])
        assert np.array_equal(one.outputs, rows.outputs[k, k])
        assert np.array_equal(one.derivatives, rows.derivatives[k, k])


def test_a_table_is_of_both_sides_and_can_be_pickled(contacts, element):
    right = pickle.loads(pickle.dumps(element_of(contacts[0], "right")))
    signs = [1, -1, 1, -1, 1, -1]
    forces = element.evaluate(element.array(lateral_position=1e-3)).outputs[:6]
    mirrored = right.evaluate(right.array(lateral_position=-1e-3)).outputs[:6]
    assert mirrored == pytest.approx(signs * forces, rel=1e-9)


def test_tables_of_others_are_refused(contacts, tmp_path):
    path = contacts[0]
    with pytest.raises(schlupf.CaseError, match=r"element\.contact_table.*contacts\.npz") as error:
        element_of(path, rail={"profile": "60E1", "cant": 0.05})
    assert error.value.field == "element.contact_table"
    with pytest.raises(schlupf.CaseError, match=r"element\.contact_table"):
        element_of(path, wheel={"profile": "S1002", "radius_x": "450 mm"})
    with pytest.raises(schlupf.CaseError, match="schlupf table CASE"):
        schlupf.element(wheel())
    (tmp_path / "other.npz").write_bytes(b"no table")
    with pytest.raises(schlupf.CaseError, match=r"other\.npz"):
        element_of(tmp_path / "other.npz")


def test_what_makes_no_table_is_told_first(tmp_path):
    path = tmp_path / "contacts.npz"
    with pytest.raises(schlupf.CaseError, match=r'normal\.model: .*"wheel-rail"'):
        schlupf.contact_table(schlupf.Case(), path)
    for name, wrong in {
        "largest_roll_angle": 1.0,
        "largest_yaw_angle": 0.0,
        "tolerance": 2.0,
    }.items():
        with pytest.raises(schlupf.CaseError, match=f"^{name} must be") as error:
            schlupf.contact_table(wheel(), path, **{name: wrong})
        assert error.value.field == name
    with pytest.raises(schlupf.CaseError, match="largest_yaw_angle must be .*5 mm"):
        schlupf.contact_table(wheel(), path, largest_yaw_angle="5 mm")
    with pytest.raises(ValueError, match="poses must be at least 1, but is 0"):
        schlupf.contact_table(wheel(), path, poses=0)
    with pytest.raises(ValueError, match=r"path must end in \.npz"):
        schlupf.contact_table(wheel(), tmp_path / "contacts.csv")
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(sys.platform == "win32", reason="signals differ")
def test_ctrl_c_leaves_no_file(tmp_path):
    program = f"""
        import signal, sys
        sys.path.insert(0, {str(__file__.rpartition("/")[0])!r})
        import schlupf
        from conftest import wheel
        signal.signal(signal.SIGINT, signal.default_int_handler)
        case = wheel()
        print("ready", flush=True)
        try:
            schlupf.contact_table(case, {str(tmp_path / "contacts.npz")!r})
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
    assert time.monotonic() - start < 30
    assert not list(tmp_path.iterdir())
