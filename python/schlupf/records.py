"""Records of results: their classes, to annotate with.

>>> import schlupf
>>> def resultant(force: schlupf.records.Force) -> float:
...     return (force.x**2 + force.y**2) ** 0.5

Made of results and of the columns of the library by tests/generate.py.
"""

from __future__ import annotations

from typing import Literal

from ._record import Found, Record
from .sections import KinematicsReference, SolverMethod, WheelsetSide

#: Whether the equations are satisfied.
Status = Literal[
    "converged",
    "not-converged",
]
#: Variables of ``fields``.
CellColumn = Literal[
    "centroid_x",
    "centroid_y",
    "pressure",
    "traction_x",
    "traction_y",
    "slip_x",
    "slip_y",
    "displacement_x",
    "displacement_y",
    "friction_coefficient",
    "friction_power",
    "temperature_rise_wheel",
    "temperature_rise_rail",
    "covered",
    "sliding",
    "contact",
]
#: Variables of ``history``.
InstantColumn = Literal[
    "distance",
    "speed",
    "creepage_x",
    "creepage_y",
    "spin",
    "shift_x",
    "shift_y",
    "turn",
    "normal_load",
    "force_x",
    "force_y",
    "moment_z",
    "friction_power",
    "creep_power",
    "stored_energy",
    "max_rise",
    "residual",
    "newton_iterations",
]


class Normal(Record):
    """``normal`` of a result."""

    load: Found[float] = Found()
    """normal load (N)."""
    semi_axis_x: Found[float] = Found()
    """half the length of the patch along rolling (m)."""
    semi_axis_y: Found[float] = Found()
    """half the width of the patch across rolling (m)."""
    peak_pressure: Found[float] = Found()
    """largest pressure (Pa)."""
    approach: Found[float | None] = Found()
    """approach of the bodies (m)."""
    origin_x: Found[float | None] = Found()
    origin_y: Found[float | None] = Found()
    parts: Found[int] = Found()


class Kinematics(Record):
    """``kinematics`` of a result."""

    speed: Found[float] = Found()
    """speed of the vehicle, or of the contact frame (m/s)."""
    creepage_x: Found[float] = Found()
    """longitudinal creepage."""
    creepage_y: Found[float] = Found()
    """lateral creepage."""
    spin: Found[float] = Found()
    """spin creepage (1/m)."""


class ReferencePatch(Record):
    """``reference.patch`` of a result."""

    creepage_x: Found[float] = Found()
    creepage_y: Found[float] = Found()
    spin: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class ReferenceFile(Record):
    """``reference.file`` of a result."""

    creepage_x: Found[float] = Found()
    creepage_y: Found[float] = Found()
    spin: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class Reference(Record):
    """``reference`` of a result."""

    point: Found[KinematicsReference] = Found()
    patch: Found[ReferencePatch] = Found(ReferencePatch)
    file: Found[ReferenceFile | None] = Found(ReferenceFile)


class ContactLawFit(Record):
    """``contact_law.fit`` of a result."""

    mean_pressures: Found[list[float]] = Found()
    stiffnesses: Found[list[float]] = Found()
    spread: Found[float] = Found()
    root_mean_square_error: Found[float] = Found()
    largest_error: Found[float] = Found()
    closed_form: Found[float] = Found()


class ContactLaw(Record):
    """``contact_law`` of a result."""

    stiffness: Found[float | None] = Found()
    rms_height: Found[float | None] = Found()
    slope_factor: Found[float | None] = Found()
    fit: Found[ContactLawFit | None] = Found(ContactLawFit)


class Force(Record):
    """``force`` of a result."""

    x: Found[float] = Found()
    """longitudinal force (N)."""
    y: Found[float] = Found()
    """lateral force (N)."""
    moment_z: Found[float | None] = Found()
    """spin moment (N m)."""


class Normalised(Record):
    """``normalised`` of a result."""

    x: Found[float] = Found()
    """longitudinal force over the friction limit."""
    y: Found[float] = Found()
    """lateral force over the friction limit."""
    moment_z: Found[float | None] = Found()
    """moment over friction limit and size."""


class Power(Record):
    """``power`` of a result."""

    friction: Found[float | None] = Found()
    """friction power (W)."""
    creep: Found[float | None] = Found()
    """power of the creep forces (W)."""
    returned: Found[float | None] = Found()
    """friction power that the bristles of the contact law return (W)."""
    into_wheel: Found[float | None] = Found()
    """part of the heat that goes into the wheel (W)."""
    into_rail: Found[float | None] = Found()
    """part of the heat that goes into the rail (W)."""
    exchanged: Found[float | None] = Found()
    """heat from the wheel into the rail as their bulk temperatures differ (W)."""


class TGamma(Record):
    """``t_gamma`` of a result."""

    without_spin: Found[float] = Found()
    """wear number, frictional energy per distance rolled (N)."""
    with_spin: Found[float | None] = Found()
    """wear number, frictional energy per distance rolled (N)."""


