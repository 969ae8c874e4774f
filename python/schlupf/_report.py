"""What a case can be asked besides its solution: records with tables."""

from __future__ import annotations

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

import numpy as np
import xarray as xr

from . import _core
from ._errors import NotConverged
from ._fields import FIELDS, quantity
from ._record import Record
from ._result import Saved, restored, table, written
from ._status import numbered
from ._tables import along, attributes, stacked
from .warnings import emit

if TYPE_CHECKING:
    from collections.abc import Sequence
    from os import PathLike

    import numpy.typing as npt
    import pandas as pd
    from matplotlib.axes import Axes

    from ._case import Case
    from ._report_plots import RoughContactPlots


R = TypeVar("R", bound="Report")


class Report(Record):
    """Results of a task: the documented JSON as attributes, tables as data sets."""

    #: The kinds of results with more than that, by the names of their tasks.
    #:
    #: :meta private:
    OF_TASKS: ClassVar[dict[str, type[Report]]] = {}

    _report: _core.Report

    def __init_subclass__(cls, task: str) -> None:
        Report.OF_TASKS[task] = cls

    #: What a pickled one keeps besides.
    _OWN = ("_case", "_over")

    @classmethod
    def _new(cls: type[R], report: _core.Report, *, warn: bool, strict: bool, depth: int) -> R:
        result = cls(json.loads(report.json()))
        result._report = report
        if strict and not result.converged:
            raise NotConverged(result)
        if warn:
            emit(result.messages, stacklevel=depth)
        return result

    if TYPE_CHECKING:
        # Their names are those of the documented JSON.
        def __getattr__(self, name: str) -> Any: ...

    def _finish(self, case: Case, families: dict[str, list[tuple[str, list[Any]]]]) -> None:
        """Keeps what only the case or the request knows."""

    @property
    def converged(self) -> bool:
        """Whether all equations are satisfied to the tolerance."""
        return self._report.status() == "converged"

    @property
    def messages(self) -> list[tuple[str, str, str]]:
        """The warnings: code, field or quantity, text."""
        return self._report.warnings()

    @cached_property
    def _tables(self) -> dict[str, list[dict[str, Any]]]:
        return self._report.tables()

    @cached_property
    def tables(self) -> dict[str, list[xr.Dataset]]:
        """All tables by name, with their rows along ``row``; a name may have several of a kind."""
        tables = self._tables.items()
        return {name: [along(columns, "row") for columns in each] for name, each in tables}

    def summary(self) -> str:
        """The summary that the command prints."""
        return self._report.summary()

    def to_json(self, path: str | PathLike[str] | None = None) -> str:
        """The documented JSON; it is also written to `path` if that is given."""
        return written(self._report.json(), path)

    def drawings(self) -> dict[str, str]:
        """The figures that the command draws, as SVG, by name."""
        return dict(self._report.drawings())

    def __repr__(self) -> str:
        return self.summary().rstrip()

    def _repr_html_(self) -> str:
        """The summary as a table."""
        return table(self._report.lines())

    def __reduce__(self) -> Any:
        own = {name: self.__dict__[name] for name in self._OWN if name in self.__dict__}
        return restored, (type(self), {"_report": Saved.of(self._report), **own})


