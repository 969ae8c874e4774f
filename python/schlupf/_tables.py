"""Columns of the library as data sets of xarray."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from ._fields import column

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray


#: A column: values, symbol, units, long_name, vector.
Column = dict[str, Any]


def attributes(of: Column) -> dict[str, str]:
    """Attributes of a variable (CF conventions): units, long_name, symbol, definition, source."""
    names = ("long_name", "units", "symbol", "definition", "source")
    return {name: of[name] for name in names if of.get(name) or name == "units"}


def along(columns: Mapping[str, Column], dimension: str, index: str | None = None) -> xr.Dataset:
    """Rows along one dimension; the column `index` becomes its coordinate."""
    variables = {
        column(name): (dimension, np.asarray(of["values"]), attributes(of))
        for name, of in columns.items()
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
            of["values"],
            attributes(of),
        )
        for name, of in columns.items()
    }
    contact = ~np.isnan(columns["covered"]["values"])
    variables["contact"] = (dimensions, contact, {"long_name": "cell in contact", "units": ""})
    coords = {
        name: (name, axis, attributes(coordinates[name]))
        for name, axis in zip(("x", "y"), axes, strict=True)
    }
    return xr.Dataset(variables, coords)
