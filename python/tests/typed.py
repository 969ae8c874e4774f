"""What type checkers know of a case and its results, and what they refuse.

Nothing of it runs: an error that is expected is ignored, and an error that is lacking is one.
"""

from typing import Literal

import numpy as np
import pandas as pd
import pint
import SurfaceTopography
import surfalize
import xarray as xr
from typing_extensions import assert_type

import schlupf
from schlupf import Case


def sections_are_dictionaries_or_sections(case: Case) -> None:
    Case("braking", normal={"load": "80 kN"}, kinematics={"creepage_x": 0.008, "speed": 30})
    Case(normal={"lod": 80e3})  # type: ignore[arg-type]
    Case(nrmal={"load": 80e3})  # type: ignore[call-arg]
    Case(normal={"load": [1.0]})  # type: ignore[arg-type]
    Case(normal={"model": "herz"})  # type: ignore[arg-type]
    Case(kinematics={"creepage_x": "0.01"})  # type: ignore[arg-type]
    Case(history={"time": ["0 s", "1 ms"], "creepage_x": np.array([0.0, 0.002])})
    Case(contact_law={"roughness": {"rms_height": "1 um"}})
    Case(contact_law={"roughness": {"rms_hight": "1 um"}})  # type: ignore[arg-type]
    case.with_(normal=case.normal, wheel=None, grid={"cells_x": np.int64(8), "cells_y": None})
    case.with_(title="other", solver={"extrapolate": True})
    case.with_(titel="other")  # type: ignore[call-arg]
    grid: schlupf.sections.GridFields = {"cells_x": 8}
    case.with_(grid=grid)


def fields_are_attributes(case: Case) -> None:
    assert_type(case.title, str)
    assert_type(case.normal, schlupf.sections.Normal)
    assert_type(case.normal.load, float | None)
    assert_type(case.grid.cells_x, int)
    assert_type(case.heat.partition, float | Literal["velocity"])
    assert_type(case.history.time, list[float] | None)
    assert_type(case.contact_law.roughness.rms_height, float | None)
    case.normal.load = "80 kN"
    case.normal = {"load": 80e3}
    case.normal.load = [1.0]  # type: ignore[assignment]
    case.normal.lod  # type: ignore[attr-defined]
    case.normal.lod = 1.0  # type: ignore[attr-defined]
    case.nrmal  # type: ignore[attr-defined]
    schlupf.Solver(case).solve(creepage_x=0.01, friction__coefficient=0.3)
    schlupf.Solver(case).solve(creepage_x=[0.01])  # type: ignore[arg-type]


def files_may_be_arrays(case: Case) -> None:
    Case(wheel={"profile": np.zeros((3, 2))}, rail={"profile": {"y": [0.0], "z": [1.0]}})
    Case(normal={"file": xr.DataArray()}, history={"file": xr.Dataset()})
    Case(contact_law={"roughness": np.zeros((8, 8))})
    Case(wheel={"profile": 3.0})  # type: ignore[arg-type]
    Case(solver={"table": np.zeros(3)})  # type: ignore[arg-type]
    case.roughness(surface=np.zeros((8, 8)), spacing="1 um")
    case.roughness(surface=np.zeros((8, 8)), spacin="1 um")  # type: ignore[call-arg]
    schlupf.roughness(np.zeros((8, 8)), spacin=1e-6)  # type: ignore[call-arg]
    schlupf.roughness(np.zeros((8, 8)), form="cone")  # type: ignore[arg-type]
    schlupf.roughness(1e-6)  # type: ignore[arg-type]
    schlupf.roughness({"wavelength": [1e-5], "level": [0.0]}, case, second="other.sur")
    schlupf.roughness(surfalize.Surface(np.zeros((8, 8)), 1.0, 1.0))
    schlupf.roughness(SurfaceTopography.Topography(np.zeros((8, 8)), (1.0, 1.0), unit="m"))
    measured = surfalize.Surface(np.zeros((8, 8)), 1.0, 1.0)
    Case(contact_law={"roughness": measured})
    Case(contact_law={"roughness": {"file": measured}})
    Case(contact_law={"roughness": {"file": 1.0}})  # type: ignore[arg-type]
    Case(contact_law={"roughness": 1.0})  # type: ignore[arg-type]
    curve = case.curve(creepage_x=[0.0, 0.001, 0.01], over={"normal.load": [60e3]})
    assert_type(curve, schlupf.Curve)
    case.curve(creepage_x=0.01)  # type: ignore[arg-type]
    quantity = pint.UnitRegistry().Quantity(np.zeros((8, 8)), "um")
    schlupf.roughness(quantity, spacing="1 um")
    for points in (xr.DataArray([0.0, 0.01]), pd.Series([0.0, 0.01]), pd.Index([0.0, 0.01])):
        case.curve(creepage_x=points)
    assert_type(schlupf.roughness(np.zeros((8, 8)), spacing=1e-6), schlupf.RoughContact)
    assert_type(schlupf.open_surface("rail.sur"), xr.DataArray)


