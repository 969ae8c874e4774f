"""Figures of the laws, computed with the package."""

from __future__ import annotations

from typing import Any

import matplotlib.pyplot as plt
import numpy as np

import schlupf

PATCH = {"model": "ellipse", "semi_axis_x": 6e-3, "semi_axis_y": 5e-3, "load": 80e3}
CONSTANT = {"model": "constant", "coefficient": 0.3}
NO_HEAT = {"model": "none"}


def _rigid(friction: dict[str, Any]) -> schlupf.Case:
    """Bodies that slide as a whole, so that |F|/N is the coefficient of friction."""
    return schlupf.Case(
        normal=PATCH,
        elasticity={"model": "rigid"},
        contact_law={"stiffness": 1e9},
        friction=friction,
        heat=NO_HEAT,
        grid={"cells_x": 8, "cells_y": 8},
    )


def over_slip_speed(laws: dict[str, dict[str, Any]], largest: float = 3.0) -> None:
    """Coefficients of friction over the slip speed, by legend."""
    _, ax = plt.subplots()
    speeds = np.linspace(0.01, largest, 80)
    for label, friction in laws.items():
        case = _rigid(friction).with_(kinematics={"speed": 30.0})
        forces = schlupf.forces(case, creepage_x=speeds / 30.0, warn=False)
        ax.plot(speeds, forces["traction_coefficient"], label=label)
    ax.set(xlabel="slip speed (m/s)", ylabel="μ", ylim=(0.0, None))
    ax.legend()


def over_temperature(laws: dict[str, dict[str, Any]], largest: float = 900.0) -> None:
    """Coefficients of friction over the temperature of the contact, by legend."""
    _, ax = plt.subplots()
    temperatures = np.linspace(0.0, largest, 46)
    for label, friction in laws.items():
        case = _rigid({**friction, "reference_temperature": 0.0})
        case = case.with_(kinematics={"creepage_x": 0.05})
        values = []
        for temperature in temperatures:
            bulk = {"bulk_temperature": temperature}
            hot = case.with_(wheel=bulk, rail=bulk).solve(warn=False)
            values.append(hot.traction_coefficient)
        ax.plot(temperatures, values, label=label)
    ax.set(xlabel="temperature over the reference (K)", ylabel="μ", ylim=(0.0, None))
    ax.legend()


def along_the_middle(**elasticities: dict[str, Any]) -> None:
    """Traction along y = 0 with several elasticities, by name; ξ = 0.001, μ = 0.3."""
    _, ax = plt.subplots()
    for label, elasticity in elasticities.items():
        case = schlupf.Case(
            kinematics={"creepage_x": 0.001},
            normal=PATCH,
            elasticity=elasticity,
            contact_law={"stiffness": 1e8},
            friction=CONSTANT,
            heat=NO_HEAT,
            grid={"cells_x": 48, "cells_y": 31},
        )
        row = case.solve(warn=False).fields.sel(y=0.0, method="nearest")
        ax.plot(row["x"] * 1e3, -row["traction_x"] / 1e6, label=label.replace("_", " "))
    ax.plot(row["x"] * 1e3, 0.3 * row["pressure"] / 1e6, "k:", label="μ pₙ")
    ax.set(xlabel="x (mm), rolling →", ylabel="traction on the rail (MPa)")
    ax.legend()


def creep_curves(methods: list[str]) -> None:
    """Forces of fast methods and of the half-space; η = 0.001, φ = 0.2/m, μ = 0.3."""
    base = schlupf.Case(
        kinematics={"creepage_y": 0.001, "spin": 0.2},
        normal=PATCH,
        friction=CONSTANT,
        heat=NO_HEAT,
        grid={"cells_x": 24, "cells_y": 24},
    )
    half_space = base.with_(elasticity={"model": "half-space"}, contact_law={"stiffness": 1e8})
    creepages = np.linspace(0.0, 0.008, 60)
    _, axes = plt.subplots(1, 2, figsize=(7.0, 2.8), sharex=True)
    for label in ["half-space", *methods]:
        case = half_space if label == "half-space" else base.with_(solver={"method": label})
        forces = schlupf.forces(case, creepage_x=creepages, warn=False)
        style = "k:" if label == "half-space" else "-"
        for ax, name in zip(axes, ("force_x", "force_y"), strict=True):
            ax.plot(creepages, -forces[name] / (0.3 * 80e3), style, label=label)
    axes[0].set(xlabel="ξ", ylabel="−Fx/μN", ylim=(0.0, 1.2))
    axes[1].set(xlabel="ξ", ylabel="−Fy/μN", ylim=(0.0, 1.0))
    axes[0].legend()


def over_sliding(stiffnesses: list[float]) -> None:
    """Traction over the sliding distance since entry, for stiffnesses k_c in 1/m."""
    _, ax = plt.subplots()
    for stiffness in stiffnesses:
        case = _rigid(CONSTANT).with_(
            kinematics={"creepage_x": 1e-4},
            contact_law={"stiffness": stiffness},
            grid={"cells_x": 60, "cells_y": 9},
        )
        row = case.solve(warn=False).fields.sel(y=0.0, method="nearest")
        share = -row["traction_x"] / (0.3 * row["pressure"])
        ax.plot((6e-3 - row["x"]) * 1e-4 * 1e6, share, label=f"k_c = {stiffness:.0e}/m")
    ax.set(xlabel="sliding distance (µm)", ylabel="traction / μ pₙ")
    ax.legend()


def temperatures(models: list[str]) -> None:
    """Rise along y = 0 under full sliding of 1 m/s at 30 m/s, μ = 0.3."""
    _, ax = plt.subplots()
    for model in models:
        case = _rigid(CONSTANT).with_(
            kinematics={"speed": 30.0, "creepage_x": 1.0 / 30.0},
            heat={"model": model, "partition": 0.5},
            grid={"cells_x": 60, "cells_y": 9},
        )
        row = case.solve(warn=False).fields.sel(y=0.0, method="nearest")
        ax.plot(row["x"] * 1e3, row["temperature_rise_wheel"], label=model)
    ax.set(xlabel="x (mm), rolling →", ylabel="temperature rise (K)")
    ax.legend()
