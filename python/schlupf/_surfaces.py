"""Surfaces of instruments, by the packages that read them."""

from __future__ import annotations

from importlib import import_module
from os import PathLike, fspath
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from ._errors import quoted
from ._units import refused, without_mask

#: Endings of the files that the library itself reads.
OWN = (".csv", ".npy", ".x3p", ".xyz")


def open_surface(path: str | PathLike[str]) -> xr.DataArray:
    """The heights (m) in a file of an instrument over x and y (m), not a number in holes.

    The formats are those of the packages surfalize (``.sur``, ``.al3d``, ``.plu``, ``.sdf``,
    ``.opd``, ``.nms`` …) and SurfaceTopography (``.mnt``, ``.nid``, ``.ibw``, ``.frt`` …), of which
    the extra ``surfaces`` has both. What they read is taken as it is: `roughness` tells holes,
    removes the form, and refuses heights in a wrong unit.

    Parameters
    ----------
    path : path
        The file.

    Raises
    ------
    OSError
        If it cannot be read.
    ValueError
        If no package reads it.
    ImportError
        If neither package is installed.

    Examples
    --------
    >>> heights = schlupf.open_surface("rail.sur")  # doctest: +SKIP
    >>> schlupf.roughness(heights, form="cylinder")  # doctest: +SKIP
    """
    path = Path(path)
    # One that is missing is told as such.
    with open(path, "rb"):
        pass
    reasons = []
    missing = 0
    for name, read in (("surfalize", _by_surfalize), ("SurfaceTopography", _by_topography)):
        try:
            heights = as_array(read(path), fspath(path))
        except ImportError:
            missing += 1
            reasons.append(f"{name}: not installed")
        # Whatever they raise for a file that they do not read.
        except Exception as error:
            reasons.append(f"{name}: {quoted(str(error))}")
        else:
            if heights is not None:
                return heights.assign_attrs(source=f"{path.name}, read by {name}")
            reasons.append(f"{name}: no heights")
    if missing == 2:
        raise ImportError(f"{path}: surfalize or SurfaceTopography reads it (extra `surfaces`)")
    raise ValueError(f"{path} must be a file of a surface, but is not: {'; '.join(reasons)}")


def _by_surfalize(path: Path) -> Any:
    return import_module("surfalize").Surface.load(path)


def _by_topography(path: Path) -> Any:
    return import_module("SurfaceTopography").read_topography(fspath(path))


def as_array(value: Any, name: str) -> xr.DataArray | None:
    """Heights of a surface of one of these packages; `None` if it is none.

    Raises
    ------
    CaseError
        If it has no unit.
    """
    if hasattr(value, "physical_sizes") and hasattr(value, "heights"):
        return _of_topography(value, name)
    if all(hasattr(value, part) for part in ("step_x", "step_y", "data")):
        # All lengths of surfalize are in µm.
        data = 1e-6 * without_mask(value.data)
        steps = {"y": 1e-6 * value.step_y, "x": 1e-6 * value.step_x}
        return _over(data, steps)
    return None


def _of_topography(topography: Any, name: str) -> xr.DataArray:
    try:
        topography = topography.to_unit("m")
        heights = without_mask(topography.heights())
    except Exception as error:
        reason = quoted(str(error))
        raise refused(name, f"{name} must have a unit of length, but has not: {reason}") from None
    if heights.ndim == 1:
        places = np.asarray(topography.positions(), float)
        return xr.DataArray(heights, {"x": places}, ("x",), attrs={"units": "m"})
    # Its first axis is x.
    return _over(heights.T, dict(zip("xy", topography.pixel_size, strict=True)))


def _over(heights: np.ndarray[Any, Any], steps: dict[str, float]) -> xr.DataArray:
    """With rows along x."""
    axes = dict(zip("yx", heights.shape, strict=True))
    places = {axis: (axis, steps[axis] * np.arange(axes[axis]), {"units": "m"}) for axis in axes}
    return xr.DataArray(heights, places, ("y", "x"), attrs={"units": "m", "long_name": "height"})
