"""Columns of the library as data sets of xarray."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from ._units import plain

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray

    from ._units import Measured

#: A column: values, symbol, units, long_name, vector.
Column = dict[str, Any]


def attributes(column: Column) -> dict[str, str]:
    """Attributes of a variable (CF conventions): units, long_name, symbol, source."""
    names = ("long_name", "units", "symbol", "source")
    return {name: column[name] for name in names if column[name] or name == "units"}


def along(columns: Mapping[str, Column], dimension: str, index: str | None = None) -> xr.Dataset:
    """Rows along one dimension; the column `index` becomes its coordinate."""
    variables = {
        name: (dimension, np.asarray(column["values"]), attributes(column))
        for name, column in columns.items()
    }
    dataset = xr.Dataset(variables)
    if index is not None and index in variables:
        dataset = dataset.rename({index: dimension}) if index != dimension else dataset
        dataset = dataset.set_coords(dimension)
    return dataset


def stacked(
    members: Sequence[xr.Dataset], dimension: str, values: Sequence[Any], attrs: dict[str, str]
) -> xr.Dataset:
    """Data sets of one shape along another dimension, whose coordinate has the values."""
    dataset = xr.concat(members, dimension, join="override", combine_attrs="override")
    return dataset.assign_coords({dimension: (dimension, list(values), attrs)})


def on_grid(
    columns: Mapping[str, Column], axes: tuple[NDArray[np.float64], NDArray[np.float64]]
) -> xr.Dataset:
    """Fields over ``time``, y and x; not a number outside of the contact."""
    dimensions = ("time", "y", "x")
    coordinates = {"x": columns["x"], "y": columns["y"]}
    variables = {
        f"centroid_{name}" if name in coordinates else name: (
            dimensions,
            column["values"],
            attributes(column),
        )
        for name, column in columns.items()
    }
    contact = ~np.isnan(columns["covered"]["values"])
    variables["contact"] = (dimensions, contact, {"long_name": "cell in contact", "units": ""})
    coords = {
        name: (name, axis, attributes(coordinates[name]))
        for name, axis in zip(("x", "y"), axes, strict=True)
    }
    return xr.Dataset(variables, coords)


def csv(data: Any, fields: Mapping[str, Measured]) -> bytes:
    """Columns by name (a mapping, data frame or data set) as a CSV file with units in its header.

    Quantities are converted to SI units; a name that has a unit of its own, such as ``load [kN]``,
    keeps it.
    """
    names = [str(name) for name in data]
    values = (plain(data[n], fields[n], n) if n in fields else data[n] for n in names)
    columns = np.broadcast_arrays(*(np.asarray(value, float) for value in values))
    units = {name: field.units for name, field in fields.items() if field.units}
    heads = [f"{name} [{units[name]}]" if name in units else name for name in names]
    rows = zip(*(column.ravel().tolist() for column in columns), strict=True)
    lines = [",".join(heads), *(",".join(map(repr, row)) for row in rows)]
    return "\n".join(lines).encode()