class Curve(Report, task="curve"):
    """Creep curves: forces along a path of creepages, for one case or several.

    With ``points`` along ``point``, and along the fields that differ where there are several
    curves; with a ``map``.

    >>> import schlupf
    >>> case = schlupf.Case(grid={"cells_x": 16, "cells_y": 16})
    >>> curve = case.curve(creepage_x=(0.0, 0.02), points=9, over={"normal.load": [60e3, 80e3]})
    >>> dict(curve.points.sizes)
    {'normal_load': 2, 'point': 9}
    """

    #: Creepages in their order.
    VARIED = ("creepage_x", "creepage_y", "spin")

    _over: Sequence[tuple[str, list[Any]]] = ()

    def _finish(self, case: Case, families: dict[str, list[tuple[str, list[Any]]]]) -> None:
        self._over = families["over"]

    @cached_property
    def points(self) -> xr.Dataset:
        """The points along ``point``: creepages, forces, power, temperature, status.

        Several curves lie along the field that differs, such as ``speed`` or
        ``friction_coefficient``, whose coordinate has its values (in SI units) and whose attribute
        ``field`` its path; those over two fields along both.
        """
        members = [numbered(along(columns, "point")) for columns in self._tables["points"]]
        for field, values in reversed(self._over):
            name = quantity(field)
            # That of the points is the same for all of a curve.
            members = [member.drop_vars(name, errors="ignore") for member in members]
            attrs = {"field": field, "units": FIELDS[field].units, "long_name": FIELDS[field].doc}
            count = len(values)
            rows = [members[k : k + count] for k in range(0, len(members), count)]
            members = [stacked(row, name, values, attrs) for row in rows]
        dataset = members[0]
        return dataset.set_coords([name for name in (*self.VARIED, "speed") if name in dataset])

    @cached_property
    def map(self) -> xr.Dataset:
        """Quantities over the creepage and the field, or of the largest force over two fields.

        The coordinates are named as in `points`. What has not converged is not a number.

        Raises
        ------
        ValueError
            If the curves are not over a field with three numbers or more, or over two fields.
        """
        found = json.loads(self._report.json())["map"]
        if found is None:
            raise ValueError("a map needs a field with at least three numbers, or two fields")
        axes = [{**axis, "name": quantity(axis["name"])} for axis in (found["y"], found["x"])]
        dimensions = [axis["name"] for axis in axes]
        coords = {
            axis["name"]: (axis["name"], axis["values"], {"units": axis["unit"]}) for axis in axes
        }
        # A creepage of every point is the axis already.
        variables = {
            name: (dimensions, np.asarray(column["values"], float), {"units": column["unit"]})
            for name, column in found["columns"].items()
            if name not in coords
        }
        return xr.Dataset(variables, coords)

    @property
    def varied(self) -> str:
        """The creepage that varies most."""
        points = self.points
        widths = {n: float(points[n].max() - points[n].min()) for n in self.VARIED}
        return max(widths, key=lambda name: widths[name])

    def to_dataframe(self) -> pd.DataFrame:
        """The points as a data frame of pandas."""
        return self.points.to_dataframe()

    def to_csv(self, path: str | PathLike[str]) -> None:
        """Writes the points as CSV, as the command does."""
        written(self._report.csv() or "", path)

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the forces over the creepage that varies; of curves over two fields the map."""
        from ._report_plots import curve

        return self.plot_map(ax=ax, **style) if len(self._over) > 1 else curve(self, ax, **style)

    def plot_map(
        self, quantity: str = "traction_coefficient", ax: Axes | None = None, **style: Any
    ) -> Axes:
        """Draws labelled contours of a quantity of the `map`, over colours."""
        from ._report_plots import creep_map

        return creep_map(self, quantity, ax, **style)


class Temperatures(Report, task="temperature"):
    """Temperatures of wheel and rail below a point, and along its row with the wake.

    With ``profile`` over the depth and ``rows`` over depth and x, in °C.

    >>> import schlupf
    >>> hot = schlupf.Case(kinematics={"creepage_x": 0.02}).temperature()
    >>> hot.rows["temperature_wheel"].dims
    ('depth', 'x')
    """

    @cached_property
    def profile(self) -> xr.Dataset:
        """Temperatures below the point, over ``depth`` (m)."""
        return along(self._tables["profile"][0], "depth", "depth")

    @cached_property
    def rows(self) -> xr.Dataset:
        """Temperatures along the row and its wake, over ``depth`` and ``x`` (m)."""
        members = [along(columns, "x", "x") for columns in self._tables["rows"]]
        depths = [row["depth"] for row in self._values["rows"]]
        units = attributes(self._tables["profile"][0]["depth"])
        return stacked(members, "depth", depths, units)

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the temperatures of the surfaces along the row and its wake."""
        from ._report_plots import temperatures

        return temperatures(self, ax, **style)


