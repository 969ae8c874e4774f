"""What the validation report computes, one function for each of its sections."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import xarray as xr
from comparisons import compare, compare_all, data, table
from IPython.display import Markdown

import schlupf

CASES = Path(__file__).parent.parent.parent / "cases"

STEEL = {"young_modulus": 210e9, "poisson_ratio": 0.28}
STEEL_OF_CONTACT = {"young_modulus": 2.0 * 82e9 * 1.28, "poisson_ratio": 0.28}
NO_HEAT = {"model": "none"}


def coulomb(mu: float) -> dict[str, Any]:
    """Constant friction."""
    return {"model": "constant", "coefficient": mu}


def bodies(material: dict[str, Any], **more: float) -> dict[str, Any]:
    """Wheel and rail of the same material."""
    return {"wheel": {**material, **more}, "rail": {**material, **more}}


#: Combined modulus E* of two bodies of steel, in Pa.
MODULUS = 0.5 * 210e9 / (1.0 - 0.28**2)
#: Full sliding of 1 m/s at 30 m/s.
SLIDE = schlupf.Case(
    **bodies(STEEL_OF_CONTACT),
    kinematics={"speed": 30.0, "creepage_x": 1.0 / 30.0},
    normal={
        "model": "ellipse",
        "semi_axis_x": 5.88e-3,
        "semi_axis_y": 10.54e-3,
        "peak_pressure": 770.4e6,
    },
    elasticity={"model": "rigid"},
    contact_law={"stiffness": 1e9},
    friction=coulomb(0.3),
    heat={"partition": 0.5},
    grid={"cells_x": 60, "cells_y": 41},
)
#: The same with other numbers of cells, in which friction heats.
UNIFORM = SLIDE.with_(
    normal={"peak_pressure": None, "load": 100e3},
    grid={"cells_x": 60, "cells_y": 61},
    **bodies(STEEL_OF_CONTACT, bulk_temperature=0.0),
)
GENTLE = {
    "model": "temperature-linear",
    "coefficient": 0.3,
    "temperature_at_zero_friction": 0.3 * 400.0 / 0.18,
    "minimum_coefficient": 0.12,
    "reference_temperature": 0.0,
}


def normal_contact() -> Markdown:
    """A sphere on a plane, and the two examples of the user guide of CONTACT."""

    def hertz(material, radii, load):
        case = schlupf.Case(
            wheel={**material, "radius_x": radii[0], "radius_y": radii[1]},
            rail={**material, "radius_x": "inf", "radius_y": "inf"},
            normal={"load": load},
        )
        return case.solve().normal

    R, N = 0.46, 80e3
    sphere = hertz(STEEL, (R, R), N)
    a = (0.75 * N * R / MODULUS) ** (1 / 3)
    compare("hertz-sphere-radius", sphere.semi_axis_x * 1e3, a * 1e3)
    pressure = (6.0 * N * MODULUS**2 / (np.pi**3 * R**2)) ** (1 / 3)
    compare("hertz-sphere-pressure", sphere.peak_pressure / 1e6, pressure / 1e6)
    compare("hertz-sphere-approach", sphere.approach * 1e3, a**2 / R * 1e3)

    wheel = hertz(STEEL_OF_CONTACT, (0.625, 1.7767), 106.7e3)
    compare("hertz-locomotive-a", wheel.semi_axis_x * 1e3)
    compare("hertz-locomotive-b", wheel.semi_axis_y * 1e3)
    compare("hertz-locomotive-pressure", wheel.peak_pressure / 1e6)
    compare("hertz-locomotive-approach", wheel.approach * 1e3)

    example = hertz(STEEL_OF_CONTACT, (1.0 / 2.030, 1.0 / 0.843), 100e3)
    compare("hertz-curvatures-a", example.semi_axis_x * 1e3)
    compare("hertz-curvatures-b", example.semi_axis_y * 1e3)
    compare("hertz-curvatures-pressure", example.peak_pressure / 1e6)
    return table(
        *(
            f"hertz-{name}"
            for name in (
                "sphere-radius",
                "sphere-pressure",
                "sphere-approach",
                "locomotive-a",
                "locomotive-b",
                "locomotive-pressure",
                "locomotive-approach",
                "curvatures-a",
                "curvatures-b",
                "curvatures-pressure",
            )
        )
    )


def shift_at_rest() -> Markdown:
    """Two spheres that are shifted without rolling."""

    def spheres(radius, load, nu, shift, cells):
        material = {"young_modulus": 210e9, "poisson_ratio": nu}
        case = schlupf.Case(
            **bodies(material),
            normal={"model": "ellipse", "semi_axis_x": radius, "semi_axis_y": radius, "load": load},
            elasticity={"model": "half-space"},
            contact_law={"stiffness": 1e9},
            friction=coulomb(0.3),
            heat=NO_HEAT,
            grid={"cells_x": cells, "cells_y": cells},
            history={"shift_x": shift},
        )
        return -case.solve().force.x / (0.3 * load)

    saturation = 3.0 * 0.3 * 50e3 * 2.0 / (8.0 * 105e9 * 5e-3)
    shares = np.array([0.1, 0.2, 0.4, 0.6, 0.8, 0.9])
    ours = np.array([spheres(5e-3, 50e3, 0.0, share * saturation, 60) for share in shares])
    exact = 1.0 - (1.0 - shares) ** 1.5
    compare_all("cattaneo-force", ours - exact)
    compare("cattaneo-contact", spheres(6e-3, 75398.224, 0.28, 0.015e-3, 40))

    fine = np.linspace(0.0, 1.0)
    _, ax = plt.subplots()
    ax.plot(fine, 1.0 - (1.0 - fine) ** 1.5, color="black", label="Cattaneo, Mindlin")
    ax.plot(shares, ours, "o", label="schlupf")
    ax.set(xlabel="shift / shift of full sliding", ylabel="force / μN")
    ax.legend()
    return table("cattaneo-force", "cattaneo-contact")


def carter() -> Markdown:
    """Strips of Carter in a slender ellipse."""
    shear_modulus = 210e9 / 2.56
    slender = schlupf.Case(
        **bodies(STEEL),
        normal={
            "model": "ellipse",
            "semi_axis_x": 2e-3,
            "semi_axis_y": 20e-3,
            "peak_pressure": 1e9,
        },
        elasticity={"model": "half-space"},
        contact_law={"stiffness": 1e9},
        friction=coulomb(0.3),
        heat=NO_HEAT,
        grid={"cells_x": 40, "cells_y": 40},
    )
    saturation = 2.0 * 0.3 * 1e9 * 0.72 / shear_modulus

    def strips(kappa):
        kappa = np.minimum(kappa, 1.0)
        root = np.sqrt(1.0 - kappa**2)
        return 1.0 - 1.5 * root + 0.5 * root**3 + 1.5 * kappa * np.arccos(kappa)

    shares = np.array([0.01, 0.03, 0.1, 0.25, 0.5, 0.75, 0.9, 1.2])
    limit = 0.3 * 2.0 / 3.0 * np.pi * 2e-3 * 20e-3 * 1e9
    forces = schlupf.forces(slender, creepage_x=shares * saturation)
    ours = -forces["force_x"].values / limit
    compare_all("carter-force", ours - strips(shares))

    fine = np.linspace(0.0, 1.2, 200)
    _, ax = plt.subplots()
    ax.plot(fine, strips(fine), color="black", label="strips of Carter")
    ax.plot(shares, ours, "o", label="schlupf")
    ax.set(xlabel="ξ/ξ₁", ylabel="−Fx/μN")
    ax.legend()
    return table("carter-force")


def creep_coefficients() -> Markdown:
    """Kalker's coefficients from forces under small creepages."""

    def coefficients(ratio, nu):
        """C11, C22, C23, C33 on a patch of c = 5 mm."""
        c, small = 5e-3, 1e-9
        material = {"young_modulus": 210e9, "poisson_ratio": nu}
        case = schlupf.Case(
            **bodies(material),
            normal={
                "model": "ellipse",
                "semi_axis_x": c * ratio**0.5,
                "semi_axis_y": c / ratio**0.5,
                "load": 50e3,
            },
            friction=coulomb(0.3),
            heat=NO_HEAT,
            solver={"method": "kalker-linear"},
        )
        unit = 210e9 / (2.0 * (1.0 + nu)) * c**2 * small
        motions = small * np.eye(3)
        got = schlupf.forces(
            case, creepage_x=motions[0], creepage_y=motions[1], spin=motions[2], warn=False
        )
        fx, fy, mz = (got[name].values for name in ("force_x", "force_y", "moment_z"))
        return -np.array([fx[0] / unit, fy[1] / unit, fy[2] / (unit * c), mz[2] / (unit * c**2)])

    printed = data("kalker_coefficients.csv")
    names = ["C11", "C22", "C23", "C33"]
    expected = printed[[f"{name}_converged" for name in names]].to_numpy()
    pairs = printed[["a_over_b", "poisson_ratio"]].to_numpy()
    ours = np.array([coefficients(*pair) for pair in pairs])
    differences = ours / expected - 1.0
    compare_all(
        "kalker-coefficients", differences[:, :3].ravel()[~np.isnan(expected[:, :3].ravel())]
    )
    compare_all("kalker-moment", differences[:, 3][~np.isnan(expected[:, 3])])

    _, axes = plt.subplots(2, 2, figsize=(6.5, 4.6), sharex=True)
    for ax, k in zip(axes.flat, range(4), strict=True):
        for nu in sorted(set(pairs[:, 1])):
            rows = pairs[:, 1] == nu
            line = ax.plot(pairs[rows, 0], ours[rows, k], label=f"ν = {nu:g}")
            ax.plot(pairs[rows, 0], expected[rows, k], "o", ms=3, color=line[0].get_color())
        ax.set(xscale="log", yscale="log" if k > 1 else "linear", title=names[k])
    axes[0, 0].legend(title="lines: schlupf, dots: Kalker")
    for ax in axes[1]:
        ax.set_xlabel("a/b")
    return table("kalker-coefficients", "kalker-moment")


