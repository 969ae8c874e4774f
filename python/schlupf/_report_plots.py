"""Plots of curves, temperatures, comparisons, fits and rough contacts."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ._plots import (
    axes_or_new,
    colored_map,
    labelled,
    largest,
    legend_beside,
    line,
    set_title,
    styled,
    variable,
    words,
)
from ._prefixes import scaled

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes

    from ._report import (
        Comparison,
        Curve,
        Damage,
        Fit,
        RoughContact,
        Subsurface,
        Temperatures,
        Wear,
        Wheelset,
    )

#: Largest slope of a rail at a contact on its head, in rad.
TREAD = 0.5

#: Forces on the wheel with their symbols.
FORCES = {"force_x": "$F_x$", "force_y": "$F_y$"}


@styled
def curve(curve: Curve, ax: Axes | None = None, **style: Any) -> Axes:
    """Forces of creep curves over the creepage that varies; those that are zero are left out."""
    ax = axes_or_new(ax)
    points, name = curve.points, curve.varied
    factor, unit = scaled(max(largest(points[force]) for force in FORCES), "N")
    # What is left of a force by rounding is none.
    noise = 1e-9 * max(largest(points[force]) for force in FORCES)
    shown = {force: symbol for force, symbol in FORCES.items() if largest(points[force]) > noise}
    over = next((str(name) for name in points.dims if name != "point"), None)
    members = [points.isel({over: k}) for k in range(points.sizes[over])] if over else [points]
    for number, member in enumerate(members):
        of_member = _member(member[over]) if over else ""
        for dashes, (force, symbol) in zip(("-", "--"), shown.items(), strict=False):
            label = f"{symbol}, {of_member}" if of_member else symbol
            own = {"color": f"C{number}", "linestyle": dashes} if of_member else {}
            line(ax, member[name], member[force] * factor, label, style, **own)
    ax.set_xlabel(labelled(points[name]))
    ax.set_ylabel(f"force on the wheel ({unit})")
    if over:
        legend_beside(ax, title=words(points[over].attrs["field"]))
    else:
        ax.legend()
    set_title(ax, curve.title)
    return ax


@styled
def creep_map(curve: Curve, quantity: str, ax: Axes | None = None, **style: Any) -> Axes:
    """Labelled contours of a quantity over two others, over colours."""
    found = curve.map
    values = variable(found, quantity)
    ax = axes_or_new(ax)
    y, x = (found[str(name)] for name in values.dims)
    filled = ax.contourf(x, y, values, **{"levels": 32, **style})
    lines = ax.contour(x, y, values, levels=8, colors="black", linewidths=0.8)
    ax.clabel(lines, fontsize="small")
    figure = ax.figure
    assert figure is not None
    labels = [_in_words(entry, curve.points) for entry in (values, x, y)]
    figure.colorbar(filled, ax=ax, label=labels[0])
    ax.set(xlabel=labels[1], ylabel=labels[2])
    set_title(ax, curve.title)
    return ax


def _in_words(values: xr.DataArray, points: xr.Dataset) -> str:
    """A label of a quantity of points, or of a field."""
    name = str(values.name)
    attrs = points[name].attrs if name in points else {}
    long_name = words(attrs["field"]) if "field" in attrs else attrs.get("long_name")
    return labelled(values.assign_attrs(long_name=long_name or words(name)))


def _member(over: xr.DataArray) -> str:
    """The value in which a curve differs from others."""
    value = over.item()
    text = value if isinstance(value, str) else f"{value:.4g}"
    return f"{text} {over.attrs['units']}".rstrip()


@styled
def temperatures(found: Temperatures, ax: Axes | None = None, **style: Any) -> Axes:
    """Temperatures of both surfaces along the row and its wake, over x."""
    ax = axes_or_new(ax)
    surface = found.rows.isel(depth=0)
    # Dashes, so that both are seen where they coincide.
    for body, dashes in (("wheel", "-"), ("rail", "--")):
        values = surface[f"temperature_{body}"]
        line(ax, surface["x"] * 1e3, values, body, style, linestyle=dashes)
    edges = found.contact
    ax.axvspan(edges.trailing_edge * 1e3, edges.leading_edge * 1e3, color="0.9", zorder=0)
    ax.set_xlabel("$x$ (mm), rolling →")
    ax.set_ylabel("surface temperature (°C)")
    legend_beside(ax)
    set_title(ax, found.title)
    return ax


@styled
def subsurface(found: Subsurface, ax: Axes | None = None, **style: Any) -> Axes:
    """Von Mises's stress over x and z in the plane through the largest one."""
    ax = axes_or_new(ax)
    place = found.largest.von_mises
    plane = found.volume["von_mises_stress"].sel(y=place.y, method="nearest")
    factor, unit = scaled(largest(plane), "Pa")
    sign = -1.0 if found.body == "rail" else 1.0
    x, z = plane["x"] * 1e3, sign * plane["depth"] * 1e3
    drawn = ax.contourf(x, z, plane * factor, **{"levels": 12, **style})
    ax.plot(place.x * 1e3, sign * place.depth * 1e3, "wx")
    ax.figure.colorbar(drawn, ax=ax, label=f"von Mises stress ({unit})")
    ax.set_aspect("equal")
    ax.set_xlabel("$x$ (mm), rolling →")
    ax.set_ylabel("$z$ (mm)")
    set_title(ax, found.title)
    return ax