class Subsurface(Report, task="subsurface"):
    """Stresses in wheel or rail below the contact.

    With ``largest``, ``profile`` and ``volume`` in Pa, and `at` for any point.

    >>> import schlupf
    >>> below = schlupf.examples.stresses_below.subsurface(warn=False)
    >>> below.at(x=0.0, y=0.0, depth=[1e-3, 2e-3])["von_mises_stress"].attrs["units"]
    'Pa'
    """

    @cached_property
    def profile(self) -> xr.Dataset:
        """Stresses below the point, over ``depth`` (m); ``x`` and ``y`` are that point."""
        return along(self._tables["profile"][0], "depth", "depth")

    @cached_property
    def volume(self) -> xr.Dataset:
        """Stresses in all layers, over ``depth``, ``y`` and ``x`` (m)."""
        columns = self._report.volume() or {}
        axes = ("depth", "y", "x")
        coords = {name: (name, columns[name]["values"], attributes(columns[name])) for name in axes}
        variables = {
            name: (axes, column["values"], attributes(column))
            for name, column in columns.items()
            if name not in axes
        }
        return xr.Dataset(variables, coords)

    def at(
        self,
        x: npt.ArrayLike | xr.DataArray,
        y: npt.ArrayLike | xr.DataArray,
        depth: npt.ArrayLike | xr.DataArray,
    ) -> xr.Dataset:
        """Stresses at points, lines or planes of any shape.

        Parameters
        ----------
        x, y, depth : array_like
            Places, in m, broadcast against each other; the depth is not negative.

        Returns
        -------
        xarray.Dataset
            Stresses over the dimensions of the places: those of data arrays, else ``dim_0`` and so
            on.

        Raises
        ------
        ValueError
            If a place is not finite or above the surface.
        TypeError
            If this result was pickled: the stresses at other points are not kept.
        """
        places = _places(x, y, depth)
        flat = [np.asarray(place, float).ravel() for place in places]
        report = self._report
        if isinstance(report, Saved):
            raise TypeError("a pickled result has no stresses at other points")
        if not all(np.isfinite(values).all() for values in flat) or (flat[2] < 0).any():
            raise ValueError("places must be finite, and the depth must not be negative")
        columns = _core.stresses_at(report, list(zip(*(v.tolist() for v in flat), strict=True)))
        first = places[0]
        variables = {
            name: (first.dims, np.reshape(column["values"], first.shape), attributes(column))
            for name, column in (columns or {}).items()
        }
        return xr.Dataset(variables).set_coords(["x", "y", "depth"])

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws von Mises's stress over x and z in the plane through the largest one."""
        from ._report_plots import subsurface

        return subsurface(self, ax, **style)


def _places(*values: npt.ArrayLike | xr.DataArray) -> list[xr.DataArray]:
    """Coordinates of points in one shape: by names of dimensions if any has some, else as NumPy."""
    if any(isinstance(value, xr.DataArray) for value in values):
        named = (v if isinstance(v, xr.DataArray) else xr.DataArray(v) for v in values)
        return list(xr.broadcast(*named))
    return [xr.DataArray(array) for array in np.broadcast_arrays(*values)]


class BulkTemperature(Report, task="bulk"):
    """The bulk temperature of the wheel in the long run.

    ``temperature.wheel`` (°C), and the balance of heat in ``heat`` (W).

    >>> import schlupf
    >>> warm = schlupf.examples.steel_wheel_braking.bulk_temperature()
    >>> warm.temperature.wheel > 20.0
    True
    """


class Calibration(Report, task="calibrate"):
    """Stiffnesses of the elastic layer for a patch.

    With how far the layer is from the half-space, and the ``case`` with them.

    >>> import schlupf
    >>> layer = schlupf.Case(grid={"cells_x": 12, "cells_y": 12}).calibrate()
    >>> layer.case.elasticity.coupling_x > 0.0
    True
    """

    _case: Case

    def _finish(self, case: Case, families: dict[str, list[tuple[str, list[Any]]]]) -> None:
        found = case.from_toml(_core.own_file(self._report, "section") or "")
        self._case = case.with_(elasticity=None).with_(elasticity=found.elasticity)

    @property
    def case(self) -> Case:
        """The case with the calibrated layer as its elasticity."""
        return self._case


