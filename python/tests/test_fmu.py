"""FMUs by FMPy: both standards, model exchange and co-simulation, rollback, derivatives, threads.

`cargo xtask python` builds the library beside the environment.
"""

import ctypes
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import fmpy
import numpy as np
import pytest
from conftest import wheel
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

import schlupf

PREFIX, SUFFIX = {"win32": ("", ".dll"), "darwin": ("lib", ".dylib")}.get(
    sys.platform, ("lib", ".so")
)
LIBRARY = Path(sys.prefix).parent / f"debug/{PREFIX}schlupf_c{SUFFIX}"
pytestmark = pytest.mark.skipif(not LIBRARY.exists(), reason="needs that of crates/schlupf-c")

R = 0.46
LOAD = 80e3
CASE = """
title = "FMU"
[kinematics]
speed = "20 m/s"
creepage_x = 0
[normal]
load = "80 kN"
[solver]
method = "shen-hedrick-elkins"
[friction]
model = "constant"
coefficient = 0.3
"""
DISCARD = 2


def write(folder: Path, version: int, *options: str, text: str = CASE) -> str:
    """An FMU of a case."""
    case, output = folder / "case.toml", folder / f"contact{version}.fmu"
    case.write_text(text, encoding="utf-8")
    command = [Path(sys.executable).with_name("schlupf"), "fmu", case, "--output", output]
    command += ["--fmi", str(version), "--library", LIBRARY, "--quiet"]
    command += [part for option in options for part in ("--set", option)]
    subprocess.run(command, check=True)
    fmpy.extract(output, output.with_suffix(""))
    return str(output)


@pytest.fixture(scope="module")
def fmus(tmp_path_factory) -> dict[tuple[int, bool], str]:
    """FMUs of both standards, with memory and without."""
    return {
        (version, memory): write(
            tmp_path_factory.mktemp("fmu"), version, f"element.memory={str(memory).lower()}"
        )
        for version in (2, 3)
        for memory in (True, False)
    }


class Unit:
    """What the tests need of an instance, whatever the standard."""

    def __init__(self, fmu: str, cosimulation: bool, token: str | None = None):
        description = fmpy.read_model_description(fmu)
        self.version = int(description.fmiVersion[0])
        kinds = {2: (FMU2Model, FMU2Slave), 3: (FMU3Model, FMU3Slave)}[self.version]
        self.references = {v.name: v.valueReference for v in description.modelVariables}
        self.names = [v.name for v in description.modelVariables]
        self.variables = {v.name: v for v in description.modelVariables}
        self.fmu = kinds[cosimulation](
            guid=token or description.guid or description.instantiationToken,
            unzipDirectory=str(Path(fmu).with_suffix("")),
            modelIdentifier="schlupf",
            instanceName="contact",
        )
        self.fmu.instantiate()
        if self.version == 2:
            self.fmu.setupExperiment(startTime=0.0)
        self.fmu.enterInitializationMode()

    def begin(self) -> None:
        self.fmu.exitInitializationMode()

    def set(self, **values: float) -> None:
        references = [self.references[name] for name in values]
        of_type = "Real" if self.version == 2 else "Float64"
        getattr(self.fmu, f"set{of_type}")(references, list(values.values()))

    def get(self, *names: str) -> np.ndarray:
        references = [self.references[name] for name in names]
        of_type = "Real" if self.version == 2 else "Float64"
        return np.array(getattr(self.fmu, f"get{of_type}")(references))

    def step(self, time: float, duration: float) -> None:
        self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=duration)

    def derivative(self, unknowns: list[str], known: str) -> np.ndarray:
        unknowns = [self.references[name] for name in unknowns]
        return np.array(
            self.fmu.getDirectionalDerivative(unknowns, [self.references[known]], [1.0])
        )

    def save(self):
        return self.fmu.getFMUState() if self.version == 3 else self.fmu.getFMUstate()

    def restore(self, state) -> None:
        (self.fmu.setFMUState if self.version == 3 else self.fmu.setFMUstate)(state)

    def serialize(self, state) -> bytes:
        if self.version == 3:
            return self.fmu.serializeFMUState(state)
        return self.fmu.serializeFMUstate(state)

    def deserialize(self, data: bytes):
        if self.version == 3:
            return self.fmu.deserializeFMUState(data)
        return self.fmu.deSerializeFMUstate(data)

    def free_state(self, state) -> None:
        (self.fmu.freeFMUState if self.version == 3 else self.fmu.freeFMUstate)(state)