#: The method without a limit of the force.
LINEAR = "Kalker linear"


@styled
def methods(comparison: Comparison, ax: Axes | None = None, **style: Any) -> Axes:
    """Longitudinal and lateral forces of all methods as bars."""
    ax = axes_or_new(ax)
    table = comparison.methods
    # The linear theory, which knows no limit of friction, may be far beyond all others.
    limited = table.sel(model=table["model"] != LINEAR)
    bound = max(largest(limited[force]) for force in FORCES)
    factor, unit = scaled(bound, "N")
    places = np.arange(table.sizes["model"])
    height = 0.8 / len(FORCES)
    for number, (force, symbol) in enumerate(FORCES.items()):
        shift = (number - (len(FORCES) - 1) / 2) * height
        options = {"label": symbol, "height": height, **style}
        ax.barh(places + shift, table[force] * factor, **options)
    ax.set_yticks(places, table["model"].values.tolist())
    ax.invert_yaxis()
    left, right = ax.get_xlim()
    edge = 1.2 * bound * factor
    ax.set_xlim(max(left, -edge), min(right, edge))
    ax.axvline(0.0, color="black", linewidth=0.6)
    ax.set_xlabel(f"force on the wheel ({unit})")
    legend_beside(ax)
    set_title(ax, comparison.title)
    return ax


@styled
def passage(found: Wear, ax: Axes | None = None, **style: Any) -> Axes:
    """Depth of wear per wheel passage across the profile, by both laws."""
    if found.profile is None:
        raise ValueError("the method has no fields, so there is no wear to draw")
    ax = axes_or_new(ax)
    profile = found.profile
    for name, label in (("archard", "Archard"), ("rail_energy", "energy")):
        line(ax, profile["y"] * 1e3, profile[name] * 1e9, label, style)
    ax.set_xlabel("$y$ (mm)")
    ax.set_ylabel("depth per wheel passage (nm)")
    legend_beside(ax)
    set_title(ax, found.title)
    return ax


@styled
def wear(damage: Damage, ax: Axes | None = None, **style: Any) -> Axes:
    """Depth of wear of the wheel across the profile, by both laws."""
    ax = axes_or_new(ax)
    profile = damage.profile
    for name, label in (("wheel_archard", "Archard"), ("wheel_energy", "energy")):
        line(ax, profile["y"] * 1e3, profile[name] * 1e6, label, style)
    ax.set_xlabel("$y$ across the profile (mm)")
    ax.set_ylabel("depth worn from the wheel (µm)")
    legend_beside(ax)
    set_title(ax, damage.title)
    return ax


@styled
def rolling_radii(wheelset: Wheelset, ax: Axes | None = None, **style: Any) -> Axes:
    """Rolling radius of the left wheel minus that of the right one over the lateral position."""
    ax = axes_or_new(ax)
    contacts = wheelset.contacts
    _, first = np.unique(contacts["lateral_position"], return_index=True)
    rows = contacts.isel(row=first)
    radii = rows["rolling_radius_difference"] * 1e3
    line(ax, rows["lateral_position"] * 1e3, radii, "left minus right", style)
    rigid = rows["rigid_rolling_radius_difference"] * 1e3
    line(ax, rows["lateral_position"] * 1e3, rigid, "rigid, without roll", {"linestyle": "--"})
    # Flange contacts, whose difference is many times as large, lie beyond the axis.
    angles = abs(contacts["angle"]).groupby(contacts["lateral_position"]).max()
    treads = largest(radii[(angles < TREAD).values])
    if 0.0 < 2.5 * treads < largest(radii):
        ax.set_ylim(-1.25 * treads, 1.25 * treads)
    ax.legend()
    ax.set_xlabel("lateral position, to the left (mm)")
    ax.set_ylabel("rolling radius, left minus right (mm)")
    set_title(ax, wheelset.title)
    return ax