class Comparison(Report, task="compare"):
    """A case by all methods.

    With ``methods`` along ``model``: forces, power, temperature rise, times in s.

    >>> import schlupf
    >>> compared = schlupf.examples.methods.compare(warn=False)
    >>> bool(compared.methods["force_x"].sel(model="Polach") < 0.0)
    True
    """

    @cached_property
    def methods(self) -> xr.Dataset:
        """Forces, power, temperature rise and time of each, along ``model``."""
        names = [entry["name"] for entry in self._values["methods"]]
        dataset = along(self._tables["methods"][0], "model")
        status = [entry["status"] for entry in self._values["methods"]]
        return dataset.assign(status=("model", status)).assign_coords(model=names)

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the longitudinal and lateral forces of all methods."""
        from ._report_plots import methods

        return methods(self, ax, **style)


class Wear(Report, task="wear"):
    """Wear, fatigue and melting per wheel passage.

    ``wear``, ``melting``, ``fatigue_index``, ``crack_damage``, ``shakedown`` and ``t_gamma``;
    ``profile`` over y and ``cells``. ``wear`` and ``melting`` are None where the method has no
    fields.

    >>> import schlupf
    >>> worn = schlupf.examples.worn_profile.wear()
    >>> worn.profile["archard"].attrs["units"]
    'm'
    """

    @cached_property
    def profile(self) -> xr.Dataset | None:
        """Depths of wear over ``y`` (m); None if the method has no fields."""
        tables = self._tables.get("profile")
        return along(tables[0], "y", "y") if tables else None

    @cached_property
    def cells(self) -> xr.Dataset | None:
        """Wear rates in the cells, along ``cell``; None if the method has no fields."""
        tables = self._tables.get("cells")
        return along(tables[0], "cell") if tables else None

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the depth of wear across the profile."""
        from ._report_plots import passage

        return passage(self, ax, **style)


class Damage(Report, task="damage"):
    """Damage over a run: energy, fatigue and wear.

    ``energy`` (J), ``t_gamma``, ``fatigue``, ``archard``, ``energy_wear``; with ``profile`` over y
    and ``run`` over the distance. States without a solution or a friction power are left out.
    """

    @cached_property
    def profile(self) -> xr.Dataset:
        """Depths of wear over ``y`` (m): of the wheel over the run, of the rail for each wheel."""
        return along(self._tables["profile"][0], "y", "y")

    @cached_property
    def run(self) -> xr.Dataset:
        """Tγ, fatigue index, energy and wear of each state, over ``distance`` (m)."""
        return along(self._tables["run"][0], "distance", "distance")

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the depth of wear of the wheel across the profile."""
        from ._report_plots import wear

        return wear(self, ax, **style)


class Fit(Report, task="fit"):
    """Parameters that fit measured creep curves.

    With their confidence, ``points`` along ``point``, and the ``case`` with them.

    >>> import schlupf
    >>> case = schlupf.Case(solver={"method": "polach"}, friction={"model": "constant"})
    >>> points = case.curve(creepage_x=(0.001, 0.02), points=9).points
    >>> ratio = -points["force_x"] / case.normal.load
    >>> measured = {"creepage_x": points["creepage_x"], "force_ratio": ratio}
    >>> fit = case.fit(["friction.coefficient"], measured)
    >>> round(fit.case.friction.coefficient, 3)
    0.4
    """

    _case: Case | None

    def _finish(self, case: Case, families: dict[str, list[tuple[str, list[Any]]]]) -> None:
        text = _core.own_file(self._report, "case")
        from ._case import rebuilt

        folder = str(case._folder)
        self._case = None if text is None else rebuilt(text, folder, case._laws)

    @cached_property
    def points(self) -> xr.Dataset:
        """Measured and fitted forces along ``point``, and their conditions."""
        return along(self._tables["points"][0], "point")

    @property
    def case(self) -> Case:
        """The case with the fitted values.

        Raises
        ------
        ValueError
            If there is none, because the fit has not converged.
        """
        if self._case is None:
            raise ValueError("no case can have the values of this fit, which has not converged")
        return self._case

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws measured points and fitted forces."""
        from ._report_plots import fit

        return fit(self, ax, **style)