@contextmanager
def unit(fmu: str, cosimulation: bool):
    """An instance that is freed."""
    one = Unit(fmu, cosimulation)
    yield one
    one.fmu.terminate()
    one.fmu.freeInstance()


BOTH = pytest.mark.parametrize("version", [2, 3])


@BOTH
@pytest.mark.parametrize("memory", [True, False])
def test_the_validator_has_no_complaints(fmus, version, memory):
    assert validate_fmu(fmus[version, memory]) == []


@BOTH
def test_both_uses_give_the_same_over_any_steps(fmus, version):
    """A wheel that slides at 1 %: model exchange by CVode, co-simulation by steps of one size and
    of others. Inputs are constant, so that steps are exact."""
    outputs = ["force_x", "elastic_shift_x"]
    fmu = fmus[version, True]
    start = {"velocity_x": 20.0, "angular_velocity": 20.2 / R}
    # The relaxation lengths are some 5 mm.
    options = {"stop_time": 1e-3, "output": outputs, "start_values": start}
    options["output_interval"] = 1e-5
    exchange = fmpy.simulate_fmu(
        fmu, fmi_type="ModelExchange", solver="CVode", relative_tolerance=1e-8, **options
    )
    coupled = fmpy.simulate_fmu(fmu, fmi_type="CoSimulation", **options)
    limit = 0.3 * LOAD
    assert np.ptp(coupled["force_x"]) > 0.5 * limit
    assert np.allclose(exchange["time"], coupled["time"])
    assert np.abs(exchange["force_x"] - coupled["force_x"]).max() < 1e-5 * limit
    random = np.random.default_rng(3)
    steps = random.uniform(0.1, 1.0, 30)
    steps *= 1e-3 / steps.sum()
    with unit(fmu, True) as one:
        one.set(**start)
        one.begin()
        time = 0.0
        for duration in steps:
            one.step(time, duration)
            time += duration
        # Steps of the shift are of second order.
        assert one.get(*outputs) == pytest.approx([coupled[name][-1] for name in outputs], rel=1e-5)
        assert one.get("time") == pytest.approx([1e-3])


@BOTH
def test_outputs_are_those_of_the_case(fmus, version):
    """Without memory at 20 m/s: forces of `schlupf.forces` to (v_s/V)²."""
    case = schlupf.Case.from_toml(CASE)
    exact = schlupf.forces(case, creepage_x=0.002, creepage_y=0.001, spin=0.1, load=60e3)
    with unit(fmus[version, False], False) as one:
        one.begin()
        one.set(velocity_x=20.02, velocity_y=0.02, spin_rate=2.0, angular_velocity=19.98 / R)
        one.set(load=60e3)
        names = ["force_x", "force_y", "moment_z"]
        found = one.get(*names)
        assert found == pytest.approx([float(exact[name]) for name in names], rel=1e-6)
        one.set(load=-1.0)
        assert not one.get(*names).any()


@BOTH
@pytest.mark.parametrize("side", ["left", "right"])
def test_a_wheel_is_that_of_its_table(contacts, tmp_path, version, side):
    """The table travels with the FMU."""
    case = wheel(side, element={"contact_table": contacts[0]})
    element = schlupf.element(case)
    moved = {"lateral_position": 1e-3, "wheelset_yaw_angle": 5e-4}
    expected = element.evaluate(element.array(**moved))
    yaw = [signal.name for signal in element.inputs].index("wheelset_yaw_angle")
    names = [signal.name for signal in element.outputs]
    with unit(write(tmp_path, version, text=case.to_toml(tmp_path)), False) as one:
        one.begin()
        one.set(**moved)
        assert np.array_equal(one.get(*names), expected.outputs)
        slopes = one.derivative(names, "wheelset_yaw_angle")
        assert np.array_equal(slopes, expected.derivatives[:, yaw])