class Temperature(Record):
    """``temperature`` of a result."""

    max_rise: Found[float | None] = Found()
    """largest temperature rise (K)."""
    max_rise_wheel: Found[float | None] = Found()
    """largest temperature rise of the wheel's surface (K)."""
    max_rise_rail: Found[float | None] = Found()
    """largest temperature rise of the rail's surface (K)."""
    max_wheel: Found[float | None] = Found()
    """largest temperature of the wheel's surface (degC)."""
    max_rail: Found[float | None] = Found()
    """largest temperature of the rail's surface (degC)."""
    x: Found[float | None] = Found()
    """position along rolling (m)."""
    y: Found[float | None] = Found()
    """position across rolling (m)."""
    peclet_wheel: Found[float] = Found()
    """Péclet number."""
    peclet_rail: Found[float] = Found()
    """Péclet number."""


class Area(Record):
    """``area`` of a result."""

    contact: Found[float] = Found()
    """area of contact (m^2)."""
    stick: Found[float | None] = Found()
    """stick area (m^2)."""
    slip: Found[float | None] = Found()
    """slip area (m^2)."""


class SensitivityCreepageX(Record):
    """``sensitivity.creepage_x`` of a result."""

    x: Found[float] = Found()
    y: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class SensitivityCreepageY(Record):
    """``sensitivity.creepage_y`` of a result."""

    x: Found[float] = Found()
    y: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class SensitivitySpin(Record):
    """``sensitivity.spin`` of a result."""

    x: Found[float] = Found()
    y: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class SensitivityLoad(Record):
    """``sensitivity.load`` of a result."""

    x: Found[float] = Found()
    y: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class SensitivityFrictionCoefficient(Record):
    """``sensitivity.friction_coefficient`` of a result."""

    x: Found[float] = Found()
    y: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class SensitivityContactStiffness(Record):
    """``sensitivity.contact_stiffness`` of a result."""

    x: Found[float] = Found()
    y: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class Sensitivity(Record):
    """``sensitivity`` of a result."""

    creepage_x: Found[SensitivityCreepageX] = Found(SensitivityCreepageX)
    creepage_y: Found[SensitivityCreepageY] = Found(SensitivityCreepageY)
    spin: Found[SensitivitySpin] = Found(SensitivitySpin)
    load: Found[SensitivityLoad | None] = Found(SensitivityLoad)
    friction_coefficient: Found[SensitivityFrictionCoefficient] = Found(
        SensitivityFrictionCoefficient
    )
    contact_stiffness: Found[SensitivityContactStiffness] = Found(SensitivityContactStiffness)


class ExtrapolationForce(Record):
    """``extrapolation.force`` of a result."""

    x: Found[float] = Found()
    y: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class ExtrapolationNormalised(Record):
    """``extrapolation.normalised`` of a result."""

    x: Found[float] = Found()
    y: Found[float] = Found()
    moment_z: Found[float | None] = Found()


class ExtrapolationError(Record):
    """``extrapolation.error`` of a result."""

    x: Found[float] = Found()
    """estimated error of the longitudinal force (N)."""
    y: Found[float] = Found()
    """estimated error of the lateral force (N)."""
    moment_z: Found[float | None] = Found()
    """estimated error of the moment (N m)."""


class Extrapolation(Record):
    """``extrapolation`` of a result."""

    force: Found[ExtrapolationForce] = Found(ExtrapolationForce)
    normalised: Found[ExtrapolationNormalised] = Found(ExtrapolationNormalised)
    error: Found[ExtrapolationError] = Found(ExtrapolationError)


class Warning(Record):
    """``warning`` of a result."""

    code: Found[str] = Found()
    quantity: Found[str] = Found()
    text: Found[str] = Found()


class Work(Record):
    """``work`` of a result."""

    strategy: Found[str | None] = Found()
    """what led to the solution: warm, cold, continuation or march."""
    newton_iterations: Found[int] = Found()
    """Newton steps."""
    operator_products: Found[float] = Found()
    """number of products with the compliance."""
    sensitivity_products: Found[int] = Found()
    outer_iterations: Found[int] = Found()
    steps: Found[int] = Found()
    cells: Found[int] = Found()


class Wheelset(Record):
    """``wheelset`` of a result."""

    side: Found[WheelsetSide] = Found()
    lateral_position: Found[float] = Found()
    height: Found[float] = Found()
    """height of the axle above the nominal radius over z = 0 of the track (m)."""
    yaw_angle: Found[float] = Found()
    roll_angle: Found[float] = Found()
    """roll angle of the wheelset (rad)."""
    angular_velocity: Found[float] = Found()
    """angular velocity of the wheel about its axle (rad/s)."""


class ContactPosition(Record):
    """``contact.position`` of a result."""

    x: Found[float] = Found()
    """position in the track, forwards of the wheelset's centre (m)."""
    y: Found[float] = Found()
    """position in the track, to the left of its middle (m)."""
    z: Found[float] = Found()
    """position in the track, upwards (m)."""


