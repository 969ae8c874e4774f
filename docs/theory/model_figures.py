"""Figures of the page on the model."""

from __future__ import annotations

import matplotlib.pyplot as plt

import schlupf

CASE = schlupf.Case(
    kinematics={"creepage_x": 0.002},
    normal={"load": "80 kN"},
    elasticity={"model": "half-space"},
    contact_law={"stiffness": 2e7},
    grid={"cells_x": 40, "cells_y": 31},
)


def stick_and_slip() -> None:
    """Traction and slip along the middle of the patch."""
    result = CASE.solve()
    row = result.fields.sel(y=0.0, method="nearest")
    x = row["x"] * 1e3
    _, (traction, slip) = plt.subplots(1, 2, figsize=(7.2, 2.7))
    traction.plot(x, row["friction_coefficient"] * row["pressure"] / 1e6, "k:", label="μ pₙ")
    traction.plot(x, -row["traction_x"] / 1e6, label="−tₓ")
    traction.set(xlabel="x (mm), rolling →", ylabel="MPa")
    traction.legend()
    slip.plot(x, row["slip_x"] * 1e3, label="slip")
    slip.axhline(0.002 * 30.0 * 1e3, color="black", ls=":", label="rigid slip ξ v0")
    slip.set(xlabel="x (mm), rolling →", ylabel="slip velocity (mm/s)")
    slip.legend()


def heat() -> None:
    """Friction power, temperature rise and coefficient along the middle at high slip."""
    hot = CASE.with_(kinematics={"creepage_x": 0.02}).solve()
    row = hot.fields.sel(y=0.0, method="nearest")
    x = row["x"] * 1e3
    _, (power, rise) = plt.subplots(1, 2, figsize=(7.2, 2.7))
    power.plot(x, row["friction_power"] / 1e6)
    power.set(xlabel="x (mm), rolling →", ylabel="friction power (W/mm²)", title="ξ = 2 %")
    rise.plot(x, row["temperature_rise_wheel"])
    rise.set(xlabel="x (mm), rolling →", ylabel="temperature rise (K)")
    right = rise.twinx()
    right.plot(x, row["friction_coefficient"], "--", color="#ee6677")
    right.set_ylabel("μ (dashed)")