class RoughContact(Report, task="roughness"):
    """A rough surface, its contact and its k_c.

    With ``fields`` over x and y, ``spectrum``, ``loads`` and ``curves``.

    >>> import schlupf
    >>> rough = schlupf.examples.measured_surface.roughness(warn=False)
    >>> rough.fields["height"].dims
    ('y', 'x')
    >>> heights = np.random.default_rng(1).normal(scale=1e-6, size=(64, 64))
    >>> rough = schlupf.roughness(heights, spacing=1e-5, pressure=[0.4e9, 0.8e9], warn=False)
    >>> round(rough.surface.root_mean_square_height * 1e6)
    1
    """

    @cached_property
    def fields(self) -> xr.Dataset:
        """Heights over ``x`` and ``y`` (m); pressures and gaps at the largest mean pressure."""
        surface = self._report.surface()
        assert surface is not None
        (dx, dy), columns = surface
        rows, count = columns["height"]["values"].shape
        axes = {"x": np.arange(count) * dx, "y": np.arange(rows) * dy}
        variables = {
            name: (("y", "x"), column["values"], attributes(column))
            for name, column in columns.items()
        }
        coords = {name: (name, axis, {"units": "m"}) for name, axis in axes.items()}
        return xr.Dataset(variables, coords)

    @cached_property
    def spectrum(self) -> xr.Dataset:
        """Power spectral density of the heights over ``wave_number`` (rad/m)."""
        return along(self._tables["spectrum"][0], "wave_number", "wave_number")

    @cached_property
    def loads(self) -> xr.Dataset:
        """Approach, gap and real contact over ``mean_pressure`` (Pa)."""
        return along(self._tables["loads"][0], "mean_pressure", "mean_pressure")

    @cached_property
    def curves(self) -> list[xr.Dataset]:
        """Traction over displacement at each mean pressure, along ``point``."""
        return [along(columns, "point") for columns in self._tables["curves"]]

    @property
    def plot(self) -> RoughContactPlots:
        """Plots: ``spectrum``, ``surface``, ``spots`` and ``curves``."""
        from ._report_plots import RoughContactPlots

        return RoughContactPlots(self)


class Wheelset(Report, task="wheelset"):
    """The contacts of a wheelset over its lateral position, and its equivalent conicity.

    With ``contacts`` of both wheels, and ``conicity``.

    >>> import schlupf
    >>> case = schlupf.examples.wheel_on_rail
    >>> moved = case.wheelset(lateral_position=("0 mm", "5 mm"), points=3)
    >>> sorted(set(moved.contacts["side"].values.tolist()))
    ['left', 'right']
    """

    @cached_property
    def contacts(self) -> xr.Dataset:
        """A row for each contact of each wheel at each position, along ``row``.

        ``lateral_position``, ``side`` and ``contact`` tell which it is; places, angles, creepages,
        patches and forces are those of `solve`, with points in their names. Where a position
        failed, ``status`` says so and ``contact`` is 0.
        """
        dataset = numbered(along(self._tables["contacts"][0], "row"))
        return dataset.set_coords(["lateral_position", "side", "contact"])

    @cached_property
    def conicity(self) -> xr.Dataset:
        """Equivalent conicity over ``amplitude`` (m) of the lateral motion of rigid bodies.

        ``equivalent_conicity`` is that by the wavelength of the nonlinear motion (EN 15302),
        ``harmonic_conicity`` that by harmonic linearisation.
        """
        return along(self._tables["conicity"][0], "amplitude", "amplitude")

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the difference of the rolling radii over the lateral position."""
        from ._report_plots import rolling_radii

        return rolling_radii(self, ax, **style)