def creep_forces() -> Markdown:
    """178 creep forces of CONTACT."""
    reference = data("contact_creep.csv")
    load = 52359.878
    computed = np.empty((len(reference), 3))
    for _, rows in reference.groupby("a_over_b"):
        a, b = rows[["semi_axis_x_m", "semi_axis_y_m"]].iloc[0]
        case = schlupf.Case(
            **bodies(STEEL),
            normal={"model": "ellipse", "semi_axis_x": a, "semi_axis_y": b, "load": load},
            elasticity={"model": "half-space"},
            contact_law={"stiffness": 1e8},
            friction=coulomb(0.3),
            heat=NO_HEAT,
            grid={"cells_x": 40, "cells_y": 40},
        )
        got = schlupf.forces(
            case,
            creepage_x=rows["creepage_x"].to_numpy(),
            creepage_y=rows["creepage_y"].to_numpy(),
            spin=rows["spin_per_m"].to_numpy(),
        )
        assert not got["status"].any()
        unit = 0.3 * load
        moment = got["moment_z"] / (a * b) ** 0.5
        computed[rows.index] = np.stack([got["force_x"], got["force_y"], moment], axis=1) / unit

    expected = reference[["fx", "fy", "mz"]].to_numpy()
    pure = (reference["spin_per_m"] == 0) & (
        (reference["creepage_x"] == 0) | (reference["creepage_y"] == 0)
    )
    compare_all("contact-pure", (computed - expected)[pure].ravel())
    compare_all("contact-combined", (computed - expected)[~pure].ravel())

    _, axes = plt.subplots(1, 2, figsize=(6.5, 3.0))
    for k, name in enumerate(("Fx/μN", "Fy/μN", "Mz/μN√(ab)")):
        axes[0].plot(expected[:, k], computed[:, k], ".", ms=3, label=name)
    axes[0].plot([-1, 1], [-1, 1], color="black", lw=0.5, zorder=0)
    axes[0].set(xlabel="CONTACT", ylabel="schlupf", aspect="equal")
    axes[0].legend()
    axes[1].hist(1e2 * (computed - expected), 30, stacked=True)
    axes[1].set(xlabel="difference (% of μN, of μN√(ab))", ylabel="values")
    return table("contact-pure", "contact-combined")


