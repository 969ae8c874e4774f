"""Plots with matplotlib. Each returns its axes and takes `ax`."""

from __future__ import annotations

import base64
import functools
import io
import textwrap
from typing import TYPE_CHECKING, Any, Literal, ParamSpec, TypeVar, cast

import numpy as np

from ._errors import UnknownName, no_such, quoted
from ._prefixes import scaled
from ._record import Record

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import xarray as xr
    from matplotlib.animation import FuncAnimation
    from matplotlib.axes import Axes
    from matplotlib.collections import QuadMesh
    from matplotlib.figure import Figure
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path
    from numpy.typing import NDArray

    from ._result import Result
    from .records import CellColumn, InstantColumn, Normal

#: Width of a figure of one column, in inches.
WIDTH = 3.5

#: Fields that vanish at the edge of the contact: means over whole cells, also half covered ones.
BOUNDED = ("pressure", "traction_x", "traction_y", "friction_power")

#: Number of arrows along the longer side of a patch.
ARROWS = 15

TITLE_SIZE = 8.0

STYLE = {
    "font.size": 8.0,
    "axes.titlesize": TITLE_SIZE,
    "axes.linewidth": 0.6,
    "figure.constrained_layout.use": True,
    "legend.frameon": False,
    "lines.linewidth": 1.2,
    "savefig.dpi": 300.0,
}


#: What separates the words of a name.
WORDS = str.maketrans("._-", "   ")

P = ParamSpec("P")
R = TypeVar("R")


def styled(plot: Callable[P, R]) -> Callable[P, R]:
    """Draws in the style of this module."""

    @functools.wraps(plot)
    def styled(*args: P.args, **kwargs: P.kwargs) -> R:
        try:
            import matplotlib.pyplot as plt
        except ImportError as error:
            raise ImportError("plots need matplotlib (extra `plot`)") from error
        # Not rc_context: while the backend of a notebook is loading it would undo its settings.
        before = {name: plt.rcParams[name] for name in STYLE}
        plt.rcParams.update(STYLE)
        try:
            return plot(*args, **kwargs)
        finally:
            plt.rcParams.update(before)

    return styled


def axes_or_new(ax: Axes | None, height: float = 2.4) -> Axes:
    """The given axes, or those of a new figure."""
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    # Compressed, so that the bar of a map with equal scales is not taller than the map.
    return plt.subplots(figsize=(WIDTH, height), layout="compressed")[1]


def set_title(ax: Axes, text: str) -> None:
    """A title in lines of the width of the axes, so that neighbours and colour bars are clear."""
    ax.set_title(wrapped(ax, text))


def wrapped(ax: Axes, text: str) -> str:
    """A text broken into lines of the width of the axes."""
    figure = cast("Figure", ax.figure)
    # Half the font size is the mean width of a character.
    characters = ax.get_position().width * figure.get_figwidth() * 72.0 / (0.5 * TITLE_SIZE)
    return textwrap.fill(text, max(16, int(characters)))


def legend_beside(ax: Axes, **options: Any) -> None:
    """A legend that covers nothing."""
    ax.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), **options)


def legend_above(ax: Axes, **options: Any) -> None:
    """A legend over the axes, for several lines of text."""
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), **options)


def line(ax: Axes, x: Any, y: Any, label: str, style: dict[str, Any], **own: Any) -> None:
    """A line with a label and a style of its own, where the given style says nothing else."""
    from matplotlib.cbook import normalize_kwargs
    from matplotlib.lines import Line2D

    # Short names, such as `c`, in place of our long ones.
    ax.plot(x, y, **{"label": label, **own, **normalize_kwargs(style, Line2D)})


