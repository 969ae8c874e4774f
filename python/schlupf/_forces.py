"""Forces under many conditions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike

from . import _core
from ._case import Case
from ._errors import no_such
from ._fields import CONDITIONS, FIELDS, quantity
from ._laws import in_law
from ._result import Result
from ._status import ATTRIBUTES, Status
from ._tables import attributes
from ._typing import Unpack
from ._units import Number, Series, in_array, plain, reals
from .sections import Conditions
from .warnings import emit

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

#: Kinds of fields that are numbers.
NUMBERS = ("quantity", "number", "count", "number-or-choice")

#: The dimension of the contacts of a wheel.
CONTACT = "contact"


def forces(
    case: Case,
    *,
    strict: bool = False,
    warn: bool = True,
    **conditions: Unpack[Conditions[ArrayLike | Series | xr.DataArray]],
) -> xr.Dataset:
    """Forces on the wheel under many conditions, on all cores.

    Each condition is that of ``case.with_(…).solve()``.

    Parameters
    ----------
    case : Case
        Everything that does not vary; its method may be a fast one.
    strict : bool, default False
        Whether to raise the error of the first condition that fails.
    warn : bool, default True
        Whether to issue the warnings of the results.
    **conditions : array or DataArray
        Any number of the case by its path with ``__`` for the dot, such as
        ``friction__coefficient``; ``creepage_x``, ``creepage_y``, ``spin``, ``speed`` stand for
        those of ``kinematics``, ``load`` for ``normal__load``. Numbers are in SI units; text and
        quantities of pint have theirs. They are broadcast: arrays as in NumPy, with dimensions
        named after the condition that alone varies along them, else ``condition_1`` (the last) …;
        data arrays and series of pandas by the names of their dimensions, if they have any.

    Returns
    -------
    xarray.Dataset
        ``force_x``, ``force_y`` (N), ``moment_z`` (N m; not a number if the method has none),
        ``traction_coefficient`` and ``status`` (0: converged, 1: not converged, 2: no contact,
        3: failed), with the conditions as coordinates. Without a normal load, or where a wheel does
        not touch the rail, forces are zero; where a condition fails they are not numbers. Of a
        wheel with profiles also ``wheel_force_x``, ``wheel_force_y``, ``wheel_force_z`` (N, in the
        track) and, along ``contact``, all that is known of up to three contacts:
        ``contact_position_y``, ``contact_angle``, ``contact_rolling_radius``,
        ``contact_normal_load``, ``contact_force_x`` …; the other forces are then those of the
        first contact, which has the largest normal force.

    Raises
    ------
    CaseError
        If all conditions fail, or `strict` and one does; it tells which one.

    Notes
    -----
    Solutions of the full method start from that of the condition before, so neighbours should be
    alike. Fixed blocks of conditions have a solver each: results do not depend on the number of
    cores. Conditions other than creepages, spin, speed and load need a solver for each value, and
    so do all of a wheel with profiles. A warning that several conditions have is issued once,
    for the worst of them; conditions are counted from 0.

    Examples
    --------
    >>> import numpy as np
    >>> import schlupf
    >>> case = schlupf.Case(friction={"model": "constant"}, solver={"method": "polach"})
    >>> table = schlupf.forces(case, creepage_x=np.linspace(0, 0.01, 5)[:, None], load=[60e3, 80e3])
    >>> table["force_x"].shape
    (5, 2)
    """
    given: Mapping[str, Any] = conditions
    paths = _paths(case, given)
    named = {quantity(path): _in_si(case, path, given[name]) for name, path in paths.items()}
    arrays, dims = _broadcast(named)
    template = next(iter(arrays.values()), xr.DataArray(np.array(0.0)))
    if template.size == 0:
        raise ValueError(f"there must be conditions, but there are none: {', '.join(conditions)}")
    coordinates = {
        name: _coordinate(path, value, arrays[name], dims[name])
        for (name, value), path in zip(named.items(), paths.values(), strict=True)
    }
    # Whether they fit is known before the work.
    _empty_table(template, coordinates)
    flat = {
        path: np.ascontiguousarray(np.ravel(arrays[name].values))
        for name, path in zip(named, paths.values(), strict=True)
    }
    columns, numbers, messages = _core.batch(case._file, flat, strict)
    if warn:
        _warn(numbers, messages)
    shaped: dict[str, Any] = {}
    for name, column in columns.items():
        width = column["values"].size // template.size
        of_contact = ([CONTACT], [width]) if width > 1 else ([], [])
        shape = (*template.shape, *of_contact[1])
        own = (*template.dims, *of_contact[0])
        shaped[name] = (own, column["values"].reshape(shape), attributes(column))
    shaped["status"] = (template.dims, numbers.reshape(template.shape), ATTRIBUTES)
    return xr.Dataset(shaped).assign_coords(coordinates)


#: Code, quantity and text of a warning, how many conditions have it, which of them is the worst,
#: and whether all are equally severe.
Counted = tuple[str, str, str, int, int, bool]


def _paths(case: Case, conditions: Mapping[str, Any]) -> dict[str, str]:
    """The fields of conditions, by their names."""
    paths = {name: CONDITIONS.get(name, name.replace("__", ".")) for name in conditions}
    for name, path in paths.items():
        if path not in FIELDS or FIELDS[path].kind not in NUMBERS:
            known = [*CONDITIONS, *FIELDS] if "." in path else CONDITIONS
            raise TypeError(no_such("condition", name, known))
        case._check_varied(path)
    if len(set(paths.values())) < len(paths):
        raise TypeError(f"a condition must be given once, but there are {', '.join(conditions)}")
    return paths


def _empty_table(template: xr.DataArray, coordinates: dict[str, xr.DataArray]) -> None:
    """Refuses dimensions and coordinates of which no table can be made."""
    own = [name for name in template.dims if name in (*_core.force_names(), "status", CONTACT)]
    if own:
        raise ValueError(f"a dimension must not have the name of a result: {own[0]}")
    try:
        xr.Dataset({"status": template}).assign_coords(coordinates)
    except (ValueError, xr.MergeError) as error:
        raise ValueError(
            f"coordinates of the same dimension must be the same: {', '.join(coordinates)}"
        ) from error


def _warn(numbers: NDArray[np.uint8], messages: list[Counted]) -> None:
    """Issues warnings, each with the conditions that it is about, where not all have it."""
    size = numbers.size
    found = []
    unconverged = np.count_nonzero(numbers == Status.NOT_CONVERGED)
    if unconverged:
        text = f"status: {unconverged} of {size} conditions have not converged"
        found.append(("not-converged", "status", text))
    for code, of, text, count, place, is_even in messages:
        which = "first" if is_even else "worst"
        of_some = f" ({count} of {size} conditions; {which}: number {place})"
        found.append((code, of, text if count == size and is_even else text + of_some))
    emit(found, stacklevel=3)


def _in_si(case: Case, path: str, value: Any) -> Any:
    """Values of a field in its SI unit; text is read as a case reads it."""
    if hasattr(value, "to_xarray"):
        # A series of pandas; without a name of its index it is an array.
        is_named = None not in value.index.names
        value = value.to_xarray() if is_named else value.to_numpy()
    if isinstance(value, xr.DataArray):
        # Dimensions of conditions are named as these.
        own = {dim: quantity(CONDITIONS[str(dim)]) for dim in value.dims if dim in CONDITIONS}
        value = value.rename({dim: name for dim, name in own.items() if dim != name})
    if isinstance(value, xr.DataArray):
        return plain(value, FIELDS[path], path)
    texts = in_array(value, FIELDS[path], path)
    if texts.dtype.kind != "U":
        return reals(texts, FIELDS[path], path)
    read = [case._file.with_fields([f"{path}={text}"]).value(path) for text in texts.ravel()]
    return np.reshape(np.asarray(read, float), texts.shape)


def _broadcast(given: dict[str, Any]) -> tuple[dict[str, xr.DataArray], dict[str, list[str]]]:
    """All conditions with the same shape, and the dimensions along which each varies.

    A dimension is named after the condition that alone varies along it.
    """
    plain = {k: np.asarray(v, float) for k, v in given.items() if not isinstance(v, xr.DataArray)}
    try:
        shape = np.broadcast_shapes(*(array.shape for array in plain.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in plain.items() if array.ndim)
        raise ValueError(f"arrays must be of shapes that broadcast, but are {shapes}") from None
    names = [_dimension(plain, k - len(shape)) for k in range(len(shape))]
    named = {}
    dims = {}
    for name, value in given.items():
        if name not in plain:
            named[name] = value.astype(float).drop_vars(value.coords)
            dims[name] = [str(dim) for dim in value.dims]
            continue
        array = plain[name]
        named[name] = xr.DataArray(np.broadcast_to(array, shape), dims=names)
        own = names[len(names) - array.ndim :]
        dims[name] = [dim for dim, size in zip(own, array.shape, strict=True) if size > 1]
    return dict(zip(named, xr.broadcast(*named.values()), strict=True)), dims


def _dimension(given: Mapping[str, NDArray[np.float64]], axis: int) -> str:
    """The name of an axis of arrays, counted from the last, -1."""
    varying = [
        name for name, array in given.items() if array.ndim >= -axis and array.shape[axis] > 1
    ]
    alone = [name for name in varying if given[name].size == given[name].shape[axis]]
    return alone[0] if len(varying) == 1 and alone else f"condition_{-axis}"


def _coordinate(path: str, given: Any, array: xr.DataArray, dims: list[str]) -> xr.DataArray:
    """The values of a field along the dimensions over which it varies."""
    if isinstance(given, xr.DataArray):
        return given.astype(float).drop_vars([c for c in given.coords if c not in given.dims])
    attrs = {"units": FIELDS[path].units, "long_name": FIELDS[path].doc}
    index = {dim: 0 for dim in array.dims if dim not in dims}
    return array.isel(index, drop=True).assign_attrs(attrs)


class Solver:
    """A solver of steady rolling that keeps its set-up and starts from its earlier solutions.

    For callers with loops of their own, such as simulators.

    Examples
    --------
    >>> import schlupf
    >>> solver = schlupf.Solver(schlupf.Case(grid={"cells_x": 16, "cells_y": 16}))
    >>> [round(solver.solve(creepage_x=ξ).force.x / 1e3) for ξ in (0.0, 0.001)]
    [0, -11]
    """

    def __init__(self, case: Case) -> None:
        self._case = case
        self._solver = _core.BatchSolver(case._file)

    def solve(
        self, *, strict: bool = True, warn: bool = True, **conditions: Unpack[Conditions[Number]]
    ) -> Result:
        """The steady state of ``case.with_(…)`` with other numbers, named as in `forces`.

        Raises
        ------
        CaseError
            If a condition is not allowed.
        NotConverged
            If `strict` and the solution has not converged.
        """
        given: Mapping[str, Any] = conditions
        several = [name for name, value in given.items() if np.ndim(value) > 0]
        if several:
            raise ValueError(f"{several[0]} must be one number: `schlupf.forces` takes arrays")
        paths = _paths(self._case, given)
        if in_law():
            raise RuntimeError("a law must not use a solver: the solver waits for the law")
        values = {
            path: np.array([float(_in_si(self._case, path, given[name]))])
            for name, path in paths.items()
        }
        return Result._new(self._solver.solve(values), strict=strict, warn=warn)