def traction_fields() -> Markdown:
    """Tractions on CONTACT's own cells."""

    def field(name, a, b, creepage_x, creepage_y, spin):
        reference = data(name)
        case = schlupf.Case(
            **bodies(STEEL),
            normal={"model": "ellipse", "semi_axis_x": a, "semi_axis_y": b, "load": 52359.878},
            kinematics={"creepage_x": creepage_x, "creepage_y": creepage_y, "spin": spin},
            elasticity={"model": "half-space"},
            contact_law={"stiffness": 1e8},
            friction=coulomb(0.3),
            heat=NO_HEAT,
            grid={"cells_x": 72, "cells_y": 72},
        )
        result = case.solve()
        at = {name: xr.DataArray(reference[f"{name}_m"], dims="cell") for name in ("x", "y")}
        there = result.fields.sel(at, method="nearest")
        for name in ("x", "y"):
            spacing = float(result.fields[name][1] - result.fields[name][0])
            assert np.abs(there[name].values - reference[f"{name}_m"]).max() < 1e-3 * spacing
        gap = sum(
            ((there[f"traction_{c}"] - reference[f"traction_{c}_Pa"]) ** 2).sum() for c in "xy"
        )
        whole = sum((reference[f"traction_{c}_Pa"] ** 2).sum() for c in "xy")
        return result, reference, float(gap / whole) ** 0.5

    circle = field("contact_field_ab1_xi002.csv", 5e-3, 5e-3, 0.002, 0.0, 0.0)
    combined = field(
        "contact_field_ab1.5_combined.csv", 6.12372436e-3, 4.08248290e-3, 1e-3, 1e-3, 0.2
    )
    compare_all("field-longitudinal", [circle[2]])
    compare_all("field-combined", [combined[2]])

    _, axes = plt.subplots(1, 2, figsize=(6.5, 2.8), sharey=True)
    for ax, (result, reference, _), title in zip(
        axes, (circle, combined), ("ξ = 0.002", "ξ = η = 0.001, φ = 0.2/m"), strict=True
    ):
        rows = reference["y_m"].to_numpy()
        middle = rows[np.abs(rows).argmin()]
        row = reference[reference["y_m"] == middle]
        line = result.fields.sel(y=middle, method="nearest")
        for c in "xy":
            drawn = ax.plot(line["x"] * 1e3, line[f"traction_{c}"] / 1e6, label=f"$t_{c}$, schlupf")
            ax.plot(
                row["x_m"] * 1e3,
                row[f"traction_{c}_Pa"] / 1e6,
                ".",
                ms=3,
                color=drawn[0].get_color(),
                label=f"$t_{c}$, CONTACT",
            )
        ax.plot(line["x"] * 1e3, -0.3 * line["pressure"] / 1e6, color="black", lw=0.5, label="−μpₙ")
        ax.set(xlabel="x (mm), middle row", title=title)
    axes[0].set_ylabel("traction on the wheel (MPa)")
    axes[1].legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return table("field-longitudinal", "field-combined")


