"""The force element: arrays in, arrays out."""

import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import schlupf

FAST = {"solver": {"method": "polach"}, "friction": {"model": "constant"}}


def test_forces_are_those_of_the_case():
    case = schlupf.Case(
        **FAST,
        kinematics={"creepage_x": 0.002, "spin": 0.2, "speed": 20.0},
        element={"motion": "creepages", "memory": False},
    )
    element = schlupf.element(case)
    found = element.evaluate(element.array())
    names = [signal.name for signal in element.outputs]
    exact = case.solve()
    assert found.outputs[names.index("force_x")] == pytest.approx(exact.force.x, rel=1e-9)
    assert found.outputs[names.index("force_y")] == pytest.approx(exact.force.y, rel=1e-9)
    assert found.status == schlupf.Status.CONVERGED


def test_derivatives_by_inputs_and_states():
    element = schlupf.element(schlupf.Case(**FAST))
    inputs = element.array(velocity_x=20.02, velocity_y=0.01, angular_velocity=43.4)
    states = np.array([1e-5, -5e-6, 1e-3])
    found = element.evaluate(inputs, states)
    for k, step in enumerate([1e-6, 1e-6, 1e-5, 1e-6, 1.0, 1e-5, 1e-3, 1e-3]):
        moved = np.array([inputs, inputs])
        moved[:, k] += [step, -step]
        both = element.evaluate(moved, states)
        for of in (both.outputs, both.rates):
            difference = (of[0] - of[1]) / (2 * step)
            start = 0 if of is both.outputs else len(element.outputs)
            exact = found.derivatives[start : start + difference.size, k]
            assert exact == pytest.approx(difference, rel=1e-4, abs=1e-4 * abs(difference).max())


def test_rows_are_those_one_by_one_on_any_number_of_threads():
    element = schlupf.element(schlupf.Case(**FAST))
    random = np.random.default_rng(1)
    inputs = element.array(
        velocity_x=random.uniform(-1, 30, 3000),
        angular_velocity=random.uniform(-1, 70, 3000),
        load=random.uniform(-1e3, 100e3, 3000),
    )
    states = random.uniform(-1e-5, 1e-5, (3000, 3))
    rows = element.evaluate(inputs, states)
    for k in range(0, 3000, 97):
        one = element.evaluate(inputs[k], states[k])
        assert np.array_equal(one.outputs, rows.outputs[k])
        assert np.array_equal(one.derivatives, rows.derivatives[k])
    plain = element.evaluate(inputs, states, derivatives=False)
    assert np.array_equal(plain.rates, rows.rates) and plain.derivatives.size == 0
    with ThreadPoolExecutor(8) as pool:
        again = list(pool.map(lambda _: element.evaluate(inputs, states), range(8)))
    assert all(np.array_equal(found.outputs, rows.outputs) for found in again)


def test_nothing_in_a_loop_raises():
    element = schlupf.element(schlupf.Case(**FAST))
    inputs = element.array(velocity_x=[10.0, np.nan, 10.0], load=[80e3, 80e3, 0.0])
    found = element.evaluate(inputs)
    assert [schlupf.Status(k).text for k in found.status] == [
        "converged",
        "not-finite",
        "no-contact",
    ]
    assert np.isnan(found.outputs[1]).all() and (found.outputs[2, :2] == 0.0).all()
    states = element.advance(inputs, np.zeros((3, 3)), 0.1)
    assert np.isnan(states[1]).all() and np.isfinite(states[[0, 2]]).all()


def test_what_a_method_neglects_is_a_warning():
    """Polach's method takes friction that falls with temperature as cold; the solver does not."""
    case = schlupf.Case(solver={"method": "polach"})
    with pytest.warns(schlupf.warnings.ColdFrictionWarning, match="temperature of the entering"):
        made = schlupf.element(case)
    assert [code for code, _, _ in made.messages] == ["cold-friction"]
    assert schlupf.element(case, warn=False).messages == made.messages
    assert schlupf.element(schlupf.Case(friction={"model": "constant"})).messages == []


def test_wrong_shapes_and_names_are_named():
    element = schlupf.element(schlupf.Case(**FAST))
    with pytest.raises(TypeError, match="no input 'lod'; there are velocity_x"):
        element.array(lod=1.0)
    with pytest.raises(TypeError, match="load must be numbers in N, but is '80 kN'"):
        element.array(load="80 kN")
    with pytest.raises(ValueError, match="rows of inputs and states must broadcast"):
        element.evaluate(np.zeros((3, 8)), np.zeros((2, 3)))
    for fields in ({"kinematics": {"force_x": "-5 kN"}}, {"history": {"time": [0.0, 1.0]}}):
        method = {} if "history" in fields else FAST
        with pytest.raises(schlupf.CaseError, match="force element"):
            schlupf.element(schlupf.Case(**method, **fields))
    with pytest.raises(ValueError, match="last axis of inputs must have 8 entries"):
        element.evaluate(np.zeros(7))
    with pytest.raises(ValueError, match="last axis of states must have 3 entries"):
        element.evaluate(element.array(), np.zeros(2))
    with pytest.raises(schlupf.CaseError, match="solver.method|normal"):
        schlupf.element(
            schlupf.Case(**FAST, normal={"model": "ellipse"}, element={"normal": "approach"})
        )


def test_it_can_be_pickled():
    element = schlupf.element(schlupf.Case(**FAST))
    again = pickle.loads(pickle.dumps(element))
    inputs = element.array(velocity_x=10.0)
    assert np.array_equal(again.evaluate(inputs).outputs, element.evaluate(inputs).outputs)


def test_it_does_not_change_with_the_case():
    case = schlupf.Case(**FAST)
    element = schlupf.element(case)
    inputs = element.array(velocity_y=1.0)
    states = element.advance(inputs, np.zeros(3), 1.0)
    before = element.evaluate(inputs, states).outputs
    case.friction.coefficient = 0.1
    again = pickle.loads(pickle.dumps(element))
    assert np.array_equal(again.evaluate(inputs, states).outputs, before)


def test_a_full_solution_is_an_element_too():
    case = schlupf.Case(
        grid={"cells_x": 8, "cells_y": 8},
        heat={"model": "none"},
        element={"motion": "creepages", "memory": False},
        kinematics={"creepage_x": 0.001},
    )
    found = (element := schlupf.element(case)).evaluate(element.array())
    assert found.outputs[0] == pytest.approx(case.solve().force.x, rel=1e-5)
