"""The methods of a case that ask for more than its solution.

Made of the tasks of the library by tests/generate_tasks.py.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from ._ask import Asking
from ._report import (
    BulkTemperature,
    Calibration,
    Comparison,
    Curve,
    Fit,
    RoughContact,
    Subsurface,
    Temperatures,
    Wear,
    Wheelset,
)

if TYPE_CHECKING:
    from ._ask import Data, Family, Number, Range, Texts


class Tasks(Asking):
    """What a case can be asked besides its solution."""

    def curve(
        self,
        *,
        creepage_x: Range | None = None,
        creepage_y: Range | None = None,
        spin: Range | None = None,
        creepage: Range | None = None,
        direction: Number | None = None,
        force_x: Range | None = None,
        traction_coefficient: Range | None = None,
        force_y: Range | None = None,
        moment_z: Range | None = None,
        over: Family | None = None,
        points: int = 41,
        spacing: Literal["refined", "even"] | None = None,
        strict: bool = False,
        warn: bool = True,
    ) -> Curve:
        """Compute creep curves: forces against creepage.

        Parameters
        ----------
        creepage_x : (float, float) or str, optional
            Vary the longitudinal creepage, such as 0..0.05; several creepages vary together.
        creepage_y : (float, float) or str, optional
            Vary the lateral creepage.
        spin : (float, float) or str, optional
            Vary the spin creepage, such as "0..2 1/m". Numbers are in 1/m.
        creepage : (float, float) or str, optional
            Vary the total creepage in a direction, in place of both creepages.
        direction : float or str, optional
            Direction of the total creepage, from longitudinal (0 deg) to lateral (90 deg). Numbers
            are in rad.
        force_x : (float, float) or str, optional
            Vary the longitudinal force on the wheel, such as "0..-20 kN" (negative in braking), in
            place of all creepages: its creepage is found. Numbers are in N.
        traction_coefficient : (float, float) or str, optional
            Vary the same over the load, such as 0..0.25 (positive in braking).
        force_y : (float, float) or str, optional
            Vary the lateral force on the wheel. Numbers are in N.
        moment_z : (float, float) or str, optional
            Vary the spin moment on the wheel, such as "0..20 N m". Numbers are in N m.
        over : mapping, optional
            Draw one curve for each value of a field, such as kinematics.speed="10 m/s,20 m/s" or
            kinematics.speed="5..50 m/s:10"; three numbers or more make a map, and two fields make
            one of the largest force over both.
        points : int, optional
            Number of points of each curve.
        spacing : {"refined", "even"}, optional
            Spacing of the points; by default refined over a creepage and even over a force
            ("refined": finer near zero creepage; "even": equal steps).
        strict : bool, default False
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.
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
        return self._ask(Curve, "curve", request, strict=strict, warn=warn)

    def roughness(
        self,
        *,
        surface: Data | None = None,
        second: Data | None = None,
        synthetic: Texts | None = None,
        form: Texts | None = None,
        cutoff: Texts | None = None,
        unit: Texts | None = None,
        spacing: Texts | None = None,
        fill_holes: bool = False,
        square_cells: bool = False,
        cells: Texts | None = None,
        seed: Texts | None = None,
        pressure: Texts | None = None,
        friction: Texts | None = None,
        hardness: Texts | None = None,
        strict: bool = False,
        warn: bool = True,
    ) -> RoughContact:
        """Compute k_c from rough surfaces, with statistics, contact area and tangential curves.

        Parameters
        ----------
        surface : path or mapping, optional
            Surface or profile of one body, or of both together (.csv, .npy, .x3p, .xyz).
        second : path or mapping, optional
            Surface of the other body, on the same lattice: their heights are added.
        synthetic : str or float, optional
            Make a self-affine surface, such as rms_height="1 um",hurst=0.8,longest="100 um",
            shortest="5 um",seed=1; also rms_slope and roll_off.
        form : str or float, optional
            Form to remove from a measured surface; by default a plane.
        cutoff : str or float, optional
            Remove waves longer than this from a measured surface, such as "0.8 mm" (λc of the
            Gaussian filter, ISO 16610).
        unit : str or float, optional
            Unit of the heights of an .npy file, of all lengths of an .xyz file, such as um.
        spacing : str or float, optional
            Spacing of the points of an .npy file or of heights alone, such as "1 um".
        fill_holes : bool, optional
            Fill points without a height smoothly.
        square_cells : bool, optional
            Resample a surface whose cells are not square.
        cells : str or float, optional
            Cells along x of the resampled or synthetic surface.
        seed : str or float, optional
            Seed of a surface generated from a profile.
        pressure : str or float, optional
            Mean pressures: a range (six pressures) or a list; by default those of the case, of a
            surface given here without a case 0.2..1.2 GPa.
        friction : str or float, optional
            Coefficient of friction; by default that of the case.
        hardness : str or float, optional
            Hardness of the softer body, such as "2.5 GPa"; by default the bodies are elastic.
        strict : bool, default False
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.
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
        return self._ask(RoughContact, "roughness", request, strict=strict, warn=warn)

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

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.
        """
        request: dict[str, object] = {}
        return self._ask(Comparison, "compare", request, strict=strict, warn=warn)

    def temperature(
        self,
        *,
        x: Number | None = None,
        y: Number | None = None,
        depth: Range | None = None,
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
        depth : (float, float) or str, optional
            Depths of the profile, such as "0..2 mm"; by default as far as heat has penetrated.
            Numbers are in m.
        wake : float or str, optional
            Length of the wake; by default twice the length of the contact. Numbers are in m.
        points : int, optional
            Number of points of each line.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.

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
        return self._ask(Temperatures, "temperature", request, strict=strict, warn=warn)

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
            depth [mm].
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.

        References
        ----------
        Love (1929); Ahmadi, Keer and Mura (1983).
        """
        request: dict[str, object] = {
            "x": x,
            "y": y,
            "points": points,
        }
        return self._ask(Subsurface, "subsurface", request, strict=strict, warn=warn)

    def wear(
        self,
        *,
        strict: bool = True,
        warn: bool = True,
    ) -> Wear:
        """Compute wear, fatigue and melting of one passage of the wheel.

        Parameters
        ----------
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.

        References
        ----------
        Wear: Archard (1953) with coefficients of Jendel (2002); Braghin, Lewis, Dwyer-Joyce and
        Bruni (2006). Fatigue: Ekberg, Kabo and Andersson (2002), Burstow (2004). Shakedown:
        Johnson and Jefferis (1963).
        """
        request: dict[str, object] = {}
        return self._ask(Wear, "wear", request, strict=strict, warn=warn)

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

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.
        """
        request: dict[str, object] = {}
        return self._ask(BulkTemperature, "bulk", request, strict=strict, warn=warn)

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
        direct : bool, optional
            Calibrate for this very patch instead of interpolating the table, and compare both.
        displacements : path, or several, optional
            Displacements of a finite-element model to fit to (CSV with columns x, y, traction_x,
            displacement_x, …); several files count together.
        cells : int, optional
            Cells across the patch on which layer and half-space are compared.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.
        """
        request: dict[str, object] = {
            "direct": direct,
            "displacements": displacements,
            "cells": cells,
        }
        return self._ask(Calibration, "calibrate", request, strict=strict, warn=warn)

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
        parameters : str or float
            Parameters to fit, such as "friction.coefficient,contact_law.stiffness";
            "contact_law.roughness" is the r.m.s. height of both surfaces together, in place of the
            stiffness.
        data : path or mapping
            Measured points (CSV): creepage_x, creepage_y or spin [1/m], force_ratio (-Fx/N over
            creepage_x, -Fy/N over creepage_y) or force_ratio_x, force_ratio_y, and where they
            differ from the case speed [m/s], load [kN]; standard_deviation where known.
        gamma : float or str, optional
            γ, for "contact_law.roughness": the rough surfaces approach by γ times that height when
            the pressure grows e-fold (Persson 2007).
        max_steps : int, optional
            Maximum number of steps of the fit.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.
        """
        request: dict[str, object] = {
            "parameters": parameters,
            "data": data,
            "gamma": gamma,
            "max_steps": max_steps,
        }
        return self._ask(Fit, "fit", request, strict=strict, warn=warn)

    def wheelset(
        self,
        *,
        lateral_position: Range = "-8..8 mm",
        points: int = 33,
        strict: bool = True,
        warn: bool = True,
    ) -> Wheelset:
        """Find the contacts of a wheelset over its lateral position, and its equivalent conicity.

        Parameters
        ----------
        lateral_position : (float, float) or str, optional
            First and last lateral position of the wheelset. Numbers are in m.
        points : int, optional
            Number of positions.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``converged``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Raises
        ------
        CaseError
            If something is wrong with the case or an argument.
        NotConverged
            If the result has not converged; the exception has it.
        """
        request: dict[str, object] = {
            "lateral_position": lateral_position,
            "points": points,
        }
        return self._ask(Wheelset, "wheelset", request, strict=strict, warn=warn)
