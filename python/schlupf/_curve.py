"""Creep curves."""

from __future__ import annotations

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any

from ._result import Record
from ._tables import along
from .warnings import emit

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.axes import Axes

    from . import _core


class Curve(Record):
    """Forces along a path of creepages: the documented JSON as attributes, the points as data set."""

    #: Creepages in their order.
    VARIED = ("creepage_x", "creepage_y", "spin")

    _curve: _core.CreepCurve

    @classmethod
    def _new(cls, curve: _core.CreepCurve, *, warn: bool) -> Curve:
        result = cls(json.loads(curve.json()))
        result._curve = curve
        if warn:
            emit(result.messages, stacklevel=3)
        return result

    @property
    def messages(self) -> list[tuple[str, str, str]]:
        """The warnings: code, field or quantity, text."""
        return self._curve.warnings()

    @cached_property
    def points(self) -> xr.Dataset:
        """The points along ``point``: creepages, forces, power, temperature, status."""
        dataset = along(self._curve.points(), "point")
        return dataset.set_coords([name for name in (*self.VARIED, "speed") if name in dataset])

    @property
    def varied(self) -> str:
        """The creepage that varies most."""
        points = self.points
        widths = {name: float(abs(points[name][-1] - points[name][0])) for name in self.VARIED}
        return max(widths, key=lambda name: widths[name])

    def to_dataframe(self) -> pd.DataFrame:
        """The points as a data frame of pandas."""
        return self.points.to_dataframe()

    def summary(self) -> str:
        """The summary that the command prints."""
        return self._curve.summary()

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the forces over the creepage that varies."""
        from ._plots import curve

        return curve(self, ax, **style)

    def __repr__(self) -> str:
        return self.summary().rstrip()