def transients() -> Markdown:
    """Rolling from rest, and under a load that oscillates."""
    reference = data("contact_transient.csv")
    load, limit = 75398.224, 0.3 * 75398.224
    radius = 2.0 * 6e-3 * MODULUS / (np.pi * 1e9)  # of a sphere on a plane, for 1 GPa
    ball = schlupf.Case(
        wheel={**STEEL, "radius_x": radius, "radius_y": radius},
        rail={**STEEL, "radius_x": "inf", "radius_y": "inf"},
        kinematics={"speed": 1.0, "creepage_x": 0.0011},
        normal={"load": load},
        elasticity={"model": "half-space"},
        contact_law={"stiffness": 1e8},
        friction=coulomb(0.3),
        heat=NO_HEAT,
        grid={"cells_x": 40, "cells_y": 40},
    )

    def roll(name, history):
        rows = reference[reference["case"] == name].dropna(subset="fx_80")
        result = ball.with_(history=history).solve(warn=False)
        path = result.history["distance"] * 1e3
        force = result.history["force_x"] / limit
        return rows, path, force, np.interp(rows["s_mm"], path, force) - rows["fx_80"]

    distance = np.linspace(0.0, 36e-3, 400)
    wave = load * (1.0 + 0.3 * np.sin(2.0 * np.pi * distance / 36e-3))
    runs = {
        "T1": roll("T1", {"time": [0.0, 23.7e-3]}),
        "T4": roll("T4", {"time": distance, "load": wave}),
    }
    compare_all("transient-rest", runs["T1"][3])
    compare_all("transient-load", runs["T4"][3])

    _, ax = plt.subplots()
    for (rows, path, force, _), label in zip(
        runs.values(), ("constant load", "oscillating load"), strict=True
    ):
        line = ax.plot(path, -force, label=label)
        ax.plot(rows["s_mm"][::4], -rows["fx_80"][::4], ".", color=line[0].get_color())
    ax.set(xlabel="distance rolled (mm)", ylabel="−Fx/μN₀", title="lines: schlupf, dots: CONTACT")
    ax.legend()
    return table("transient-rest", "transient-load")


