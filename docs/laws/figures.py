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
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=4)


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
        ax.plot((6e-3 - row["x"]) * 1e-4 * 1e6, share, label=f"k_c = {stiffness / 1e6:g}·10⁶/m")
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


def hertz() -> None:
    """Semi-axes and largest pressure over the load."""
    loads = np.linspace(5e3, 120e3, 24)
    results = [
        schlupf.Case(
            normal={"load": load},
            friction={"model": "constant"},
            heat={"model": "none"},
            solver={"method": "polach"},
        ).solve(warn=False)
        for load in loads
    ]
    _, axes = plt.subplots(1, 2, figsize=(7.0, 2.8))
    for name, label in (("semi_axis_x", "a"), ("semi_axis_y", "b")):
        axes[0].plot(loads / 1e3, [r.normal[name] * 1e3 for r in results], label=label)
    axes[0].set(xlabel="load (kN)", ylabel="semi-axis (mm)", ylim=(0, None))
    axes[0].legend()
    axes[1].plot(loads / 1e3, [r.normal.peak_pressure / 1e6 for r in results])
    axes[1].set(xlabel="load (kN)", ylabel="p0 (MPa)", ylim=(0, None))


def friction_across() -> None:
    """A rail that is lubricated on the right: tractions, and the coefficient over y."""
    case = schlupf.Case(
        kinematics={"creepage_x": 0.002},
        normal=PATCH,
        friction={**CONSTANT, "variation_y": ["-4 mm", "-1 mm"], "variation_factor": [0.4, 1.0]},
        heat=NO_HEAT,
        grid={"cells_x": 32, "cells_y": 32},
    )
    result = case.solve(warn=False)
    _, axes = plt.subplots(1, 2, figsize=(8, 2.8))
    result.plot.traction(ax=axes[0])
    column = result.fields.sel(x=-3e-3, method="nearest")
    axes[1].plot(column["y"] * 1e3, column["friction_coefficient"])
    axes[1].set(xlabel="y (mm)", ylabel="μ", ylim=(0, None))


def friction_memory() -> None:
    """Coefficient along y = 0 with and without memory."""
    _, ax = plt.subplots()
    for distance in (None, 5e-6, 20e-6):
        case = schlupf.Case(
            kinematics={"creepage_x": 0.005},
            normal=PATCH,
            friction={
                "model": "exponential",
                "coefficient": 0.4,
                "kinetic_coefficient": 0.2,
                "half_speed": 0.2,
                "memory_distance": distance,
            },
            heat=NO_HEAT,
            grid={"cells_x": 48, "cells_y": 15},
        )
        row = case.solve(warn=False).fields.sel(y=0.0, method="nearest")
        label = "no memory" if distance is None else f"d_c = {distance * 1e6:.0f} µm"
        ax.plot(row["x"] * 1e3, row["friction_coefficient"], label=label)
    ax.set(xlabel="x (mm), rolling →", ylabel="μ")
    ax.legend()


def roughness_closed_form() -> None:
    """Creep curves for several heights."""
    case = schlupf.Case(
        normal=PATCH, elasticity={"model": "half-space"}, friction=CONSTANT, heat=NO_HEAT
    )
    creepages = np.linspace(0.0, 0.006, 40)
    _, ax = plt.subplots()
    for height in (1e-6, 5e-6, 20e-6):
        rough = case.with_(contact_law={"roughness": {"rms_height": height}})
        forces = schlupf.forces(rough, creepage_x=creepages)
        label = f"h_rms = {height * 1e6:.0f} µm"
        ax.plot(creepages, -forces["force_x"] / (0.3 * 80e3), label=label)
    smooth = schlupf.forces(case.with_(contact_law={"stiffness": 1e8}), creepage_x=creepages)
    ax.plot(creepages, -smooth["force_x"] / (0.3 * 80e3), "k:", label="k_c = 10⁸/m")
    ax.set(xlabel="ξ", ylabel="−Fx/μN")
    ax.legend()


def roughness_micro_model() -> None:
    """Contact spots and tangential curves of a synthetic surface."""
    case = schlupf.Case(
        contact_law={
            "roughness": {
                "rms_height": "1 um",
                "hurst": 0.8,
                "longest_wavelength": "100 um",
                "shortest_wavelength": "25 um",
                "cells": 128,
                "pressures": ["200 MPa", "800 MPa"],
            }
        }
    )
    rough = case.roughness(warn=False)
    _, axes = plt.subplots(1, 2, figsize=(8, 3.0))
    rough.plot.spots(ax=axes[0])
    rough.plot.curves(ax=axes[1])
    for ax in axes:
        ax.set_title("")


def layer() -> None:
    """Creep curves of a locomotive with clean bodies and with a layer."""
    creepages = np.linspace(0.0, 0.02, 50)
    clean = schlupf.Case(
        normal=PATCH,
        elasticity={"model": "half-space"},
        contact_law={"model": "coulomb"},
        friction={"model": "constant", "coefficient": 0.33},
        heat=NO_HEAT,
    )
    layered = clean.with_(layer=schlupf.layers.eurosprinter)
    _, ax = plt.subplots()
    for label, case, style in [
        ("clean", clean, "k-"),
        ("layer", layered, "C0-"),
        ("layer, FASTSIM", layered.with_(solver={"method": "fastsim"}), "C0:"),
    ]:
        forces = schlupf.forces(case, creepage_x=creepages, warn=False)
        ax.plot(creepages, -forces["force_x"] / 80e3, style, label=label)
    ax.set(xlabel="ξ", ylabel="−Fx/N", ylim=(0.0, None))
    ax.legend()


def total_displacement() -> None:
    """Lateral force over spin with both forms of the contact law."""
    _, ax = plt.subplots()
    spins = np.linspace(0.0, 2.0, 21)
    for model in ("incremental", "total-displacement"):
        case = schlupf.Case(
            normal=PATCH,
            elasticity={"model": "half-space"},
            friction=CONSTANT,
            contact_law={"model": model},
            heat=NO_HEAT,
        )
        forces = schlupf.forces(case, spin=spins, warn=False)
        ax.plot(spins, -forces["force_y"] / (0.3 * 80e3), label=model)
    ax.set(xlabel="φ (1/m)", ylabel="−Fy/μN")
    ax.legend()