def studies_are_objects(case: Case) -> None:
    study = schlupf.study(case, vary={"normal.load": [60e3, 80e3]})
    assert_type(study.rows, int)
    assert_type(schlupf.sweep(study, "table.csv").table, xr.Dataset)
    schlupf.study(case, vary={"normal.lod": [60e3]})  # type: ignore[dict-item]
    schlupf.study(case, states={"creepage_x": [0.0]}, fields=["pressure"])
    assert_type(schlupf.open_table("table.csv"), xr.Dataset)
    assert_type(schlupf.open_result("result.nc"), schlupf.Result)


def conditions_are_fields(case: Case) -> None:
    schlupf.forces(case, creepage_x=np.linspace(0, 0.01, 5), load=["60 kN", "80 kN"])
    schlupf.forces(case, wheel__radius_x=0.5)
    schlupf.forces(case, creepage=0.1)  # type: ignore[call-arg]
    case.curve(creepage_x=(0, 0.05), over={"kinematics.speed": [10, 20]})
    case.curve(over={"kinematics.sped": [10, 20]})  # type: ignore[dict-item]


def contact_tables_state_their_errors(case: Case) -> None:
    errors = schlupf.contact_table(case, "contacts.npz", largest_yaw_angle="10 mrad", poses=9)
    assert_type(errors, schlupf.ContactTableErrors)
    assert_type(errors.load.ninety_percent, float)
    schlupf.contact_table(case, "contacts.npz", largest_roll_angle=0.01, tolerance=0.01)
    schlupf.contact_table(case)  # type: ignore[call-arg]
    schlupf.contact_table(case, "contacts.npz", tolerance="1 %")  # type: ignore[arg-type]


def presets_are_sections() -> None:
    steel, wet = schlupf.materials.steel, schlupf.friction.polach_wet
    Case(wheel=steel, rail=steel, friction=wet, layer=schlupf.layers.sand)
    Case(contact_law={"roughness": schlupf.roughnesses.ground_rail})
    Case(**schlupf.methods.polach_dry)
    case = Case(**schlupf.conditions.wet)
    case.wheel = schlupf.materials["steel"]
    assert_type(wet, schlupf.Preset[schlupf.sections.FrictionFields])
    Case(wheel=wet)  # type: ignore[arg-type]
    Case(friction=steel)  # type: ignore[arg-type]
    Case(solver=schlupf.methods.polach_dry)  # type: ignore[arg-type]
    Case(contact_law=schlupf.roughnesses.ground_rail)  # type: ignore[arg-type]
    case.wheel = schlupf.friction["polach_wet"]  # type: ignore[assignment]
    schlupf.materials.stel  # type: ignore[attr-defined]
    assert_type(schlupf.materials.steel.source, str)


def results_are_records(result: schlupf.Result) -> None:
    assert_type(result.force.x, float)
    assert_type(result.force.moment_z, float | None)
    assert_type(result.temperature.max_rise, float | None)
    assert_type(result.work.newton_iterations, int)
    assert_type(result.power.friction, float | None)
    result.forse  # type: ignore[attr-defined]
    result.force.z  # type: ignore[attr-defined]
    result.force.x = 1.0  # type: ignore[assignment]
    result.plot.surface("pressure")
    result.plot.surface("presure")  # type: ignore[arg-type]
    result.plot.surface("centroid_x")
    result.plot.surface("x")  # type: ignore[arg-type]
    result.plot.cut("slip_x", "friction_limit")
    result.plot.cut("y")  # type: ignore[arg-type]
    result.plot.history("max_rise")
    result.plot.history("time")  # type: ignore[arg-type]
    schlupf.plot_comparison([result], "slip_x")
    schlupf.animate(result, "slip")  # type: ignore[arg-type]


def what_a_result_may_lack_is_optional(result: schlupf.Result) -> None:
    result.contacts[0]  # type: ignore[index]
    result.extrapolation.error  # type: ignore[union-attr]
    if result.contacts is not None and result.wheel_force is not None:
        assert_type(result.contacts[0], schlupf.records.Contact)
        assert_type(result.contacts[0].normal.load, float)
        assert_type(result.contacts[0].max_rise, float | None)
        assert_type(result.contacts[0].area.contact, float)
        assert_type(result.wheel_force.z, float)
    if result.wheelset is not None:
        assert_type(result.wheelset.side, Literal["right", "left"])
    if result.contact_law is not None:
        assert_type(result.contact_law.stiffness, float | None)
        assert_type(result.contact_law.rms_height, float | None)
        assert_type(result.contact_law.fit, schlupf.records.ContactLawFit | None)
    if result.extrapolation is not None:
        assert_type(result.extrapolation.force.x, float)


def names_are_literals(result: schlupf.Result) -> None:
    assert_type(result.status, Literal["converged", "not-converged"])
    assert_type(result.reference.point, Literal["patch", "file"])
    assert_type(result.method, schlupf.sections.SolverMethod)


def records_are_public(result: schlupf.Result) -> None:
    force: schlupf.records.Force = result.force
    solved: schlupf.records.Solved = result
    column: schlupf.records.CellColumn = "pressure"
    result.plot.surface(column)
    assert_type(solved.force, schlupf.records.Force)
    force.x