def temperatures() -> Markdown:
    """Flash temperatures under full sliding."""
    rigid = SLIDE.solve()
    compare("flash-rigid", rigid.temperature.max_rise)
    compare("flash-place", rigid.temperature.x / 5.88e-3)
    constant = SLIDE.with_(heat={"model": "constant-source", "partition": 0.5}).solve(warn=False)
    compare("flash-constant-source", constant.temperature.max_rise)
    elastic = SLIDE.with_(
        elasticity={"model": "half-space"}, kinematics={"creepage_x": -1.0 / 30.0}
    )
    compare("flash-half-space", elastic.solve().temperature.max_rise)
    chill = SLIDE.with_(wheel={"bulk_temperature": 150.0}, rail={"bulk_temperature": 0.0})
    compare("rail-chill", chill.solve().temperature.max_rail)
    cold = chill.with_(kinematics={"creepage_x": 0.0}).solve()
    compare("hot-wheel", cold.temperature.max_rail)

    _, ax = plt.subplots()
    for result, label in ((rigid, "Duhamel"), (constant, "constant source")):
        row = result.fields.sel(y=0.0, method="nearest")
        ax.plot(row["x"] * 1e3, row["temperature_rise_wheel"], label=f"schlupf, {label}")
    u = np.linspace(-1.0, 1.0, 201)
    effusivity = (50.0 * 7850.0 * 450.0) ** 0.5
    scale = 0.5 * 0.3 * 770.4e6 * (5.88e-3 / 30.0) ** 0.5 / effusivity / np.pi**0.5
    # ∫ √(1 − s²)/√(s − u) ds from u to 1, with s = u + (1 − u) r².
    r = (np.arange(2000) + 0.5) / 2000
    s = u[:, None] + (1.0 - u[:, None]) * r**2
    exact = 2.0 * scale * (1.0 - u) ** 0.5 * np.sqrt(np.maximum(1.0 - s**2, 0.0)).mean(axis=1)
    ax.plot(u * 5.88, exact, "k:", label="Knothe and Liebelt")
    ax.set(xlabel="x (mm), rolling →", ylabel="temperature rise (K)")
    ax.legend()
    return table(
        "flash-rigid",
        "flash-place",
        "flash-constant-source",
        "flash-half-space",
        "rail-chill",
        "hot-wheel",
    )


def slow_rolling() -> Markdown:
    """Conduction in all directions near standstill."""
    a = 5e-3
    kappa = 50.0 / (7850.0 * 450.0)
    still = schlupf.Case(
        **bodies(STEEL),
        kinematics={"speed": 0.01 * kappa / a, "creepage_x": -0.01},
        normal={"model": "ellipse", "semi_axis_x": a, "semi_axis_y": a, "peak_pressure": 1e9},
        elasticity={"model": "rigid"},
        contact_law={"stiffness": 1e9},
        friction=coulomb(0.3),
        heat={"partition": 0.0},
        grid={"cells_x": 40, "cells_y": 40},
    )
    flux = 0.3 * 1e9 * 0.01 * still.kinematics.speed
    rise = still.solve(warn=False).temperature.max_rise_rail  # Its speed is unusual.
    compare("slow-circle", rise / (np.pi * flux * a / 200.0))
    exchange = still.with_(
        kinematics={"speed": 1e-6, "creepage_x": 0.0},
        heat={"partition": 0.5},
        wheel={"bulk_temperature": 100.0},
        rail={"bulk_temperature": 0.0},
    )
    compare("holm", exchange.solve(warn=False).power.exchanged / (2.0 * 50.0 * a * 100.0))
    return table("slow-circle", "holm")


def friction_that_heats() -> Markdown:
    """Full sliding with friction that falls with the temperature."""
    steep = {
        "model": "temperature-piecewise-linear",
        "coefficient": 0.3,
        "hot_coefficient": 0.12,
        "temperature_range": 30.0,
        "reference_temperature": 100.0,
    }
    result = UNIFORM.with_(friction=GENTLE).solve()
    compare("linear-temperature", result.temperature.max_rise)
    compare("linear-force", result.normalised.x)
    result = UNIFORM.with_(friction=steep).solve()
    compare("steep-temperature", result.temperature.max_wheel)
    compare("steep-force", result.normalised.x)
    return table("linear-temperature", "linear-force", "steep-temperature", "steep-force")


