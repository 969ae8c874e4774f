"""Numbers in SI units from whatever gives them."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import Any, Protocol

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from ._errors import CaseError, quoted


class Measured(Protocol):
    """What has an SI unit."""

    @property
    def units(self) -> str: ...


class Quantity(Protocol):
    """One of pint, or like one."""

    @property
    def magnitude(self) -> Any: ...
    def to(self, *arguments: Any, **options: Any) -> Any: ...


#: A number without unit.
Plain = float | np.floating[Any] | np.integer[Any] | Quantity
#: A number in SI units, or text with its unit, or a quantity of pint.
Number = Plain | str


class Labelled(Protocol):
    """A series of pandas, a data array, or like these."""

    def to_numpy(self) -> Any: ...


#: Several of them.
Series = Sequence[Number] | NDArray[Any] | Quantity | Labelled
#: A whole number.
Count = int | np.integer[Any]
#: Yes or no.
Flag = bool | np.bool_
#: A path.
File = str | PathLike[str]


class Columns(Protocol):
    """Columns by name: a mapping, a data frame, a data set."""

    def keys(self) -> Any: ...
    def __getitem__(self, name: Any, /) -> Any: ...


#: A file, or an array in its place.
Array = File | xr.DataArray | NDArray[Any] | Quantity
#: The same, or a table.
Data = Array | Columns | Sequence[Sequence[float]]


class Topography(Protocol):
    """A surface of SurfaceTopography."""

    @property
    def physical_sizes(self) -> Any: ...
    @property
    def heights(self) -> Any: ...


class Profilometry(Protocol):
    """A surface of surfalize."""

    @property
    def data(self) -> Any: ...
    @property
    def step_x(self) -> Any: ...
    @property
    def step_y(self) -> Any: ...


#: Heights.
Heights = Array | Topography | Profilometry
#: Heights, or a table of them or of levels of their spectrum.
Surface = Heights | Data


def refused(field: str, message: str) -> CaseError:
    """An error of a field, as the library raises it."""
    return CaseError([{"field": field, "message": message, "place": "", "help": None}])


def is_quantity(value: Any) -> bool:
    """Whether it is one of pint, or like one."""
    return hasattr(value, "magnitude") and hasattr(value, "to")


def magnitude(value: Any, units: str, name: str) -> Any:
    """The magnitude of a quantity of pint in the SI unit of what is called `name`.

    Raises
    ------
    CaseError
        If it is of another kind: temperatures are no differences, frequencies no angular
        velocities.
    """
    given = str(value.units)
    is_offset = units == "K" and ("degree_C" in given or "degree_F" in given)
    if is_offset and not given.startswith("delta"):
        raise refused(name, f"{name} must be a temperature difference, but is {value}")
    if units == "rad/s" and "hertz" in given:
        raise refused(name, f"{name} must be an angular velocity, but is {value}: a frequency")
    try:
        return value.to(units).magnitude
    except Exception as error:
        # Of pint, which need not be installed.
        if type(error).__name__ != "DimensionalityError":
            raise
        expected = units or "no unit"
        raise refused(name, f"{name} must be given in {expected}, but is in {given}") from None


def plain(value: Any, field: Measured, name: str) -> Any:
    """Numbers or arrays in the SI unit of a field, from quantities and data arrays with units.

    Durations are in seconds; masked numbers of an array are not a number.

    Raises
    ------
    CaseError
        If it is in another unit, or no real numbers or text, such as dates.
    """
    if is_quantity(value):
        value = magnitude(value, field.units, name)
    given = getattr(value, "attrs", {}).get("units")
    if given not in (None, "", field.units):
        unit = field.units or "no unit"
        is_in = f"its attribute `units` is {quoted(given)}"
        raise refused(name, f"{name} must be in {unit}, but {is_in}")
    kind = getattr(getattr(value, "dtype", None), "kind", "")
    if kind == "m" and field.units == "s":
        return value / np.timedelta64(1, "s")
    if kind and kind in "mMcSV":
        raise refused(name, f"{name} must be real numbers, but is of type {value.dtype}")
    return without_mask(value) if isinstance(value, np.ma.MaskedArray) else value


def in_array(value: Any, field: Measured, name: str) -> NDArray[Any]:
    """The same as an array of numbers, text or objects."""
    if isinstance(value, (list, tuple)):
        value = [plain(each, field, name) if is_quantity(each) else each for each in value]
    value = plain(value, field, name)
    try:
        array = np.asarray(value)
    # TypeError: of rows of quantities.
    except (TypeError, ValueError):
        raise refused(name, f"{name} must be numbers, but is {quoted(value)}") from None
    return np.asarray(plain(array, field, name))


def reals(value: Any, field: Measured, name: str) -> NDArray[np.float64]:
    """The same as an array of real numbers."""
    array = in_array(value, field, name)
    try:
        if array.dtype.kind in "iufO":
            return without_mask(array)
    except (TypeError, ValueError):
        pass
    raise refused(name, f"{name} must be numbers, but is {quoted(value)}")


def without_mask(array: Any) -> NDArray[np.float64]:
    """Numbers that are not numbers where the array is masked."""
    masked: Any = np.ma
    numbers: NDArray[np.float64] = masked.filled(masked.asarray(array, float), np.nan)
    return numbers
