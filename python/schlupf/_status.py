"""What became of a state."""

from __future__ import annotations

from enum import IntEnum
from typing import Any

import numpy as np
import xarray as xr

from . import _core


class Status(IntEnum):
    """What became of a state: a number in data sets; `text` is its name in the JSON.

    >>> import schlupf
    >>> schlupf.Status.NOT_CONVERGED.text, int(schlupf.Status.NOT_CONVERGED)
    ('not-converged', 1)
    """

    CONVERGED = 0
    NOT_CONVERGED = 1
    #: Nothing acts: without a normal load, or where a wheel does not touch the rail.
    NO_CONTACT = 2
    #: The case cannot be, or cannot be solved.
    FAILED = 3
    #: An input of an element is no finite number.
    NOT_FINITE = 4
    #: An element was given arrays of a wrong size.
    WRONG_SIZE = 5
    #: A state is outside of the table of an element.
    OUTSIDE_TABLE = 6

    @classmethod
    def of(cls, name: str) -> Status:
        """That of a name, such as ``"not-converged"``."""
        return cls.CONVERGED if name == "found" else cls[name.upper().replace("-", "_")]

    @property
    def text(self) -> str:
        """Its name in the JSON and in tables."""
        return self.name.lower().replace("_", "-")


#: Attributes of a variable with numbers of states (CF conventions).
ATTRIBUTES: dict[str, Any] = {
    "flag_values": list(range(len(_core.condition_status()))),
    "flag_meanings": " ".join(_core.condition_status()),
    "long_name": "status",
}
assert [Status.of(name) for name in _core.condition_status()] == ATTRIBUTES["flag_values"]

#: By the number that an element gives.
OF_ELEMENT = np.array([Status.of(name) for name in _core.element_status()], np.uint8)


def numbered(table: xr.Dataset) -> xr.Dataset:
    """With numbers in place of the names of states in its column ``status``."""
    status = table["status"]
    numbers = np.array([Status.of(name) for name in status.values.tolist()], np.uint8)
    return table.assign(status=(status.dims, numbers, ATTRIBUTES))