class ContactNormal(Record):
    """``contact.normal`` of a result."""

    load: Found[float] = Found()
    """normal load (N)."""
    semi_axis_x: Found[float] = Found()
    """half the length of the patch along rolling (m)."""
    semi_axis_y: Found[float] = Found()
    """half the width of the patch across rolling (m)."""
    peak_pressure: Found[float] = Found()
    """largest pressure (Pa)."""
    approach: Found[float | None] = Found()
    """approach of the bodies (m)."""
    origin_x: Found[float | None] = Found()
    origin_y: Found[float | None] = Found()
    parts: Found[int] = Found()


class ContactForce(Record):
    """``contact.force`` of a result."""

    x: Found[float] = Found()
    """longitudinal force (N)."""
    y: Found[float] = Found()
    """lateral force (N)."""
    moment_z: Found[float | None] = Found()
    """spin moment (N m)."""


class ContactNormalised(Record):
    """``contact.normalised`` of a result."""

    x: Found[float] = Found()
    """longitudinal force over the friction limit."""
    y: Found[float] = Found()
    """lateral force over the friction limit."""
    moment_z: Found[float | None] = Found()
    """moment over friction limit and size."""


class ContactTGamma(Record):
    """``contact.t_gamma`` of a result."""

    without_spin: Found[float] = Found()
    """wear number, frictional energy per distance rolled (N)."""
    with_spin: Found[float | None] = Found()
    """wear number, frictional energy per distance rolled (N)."""


class ContactArea(Record):
    """``contact.area`` of a result."""

    contact: Found[float] = Found()
    """area of contact (m^2)."""
    stick: Found[float | None] = Found()
    """stick area (m^2)."""
    slip: Found[float | None] = Found()
    """slip area (m^2)."""


class Contact(Record):
    """``contact`` of a result."""

    position: Found[ContactPosition] = Found(ContactPosition)
    angle: Found[float] = Found()
    """angle of the contact plane, positive where the rail's outward normal leans to the left
    (rad)."""
    rise_angle: Found[float] = Found()
    """angle by which the contact plane rises forwards, with the rail (rad)."""
    rail_position: Found[float] = Found()
    """position of the contact on the rail's profile, outwards (m)."""
    wheel_position: Found[float] = Found()
    """position of the contact on the wheel's profile, outwards (m)."""
    rolling_radius: Found[float] = Found()
    """radius of the wheel at the contact (m)."""
    turn: Found[float] = Found()
    status: Found[Status] = Found()
    speed: Found[float] = Found()
    """speed of the vehicle, or of the contact frame (m/s)."""
    creepage_x: Found[float] = Found()
    """longitudinal creepage."""
    creepage_y: Found[float] = Found()
    """lateral creepage."""
    spin: Found[float] = Found()
    """spin creepage (1/m)."""
    normal: Found[ContactNormal] = Found(ContactNormal)
    force: Found[ContactForce] = Found(ContactForce)
    normalised: Found[ContactNormalised] = Found(ContactNormalised)
    t_gamma: Found[ContactTGamma] = Found(ContactTGamma)
    friction_power: Found[float | None] = Found()
    """friction power (W)."""
    max_rise: Found[float | None] = Found()
    """largest temperature rise (K)."""
    area: Found[ContactArea] = Found(ContactArea)
    residual: Found[float] = Found()
    """relative residual."""


class WheelForce(Record):
    """``wheel_force`` of a result."""

    x: Found[float] = Found()
    """longitudinal force on the wheel in the track frame (N)."""
    y: Found[float] = Found()
    """lateral force on the wheel in the track frame (N)."""
    z: Found[float] = Found()
    """vertical force on the wheel in the track frame (N)."""


class Solved(Record):
    """The scalars of a result."""

    program: Found[str] = Found()
    title: Found[str] = Found()
    method: Found[SolverMethod] = Found()
    status: Found[Status] = Found()
    normal: Found[Normal] = Found(Normal)
    kinematics: Found[Kinematics] = Found(Kinematics)
    reference: Found[Reference] = Found(Reference)
    contact_law: Found[ContactLaw | None] = Found(ContactLaw)
    force: Found[Force] = Found(Force)
    normalised: Found[Normalised] = Found(Normalised)
    traction_coefficient: Found[float] = Found()
    """tangential force over the load."""
    power: Found[Power] = Found(Power)
    t_gamma: Found[TGamma] = Found(TGamma)
    temperature: Found[Temperature] = Found(Temperature)
    area: Found[Area] = Found(Area)
    sensitivity: Found[Sensitivity | None] = Found(Sensitivity)
    extrapolation: Found[Extrapolation | None] = Found(Extrapolation)
    warnings: Found[list[Warning]] = Found(Warning)
    residual: Found[float] = Found()
    """relative residual."""
    work: Found[Work] = Found(Work)
    wheelset: Found[Wheelset | None] = Found(Wheelset)
    contacts: Found[list[Contact] | None] = Found(Contact)
    wheel_force: Found[WheelForce | None] = Found(WheelForce)
