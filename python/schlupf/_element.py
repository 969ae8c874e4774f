"""The force element: a contact inside a simulation."""

from __future__ import annotations

from copy import copy
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from . import _core
from ._errors import quoted
from ._status import OF_ELEMENT
from ._units import is_quantity, magnitude
from .warnings import emit

if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import ArrayLike, NDArray

    from ._case import Case


class Signal(NamedTuple):
    """An input, output or state of an element."""

    name: str
    #: SI unit, temperatures in degC; empty if dimensionless.
    unit: str
    doc: str


class Evaluation(NamedTuple):
    """What an element finds, the signals along the last axis of each array."""

    #: Outputs.
    outputs: NDArray[np.float64]
    #: Rates of the states.
    rates: NDArray[np.float64]
    #: Of outputs and, after them, rates (the axis before the last) by inputs and, after them,
    #: states; empty where they were not wanted.
    derivatives: NDArray[np.float64]
    #: Numbers of `schlupf.Status`; 0 where forces were found.
    status: NDArray[np.uint8]


class Element:
    """A contact as a function of inputs and states, for loops: arrays in, arrays out.

    Section ``element`` of the case says what it takes. Nothing in a loop raises: without a load
    there are no forces, numbers that are not finite give such, and `Evaluation.status` says so.

    `schlupf.element` makes it of a case.

    Examples
    --------
    Eight wheels, of which one lifts off:

    >>> import numpy as np
    >>> import schlupf
    >>> case = schlupf.Case(solver={"method": "polach"}, friction={"model": "constant"})
    >>> element = schlupf.element(case)
    >>> [state.name for state in element.states]
    ['elastic_shift_x', 'elastic_shift_y', 'elastic_turn']
    >>> inputs = element.array(velocity_x=30.0, load=[80e3] * 7 + [-1.0])
    >>> states = np.zeros((8, 3))
    >>> states = element.advance(inputs, states, 1e-3)
    >>> found = element.evaluate(inputs, states)
    >>> found.outputs.shape, found.derivatives.shape
    ((8, 9), (8, 12, 11))
    >>> schlupf.Status(found.status[-1]).text
    'no-contact'
    """

    def __init__(self, case: Case) -> None:
        # Its own, whatever becomes of the case.
        self._case = copy(case)
        self._element = _core.Element(case._file)
        signals = self._element.signals()
        self._inputs, self._outputs, self._states = (
            tuple(Signal(*signal) for signal in some) for some in signals
        )

    @property
    def inputs(self) -> tuple[Signal, ...]:
        """Its inputs, in their order."""
        return self._inputs

    @property
    def outputs(self) -> tuple[Signal, ...]:
        """Its outputs, in their order."""
        return self._outputs

    @property
    def states(self) -> tuple[Signal, ...]:
        """Its states, in their order: none without memory."""
        return self._states

    @property
    def messages(self) -> list[tuple[str, str, str]]:
        """What its method neglects, as warnings: code, field or quantity, text."""
        return self._element.warnings()

    def __repr__(self) -> str:
        """Show the names of the inputs."""
        names = ", ".join(signal.name for signal in self._inputs)
        return f"Element({names})"

    def __reduce__(self) -> tuple[type[Element], tuple[Case]]:
        """Pickle the case: what a solver found is not kept."""
        return Element, (self._case,)

    def array(self, **inputs: Any) -> NDArray[np.float64]:
        """Inputs by name along the last axis, the others as in the case; arrays broadcast.

        Numbers are in SI units; quantities of pint and astropy have their own.
        """
        names = [signal.name for signal in self._inputs]
        unknown = [name for name in inputs if name not in names]
        if unknown:
            known = ", ".join(names)
            raise TypeError(f"no input {quoted(unknown[0])}; there are {known}")
        columns: list[Any] = list(self._element.start())
        for k, (name, unit, _) in enumerate(self._inputs):
            if name in inputs:
                given = inputs[name]
                columns[k] = magnitude(given, unit, name) if is_quantity(given) else given
                try:
                    columns[k] = np.asarray(columns[k], float)
                except (TypeError, ValueError):
                    raise TypeError(
                        f"{name} must be numbers in {unit or 'no unit'}, but is {quoted(given)}"
                    ) from None
        arrays = np.broadcast_arrays(*columns)
        return np.stack(arrays, axis=-1)

    def evaluate(
        self, inputs: ArrayLike, states: ArrayLike | None = None, *, derivatives: bool = True
    ) -> Evaluation:
        """Outputs, rates and derivatives of inputs and states, signals along their last axes.

        Without states they are zero. More than 512 rows are evaluated on all cores. A solver starts
        from what it found last, which changes the result within its tolerance only.
        """
        given, held, shape = self._rows(inputs, states)
        found = self._element.evaluate(given.ravel(), held.ravel(), derivatives)
        outputs, rates, slopes, status = found
        rows = len(self._outputs) + len(self._states)
        columns = len(self._inputs) + len(self._states)
        return Evaluation(
            outputs.reshape(*shape, len(self._outputs)),
            rates.reshape(*shape, len(self._states)),
            slopes.reshape(*shape, rows, columns) if derivatives else slopes,
            OF_ELEMENT[status].reshape(shape),
        )

    def advance(self, inputs: ArrayLike, states: ArrayLike, duration: float) -> NDArray[np.float64]:
        """The states after a time (s) with constant inputs."""
        given, held, shape = self._rows(inputs, states)
        later = self._element.advance(given.ravel(), held.ravel(), float(duration))
        return later.reshape(*shape, len(self._states))

    def forget(self) -> None:
        """Forgets what a solver found, from which it would start."""
        self._element.forget()

    def _rows(
        self, inputs: ArrayLike, states: ArrayLike | None
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], tuple[int, ...]]:
        given = np.ascontiguousarray(inputs, float)
        _check("inputs", given, len(self._inputs))
        count = len(self._states)
        held = np.zeros(count) if states is None else np.asarray(states, float)
        _check("states", held, count)
        rows = (given.shape[:-1], held.shape[:-1])
        try:
            shape = np.broadcast_shapes(*rows)
        except ValueError:
            raise ValueError(f"rows of inputs and states must broadcast: {rows}") from None
        given = np.ascontiguousarray(np.broadcast_to(given, (*shape, given.shape[-1])))
        held = np.ascontiguousarray(np.broadcast_to(held, (*shape, count)))
        return given, held, shape


def _check(name: str, array: NDArray[np.float64], count: int) -> None:
    if array.ndim == 0 or array.shape[-1] != count:
        raise ValueError(
            f"the last axis of {name} must have {count} entries, but the shape is {array.shape}"
        )


def element(case: Case, *, warn: bool = True) -> Element:
    """The force element of a case, for loops: see `Element`.

    Section ``element`` of the case says how motion and load are given, and whether it has memory;
    ``solver`` the method of its forces.

    Parameters
    ----------
    case
        The case.
    warn
        Whether to issue what the method neglects as warnings.

    Raises
    ------
    CaseError
        If the case cannot be one, such as a wheel with profiles and no table of its contacts.
    """
    made = Element(case)
    if warn:
        emit(made.messages, stacklevel=2)
    return made
