"""Forces under many conditions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from . import _core
from ._fields import FIELDS
from ._laws import in_law
from ._result import Result
from ._tables import attributes
from ._units import plain, refused
from .warnings import emit

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._case import Case

#: Conditions that need no other case, with their fields.
CONDITIONS = dict(_core.conditions())

#: Kinds of fields that are numbers.
NUMBERS = ("quantity", "number", "count", "number-or-choice")

#: Variables of the results.
RESULTS = ("force_x", "force_y", "moment_z", "traction_coefficient")

#: Values of ``status``.
STATUS = ("converged", "not-converged")


def forces(case: Case, *, warn: bool = True, **conditions: ArrayLike | xr.DataArray) -> xr.Dataset:
    """Forces on the wheel under many conditions, on all cores.

    Parameters
    ----------
    case : Case
        Everything that does not vary; its method may be a fast one.
    warn : bool, default True
        Whether to issue the warnings of the results.
    **conditions : array or DataArray
        ``creepage_x``, ``creepage_y`` (dimensionless), ``spin`` (1/m), ``speed`` (m/s), ``load``
        (N), which change as in a history of the case; or any number of the case by its path with
        ``__`` for the dot, such as ``friction__coefficient``, which is as in a case with that
        field. Numbers are in SI units; text and quantities of pint have theirs. They are
        broadcast: arrays as in NumPy, with dimensions ``dim_0``
        …, data arrays by the names of their dimensions.

    Returns
    -------
    xarray.Dataset
        ``force_x``, ``force_y`` (N), ``moment_z`` (N m; not a number if the method has none),
        ``traction_coefficient`` and ``status`` (0: converged, 1: not), with the conditions as
        coordinates.

    Raises
    ------
    CaseError
        If a condition is not allowed; it tells which one.

    Notes
    -----
    Solutions of the full method start from that of the condition before, so neighbours should be
    alike. Fixed blocks of conditions have a solver each: results do not depend on the number of
    cores. Other numbers than those named need a solver for each value. A warning that several
    conditions have is issued once; conditions are counted from 0.

    Examples
    --------
    >>> import numpy as np
    >>> import schlupf
    >>> case = schlupf.Case(friction={"model": "constant"}, solver={"method": "polach"})
    >>> table = schlupf.forces(case, creepage_x=np.linspace(0, 0.01, 5)[:, None], load=[60e3, 80e3])
    >>> table["force_x"].shape
    (5, 2)
    """
    paths = {name: name.replace("__", ".") for name in conditions}
    for name, path in paths.items():
        if name not in CONDITIONS and (path not in FIELDS or FIELDS[path].kind not in NUMBERS):
            known = ", ".join(CONDITIONS)
            raise TypeError(f"no condition {name}; there are {known} and the fields of the case")
        case._check_varied(CONDITIONS.get(name, path))
        _check_motion(case, name)
    given = {
        name if name in CONDITIONS else paths[name]: _in_si(case, name, value)
        for name, value in conditions.items()
    }
    fields = {name: CONDITIONS.get(name, name) for name in given}
    if len(set(fields.values())) < len(fields):
        raise TypeError(f"a condition must be given once, but there are {', '.join(conditions)}")
    arrays = _broadcast(given)
    flat: dict[str, NDArray[np.float64]] = {
        name: np.ravel(array.values) for name, array in arrays.items()
    }
    template = next(iter(arrays.values()), xr.DataArray(np.array(0.0)))
    if template.size == 0:
        raise ValueError(f"there must be conditions, but there are none: {', '.join(conditions)}")
    coordinates = {
        name: _coordinate(name, fields[name], given[name], arrays[name]) for name in given
    }
    # Whether they fit is known before the work.
    _empty_table(template, coordinates)
    columns, converged, messages = _found(case, flat, template.size)
    shaped = {
        name: (template.dims, column["values"].reshape(template.shape), attributes(column))
        for name, column in columns.items()
    }
    status = {"flag_values": [0, 1], "flag_meanings": " ".join(STATUS), "long_name": "status"}
    if warn and not converged.all():
        failed = f"{np.count_nonzero(~converged)} of {converged.size} conditions have not converged"
        emit([("not-converged", "status", f"status: {failed}")], stacklevel=2)
    if warn:
        emit(_of_conditions(messages, template.size), stacklevel=2)
    numbers = np.where(converged, 0, 1).astype(np.int8).reshape(template.shape)
    dataset = xr.Dataset({**shaped, "status": (template.dims, numbers, status)})
    return dataset.assign_coords(coordinates)


#: Fields from which others follow, by the conditions that would contradict them.
_FROM = {
    "speed": "kinematics.angular_velocity",
    "creepage_x": "kinematics.angular_velocity",
    "creepage_y": "kinematics.yaw_angle",
}


def _check_motion(case: Case, name: str) -> None:
    """Refuses a condition that would contradict what the case gives in place of creepages."""
    source = _FROM.get(name)
    if source is not None and source in case.given():
        field = CONDITIONS[name]
        raise refused(
            field,
            f"{name} cannot vary where the case gives {source}, from which its creepage follows; "
            f"vary {field.replace('.', '__')}, as a field of the case, or give creepages",
        )


def _empty_table(template: xr.DataArray, coordinates: dict[str, xr.DataArray]) -> None:
    """Refuses dimensions and coordinates of which no table can be made."""
    own = [name for name in template.dims if name in (*RESULTS, "status")]
    if own:
        raise ValueError(f"a dimension must not have the name of a result: {own[0]}")
    try:
        xr.Dataset({"status": template}).assign_coords(coordinates)
    except (ValueError, xr.MergeError) as error:
        raise ValueError(
            f"coordinates of the same dimension must be the same: {', '.join(coordinates)}"
        ) from error


def _of_conditions(
    messages: list[tuple[str, str, str, int, int]], size: int
) -> list[tuple[str, str, str]]:
    """Warnings with the conditions that they are about, where not all have them."""
    return [
        (code, quantity, text)
        if count == size
        else (code, quantity, f"{text} ({count} of {size} conditions; this is number {first})")
        for code, quantity, text, count, first in messages
    ]


def _in_si(case: Case, name: str, value: Any) -> Any:
    """Values of a condition in the SI unit of its field; text is read as a case reads it."""
    path = CONDITIONS.get(name, name.replace("__", "."))
    field = FIELDS[path]
    value = plain(value, field, name)
    if isinstance(value, xr.DataArray) or np.asarray(value).dtype.kind != "U":
        return value
    texts = np.asarray(value)
    read = [case._file.with_fields([f"{path}={text}"]).value(path) for text in texts.ravel()]
    return np.reshape(np.asarray(read, float), texts.shape)


def _broadcast(given: dict[str, Any]) -> dict[str, xr.DataArray]:
    """All conditions with the same shape."""
    plain = {k: np.asarray(v, float) for k, v in given.items() if not isinstance(v, xr.DataArray)}
    shape = np.broadcast_shapes(*(array.shape for array in plain.values()))
    dims = [f"dim_{k}" for k in range(len(shape))]
    named = {
        name: xr.DataArray(np.broadcast_to(array, shape), dims=dims)
        for name, array in plain.items()
    }
    named |= {k: v.astype(float).drop_vars(v.coords) for k, v in given.items() if k not in named}
    return dict(zip(named, xr.broadcast(*named.values()), strict=True))


def _coordinate(name: str, path: str, given: Any, array: xr.DataArray) -> xr.DataArray:
    field = FIELDS[path]
    attrs = {"units": field.units, "long_name": field.doc}
    if isinstance(given, xr.DataArray):
        return given.astype(float).drop_vars([c for c in given.coords if c not in given.dims])
    own = np.asarray(given, float)
    # Only along the dimensions over which it varies.
    dims = enumerate(reversed(array.dims))
    kept = [dim for k, dim in dims if k < own.ndim and own.shape[-1 - k] > 1]
    index = {dim: 0 for dim in array.dims if dim not in kept}
    return array.isel(index, drop=True).assign_attrs(attrs)


def _found(
    case: Case, flat: dict[str, NDArray[np.float64]], size: int
) -> tuple[dict[str, dict[str, Any]], NDArray[np.bool_], list[tuple[str, str, str, int, int]]]:
    """Columns, whether each condition has converged, and warnings."""
    own = {name: np.ascontiguousarray(flat[name]) for name in flat if name in CONDITIONS}
    others = {name: values for name, values in flat.items() if name not in CONDITIONS}
    load = own.get("load", np.zeros(0))
    is_sorted = bool(np.all(load[1:] >= load[:-1]))
    if not others and is_sorted:
        return _core.batch([case._file], [size], None, own)
    if not others:
        # A change of the load is a new contact.
        return _in_order(np.argsort(load, kind="stable"), [case._file], [size], own)
    # A case for each combination of numbers that are no conditions, with its conditions in a row.
    rows, which = np.unique(np.stack(list(others.values()), axis=1), axis=0, return_inverse=True)
    members = []
    for row in rows:
        member = case
        for path, value in zip(others, row, strict=True):
            member = member.with_(**_nested(path, float(value)))
        members.append(member._file)
    which = which.ravel()
    keys = (which,) if is_sorted else (load, which)
    counts = np.bincount(which, minlength=len(rows)).tolist()
    return _in_order(np.lexsort(keys), members, counts, own)


def _in_order(
    order: NDArray[np.int64],
    members: list[_core.CaseFile],
    counts: list[int],
    own: dict[str, NDArray[np.float64]],
) -> tuple[dict[str, dict[str, Any]], NDArray[np.bool_], list[tuple[str, str, str, int, int]]]:
    """Solves conditions in another order than that in which they are given."""
    sorted_ = {name: values[order] for name, values in own.items()}
    columns, converged, messages = _core.batch(members, counts, order.tolist(), sorted_)
    back = np.argsort(order)
    for column in columns.values():
        column["values"] = column["values"][back]
    return columns, converged[back], messages


def _nested(path: str, value: float) -> dict[str, Any]:
    section, _, name = path.partition(".")
    kind = FIELDS[path].kind
    # What is no whole number is refused by the case.
    number: float = int(value) if kind == "count" and value.is_integer() else value
    return {section: {name: number} if "." not in name else _nested(name, value)}


class Solver:
    """A solver of steady rolling that keeps its set-up and starts from its earlier solutions.

    For callers with loops of their own, such as simulators: ``case.solver()``.

    Examples
    --------
    >>> import schlupf
    >>> solver = schlupf.Case(grid={"cells_x": 16, "cells_y": 16}).solver()
    >>> [round(solver.solve(creepage_x=ξ).force.x / 1e3) for ξ in (0.0, 0.001)]
    [0, -11]
    """

    def __init__(self, case: Case) -> None:
        self._case = case
        self._solver = _core.BatchSolver(case._file)

    def solve(self, *, strict: bool = True, warn: bool = True, **conditions: float) -> Result:
        """The steady state under other conditions, named as in `forces`; the rest is the case's.

        Raises
        ------
        CaseError
            If a condition is not allowed.
        NotConverged
            If `strict` and the solution has not converged.
        """
        several = [name for name, value in conditions.items() if np.ndim(value) > 0]
        if several:
            raise ValueError(f"{several[0]} must be one number: `schlupf.forces` takes arrays")
        unknown = [name for name in conditions if name not in CONDITIONS]
        if unknown:
            raise TypeError(f"no condition {unknown[0]}; there are {', '.join(CONDITIONS)}")
        if in_law():
            raise RuntimeError("a law must not use a solver: the solver waits for the law")
        for name in conditions:
            _check_motion(self._case, name)
        given = {name: _in_si(self._case, name, value) for name, value in conditions.items()}
        values = {name: np.array([float(value)]) for name, value in given.items()}
        return Result._new(self._solver.solve(values), strict=strict, warn=warn)