def _varied(points: xr.Dataset) -> str:
    """The creepage that varies most over its largest value."""
    names = ("creepage_x", "creepage_y", "spin")
    spread = {
        n: float(points[n].max() - points[n].min()) / (largest(points[n]) or 1) for n in names
    }
    return max(names, key=lambda name: spread[name])


def _series(points: xr.Dataset) -> list[xr.Dataset]:
    """Points of the same speed and load."""
    conditions = np.stack([points["speed"].values, points["normal_load"].values])
    _, inverse = np.unique(conditions, axis=1, return_inverse=True)
    inverse = inverse.ravel()
    return [points.isel(point=inverse == k) for k in range(int(inverse.max()) + 1)]


@styled
def fit(fit: Fit, ax: Axes | None = None, **style: Any) -> Axes:
    """Measured points, and the fitted forces at their creepages."""
    ax = axes_or_new(ax)
    points = fit.points
    series = [
        (component, member)
        for component in dict.fromkeys(points["component"].values.tolist())
        for member in _series(points.isel(point=points["component"].values == component))
    ]
    for number, (component, own) in enumerate(series):
        name = _varied(own)
        own = own.sortby(name)
        color = f"C{number}"
        speed = f", {float(own['speed'][0]):g} m/s" if len(series) > 1 else ""
        label = f"$F_{component}/N${speed}, measured"
        ax.plot(own[name], own["force_ratio"], "o", color=color, markersize=3, label=label)
        line(ax, own[name], own["fitted"], "fitted", style, color=color)
        ax.set_xlabel(labelled(own[name]))
    ax.set_ylabel("force on the rail over load")
    legend_beside(ax)
    set_title(ax, fit.title)
    return ax


def _surfaces(title: str) -> str:
    """The title of a rough contact, with the names of files alone."""
    return " and ".join(Path(part).name for part in title.split(" and "))


class RoughContactPlots:
    """The plots of a rough contact: ``contact.plot.spectrum()`` and others."""

    def __init__(self, contact: RoughContact) -> None:
        self._contact = contact

    @styled
    def spectrum(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Power spectral density of the heights over the wave number."""
        ax = axes_or_new(ax)
        spectrum = self._contact.spectrum
        # What rounding leaves of waves that a synthetic surface does not have is none.
        density = spectrum["spectral_density"]
        spectrum = spectrum.isel(wave_number=(density > 1e-12 * density.max()).values)
        ax.loglog(spectrum["wave_number"], spectrum["spectral_density"], **style)
        ax.set_xlabel("wave number $q$ (rad/m)")
        ax.set_ylabel("$C(q)$ (m⁴)")
        set_title(ax, _surfaces(self._contact.title))
        return ax

    @styled
    def surface(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Heights."""
        heights = self._contact.fields["height"]
        return colored_map(heights, "height", ax, **{"cmap": "gray", **style})

    @styled
    def spots(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Pressures in the contact spots at the largest mean pressure."""
        pressure = self._contact.fields["pressure"]
        return colored_map(pressure.where(pressure > 0.0), "pressure", ax, **style)

    @styled
    def curves(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Traction over displacement at each mean pressure, normalised."""
        ax = axes_or_new(ax)
        for entry, points in zip(self._contact["pressures"], self._contact.curves, strict=True):
            pressure = cast("float", entry["mean_pressure"])
            label = f"{pressure * 1e-6:.0f} MPa"
            line(ax, points["displacement"] * 1e6, points["normalised_traction"], label, style)
        ax.set_xlabel("displacement (µm)")
        ax.set_ylabel(r"$t / \mu p$")
        legend_beside(ax)
        set_title(ax, _surfaces(self._contact.title))
        return ax