class ResultPlots:
    """The plots of a result: ``result.plot.traction()`` and others.

    Positions are in mm; the wheel rolls towards +x.
    """

    def __init__(self, result: Result) -> None:
        self._result = result

    def _fields(self) -> xr.Dataset:
        fields = self._result.fields
        if not len(fields["x"]):
            raise ValueError(f"the method {self._result.method} gives forces, but no fields")
        return fields

    @styled
    def traction(self, ax: Axes | None = None, *, arrows: bool = True, **style: Any) -> Axes:
        """Magnitude of the traction on the wheel, with arrows and the border of the stick zone."""
        ax = self._vectors("traction", "traction on the wheel", ax, arrows, style)
        self._stick(ax)
        return ax

    @styled
    def pressure(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Normal pressure."""
        return self._map(shown(self._fields(), "pressure"), "pressure", ax, **style)

    @styled
    def slip(self, ax: Axes | None = None, *, arrows: bool = True, **style: Any) -> Axes:
        """Slip velocity of the wheel over the rail."""
        return self._vectors("slip", "slip velocity", ax, arrows, style)

    @styled
    def stick_slip(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Where the contact sticks and where it slides."""
        from matplotlib.colors import ListedColormap
        from matplotlib.patches import Patch

        fields = self._fields()
        ax = axes_or_new(ax)
        colors = ["#4477aa", "#ee6677"]
        sliding = fields["sliding"].where(fields["contact"])
        shown = {"cmap": ListedColormap(colors), "vmin": 0, "vmax": 1, **style}
        mesh = _mesh(ax, sliding, 1.0, **shown)
        self._cut_to_patch(ax)
        shown_colors = [cast("Any", mesh.cmap(mesh.norm(sliding))) for sliding in (0.0, 1.0)]
        labels = zip(shown_colors, ("stick", "slip"), strict=True)
        legend_beside(ax, handles=[Patch(color=color, label=label) for color, label in labels])
        _patch_axes(ax, self._result.title)
        return ax

    @styled
    def temperature(self, ax: Axes | None = None, *, body: str = "wheel", **style: Any) -> Axes:
        """Temperature of the surface of the wheel or the rail, in °C."""
        if body not in ("wheel", "rail"):
            raise ValueError(f"body must be 'wheel' or 'rail', but is {quoted(body)}")
        rise = self._fields()[f"temperature_rise_{body}"]
        found = self._result.temperature
        bulk = found[f"max_{body}"] - found[f"max_rise_{body}"]
        celsius = (rise + bulk).assign_attrs(units="degC")
        label = f"temperature, {body}"
        return self._map(celsius, label, ax, **{"cmap": "inferno", **style})

    @styled
    def cut(
        self,
        *names: CellColumn | Literal["friction_limit"],
        y: float | str | None = None,
        x: float | str | None = None,
        ax: Axes | None = None,
        **style: Any,
    ) -> Axes:
        """Fields along a line: at `y` along rolling (by default 0), or at `x` across.

        Parameters
        ----------
        *names : str
            Variables of ``result.fields``; by default pressure times friction and tractions.
        """
        if x is not None and y is not None:
            raise TypeError("a cut is at x or at y")
        from ._case import length

        fields = self._fields()
        fields = fields.assign(
            friction_limit=(fields["pressure"] * fields["friction_coefficient"]).assign_attrs(
                units="Pa", long_name="friction limit"
            )
        )
        along = "x" if x is None else "y"
        place = {"y": 0.0 if y is None else y} if x is None else {"x": x}
        ((axis, where),) = place.items()
        where = length(axis, where)
        place = {axis: where}
        ends = fields[axis].values[[0, -1]]
        half = 0.5 * abs(fields[axis].values[1] - ends[0]) if fields.sizes[axis] > 1 else np.inf
        if not ends.min() - half <= where <= ends.max() + half:
            low, high = ends.min() - half, ends.max() + half
            raise ValueError(f"{axis} must be from {low:.3g} to {high:.3g} m, but is {where:.3g}")
        row = fields.sel(place, method="nearest")
        names = names or ("friction_limit", "traction_x", "traction_y")
        entries = [variable(row, name) for name in names]
        factor, unit = common_unit(entries, "a cut")
        ax = axes_or_new(ax)
        for entry in entries:
            label = entry.attrs.get("long_name") or str(entry.name)
            line(ax, row[along] * 1e3, entry * factor, label, style)
        ax.set_xlabel(f"${along}$ (mm)")
        ax.set_ylabel(unit)
        legend_above(ax)
        return ax

    @styled
    def surface(self, name: CellColumn = "pressure", ax: Axes | None = None, **style: Any) -> Axes:
        """A field as a surface over the patch, as in the figures of Neuhaus and Sextro (2014)."""
        import matplotlib.pyplot as plt
        from mpl_toolkits.mplot3d import Axes3D  # type: ignore[import-untyped]

        values = variable(self._fields(), name).fillna(0.0)
        factor, unit = scaled(largest(values), values.attrs["units"])
        if ax is None:
            _, ax = plt.subplots(figsize=(WIDTH, 3.0), subplot_kw={"projection": "3d"})
        if not isinstance(ax, Axes3D):
            raise TypeError("ax must be three-dimensional, of projection '3d'")
        x, y = np.meshgrid(values["x"] * 1e3, values["y"] * 1e3)
        colors = {} if {"color", "facecolors"} & style.keys() else {"cmap": "viridis"}
        ax.plot_surface(x, y, values.values * factor, **{**colors, **style})
        ax.set_xlabel("$x$ (mm)")
        ax.set_ylabel("$y$ (mm)")
        ax.set_zlabel(labelled(values.assign_attrs(units=unit)))
        # Its labels stand outside of the box.
        ax.set_box_aspect(None, zoom=0.8)
        set_title(cast("Axes", ax), self._result.title)
        return cast("Axes", ax)

    @styled
    def history(self, *names: InstantColumn, ax: Axes | None = None, **style: Any) -> Axes:
        """Numbers of ``result.history`` over time; by default the forces over the load."""
        history = self._result.history
        if history.sizes["time"] < 2:
            raise ValueError("steady rolling has no history: give the case one")
        ax = axes_or_new(ax)
        if not names:
            for name in ("force_x", "force_y"):
                ratio = history[name] / history["normal_load"]
                line(ax, history["time"] * 1e3, ratio, f"$F_{name[-1]}/N$", style)
            ax.set_ylabel("force on the wheel over load")
        else:
            entries = [variable(history, name) for name in names]
            factor, unit = common_unit(entries, "a history")
            for entry in entries:
                line(ax, history["time"] * 1e3, entry * factor, str(entry.long_name), style)
            ax.set_ylabel(unit)
        ax.set_xlabel("time (ms)")
        legend_above(ax)
        return ax

    def animation(
        self, field: CellColumn = "traction_x", *, ax: Axes | None = None, **options: Any
    ) -> FuncAnimation:
        """A field over time, where the case was solved with ``fields_every``; see `animate`."""
        return frames(self._result, field, ax=ax, **options)

    def _map(self, values: xr.DataArray, label: str, ax: Axes | None, **style: Any) -> Axes:
        ax = colored_map(values, label, ax, **style)
        self._cut_to_patch(ax)
        _patch_axes(ax, self._result.title)
        return ax

    def _cut_to_patch(self, ax: Axes) -> None:
        """Cuts the last map along the edge of the contact, where cells are half covered."""
        edge = _ellipse(self._fields(), self._result.normal)
        edge = edge or _outline(self._fields()["covered"].fillna(0.0))
        mesh = ax.collections[-1]
        mesh.set_clip_path(edge, ax.transData)
        ax.add_patch(_line_along(edge))
        # Room for the line.
        ax.use_sticky_edges = False
        ax.margins(0.03)

    def _vectors(
        self, name: str, label: str, ax: Axes | None, arrows: bool, style: dict[str, Any]
    ) -> Axes:
        """The magnitude of a vector field, with arrows."""
        fields = self._fields()
        x, y = shown(fields, f"{name}_x"), shown(fields, f"{name}_y")
        ax = self._map(_magnitude(x, y), label, ax, **style)
        if arrows:
            self._arrows(ax, x, y)
        return ax

    def _arrows(self, ax: Axes, x: xr.DataArray, y: xr.DataArray) -> None:
        if largest(x) == largest(y) == 0.0:
            return
        step = max(1, -(-max(x.shape) // ARROWS))
        part = {name: slice(step // 2, None, step) for name in ("x", "y")}
        x, y = x.isel(part), y.isel(part)
        ax.quiver(x["x"] * 1e3, x["y"] * 1e3, x, y, color="white", pivot="mid", width=0.004)

    def _stick(self, ax: Axes) -> None:
        sliding = self._fields()["sliding"].astype(float)
        if 0.0 < float(sliding.where(self._fields()["contact"]).mean()) < 1.0:
            inside = sliding.where(self._fields()["contact"])
            ax.contour(
                inside["x"] * 1e3, inside["y"] * 1e3, inside, [0.5], colors="black", linewidths=0.8
            )

    def _thumbnail(self) -> str | None:
        """A small map of the traction as PNG in base64; nothing without matplotlib."""
        try:
            from matplotlib.backends.backend_agg import FigureCanvasAgg
            from matplotlib.figure import Figure
        except ImportError:
            return None
        figure = Figure(figsize=(WIDTH, 2.2), dpi=96, layout="constrained")
        FigureCanvasAgg(figure)
        self.traction(figure.add_subplot())
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png")
        return base64.b64encode(buffer.getvalue()).decode("ascii")


def shown(fields: xr.Dataset, name: str) -> xr.DataArray:
    """A field as a map shows it: of a cell at the edge, the mean over its covered part."""
    values = variable(fields, name)
    if name not in BOUNDED:
        return values
    return (values / fields["covered"]).assign_attrs(values.attrs)


def _ellipse(fields: xr.Dataset, normal: Normal) -> Path | None:
    """The edge of a contact with the pressure of Hertz in mm; none of another."""
    from matplotlib.path import Path

    a, b = normal.semi_axis_x, normal.semi_axis_y
    inside = np.clip(1.0 - (fields["x"] / a) ** 2 - (fields["y"] / b) ** 2, 0.0, None)
    whole = fields["covered"] > 0.999
    difference = fields["pressure"] / normal.peak_pressure - np.sqrt(inside)
    cells = np.pi * a * b
    for name in ("x", "y"):
        cells /= _with_step(fields[name].values)[1]
    same_area = abs(float(fields["covered"].sum()) / cells - 1.0) < 0.02
    if not same_area or largest(difference.where(whole, 0.0)) > 0.1:
        return None
    angles = np.linspace(0.0, 2.0 * np.pi, 361)
    return Path(1e3 * np.column_stack([a * np.cos(angles), b * np.sin(angles)]), closed=True)


def _outline(covered: xr.DataArray) -> Path:
    """The edge of the contact in mm, from the covered parts of the cells."""
    from contourpy import contour_generator
    from matplotlib.path import Path

    # Cells around the grid, in which there is no contact.
    padded = np.pad(covered.values, 1)
    x, y = (
        np.concatenate(([axis[0] - step], axis, [axis[-1] + step]))
        for axis, step in (_with_step(covered[name].values * 1e3) for name in ("x", "y"))
    )
    lines = contour_generator(x, y, padded).lines(0.5)
    return Path.make_compound_path(*(Path(cast("Any", line), closed=True) for line in lines))


def _with_step(axis: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    return axis, float(axis[1] - axis[0]) if len(axis) > 1 else 1.0


def _line_along(edge: Path) -> PathPatch:
    from matplotlib.patches import PathPatch

    return PathPatch(edge, fill=False, edgecolor="black", linewidth=0.5)


def _magnitude(x: xr.DataArray, y: xr.DataArray) -> xr.DataArray:
    return cast("xr.DataArray", np.hypot(x, y)).assign_attrs(units=x.attrs["units"])


def colored_map(values: xr.DataArray, label: str, ax: Axes | None, **style: Any) -> Axes:
    """Values over x and y with a colour bar; a new figure where `ax` is none."""
    ax = axes_or_new(ax)
    factor, unit = scaled(largest(values), values.attrs["units"])
    mesh = _mesh(ax, values, factor, **{"cmap": "viridis", **style})
    _color_bar(mesh, ax, f"{label} ({unit})" if unit else label)
    _places(ax)
    return ax


def _color_bar(mesh: QuadMesh, ax: Axes | Sequence[Axes], label: str) -> None:
    figure = cast("Figure", mesh.get_figure())
    figure.colorbar(mesh, ax=ax, shrink=0.8, label=label)


def _places(ax: Axes) -> None:
    ax.set_xlabel("$x$ (mm)")
    ax.set_ylabel("$y$ (mm)")
    ax.set_aspect("equal")
    from matplotlib.ticker import MaxNLocator

    sides = [(ax.xaxis, np.ptp(ax.get_xlim())), (ax.yaxis, np.ptp(ax.get_ylim()))]
    longest = max(width for _, width in sides)
    for axis, width in sides:
        # Room for the numbers of a slender patch.
        if width < 0.4 * longest:
            axis.set_major_locator(MaxNLocator(1 if width < 0.2 * longest else 3))
    if sides[0][1] < 0.2 * longest:
        ax.tick_params(axis="x", labelrotation=90)


def variable(fields: xr.Dataset, name: str) -> xr.DataArray:
    """A variable of fields or of a history.

    Raises
    ------
    KeyError
        If there is none of this name.
    """
    if not isinstance(name, str) or name not in fields.data_vars:
        raise UnknownName(no_such("field", name, fields.data_vars))
    return fields[name]


def labelled(values: xr.DataArray) -> str:
    """Label of an axis: what it is, and its unit."""
    name, unit = str(values.attrs["long_name"]), values.attrs["units"]
    return f"{name} ({unit})" if unit else name


def common_unit(entries: Sequence[xr.DataArray], of: str) -> tuple[float, str]:
    """Factor and unit with a prefix of what shares an axis.

    Raises
    ------
    ValueError
        If there are several units.
    """
    units = sorted({entry.attrs["units"] for entry in entries})
    if len(units) > 1:
        raise ValueError(f"fields of {of} must have one unit, but have {units}")
    return scaled(max(largest(entry) for entry in entries), units[0])


def words(name: str) -> str:
    """A dotted field or a column in words."""
    return name.removeprefix("kinematics.").removeprefix("normal.").translate(WORDS)


def largest(values: xr.DataArray) -> float:
    """The largest magnitude; zero without a number."""
    magnitudes = np.abs(np.asarray(values))
    return float(np.max(magnitudes, initial=0.0, where=~np.isnan(magnitudes)))


def _mesh(ax: Axes, values: xr.DataArray, factor: float, **style: Any) -> QuadMesh:
    style = {"shading": "nearest", **style}
    return ax.pcolormesh(values["x"] * 1e3, values["y"] * 1e3, values * factor, **style)


def _patch_axes(ax: Axes, title: str) -> None:
    ax.set_xlabel("$x$ (mm), rolling →")
    ax.set_ylabel("$y$ (mm)")
    ax.set_aspect("equal")
    set_title(ax, title)


@styled
def comparison(
    results: Sequence[Result],
    field: CellColumn = "pressure",
    labels: Sequence[str] | None = None,
    ax: Sequence[Axes] | None = None,
) -> list[Axes]:
    """Maps of one field of several results side by side, with the same colours.

    Parameters
    ----------
    results : sequence of Result
        At least one.
    field : str
        Variable of their fields.
    labels : sequence of str, optional
        Titles of the maps; by default those of the cases.
    ax : sequence of Axes, optional
        One for each result.
    """
    import matplotlib.pyplot as plt

    if isinstance(results, Record) or not len(results):
        raise TypeError("a comparison takes several results: [result, result, …]")
    if ax is None:
        size = (WIDTH * len(results), 2.4)
        _, grid = plt.subplots(1, len(results), figsize=size, squeeze=False, layout="compressed")
        ax = list(grid[0])
    elif len(ax) != len(results):
        raise ValueError(
            f"ax must have {len(results)} axes, one for each result, but has {len(ax)}"
        )
    fields = [shown(result.fields, field) for result in results]
    bound = max(largest(values) for values in fields)
    factor, unit = scaled(bound, fields[0].attrs["units"])
    colors = _colors(fields, bound * factor)
    names = labels or [result.title for result in results]
    for axes, result, values, name in zip(ax, results, fields, names, strict=True):
        mesh = _mesh(axes, values, factor, **colors)
        ResultPlots(result)._cut_to_patch(axes)
        _patch_axes(axes, name)
    _color_bar(mesh, list(ax), labelled(fields[0].assign_attrs(units=unit)))
    return list(ax)


@styled
def frames(
    results: Result | Sequence[Result],
    field: CellColumn = "traction_x",
    *,
    ax: Axes | None = None,
    **options: Any,
) -> FuncAnimation:
    """An animation of one field over time.

    Parameters
    ----------
    results : Result or sequence of Result
        A result with a `Result.field_history`, or results of successive times on one grid.
    field : str
        Variable of their fields.
    ax : Axes, optional
        Where to draw; by default axes of a new figure.
    **options
        Of `matplotlib.animation.FuncAnimation`, such as ``interval`` (ms).
    """
    from matplotlib.animation import FuncAnimation

    shown, titles = _over_time(results, field)
    if not shown:
        raise ValueError("animate needs results, but there are none")
    if len({values.shape for values in shown}) != 1:
        raise ValueError("the results must be on one grid")
    ax = axes_or_new(ax)
    bound = max(largest(values) for values in shown)
    factor, unit = scaled(bound, shown[0].attrs["units"])
    mesh = _mesh(ax, shown[0], factor, **_colors(shown, bound * factor))
    _color_bar(mesh, ax, labelled(shown[0].assign_attrs(units=unit)))
    _patch_axes(ax, titles[0])

    def draw(k: int) -> list[QuadMesh]:
        mesh.set_array((shown[k] * factor).values)
        # Not set_title, which would take the font size of whoever shows the film.
        ax.title.set_text(wrapped(ax, titles[k]))
        return [mesh]

    options = {"frames": len(shown), **options}
    return FuncAnimation(cast("Figure", ax.figure), draw, **options)


def _colors(shown: Sequence[xr.DataArray], bound: float) -> dict[str, Any]:
    """Colours for fields with a largest magnitude: around zero where there are both signs."""
    bound = bound or 1.0
    if any(float(values.min()) < 0.0 for values in shown):
        return {"vmin": -bound, "vmax": bound, "cmap": "RdBu"}
    return {"vmin": 0.0, "vmax": bound, "cmap": "viridis"}


def _over_time(
    results: Result | Sequence[Result], field: str
) -> tuple[list[xr.DataArray], list[str]]:
    """A field at successive times, with a title for each."""
    if isinstance(results, Record):
        values = variable(results.field_history, field)
        shown = [values.isel(time=k) for k in range(values.sizes["time"])]
        return shown, [f"{results.title}, {float(v['time']) * 1e3:.4g} ms" for v in shown]
    results = list(results)
    if not all(hasattr(result, "fields") for result in results):
        raise TypeError("animate takes a result, or results of successive times")
    shown = [variable(result.fields, field) for result in results]
    return shown, [result.title for result in results]