def locomotive() -> Markdown:
    """Creep curves of the Eurosprinter."""
    measured = data("eurosprinter.csv")
    locomotive = schlupf.Case(
        **bodies(STEEL, bulk_temperature=0.0),
        kinematics={"speed": 10.0},
        normal={
            "model": "ellipse",
            "semi_axis_x": 6.304e-3,
            "semi_axis_y": 12.61e-3,
            "load": 106.7e3,
        },
        elasticity={"model": "half-space"},
        contact_law={"stiffness": 1e8},
        heat={"partition": "velocity"},
        grid={"cells_x": 32, "cells_y": 32},
    )
    laws = {
        "constant 0.33 (grid 48x44)": ("locomotive-constant", coulomb(0.33)),
        "-0.19 per 1200 C": ("locomotive-falling-1200", (0.14, 1200.0)),
        "-0.19 per 400 C": ("locomotive-falling-400", (0.14, 400.0)),
        "+0.19 per 1200 C": ("locomotive-rising", (0.52, 1200.0)),
    }
    _, ax = plt.subplots()
    for friction, (name, law) in laws.items():
        if isinstance(law, tuple):
            law = {
                "model": "temperature-piecewise-linear",
                "coefficient": 0.33,
                "hot_coefficient": law[0],
                "temperature_range": law[1],
                "reference_temperature": 0.0,
            }
        rows = measured[measured["friction"] == friction]
        got = schlupf.forces(
            locomotive.with_(friction=law), warn=False, creepage_x=rows["creepage_x"].to_numpy()
        )
        ours = -got["force_x"].values / 106.7e3
        compare_all(name, ours - rows["force_x_N"] / 106.7e3)
        line = ax.plot(rows["creepage_x"] * 100, ours, label=friction.split(" (")[0])
        ax.plot(
            rows["creepage_x"] * 100, rows["force_x_N"] / 106.7e3, ".", color=line[0].get_color()
        )
    ax.set(xlabel="ξ (%)", ylabel="−Fx/N", title="lines: schlupf, dots: CONTACT")
    ax.legend(title="μ = 0.33")
    return table(*(name for name, _ in laws.values()))


def fast_methods() -> Markdown:
    """Polach's method and FASTSIM."""
    dry = schlupf.Case.from_file(CASES / "polach_locomotive.toml")
    creepages = np.linspace(0.0, 0.1, 2001)
    adhesion = -schlupf.forces(dry, creepage_x=creepages)["force_x"].values / dry.normal.load
    compare("polach-maximum", adhesion.max())
    compare("polach-creepage", creepages[adhesion.argmax()])

    spinning = schlupf.Case(
        **bodies(STEEL_OF_CONTACT),
        kinematics={"creepage_y": -6.25e-4, "spin": 0.625},
        normal={"model": "ellipse", "semi_axis_x": 8e-3, "semi_axis_y": 4e-3, "load": 82e3},
        friction=coulomb(0.3),
        heat=NO_HEAT,
        grid={"cells_x": 100, "cells_y": 100},
        solver={"method": "fastsim"},
    )
    compare("fastsim-parabolic", spinning.solve(warn=False).normalised.y)
    compare(
        "fastsim-elliptic",
        spinning.with_(fastsim={"bound": "elliptic"}).solve(warn=False).normalised.y,
    )
    full = spinning.with_(
        solver={"method": None},
        elasticity={"model": "half-space"},
        contact_law={"stiffness": 1e9},
        grid={"cells_x": 40, "cells_y": 40},
    )
    compare("fastsim-half-space", full.solve(warn=False).normalised.y)
    heated = UNIFORM.with_(
        friction=GENTLE,
        solver={"method": "fastsim"},
        elasticity={"model": None},
        contact_law={"stiffness": None},
        fastsim={"bound": "elliptic"},
    )
    compare("fastsim-temperature", heated.solve(warn=False).temperature.max_rise)

    _, ax = plt.subplots()
    ax.plot(creepages * 100, adhesion)
    ax.plot(3.0, 0.453, "o", label="Polach 2005")
    ax.set(xlabel="ξ (%)", ylabel="−Fx/N")
    ax.legend()
    return table(
        "polach-maximum",
        "polach-creepage",
        "fastsim-parabolic",
        "fastsim-elliptic",
        "fastsim-half-space",
        "fastsim-temperature",
    )
