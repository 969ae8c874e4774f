"""Laws as functions of arrays."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import quoted

Array = NDArray[np.float64]

#: A function of arrays that returns an array.
Law = Callable[..., Any]

#: Values are at most this.
LARGEST = float(np.finfo(float).max)

#: Part of the largest pressure that counts as none.
NEGLIGIBLE = 1e-4

#: Points of a pressure along x and y.
SAMPLES = 257


#: Whether this thread is within a law.
_CALLED = threading.local()


def in_law() -> bool:
    """Whether a law is being called by this thread."""
    return getattr(_CALLED, "now", False)


def checked(name: str, law: Law, requirement: str, upper: float) -> Callable[..., Array]:
    """The law, whose values must be numbers from 0 to `upper`."""

    if not callable(law):
        raise TypeError(f"{name} must be a function, but is {quoted(law)}")

    def values(*arguments: Array) -> Array:
        before = in_law()
        _CALLED.now = True
        try:
            found = np.asarray(law(*arguments), dtype=float)
        finally:
            _CALLED.now = before
        try:
            found = np.broadcast_to(found, arguments[0].shape)
        except ValueError:
            raise ValueError(
                f"{name} must return as many values as it is given, "
                f"{arguments[0].shape}, but returns {found.shape}"
            ) from None
        wrong = ~((found >= 0.0) & (found <= upper))
        if wrong.any():
            raise ValueError(f"{name} must be {requirement}, but is {found[wrong][0]}")
        return np.ascontiguousarray(found)

    return values


def sampled(
    pressure: Law, extent: tuple[tuple[float, float], tuple[float, float]]
) -> tuple[list[float], list[float], list[float]]:
    """Places x and y (m), and the pressure (Pa) there, rows along x."""
    try:
        (x0, x1), (y0, y1) = extent
        x, y = np.linspace(x0, x1, SAMPLES), np.linspace(y0, y1, SAMPLES)
    except (TypeError, ValueError):
        raise ValueError(f"extent must be ((x0, x1), (y0, y1)), but is {quoted(extent)}") from None
    if not (x0 < x1 and y0 < y1):
        raise ValueError(f"the ends of extent must increase, but it is {quoted(extent)}")
    places = np.meshgrid(x, y)
    values = checked("pressure", pressure, "finite and not negative", LARGEST)(*places)
    peak = values.max()
    if peak <= 0.0:
        raise ValueError("pressure must be positive somewhere within extent, but is zero")
    border = max(values[[0, -1]].max(), values[:, [0, -1]].max())
    if border > NEGLIGIBLE * peak:
        raise ValueError(
            f"extent must contain the contact, but the pressure at its border is {border:.3g} Pa"
        )
    return x.tolist(), y.tolist(), values.ravel().tolist()
