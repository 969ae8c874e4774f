"""Tasks.

Made of the tasks of the library by tests/generate.py.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from ._ask import Family, Numbers, Points, Texts, ask
from ._report import (
    BulkTemperature,
    Calibration,
    Comparison,
    Curve,
    Damage,
    Fit,
    Report,
    RoughContact,
    Subsurface,
    Temperatures,
    Wear,
    Wheelset,
)
from ._units import Data, File, Number, Surface

if TYPE_CHECKING:
    from ._case import Case


class Tasks:
    """What a case can be asked besides its solution."""

    def patch(
        self,
        *,
        strict: bool = True,
        warn: bool = True,
    ) -> Report:
        """Find the contact alone: its patch and its pressure.

        Parameters
        ----------
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Report
            Results of a task: the documented JSON as attributes, tables as data sets.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.
        """
        request: dict[str, object] = {}
        return ask(Report, "patch", self, request, strict=strict, warn=warn)

    def curve(
        self,
        *,
        creepage_x: Points | None = None,
        creepage_y: Points | None = None,
        spin: Points | None = None,
        creepage: Points | None = None,
        direction: Number | None = None,
        force_x: Points | None = None,
        traction_coefficient: Points | None = None,
        force_y: Points | None = None,
        moment_z: Points | None = None,
        over: Family | None = None,
        points: int | None = None,
        spacing: Literal["refined", "even"] | None = None,
        strict: bool = False,
        warn: bool = True,
    ) -> Curve:
        """Compute creep curves: forces against creepage.

        Parameters
        ----------
        creepage_x : (start, end), array of values or str, optional
            Vary the longitudinal creepage, such as 0..0.05 or 0,0.001,0.05; several creepages vary
            together, each linearly with the others.
        creepage_y : (start, end), array of values or str, optional
            Vary the lateral creepage.
        spin : (start, end), array of values or str, optional
            Vary the spin creepage, such as "0..2 1/m". Numbers are in 1/m.
        creepage : (start, end), array of values or str, optional
            Vary the total creepage in a direction, in place of both creepages.
        direction : float or str, optional
            Direction of the total creepage, from longitudinal (0 deg) to lateral (90 deg). Numbers
            are in rad.
        force_x : (start, end), array of values or str, optional
            Vary the longitudinal force on the wheel, such as "0..-20 kN" (negative in braking), in
            place of all creepages: its creepage is found. Numbers are in N.
        traction_coefficient : (start, end), array of values or str, optional
            Vary the same over the load, such as 0..0.25 (positive in braking).
        force_y : (start, end), array of values or str, optional
            Vary the lateral force on the wheel. Numbers are in N.
        moment_z : (start, end), array of values or str, optional
            Vary the spin moment on the wheel, such as "0..20 N m". Numbers are in N m.
        over : mapping of fields to their values, optional
            Draw one curve for each value of a field, such as 10, 20 and 30 m/s of
            kinematics.speed. At least three numbers make a map over the creepage and the field,
            two fields one of the largest force over both.
        points : int, optional
            Number of points of each curve over a range; by default 41.
        spacing : {"refined", "even"}, optional
            Spacing of the points over a range; by default refined over a creepage and even over a
            force ("refined": finer near zero creepage; "even": equal steps).
        strict : bool, default False
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Curve
            Creep curves: forces along a path of creepages, for one case or several. With
            ``points`` along ``point``, and along the fields that differ where there are several
            curves; with a ``map``.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.
        """
        request: dict[str, object] = {
            "creepage_x": creepage_x,
            "creepage_y": creepage_y,
            "spin": spin,
            "creepage": creepage,
            "direction": direction,
            "force_x": force_x,
            "traction_coefficient": traction_coefficient,
            "force_y": force_y,
            "moment_z": moment_z,
            "over": over,
            "points": points,
            "spacing": spacing,
        }
        return ask(Curve, "curve", self, request, strict=strict, warn=warn)

    def roughness(
        self,
        *,
        surface: Surface | None = None,
        second: Surface | None = None,
        synthetic: Texts | None = None,
        form: Literal["plane", "cylinder", "sphere", "none"] | None = None,
        cutoff: Number | None = None,
        unit: str | None = None,
        spacing: Number | None = None,
        fill_holes: bool = False,
        square_cells: bool = False,
        cells: int | None = None,
        seed: int | None = None,
        pressure: Numbers | None = None,
        friction: Number | None = None,
        hardness: Number | None = None,
        strict: bool = False,
        warn: bool = True,
    ) -> RoughContact:
        """Compute k_c from rough surfaces, with statistics, contact area and tangential curves.

        Parameters
        ----------
        surface : path, array, mapping, or surface of SurfaceTopography or surfalize, optional
            Surface or profile of one body, or of both together (.csv, .npy, .x3p, .xyz). Files of
            instruments are read by `open_surface`. Columns of a mapping without a unit: x in m, y
            in m, height in m, wavelength in m, level in dB.
        second : path, array, mapping, or surface of SurfaceTopography or surfalize, optional
            Surface of the other body, on the same lattice: their heights are added. Files of
            instruments are read by `open_surface`. Columns of a mapping without a unit: x in m, y
            in m, height in m, wavelength in m, level in dB.
        synthetic : str or sequence of str, optional
            Make a self-affine surface, such as rms_height="1 um",hurst=0.8,longest="100 um",
            shortest="5 um",seed=1; also rms_slope and roll_off.
        form : {"plane", "cylinder", "sphere", "none"}, optional
            Form to remove from a measured surface; by default a plane ("plane": a tilted plane;
            "cylinder": a circular cylinder in any direction; "sphere": a sphere; "none": nothing).
        cutoff : float or str, optional
            Remove waves longer than this from a measured surface, such as "0.8 mm" (λc of the
            Gaussian filter, ISO 16610). Numbers are in m.
        unit : str, optional
            Unit of the heights of an .npy file, of all lengths of an .xyz file, such as um.
        spacing : float or str, optional
            Spacing of the points of an .npy file or of heights alone, such as "1 um". Numbers are
            in m.
        fill_holes : bool, default False
            Fill points without a height smoothly.
        square_cells : bool, default False
            Resample a surface whose cells are not square.
        cells : int, optional
            Cells along x of the resampled or synthetic surface.
        seed : int, optional
            Seed of a surface generated from a profile.
        pressure : float or str, or several, optional
            Mean pressures: a range (six pressures) or a list; by default those of the case, of a
            surface given here without a case 0.2..1.2 GPa. Numbers are in Pa.
        friction : float or str, optional
            Coefficient of friction; by default that of the case.
        hardness : float or str, optional
            Hardness of the softer body, such as "2.5 GPa"; by default the bodies are elastic.
            Numbers are in Pa.
        strict : bool, default False
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        RoughContact
            A rough surface, its contact and its k_c. With ``fields`` over x and y, ``spectrum``,
            ``loads`` and ``curves``.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.
        """
        request: dict[str, object] = {
            "surface": surface,
            "second": second,
            "synthetic": synthetic,
            "form": form,
            "cutoff": cutoff,
            "unit": unit,
            "spacing": spacing,
            "fill_holes": fill_holes,
            "square_cells": square_cells,
            "cells": cells,
            "seed": seed,
            "pressure": pressure,
            "friction": friction,
            "hardness": hardness,
        }
        return ask(RoughContact, "roughness", self, request, strict=strict, warn=warn)

    def compare(
        self,
        *,
        strict: bool = False,
        warn: bool = True,
    ) -> Comparison:
        """Solve a case by all methods and compare forces, temperatures and times.

        Parameters
        ----------
        strict : bool, default False
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Comparison
            A case by all methods. With ``methods`` along ``model``: forces, power, temperature
            rise, times in s.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.
        """
        request: dict[str, object] = {}
        return ask(Comparison, "compare", self, request, strict=strict, warn=warn)

    def temperature(
        self,
        *,
        x: Number | None = None,
        y: Number | None = None,
        depth: Points | None = None,
        wake: Number | None = None,
        points: int = 201,
        strict: bool = True,
        warn: bool = True,
    ) -> Temperatures:
        """Compute temperatures below a point and along its row, including the wake.

        Parameters
        ----------
        x : float or str, optional
            Position along rolling, such as "-3 mm"; by default that of the hottest point. Numbers
            are in m.
        y : float or str, optional
            Position across rolling; by default that of the hottest point. Numbers are in m.
        depth : (start, end), array of values or str, optional
            Depths of the profile, such as "0..2 mm" or "0,0.1,2 mm"; by default as far as heat has
            penetrated. Numbers are in m.
        wake : float or str, optional
            Length of the wake; by default twice the length of the contact. Numbers are in m.
        points : int, default 201
            Number of points of each line that is a range.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Temperatures
            Temperatures of wheel and rail below a point, and along its row with the wake. With
            ``profile`` over the depth and ``rows`` over depth and x, in °C.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.

        References
        ----------
        Conduction perpendicular to the surface: Carslaw and Jaeger (1959).
        """
        request: dict[str, object] = {
            "x": x,
            "y": y,
            "depth": depth,
            "wake": wake,
            "points": points,
        }
        return ask(Temperatures, "temperature", self, request, strict=strict, warn=warn)

    def subsurface(
        self,
        *,
        x: Number | None = None,
        y: Number | None = None,
        points: Data | None = None,
        strict: bool = True,
        warn: bool = True,
    ) -> Subsurface:
        """Compute the stresses below the surface of wheel or rail.

        Parameters
        ----------
        x : float or str, optional
            Position of the profile along rolling, such as "-3 mm"; by default that of the largest
            stress of von Mises. Numbers are in m.
        y : float or str, optional
            Position of the profile across rolling; by default that of the largest stress of von
            Mises. Numbers are in m.
        points : path or mapping, optional
            Table of points (CSV) at which stresses are wanted, too: columns x [mm], y [mm] and
            depth [mm]. Columns of a mapping without a unit: x in m, y in m, depth in m.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Subsurface
            Stresses in wheel or rail below the contact. With ``largest``, ``profile`` and
            ``volume`` in Pa, and `at` for any point.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.

        References
        ----------
        Love (1929); Ahmadi, Keer and Mura (1983).
        """
        request: dict[str, object] = {
            "x": x,
            "y": y,
            "points": points,
        }
        return ask(Subsurface, "subsurface", self, request, strict=strict, warn=warn)

    def wear(
        self,
        *,
        strict: bool = True,
        warn: bool = True,
    ) -> Wear:
        """Compute wear, fatigue and melting per wheel passage.

        Parameters
        ----------
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Wear
            Wear, fatigue and melting per wheel passage. ``wear``, ``melting``, ``fatigue_index``,
            ``crack_damage``, ``shakedown`` and ``t_gamma``; ``profile`` over y and ``cells``.
            ``wear`` and ``melting`` are None where the method has no fields.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.

        References
        ----------
        Wear: Archard (1953) with coefficients of Jendel (2002); Braghin, Lewis, Dwyer-Joyce and
        Bruni (2006). Fatigue: Ekberg, Kabo and Andersson (2002), Burstow (2004). Shakedown:
        Johnson and Jefferis (1963).
        """
        request: dict[str, object] = {}
        return ask(Wear, "wear", self, request, strict=strict, warn=warn)

    def bulk_temperature(
        self,
        *,
        strict: bool = True,
        warn: bool = True,
    ) -> BulkTemperature:
        """Compute the long-term bulk temperature of the wheel from its heat balance.

        Parameters
        ----------
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        BulkTemperature
            The bulk temperature of the wheel in the long run. ``temperature.wheel`` (°C), and the
            balance of heat in ``heat`` (W).

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.
        """
        request: dict[str, object] = {}
        return ask(BulkTemperature, "bulk", self, request, strict=strict, warn=warn)

    def calibrate(
        self,
        *,
        direct: bool = False,
        displacements: Data | list[Data] | None = None,
        cells: int = 20,
        strict: bool = True,
        warn: bool = True,
    ) -> Calibration:
        """Determine the stiffnesses of the elastic layer: tabulated, recalibrated, or fitted to
        displacements.

        Parameters
        ----------
        direct : bool, default False
            Calibrate for this very patch instead of interpolating the table, and compare both.
        displacements : path or mapping, or several, optional
            Displacements of a finite-element model to fit to (CSV with columns x, y, traction_x,
            displacement_x, …); several files count together. Columns of a mapping without a unit:
            x in m, y in m, traction_x in Pa, traction_y in Pa, displacement_x in m, displacement_y
            in m.
        cells : int, default 20
            Cells across the patch on which layer and half-space are compared.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Calibration
            Stiffnesses of the elastic layer for a patch. With how far the layer is from the half-
            space, and the ``case`` with them.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.
        """
        request: dict[str, object] = {
            "direct": direct,
            "displacements": displacements,
            "cells": cells,
        }
        return ask(Calibration, "calibrate", self, request, strict=strict, warn=warn)

    def fit(
        self,
        parameters: Texts,
        data: Data,
        *,
        gamma: Number = 0.45,
        max_steps: int = 100,
        strict: bool = True,
        warn: bool = True,
    ) -> Fit:
        """Fit constants of friction and contact law to measured creep forces.

        Parameters
        ----------
        parameters : str or sequence of str
            Parameters to fit, such as "friction.coefficient,contact_law.stiffness";
            "contact_law.roughness" is the r.m.s. height of both surfaces together, in place of the
            stiffness.
        data : path or mapping
            Measured points (CSV): creepage_x, creepage_y or spin [1/m], force_ratio (-Fx/N over
            creepage_x, -Fy/N over creepage_y) or force_ratio_x, force_ratio_y, and where they
            differ from the case speed [m/s], load [kN]; standard_deviation where known. Columns of
            a mapping without a unit: spin in 1/m, speed in m/s, load in N.
        gamma : float or str, default 0.45
            γ, for "contact_law.roughness": the rough surfaces approach by γ times that height when
            the pressure grows e-fold (Persson 2007).
        max_steps : int, default 100
            Maximum number of steps of the fit.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Fit
            Parameters that fit measured creep curves. With their confidence, ``points`` along
            ``point``, and the ``case`` with them.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.
        """
        request: dict[str, object] = {
            "parameters": parameters,
            "data": data,
            "gamma": gamma,
            "max_steps": max_steps,
        }
        return ask(Fit, "fit", self, request, strict=strict, warn=warn)

    def wheelset(
        self,
        *,
        lateral_position: Points = "-8..8 mm",
        points: int | None = None,
        strict: bool = True,
        warn: bool = True,
    ) -> Wheelset:
        """Find the contacts of a wheelset over its lateral position, and its equivalent conicity.

        Parameters
        ----------
        lateral_position : (start, end), array of values or str, default "-8..8 mm"
            Lateral positions of the wheelset: the first and the last, or each of them. Numbers are
            in m.
        points : int, optional
            Number of positions in a range; by default 33.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Wheelset
            The contacts of a wheelset over its lateral position, and its equivalent conicity. With
            ``contacts`` of both wheels, and ``conicity``.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; it has the result.
        """
        request: dict[str, object] = {
            "lateral_position": lateral_position,
            "points": points,
        }
        return ask(Wheelset, "wheelset", self, request, strict=strict, warn=warn)


def roughness(
    surface: Surface | None = None,
    case: Case | None = None,
    *,
    second: Surface | None = None,
    synthetic: Texts | None = None,
    form: Literal["plane", "cylinder", "sphere", "none"] | None = None,
    cutoff: Number | None = None,
    unit: str | None = None,
    spacing: Number | None = None,
    fill_holes: bool = False,
    square_cells: bool = False,
    cells: int | None = None,
    seed: int | None = None,
    pressure: Numbers | None = None,
    friction: Number | None = None,
    hardness: Number | None = None,
    strict: bool = False,
    warn: bool = True,
) -> RoughContact:
    """Compute k_c from rough surfaces, with statistics, contact area and tangential curves.

    Parameters
    ----------
    surface : path, array, mapping, or surface of SurfaceTopography or surfalize, optional
        Surface or profile of one body, or of both together (.csv, .npy, .x3p, .xyz). Files of
        instruments are read by `open_surface`. Columns of a mapping without a unit: x in m, y
        in m, height in m, wavelength in m, level in dB.
    second : path, array, mapping, or surface of SurfaceTopography or surfalize, optional
        Surface of the other body, on the same lattice: their heights are added. Files of
        instruments are read by `open_surface`. Columns of a mapping without a unit: x in m, y
        in m, height in m, wavelength in m, level in dB.
    synthetic : str or sequence of str, optional
        Make a self-affine surface, such as rms_height="1 um",hurst=0.8,longest="100 um",
        shortest="5 um",seed=1; also rms_slope and roll_off.
    form : {"plane", "cylinder", "sphere", "none"}, optional
        Form to remove from a measured surface; by default a plane ("plane": a tilted plane;
        "cylinder": a circular cylinder in any direction; "sphere": a sphere; "none": nothing).
    cutoff : float or str, optional
        Remove waves longer than this from a measured surface, such as "0.8 mm" (λc of the
        Gaussian filter, ISO 16610). Numbers are in m.
    unit : str, optional
        Unit of the heights of an .npy file, of all lengths of an .xyz file, such as um.
    spacing : float or str, optional
        Spacing of the points of an .npy file or of heights alone, such as "1 um". Numbers are
        in m.
    fill_holes : bool, default False
        Fill points without a height smoothly.
    square_cells : bool, default False
        Resample a surface whose cells are not square.
    cells : int, optional
        Cells along x of the resampled or synthetic surface.
    seed : int, optional
        Seed of a surface generated from a profile.
    pressure : float or str, or several, optional
        Mean pressures: a range (six pressures) or a list; by default those of the case, of a
        surface given here without a case 0.2..1.2 GPa. Numbers are in Pa.
    friction : float or str, optional
        Coefficient of friction; by default that of the case.
    hardness : float or str, optional
        Hardness of the softer body, such as "2.5 GPa"; by default the bodies are elastic.
        Numbers are in Pa.
    case : Case, optional
        The case of the bodies; by default steel wheel and rail.
    strict : bool, default False
        Whether to raise `NotConverged`; else look at ``converged``.
    warn : bool, default True
        Whether to issue the warnings of the result.

    Returns
    -------
    RoughContact
        A rough surface, its contact and its k_c. With ``fields`` over x and y, ``spectrum``,
        ``loads`` and ``curves``.

    Raises
    ------
    CaseError
        If something is wrong with the case or an argument.
    NotConverged
        If the result has not converged; it has the result.
    """
    request: dict[str, object] = {
        "surface": surface,
        "second": second,
        "synthetic": synthetic,
        "form": form,
        "cutoff": cutoff,
        "unit": unit,
        "spacing": spacing,
        "fill_holes": fill_holes,
        "square_cells": square_cells,
        "cells": cells,
        "seed": seed,
        "pressure": pressure,
        "friction": friction,
        "hardness": hardness,
    }
    return ask(RoughContact, "roughness", case, request, strict=strict, warn=warn)


def damage(
    run: File,
    case: Case | None = None,
    *,
    strict: bool = False,
    warn: bool = True,
) -> Damage:
    """Compute the damage over a run: energy, fatigue and wear across the profile.

    Parameters
    ----------
    run : path
        Table of `sweep` with a column distance or time, or a study of such states (.toml),
        which is solved.
    case : Case, optional
        The case with the laws in the section [damage]; by default that of the study, which its
        table keeps.
    strict : bool, default False
        Whether to raise `NotConverged`; else look at ``converged``.
    warn : bool, default True
        Whether to issue the warnings of the result.

    Returns
    -------
    Damage
        Damage over a run: energy, fatigue and wear. ``energy`` (J), ``t_gamma``, ``fatigue``,
        ``archard``, ``energy_wear``; with ``profile`` over y and ``run`` over the distance.
        States without a solution or a friction power are left out.

    Raises
    ------
    CaseError
        If something is wrong with the case or an argument.
    NotConverged
        If the result has not converged; it has the result.

    References
    ----------
    Fatigue: Ekberg, Kabo and Andersson (2002). Wear: Archard (1953) with coefficients of
    Jendel (2002); Braghin, Lewis, Dwyer-Joyce and Bruni (2006).
    """
    request: dict[str, object] = {
        "run": run,
    }
    return ask(Damage, "damage", case, request, strict=strict, warn=warn)
