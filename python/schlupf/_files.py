"""Arrays in place of files: as a URL that holds them (RFC 2397)."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from os import PathLike, fspath
from pathlib import Path, PurePath
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from ._errors import quoted
from ._surfaces import OWN, as_array, open_surface
from ._units import in_array, is_quantity, magnitude, reals, refused

#: Columns of a table: names with their SI units.
Table = Mapping[str, str]


class Unit(NamedTuple):
    """A unit, as `plain` reads it."""

    units: str


def in_place(value: Any, tables: Sequence[Table], name: str, folder: Path) -> Any:
    """What stands in place of a file: its path, or data; relative paths start in a folder."""
    is_path = isinstance(value, (str, PathLike))
    is_surface = any("height" in table for table in tables)
    if is_path and not (is_surface and is_foreign(value)):
        return value
    return data_url(open_surface(folder / value) if is_path else value, tables, name)


def are_rows(values: Sequence[Any]) -> bool:
    """Whether they are the rows of one table."""
    several = (list, tuple, np.ndarray)
    return all(
        isinstance(row, several) and not any(isinstance(cell, several) for cell in row)
        for row in values
    )


def each_in_place(values: Any, tables: Sequence[Table], name: str, folder: Path) -> Any:
    """The same of values of a field that varies: each has a name of its own."""
    if not tables:
        return values
    return [in_place(each, tables, f"{name}[{k}]", folder) for k, each in enumerate(values)]


def is_foreign(path: str | PathLike[str]) -> bool:
    """Whether a surface is in a format that the library does not read."""
    text = fspath(path)
    ending = PurePath(text).suffix.lower()
    return not text.startswith("data:") and ending != "" and ending not in OWN


def data_url(value: Any, tables: Sequence[Table], name: str) -> str:
    """A table or a map in place of the file that `name` names.

    Parameters
    ----------
    value : mapping, DataFrame, Series, Dataset, DataArray or array_like
        Columns by name; a map over x and y; or an array, of which the columns are those of the
        table if they are as many, and which is else a map with rows along x, as one of heights
        always is.
    tables : sequence of mappings
        Columns of the tables that the file may hold, with their SI units.

    Raises
    ------
    CaseError
        If it is none of these.
    """
    # Names tell tables apart; arrays without them are maps, where the file may hold one.
    maps = [table for table in tables if {"x", "y"} <= table.keys()]
    every, units = (
        {k: v for table in of for k, v in table.items()} for of in (tables, maps or tables)
    )
    if "height" in units:
        surface = as_array(value, name)
        value = value if surface is None else surface
    is_table = len(tables) == 1 and "height" not in units
    own = "m" if getattr(value, "attrs", {}).get("units") == "m" or is_quantity(value) else None
    if (
        isinstance(value, xr.Dataset)
        and len(value.data_vars) == 1
        and {*value.data_vars} <= {*every}
    ):
        (value,) = value.data_vars.values()
    if isinstance(value, xr.DataArray):
        along = [dim for dim in value.dims if dim in every and dim in value.coords]
        axes = [_even(value[axis], name) for axis in ("x", "y") if axis in along]
        if {*value.dims} == {"x", "y"} and len(axes) != 1 and all(axes):
            return _map(_numbers(value.transpose("y", "x"), units, name), name, axes, own)
        if value.ndim < 2 or len(along) == value.ndim:
            value = _named(value, every if value.name in every else units, name).to_dataset()
        elif is_table:
            value = _numbers(value, units, name)
        else:
            dims = ", ".join(map(str, value.dims))
            raise refused(
                name,
                f"{name} must have the dimensions y and x, with coordinates of both or of none, "
                f"but has {dims} with those of {', '.join(map(str, along)) or 'none'}",
            )
    if isinstance(value, xr.Dataset):
        names = [*(c for c in value.coords if c in every), *value.data_vars]
        value = dict(zip(names, xr.broadcast(*(value[each] for each in names)), strict=True))
    if hasattr(value, "to_frame"):
        value = value.to_frame()
    if hasattr(value, "keys"):
        return _text(*_columns(value, every), every, name)
    if is_quantity(value):
        (unit, *others) = dict.fromkeys(units.values())
        if others:
            raise refused(name, f"{name} must be columns, whose units differ, but is one quantity")
        value = magnitude(value, unit, name)
    array = reals(value, Unit(""), name)
    if array.ndim == 2 and is_table and array.shape[1] == len(units):
        columns = dict(zip(units, array.T, strict=True))
        return _text(columns, None, units, name)
    if not {"x", "y"} <= units.keys() or array.ndim not in (1, 2):
        expected = ", ".join(f"{column} ({unit or '1'})" for column, unit in units.items())
        raise refused(
            name,
            f"{name} must be a path or a table with the columns {expected}, but is an array of "
            f"shape {array.shape}",
        )
    return _map(array, name, [], own)


def _named(array: xr.DataArray, units: Table, name: str) -> xr.DataArray:
    """With the name of the column that its values are."""
    others = [column for column in units if column not in (*array.dims, "x", "y")]
    if array.name in others:
        return array
    if len(others) != 1:
        known = " or ".join(others)
        raise refused(name, f"{name} must be an array named {known}, but is named {array.name!r}")
    return array.rename(others[0])


def _even(axis: xr.DataArray, name: str) -> tuple[str, float, float] | None:
    """Name, start and spacing of an axis with even steps."""
    places = reals(axis, Unit("m"), f"{axis.name} of {name}")
    steps = np.diff(places)
    if steps.size == 0 or not (steps > 0).all() or np.ptp(steps) > 1e-6 * steps.mean():
        return None
    return str(axis.name), float(places[0]), float((places[-1] - places[0]) / steps.size)


def _numbers(array: xr.DataArray, units: Table, name: str) -> np.ndarray[Any, Any]:
    """The values of a map, in the SI unit of what it is."""
    of_all = dict.fromkeys(unit for column, unit in units.items() if column not in ("x", "y"))
    own = [units[str(array.name)]] if array.name in units else [*of_all]
    given = array.attrs.get("units")
    return reals(array, Unit(given if given in own else own[0]), name)


def _columns(table: Any, units: Table) -> tuple[dict[str, Any], Iterable[Any] | None]:
    """Columns by name, and what its rows are called, if not by number."""
    index = getattr(table, "index", None)
    if index is None or callable(index):
        return {str(each): table[each] for each in table.keys()}, None  # noqa: SIM118
    levels = [level for level in index.names if level in units]
    table = table.reset_index(level=levels) if levels else table
    return {str(each): table[each] for each in table.columns}, index


def _text(columns: dict[str, Any], labels: Iterable[Any] | None, units: Table, name: str) -> str:
    """Columns as CSV; a name that has a unit of its own, such as ``load [kN]``, keeps it."""
    own = {each: getattr(column, "attrs", {}).get("units", "") for each, column in columns.items()}
    given = {
        each: in_array(column, Unit(units.get(each, own[each])), f"{each} of {name}")
        for each, column in columns.items()
    }
    try:
        arrays = np.broadcast_arrays(*given.values())
    except ValueError:
        shapes = ", ".join(f"{each} {array.shape}" for each, array in given.items())
        raise refused(name, f"{name} must have columns of one length, but has {shapes}") from None
    heads = [f"{each} [{units[each]}]" if units.get(each) else each for each in columns]
    # Row by row: a million of them are no lists of text.
    text = io.StringIO()
    text.write(f"data:text/csv;name={name},{','.join(['index', *heads])}".replace("%", "%25"))
    cells = [_cells(array, f"{k} of {name}") for k, array in zip(given, arrays, strict=True)]
    rows = range(arrays[0].size if arrays else 0) if labels is None else labels
    for row in zip(map(_label, rows), *cells, strict=True):
        text.write("\n" + ",".join(row).replace("%", "%25"))
    return text.getvalue()


def _cells(array: np.ndarray[Any, Any], name: str) -> Iterator[str]:
    for value in array.ravel().tolist():
        try:
            yield _cell(value)
        except (TypeError, ValueError):
            raise refused(name, f"{name} must be numbers, but has {quoted(value)}") from None


def _cell(value: Any) -> str:
    if isinstance(value, str):
        return '"' + value.replace('"', '""') + '"' if set(value) & set(',"\n\r#') else value
    return repr(int(value) if isinstance(value, (int, np.integer)) else float(value))


#: Signs that a label in a table cannot have.
_SIGNS = str.maketrans(dict.fromkeys(',"\n\r#', " "))


def _label(value: Any) -> str:
    return str(value).translate(_SIGNS)


def _map(
    array: np.ndarray[Any, Any],
    name: str,
    axes: Sequence[tuple[str, float, float] | None],
    unit: str | None,
) -> str:
    file = io.BytesIO()
    np.save(file, array, allow_pickle=False)
    known = (axis for axis in axes if axis is not None)
    places = "".join(f"spacing_{a}={step!r};start_{a}={start!r};" for a, start, step in known)
    places += f"unit={unit};" if unit else ""
    data = base64.b64encode(file.getvalue()).decode()
    return f"data:application/x-npy;name={name};{places}base64,{data}"


def label(value: Any) -> Any:
    """A value as tables have it: of data in place of a file their name."""
    named = re.match("data:[^,]*;name=([^;,]*)", value) if isinstance(value, str) else None
    return named[1] if named else value


def shown(value: Any) -> str:
    """A value for people, without the data in place of a file."""
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key!r}: {shown(entry)}' for key, entry in value.items())}}}"
    if isinstance(value, str) and value.startswith("data:"):
        return repr(f"{value.partition(',')[0]},…")
    return repr(value)