@BOTH
@pytest.mark.parametrize("cosimulation", [False, True])
def test_rollback_repeats_bit_for_bit(fmus, version, cosimulation):
    """State saved, restored after other steps, and through bytes in another instance."""
    fmu = fmus[version, True]

    def go_on(one: Unit) -> list[float]:
        if cosimulation:
            for k in range(5):
                one.set(angular_velocity=(20.1 + 0.05 * k) / R)
                one.step(k * 1e-4, 1e-4)
        return [*one.get(*one.names)]

    with unit(fmu, cosimulation) as one, unit(fmu, cosimulation) as other:
        one.set(elastic_shift_x=1e-5)
        one.begin()
        one.set(velocity_x=19.9)
        saved = one.save()
        first = go_on(one)
        one.set(load=1e3, velocity_y=1.0)
        one.restore(saved)
        assert go_on(one) == first
        data = one.serialize(saved)
        elsewhere = other.deserialize(data)
        other.restore(elsewhere)
        assert go_on(other) == first
        for state, owner in ((saved, one), (elsewhere, other)):
            owner.free_state(state)


@BOTH
def test_directional_derivatives_are_those_of_differences(fmus, version):
    with unit(fmus[version, True], False) as one:
        one.set(elastic_shift_x=1e-5, elastic_shift_y=-5e-6, elastic_turn=5e-4)
        start = one.names.index("velocity_x")
        inputs = one.names[start : start + 8]
        states = [name for name in one.names if name.startswith("elastic")]
        unknowns = [n for n in one.names[1:] if n not in inputs + states]
        one.set(velocity_x=20.03, velocity_y=0.02, spin_rate=0.5, angular_velocity=20 / R)
        for known in inputs + states:
            value = one.get(known)[0]
            nominal = one.variables[known].nominal or 1.0
            size = float(nominal) if known in states else max(abs(value), 0.1)
            step = 1e-5 * size
            sides = []
            for moved in (value + step, value - step):
                one.set(**{known: moved})
                sides.append(one.get(*unknowns))
            one.set(**{known: value})
            scale = np.abs(sides[0]) / step
            difference = (sides[0] - sides[1]) / (2 * step)
            found = one.derivative(unknowns, known)
            assert np.all(np.abs(found - difference) < 1e-4 * np.abs(difference) + 1e-10 * scale)
        one.begin()


@BOTH
def test_what_is_not_finite_is_discarded(fmus, version):
    """No crash, no exception of the library: the step does not happen, and may be tried again."""
    with unit(fmus[version, True], True) as one:
        one.begin()
        one.set(velocity_x=float("nan"))
        for act in (lambda: one.step(0.0, 1e-3), lambda: one.get("force_x")):
            with pytest.raises(FMICallException) as refused:
                act()
            assert refused.value.status == DISCARD
        assert one.get("time") == 0.0
        one.set(velocity_x=20.0)
        one.step(0.0, 1e-3)
        assert one.get("time") == 1e-3


@BOTH
def test_wrong_calls_are_errors(fmus, version):
    with pytest.raises(Exception, match="instantiate"):
        Unit(fmus[version, True], True, token="another")
    with unit(fmus[version, True], True) as one:
        one.begin()
        assert one.get("force_x") == 0.0
        for name in ("force_x", "elastic_turn", "time"):
            with pytest.raises(FMICallException):
                one.set(velocity_x=float("nan"), **{name: 1.0})
        with pytest.raises(FMICallException):
            one.get("force_x")
        one.set(velocity_x=20.0)
        for duration in (-1.0, float("inf")):
            with pytest.raises(FMICallException):
                one.step(0.0, duration)


@BOTH
def test_instances_run_on_threads(fmus, version, monkeypatch):
    """Eight instances at a time, each with its own inputs, as one after the other."""
    # FMPy changes the working directory while it loads a library, and threads leave it so.
    monkeypatch.chdir(Path.cwd())

    def run(slip: float) -> float:
        with unit(fmus[version, True], True) as one:
            one.begin()
            for k in range(2000):
                one.set(velocity_x=20.0, angular_velocity=(20.0 + slip * k / 2000) / R)
                one.step(k * 1e-5, 1e-5)
            return one.get("force_x")[0]

    slips = np.linspace(-0.04, 0.04, 8)
    with ThreadPoolExecutor(8) as pool:
        at_once = list(pool.map(run, slips))
    assert at_once == [run(slip) for slip in slips]
    assert len(set(at_once)) == 8


MASS, INERTIA = LOAD / 9.81, 60.0


def torque(time: float) -> float:
    """A brake that is applied within 0.2 s, on one wheel."""
    return -6e3 * min(time / 0.2, 1.0)


def braked(one: Unit, start: list[float], options: dict) -> np.ndarray:
    """Forward and angular velocity after 1 s, with forces and derivatives of an instance."""
    states = [name for name in one.names if name.startswith("elastic")]
    unknowns = ["force_x", *(f"der({name})" for name in states)]
    knowns = ["velocity_x", "angular_velocity", *states]

    def give(motion):
        one.set(velocity_x=motion[0], angular_velocity=motion[1])
        values = (ctypes.c_double * len(states))(*motion[2:])
        one.fmu.setContinuousStates(values, len(states))

    def rates(time, motion):
        give(motion)
        force, *moving = one.get(*unknowns)
        return [force / MASS, (torque(time) - R * force) / INERTIA, *moving]

    def jacobian(time, motion):
        give(motion)
        force, *moving = np.transpose([one.derivative(unknowns, known) for known in knowns])
        return np.vstack([force / MASS, -R * force / INERTIA, *moving])

    begin = [*start, *[0.0] * len(states)]
    found = solve_ivp(rates, (0.0, 1.0), begin, jac=jacobian, **options)
    assert found.success
    return found.y[:2, -1]


def test_a_braked_wheel_is_that_of_the_same_equations(fmus):
    """One forward and one torsional degree of freedom, 1 s: with forces of the FMU and Jacobians
    from its directional derivatives, and with `schlupf.forces` and differences. With memory, the
    wheel is the same after the transient."""
    case = schlupf.Case.from_toml(CASE)

    def reference(time, motion):
        forward, turning = motion
        slip, speed = forward - R * turning, (forward + R * turning) / 2
        creepage = slip / np.hypot(speed, 0.01)
        force = float(schlupf.forces(case, creepage_x=creepage, load=LOAD, warn=False).force_x)
        return [force / MASS, (torque(time) - R * force) / INERTIA]

    start = [20.0, 20.0 / R]
    options = {"method": "BDF", "rtol": 1e-7, "atol": 1e-8}
    exact = solve_ivp(reference, (0.0, 1.0), start, **options).y[:, -1]
    assert exact[0] - R * exact[1] > 0.005

    for memory, allowed in ((False, 1e-5), (True, 1e-4)):
        with unit(fmus[2, memory], False) as one:
            one.begin()
            found = braked(one, start, options)
        assert found == pytest.approx(exact, rel=allowed)


def run_page(name: str) -> dict:
    """The names that the code of a page defines."""
    page = Path(__file__).parents[2] / "docs" / name
    cells = r"```(?:python|{code-cell} python)\n(.*?)```"
    code = re.findall(cells, page.read_text(encoding="utf-8"), re.DOTALL)
    names: dict = {}
    exec("\n".join(code), names)
    return names


def test_a_wheelset_is_the_same_in_all_programs(monkeypatch):
    """Hunting: through Python, C and FMUs, with one integrator, to the last bit, since all do the
    same operations; in exudyn but for its finite rotations, whose square is below 1e-5."""
    monkeypatch.setenv("SCHLUPF_LIBRARY", str(LIBRARY))
    names = run_page("simulation/hunting.md")
    found = names["found"]
    assert np.abs(found["Python"]).max() > 4e-3
    for name, allowed in {"C": 0.0, "FMU": 0.0, "exudyn": 1e-5 * 5e-3}.items():
        assert np.abs(found[name] - found["Python"]).max() <= allowed
    assert np.abs(names["ours"].y[2]).max() ** 2 < 1e-5


def test_the_page_runs(tmp_path, monkeypatch):
    """What docs/recipes/fmu.md shows."""
    write(tmp_path, 2)
    (tmp_path / "contact2.fmu").rename(tmp_path / "contact.fmu")
    monkeypatch.chdir(tmp_path)
    names = run_page("recipes/fmu.md")
    assert names["result"]["force_x"][-1] == pytest.approx(-0.3 * LOAD, rel=0.2)
