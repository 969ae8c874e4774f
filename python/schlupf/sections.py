"""Sections of a case as classes, and what they are given as dictionaries.

>>> import schlupf
>>> load: schlupf.sections.NormalFields = {"load": "80 kN"}
>>> case = schlupf.Case(normal=load)
>>> isinstance(case.normal, schlupf.sections.Normal)
True

Made of the fields of the library by tests/generate.py.
"""

from __future__ import annotations

from typing import Generic, Literal, TypeVar

from ._preset import Preset
from ._section import Entry, Section, SolverSection
from ._typing import TypedDict
from ._units import Count, Data, File, Flag, Heights, Number, Plain, Series, Surface

V = TypeVar("V")

KinematicsReference = Literal[
    "patch",
    "file",
]
WheelProfileZ = Literal[
    "auto",
    "up",
    "down",
]
WheelProfileY = Literal[
    "auto",
    "outwards",
    "inwards",
]
RailProfileZ = Literal[
    "auto",
    "up",
    "down",
]
RailProfileY = Literal[
    "auto",
    "outwards",
    "inwards",
]
NormalModel = Literal[
    "hertz",
    "line",
    "ellipse",
    "tabulated",
    "profile",
    "wheel-rail",
]
NormalRowMotion = Literal[
    "automatic",
    "surface",
    "plane",
]
NormalMethod = Literal[
    "half-spaces",
    "conformal",
    "kik-piotrowski",
    "ellipse-corrected",
    "equivalent-ellipse",
    "analyn",
]
WheelsetSide = Literal[
    "right",
    "left",
]
WheelsetForceAxis = Literal[
    "track",
    "wheelset",
]
LeftWheelProfileZ = Literal[
    "auto",
    "up",
    "down",
]
LeftWheelProfileY = Literal[
    "auto",
    "outwards",
    "inwards",
]
RightWheelProfileZ = Literal[
    "auto",
    "up",
    "down",
]
RightWheelProfileY = Literal[
    "auto",
    "outwards",
    "inwards",
]
LeftRailProfileZ = Literal[
    "auto",
    "up",
    "down",
]
LeftRailProfileY = Literal[
    "auto",
    "outwards",
    "inwards",
]
RightRailProfileZ = Literal[
    "auto",
    "up",
    "down",
]
RightRailProfileY = Literal[
    "auto",
    "outwards",
    "inwards",
]
ElasticityModel = Literal[
    "elastic-layer",
    "half-space",
    "viscoelastic",
    "winkler",
    "rigid",
]
ElasticityCalibration = Literal["half-space"]
ElasticityUnlikeBodies = Literal[
    "coupled",
    "one-way",
    "neglected",
]
ContactLawModel = Literal[
    "incremental",
    "total-displacement",
    "coulomb",
]
ContactLawRoughnessForm = Literal[
    "plane",
    "cylinder",
    "sphere",
    "none",
]
FrictionModel = Literal[
    "temperature-linear",
    "constant",
    "temperature-piecewise-linear",
    "exponential",
    "rational",
    "linear-in-speed",
    "polach",
]
FrictionSpeedModel = Literal[
    "none",
    "exponential",
    "rational",
    "linear-in-speed",
    "polach",
]
HeatModel = Literal[
    "duhamel",
    "constant-source",
    "none",
]
HeatPartition = Literal["velocity"]
SubsurfaceBody = Literal[
    "rail",
    "wheel",
]
SolverDriver = Literal[
    "steady",
    "marching",
]
SolverBranch = Literal[
    "low-slip",
    "high-slip",
]
SolverMethod = Literal[
    "full",
    "kalker-linear",
    "shen-hedrick-elkins",
    "polach",
    "table",
    "fastsim",
    "modified-fastsim",
]
FastsimFlexibilities = Literal[
    "three",
    "one",
]
FastsimBound = Literal[
    "parabolic",
    "elliptic",
]
ElementMotion = Literal[
    "velocities",
    "creepages",
]
ElementNormal = Literal[
    "load",
    "approach",
]
HistoryStart = Literal[
    "rest",
    "steady",
]

#: Dotted paths of all fields.
FieldPath = Literal[
    "title",
    "kinematics.speed",
    "kinematics.creepage_x",
    "kinematics.angular_velocity",
    "kinematics.wheel_radius",
    "kinematics.creepage_y",
    "kinematics.yaw_angle",
    "kinematics.spin",
    "kinematics.force_x",
    "kinematics.traction_coefficient",
    "kinematics.wheel_torque",
    "kinematics.force_y",
    "kinematics.moment_z",
    "kinematics.reference",
    "wheel.young_modulus",
    "wheel.relaxed_modulus",
    "wheel.retardation_time",
    "wheel.poisson_ratio",
    "wheel.conductivity",
    "wheel.density",
    "wheel.specific_heat",
    "wheel.bulk_temperature",
    "wheel.radius_x",
    "wheel.radius_y",
    "wheel.profile",
    "wheel.profile_z",
    "wheel.profile_y",
    "wheel.profile_scale",
    "wheel.profile_smoothing",
    "wheel.flange_back_position",
    "rail.young_modulus",
    "rail.relaxed_modulus",
    "rail.retardation_time",
    "rail.poisson_ratio",
    "rail.conductivity",
    "rail.density",
    "rail.specific_heat",
    "rail.bulk_temperature",
    "rail.radius_x",
    "rail.radius_y",
    "rail.angular_velocity",
    "rail.profile",
    "rail.profile_z",
    "rail.profile_y",
    "rail.profile_scale",
    "rail.profile_smoothing",
    "rail.cant",
    "rail.origin_y",
    "rail.origin_z",
    "normal.model",
    "normal.load",
    "normal.approach",
    "normal.length",
    "normal.semi_axis_x",
    "normal.semi_axis_y",
    "normal.peak_pressure",
    "normal.file",
    "normal.spacing_x",
    "normal.spacing_y",
    "normal.cells",
    "normal.join_distance",
    "normal.join_angle",
    "normal.row_motion",
    "normal.method",
    "track.gauge",
    "track.gauge_depth",
    "track.curve_radius",
    "track.flange_back_distance",
    "wheelset.side",
    "wheelset.track_position",
    "wheelset.pitch_angle",
    "wheelset.lateral_position",
    "wheelset.yaw_angle",
    "wheelset.roll_angle",
    "wheelset.height",
    "wheelset.lateral_velocity",
    "wheelset.vertical_velocity",
    "wheelset.yaw_rate",
    "wheelset.roll_rate",
    "wheelset.force_axis",
    "left_wheel.profile",
    "left_wheel.profile_z",
    "left_wheel.profile_y",
    "left_wheel.profile_scale",
    "left_wheel.profile_smoothing",
    "left_wheel.radius_x",
    "left_wheel.flange_back_position",
    "left_wheel.longitudinal_displacement",
    "left_wheel.lateral_displacement",
    "left_wheel.vertical_displacement",
    "left_wheel.roll_angle",
    "left_wheel.yaw_angle",
    "left_wheel.longitudinal_velocity",
    "left_wheel.lateral_velocity",
    "left_wheel.vertical_velocity",
    "left_wheel.roll_rate",
    "left_wheel.pitch_rate",
    "left_wheel.yaw_rate",
    "right_wheel.profile",
    "right_wheel.profile_z",
    "right_wheel.profile_y",
    "right_wheel.profile_scale",
    "right_wheel.profile_smoothing",
    "right_wheel.radius_x",
    "right_wheel.flange_back_position",
    "right_wheel.longitudinal_displacement",
    "right_wheel.lateral_displacement",
    "right_wheel.vertical_displacement",
    "right_wheel.roll_angle",
    "right_wheel.yaw_angle",
    "right_wheel.longitudinal_velocity",
    "right_wheel.lateral_velocity",
    "right_wheel.vertical_velocity",
    "right_wheel.roll_rate",
    "right_wheel.pitch_rate",
    "right_wheel.yaw_rate",
    "left_rail.profile",
    "left_rail.profile_z",
    "left_rail.profile_y",
    "left_rail.profile_scale",
    "left_rail.profile_smoothing",
    "left_rail.cant",
    "left_rail.origin_y",
    "left_rail.origin_z",
    "left_rail.lateral_displacement",
    "left_rail.vertical_displacement",
    "left_rail.roll_angle",
    "left_rail.lateral_velocity",
    "left_rail.vertical_velocity",
    "left_rail.roll_rate",
    "right_rail.profile",
    "right_rail.profile_z",
    "right_rail.profile_y",
    "right_rail.profile_scale",
    "right_rail.profile_smoothing",
    "right_rail.cant",
    "right_rail.origin_y",
    "right_rail.origin_z",
    "right_rail.lateral_displacement",
    "right_rail.vertical_displacement",
    "right_rail.roll_angle",
    "right_rail.lateral_velocity",
    "right_rail.vertical_velocity",
    "right_rail.roll_rate",
    "elasticity.model",
    "elasticity.calibration",
    "elasticity.unlike_bodies",
    "elasticity.bedding_x",
    "elasticity.bedding_y",
    "elasticity.coupling_x",
    "elasticity.coupling_x_across",
    "elasticity.coupling_y",
    "elasticity.coupling_y_across",
    "elasticity.spring_x",
    "elasticity.spring_y",
    "elasticity.spring_coupling_x",
    "elasticity.spring_coupling_y",
    "elasticity.margin",
    "layer.thickness",
    "layer.shear_modulus",
    "layer.yield_stress",
    "layer.hardening",
    "contact_law.model",
    "contact_law.stiffness",
    "contact_law.roughness.rms_height",
    "contact_law.roughness.rms_height_wheel",
    "contact_law.roughness.rms_height_rail",
    "contact_law.roughness.slope_factor",
    "contact_law.roughness.rms_slope",
    "contact_law.roughness.longest_wavelength",
    "contact_law.roughness.roll_off_wavelength",
    "contact_law.roughness.shortest_wavelength",
    "contact_law.roughness.hurst",
    "contact_law.roughness.file",
    "contact_law.roughness.second_file",
    "contact_law.roughness.unit",
    "contact_law.roughness.spacing",
    "contact_law.roughness.form",
    "contact_law.roughness.cutoff_wavelength",
    "contact_law.roughness.fill_holes",
    "contact_law.roughness.square_cells",
    "contact_law.roughness.cells",
    "contact_law.roughness.seed",
    "contact_law.roughness.hardness",
    "contact_law.roughness.pressures",
    "friction.model",
    "friction.coefficient",
    "friction.temperature_at_zero_friction",
    "friction.reference_temperature",
    "friction.minimum_coefficient",
    "friction.hot_coefficient",
    "friction.temperature_range",
    "friction.speed_model",
    "friction.kinetic_coefficient",
    "friction.half_speed",
    "friction.second_coefficient",
    "friction.second_half_speed",
    "friction.limit_ratio",
    "friction.decay",
    "friction.memory_distance",
    "friction.memory_speed",
    "friction.variation_y",
    "friction.variation_inclination",
    "friction.variation_factor",
    "friction.variation_file",
    "heat.model",
    "heat.partition",
    "cooling.film_coefficient",
    "cooling.area",
    "cooling.air_temperature",
    "subsurface.body",
    "subsurface.depth",
    "subsurface.layers",
    "subsurface.margin",
    "damage.shear_yield_stress",
    "damage.hardness",
    "damage.wear_coefficient_mild",
    "damage.wear_coefficient_severe",
    "damage.wear_coefficient_catastrophic",
    "damage.wear_map",
    "damage.wear_rate_mild",
    "damage.wear_rate_catastrophic",
    "damage.crack_t_gamma",
    "damage.crack_damage",
    "damage.melting_temperature",
    "grid.cells_x",
    "grid.cells_y",
    "solver.driver",
    "solver.branch",
    "solver.method",
    "solver.table",
    "solver.tolerance",
    "solver.max_iterations",
    "solver.max_steps",
    "solver.sensitivity",
    "solver.extrapolate",
    "solver.slip_threshold",
    "solver.polach_area_adhesion",
    "solver.polach_area_slip",
    "fastsim.flexibilities",
    "fastsim.bound",
    "fastsim.initial_reduction",
    "fastsim.reduction_limit_ratio",
    "fastsim.reduction_decay",
    "element.motion",
    "element.normal",
    "element.memory",
    "element.contact_table",
    "element.standstill_speed",
    "history.time",
    "history.start",
    "history.creepage_x",
    "history.creepage_y",
    "history.spin",
    "history.speed",
    "history.load",
    "history.force_x",
    "history.force_y",
    "history.moment_z",
    "history.shift_x",
    "history.shift_y",
    "history.turn",
    "history.shifts_x",
    "history.shifts_y",
    "history.turns",
    "history.lateral_position",
    "history.yaw_angle",
    "history.roll_angle",
    "history.height",
    "history.lateral_velocity",
    "history.vertical_velocity",
    "history.yaw_rate",
    "history.roll_rate",
    "history.angular_velocity",
    "history.shift_duration",
    "history.file",
]


class KinematicsFields(TypedDict, total=False):
    """Fields of the section `kinematics`."""

    speed: Number | None
    """v0, speed of the vehicle, or of the circumference of a roller (m/s); default: 108 km/h."""
    creepage_x: Plain | None
    """ξ, longitudinal creepage: positive when braking; default: 0.0."""
    angular_velocity: Number | None
    """ω of the wheel, in place of creepage_x (rad/s)."""
    wheel_radius: Number | None
    """R, rolling radius that goes with angular_velocity or wheel_torque (m); default:
    wheel.radius_x."""
    creepage_y: Plain | None
    """η, lateral creepage; default: 0.0."""
    yaw_angle: Number | None
    """α, slip angle, in place of creepage_y (rad)."""
    spin: Number | None
    """φ, spin creepage (1/m); default: 0 1/m."""
    force_x: Number | None
    """Fx on the wheel, in place of creepage_x, which is found: negative when braking; of two
    profiles that of all contacts together (N)."""
    traction_coefficient: Plain | None
    """-Fx/N, in place of creepage_x: positive when braking; of two profiles over the vertical
    force."""
    wheel_torque: Number | None
    """T on the wheel about its axle, in place of creepage_x, with Fx = T/wheel_radius (of two
    profiles in balance with the tractions of all contacts): negative when braking (N m)."""
    force_y: Number | None
    """Fy on the wheel, in place of creepage_y and shifts_y (N)."""
    moment_z: Number | None
    """Mz on the wheel, in place of spin and turns (N m)."""
    reference: KinematicsReference | None
    """where creepages hold (those of a history, too) and about which point the moment is taken;
    default: patch ("patch": the middle of the patch; "file": the origin of the positions in
    normal.file)."""


class Kinematics(Section, path="kinematics"):
    """How the wheel moves over the rail. Braking has a positive creepage and a negative force."""

    __slots__ = ()
    speed: Entry[float | None, Number | None] = Entry()
    """v0, speed of the vehicle, or of the circumference of a roller (m/s); default: 108 km/h."""
    creepage_x: Entry[float | None, Plain | None] = Entry()
    """ξ, longitudinal creepage: positive when braking; default: 0.0."""
    angular_velocity: Entry[float | None, Number | None] = Entry()
    """ω of the wheel, in place of creepage_x (rad/s)."""
    wheel_radius: Entry[float | None, Number | None] = Entry()
    """R, rolling radius that goes with angular_velocity or wheel_torque (m); default:
    wheel.radius_x."""
    creepage_y: Entry[float | None, Plain | None] = Entry()
    """η, lateral creepage; default: 0.0."""
    yaw_angle: Entry[float | None, Number | None] = Entry()
    """α, slip angle, in place of creepage_y (rad)."""
    spin: Entry[float | None, Number | None] = Entry()
    """φ, spin creepage (1/m); default: 0 1/m."""
    force_x: Entry[float | None, Number | None] = Entry()
    """Fx on the wheel, in place of creepage_x, which is found: negative when braking; of two
    profiles that of all contacts together (N)."""
    traction_coefficient: Entry[float | None, Plain | None] = Entry()
    """-Fx/N, in place of creepage_x: positive when braking; of two profiles over the vertical
    force."""
    wheel_torque: Entry[float | None, Number | None] = Entry()
    """T on the wheel about its axle, in place of creepage_x, with Fx = T/wheel_radius (of two
    profiles in balance with the tractions of all contacts): negative when braking (N m)."""
    force_y: Entry[float | None, Number | None] = Entry()
    """Fy on the wheel, in place of creepage_y and shifts_y (N)."""
    moment_z: Entry[float | None, Number | None] = Entry()
    """Mz on the wheel, in place of spin and turns (N m)."""
    reference: Entry[KinematicsReference, KinematicsReference | None] = Entry()
    """where creepages hold (those of a history, too) and about which point the moment is taken;
    default: patch ("patch": the middle of the patch; "file": the origin of the positions in
    normal.file)."""


class WheelFields(TypedDict, total=False):
    """Fields of the section `wheel`."""

    young_modulus: Number | None
    """E, Young's modulus (Pa); default: 210 GPa."""
    relaxed_modulus: Number | None
    """E∞, Young's modulus after a long time, where young_modulus is the instantaneous one (Pa);
    default: wheel.young_modulus."""
    retardation_time: Number | None
    """τ, retardation time: under constant stress the rest of the creep falls as exp(-t/τ) (s);
    default: 0 s."""
    poisson_ratio: Plain | None
    """ν, Poisson's ratio; default: 0.28."""
    conductivity: Number | None
    """λ, thermal conductivity (W/(m K)); default: 50 W/(m K)."""
    density: Number | None
    """ρ, density (kg/m^3); default: 7850 kg/m^3."""
    specific_heat: Number | None
    """c, specific heat (J/(kg K)); default: 450 J/(kg K)."""
    bulk_temperature: Number | None
    """temperature far from the contact (degC); default: 20 degC."""
    radius_x: Number | None
    """radius of curvature along rolling: "inf" where straight, negative where concave (m);
    default: 0.46 m."""
    radius_y: Number | None
    """radius of curvature across rolling (m); default: inf."""
    profile: Data | None
    """profile: a file (CSV with the header `y [mm],z [mm]`, Simpack, Miniprof, or two columns in
    mm) or the name of one that is built in, such as "S1002"; or a table of y (m), z (m)."""
    profile_z: WheelProfileZ | None
    """direction of z in the file; default: auto ("auto": found from the shape (what runs is level,
    sides and flange hang down), else that of the format; "up": upwards; "down": downwards)."""
    profile_y: WheelProfileY | None
    """direction of y in the file; default: auto ("auto": found from the flange of a wheel and the
    deeper side of a rail, else that of the format; "outwards": away from the middle of the track;
    "inwards": towards the middle of the track)."""
    profile_scale: Plain | None
    """factor of y and z in the file; default: 1.0."""
    profile_smoothing: Number | None
    """L: what is shorter along the profile is levelled out; 5 mm for a measured one (m); default:
    0 mm."""
    flange_back_position: Number | None
    """y of the flange back in the profile, with y outwards (m); default: -70 mm; 0 mm in files of
    Miniprof, and where the flange lies so."""


class Wheel(Section, path="wheel"):
    """The wheel: elastic and thermal constants, temperature, curvature radii."""

    __slots__ = ()
    young_modulus: Entry[float, Number | None] = Entry()
    """E, Young's modulus (Pa); default: 210 GPa."""
    relaxed_modulus: Entry[float | None, Number | None] = Entry()
    """E∞, Young's modulus after a long time, where young_modulus is the instantaneous one (Pa);
    default: wheel.young_modulus."""
    retardation_time: Entry[float, Number | None] = Entry()
    """τ, retardation time: under constant stress the rest of the creep falls as exp(-t/τ) (s);
    default: 0 s."""
    poisson_ratio: Entry[float, Plain | None] = Entry()
    """ν, Poisson's ratio; default: 0.28."""
    conductivity: Entry[float, Number | None] = Entry()
    """λ, thermal conductivity (W/(m K)); default: 50 W/(m K)."""
    density: Entry[float, Number | None] = Entry()
    """ρ, density (kg/m^3); default: 7850 kg/m^3."""
    specific_heat: Entry[float, Number | None] = Entry()
    """c, specific heat (J/(kg K)); default: 450 J/(kg K)."""
    bulk_temperature: Entry[float, Number | None] = Entry()
    """temperature far from the contact (degC); default: 20 degC."""
    radius_x: Entry[float, Number | None] = Entry()
    """radius of curvature along rolling: "inf" where straight, negative where concave (m);
    default: 0.46 m."""
    radius_y: Entry[float, Number | None] = Entry()
    """radius of curvature across rolling (m); default: inf."""
    profile: Entry[str | None, Data | None] = Entry()
    """profile: a file (CSV with the header `y [mm],z [mm]`, Simpack, Miniprof, or two columns in
    mm) or the name of one that is built in, such as "S1002"; or a table of y (m), z (m)."""
    profile_z: Entry[WheelProfileZ, WheelProfileZ | None] = Entry()
    """direction of z in the file; default: auto ("auto": found from the shape (what runs is level,
    sides and flange hang down), else that of the format; "up": upwards; "down": downwards)."""
    profile_y: Entry[WheelProfileY, WheelProfileY | None] = Entry()
    """direction of y in the file; default: auto ("auto": found from the flange of a wheel and the
    deeper side of a rail, else that of the format; "outwards": away from the middle of the track;
    "inwards": towards the middle of the track)."""
    profile_scale: Entry[float, Plain | None] = Entry()
    """factor of y and z in the file; default: 1.0."""
    profile_smoothing: Entry[float, Number | None] = Entry()
    """L: what is shorter along the profile is levelled out; 5 mm for a measured one (m); default:
    0 mm."""
    flange_back_position: Entry[float | None, Number | None] = Entry()
    """y of the flange back in the profile, with y outwards (m); default: -70 mm; 0 mm in files of
    Miniprof, and where the flange lies so."""


class RailFields(TypedDict, total=False):
    """Fields of the section `rail`."""

    young_modulus: Number | None
    """E, Young's modulus (Pa); default: 210 GPa."""
    relaxed_modulus: Number | None
    """E∞, Young's modulus after a long time, where young_modulus is the instantaneous one (Pa);
    default: rail.young_modulus."""
    retardation_time: Number | None
    """τ, retardation time: under constant stress the rest of the creep falls as exp(-t/τ) (s);
    default: 0 s."""
    poisson_ratio: Plain | None
    """ν, Poisson's ratio; default: 0.28."""
    conductivity: Number | None
    """λ, thermal conductivity (W/(m K)); default: 50 W/(m K)."""
    density: Number | None
    """ρ, density (kg/m^3); default: 7850 kg/m^3."""
    specific_heat: Number | None
    """c, specific heat (J/(kg K)); default: 450 J/(kg K)."""
    bulk_temperature: Number | None
    """temperature far from the contact (degC); default: 20 degC."""
    radius_x: Number | None
    """radius of curvature along rolling: "inf" where straight, negative where concave (m);
    default: inf."""
    radius_y: Number | None
    """radius of curvature across rolling (m); default: 300 mm."""
    angular_velocity: Number | None
    """of a roller of radius radius_x, in place of kinematics.speed (rad/s)."""
    profile: Data | None
    """profile: a file or the name of one that is built in, such as "60E1"; as for the wheel; or a
    table of y (m), z (m)."""
    profile_z: RailProfileZ | None
    """direction of z in the file; default: auto ("auto": found from the shape (what runs is level,
    sides and flange hang down), else that of the format; "up": upwards; "down": downwards)."""
    profile_y: RailProfileY | None
    """direction of y in the file; default: auto ("auto": found from the flange of a wheel and the
    deeper side of a rail, else that of the format; "outwards": away from the middle of the track;
    "inwards": towards the middle of the track)."""
    profile_scale: Plain | None
    """factor of y and z in the file; default: 1.0."""
    profile_smoothing: Number | None
    """L: what is shorter along the profile is levelled out; 5 mm for a measured one (m); default:
    0 mm."""
    cant: Plain | None
    """inclination of the rail towards the middle, such as 0.025 for 1:40; 0 for a profile that is
    canted already; default: 0.0."""
    origin_y: Number | None
    """y of the origin of the profile in the track, outwards, in place of track.gauge (m)."""
    origin_z: Number | None
    """z of that origin in the track (m); default: 0 mm."""


class Rail(Section, path="rail"):
    """The rail: the same fields as the wheel."""

    __slots__ = ()
    young_modulus: Entry[float, Number | None] = Entry()
    """E, Young's modulus (Pa); default: 210 GPa."""
    relaxed_modulus: Entry[float | None, Number | None] = Entry()
    """E∞, Young's modulus after a long time, where young_modulus is the instantaneous one (Pa);
    default: rail.young_modulus."""
    retardation_time: Entry[float, Number | None] = Entry()
    """τ, retardation time: under constant stress the rest of the creep falls as exp(-t/τ) (s);
    default: 0 s."""
    poisson_ratio: Entry[float, Plain | None] = Entry()
    """ν, Poisson's ratio; default: 0.28."""
    conductivity: Entry[float, Number | None] = Entry()
    """λ, thermal conductivity (W/(m K)); default: 50 W/(m K)."""
    density: Entry[float, Number | None] = Entry()
    """ρ, density (kg/m^3); default: 7850 kg/m^3."""
    specific_heat: Entry[float, Number | None] = Entry()
    """c, specific heat (J/(kg K)); default: 450 J/(kg K)."""
    bulk_temperature: Entry[float, Number | None] = Entry()
    """temperature far from the contact (degC); default: 20 degC."""
    radius_x: Entry[float, Number | None] = Entry()
    """radius of curvature along rolling: "inf" where straight, negative where concave (m);
    default: inf."""
    radius_y: Entry[float, Number | None] = Entry()
    """radius of curvature across rolling (m); default: 300 mm."""
    angular_velocity: Entry[float | None, Number | None] = Entry()
    """of a roller of radius radius_x, in place of kinematics.speed (rad/s)."""
    profile: Entry[str | None, Data | None] = Entry()
    """profile: a file or the name of one that is built in, such as "60E1"; as for the wheel; or a
    table of y (m), z (m)."""
    profile_z: Entry[RailProfileZ, RailProfileZ | None] = Entry()
    """direction of z in the file; default: auto ("auto": found from the shape (what runs is level,
    sides and flange hang down), else that of the format; "up": upwards; "down": downwards)."""
    profile_y: Entry[RailProfileY, RailProfileY | None] = Entry()
    """direction of y in the file; default: auto ("auto": found from the flange of a wheel and the
    deeper side of a rail, else that of the format; "outwards": away from the middle of the track;
    "inwards": towards the middle of the track)."""
    profile_scale: Entry[float, Plain | None] = Entry()
    """factor of y and z in the file; default: 1.0."""
    profile_smoothing: Entry[float, Number | None] = Entry()
    """L: what is shorter along the profile is levelled out; 5 mm for a measured one (m); default:
    0 mm."""
    cant: Entry[float, Plain | None] = Entry()
    """inclination of the rail towards the middle, such as 0.025 for 1:40; 0 for a profile that is
    canted already; default: 0.0."""
    origin_y: Entry[float | None, Number | None] = Entry()
    """y of the origin of the profile in the track, outwards, in place of track.gauge (m)."""
    origin_z: Entry[float, Number | None] = Entry()
    """z of that origin in the track (m); default: 0 mm."""


class NormalFields(TypedDict, total=False):
    """Fields of the section `normal`."""

    model: NormalModel | None
    """source of the pressure; default: hertz ("hertz": from the radii and the moduli of both
    bodies, and load or approach; "line": from the radii along rolling and the moduli of two
    cylinders, length, and load or approach; "ellipse": from semi_axis_x, semi_axis_y, and load or
    peak_pressure; "tabulated": from file, scaled to load if that is given; "profile": from file,
    the undeformed distance of the bodies, and load or approach; "wheel-rail": from wheel.profile,
    rail.profile, track, wheelset, and load, the vertical force: all contacts of a wheel)."""
    load: Number | None
    """N, normal load; with "wheel-rail" the vertical force on the wheel (N); default: 80 kN."""
    approach: Number | None
    """δ, approach of the bodies since they touch, in place of load, which is found (m)."""
    length: Number | None
    """L, length of a line contact across rolling, on which the whole load acts; with "profile" for
    a file of x alone (m)."""
    semi_axis_x: Number | None
    """a, semi-axis along rolling (m)."""
    semi_axis_y: Number | None
    """b, semi-axis across rolling (m)."""
    peak_pressure: Number | None
    """p0, largest pressure, in place of load (Pa)."""
    file: Data | None
    """CSV with the header `x [mm],y [mm],pressure [MPa]`, or with "profile" `x [mm],y
    [mm],distance [um]`, `y [mm],distance [mm]` (across at x = 0) or `x [mm],distance [mm]` (along,
    for a line contact); or .npy in Pa or m, each row along x; or a table of x (m), y (m), pressure
    (Pa) or x (m), y (m), distance (m)."""
    spacing_x: Number | None
    """spacing of the columns of an .npy file (m)."""
    spacing_y: Number | None
    """spacing of the rows of an .npy file (m)."""
    cells: Count | None
    """cells across the contact each way, on which the pressure of profiles is found (64 with
    "wheel-rail"); default: 128."""
    join_distance: Number | None
    """distance up to which neighbouring contacts share a plane (m); default: 8 mm."""
    join_angle: Number | None
    """difference of their angles up to which they do (rad); default: 20 deg."""
    row_motion: NormalRowMotion | None
    """with what the rows across a curved contact move; default: automatic ("automatic": plane
    where the surface turns by up to 0.2 rad over a contact, surface from 0.3 rad on; "surface":
    every row slips and spins as the surface there; "plane": all rows move with the plane of the
    contact)."""
    method: NormalMethod | None
    """how the contacts of two profiles are found; default: half-spaces ("half-spaces": the
    pressure of two elastic half-spaces; "conformal": the same on the curved surface of the rail,
    for contacts that turn by more than 0.3 rad; "kik-piotrowski": patch and pressure from the
    overlap at 0.55 of the approach (virtual penetration); "ellipse-corrected": the same with
    shares of the approach from Hertz's theory, exact for ellipses; "equivalent-ellipse": Hertz's
    ellipse with the curvatures of the distance; "analyn": row by row as in Hertz's ellipse with
    the curvatures there)."""


class Normal(Section, path="normal"):
    """Where the normal pressure comes from."""

    __slots__ = ()
    model: Entry[NormalModel, NormalModel | None] = Entry()
    """source of the pressure; default: hertz ("hertz": from the radii and the moduli of both
    bodies, and load or approach; "line": from the radii along rolling and the moduli of two
    cylinders, length, and load or approach; "ellipse": from semi_axis_x, semi_axis_y, and load or
    peak_pressure; "tabulated": from file, scaled to load if that is given; "profile": from file,
    the undeformed distance of the bodies, and load or approach; "wheel-rail": from wheel.profile,
    rail.profile, track, wheelset, and load, the vertical force: all contacts of a wheel)."""
    load: Entry[float | None, Number | None] = Entry()
    """N, normal load; with "wheel-rail" the vertical force on the wheel (N); default: 80 kN."""
    approach: Entry[float | None, Number | None] = Entry()
    """δ, approach of the bodies since they touch, in place of load, which is found (m)."""
    length: Entry[float | None, Number | None] = Entry()
    """L, length of a line contact across rolling, on which the whole load acts; with "profile" for
    a file of x alone (m)."""
    semi_axis_x: Entry[float | None, Number | None] = Entry()
    """a, semi-axis along rolling (m)."""
    semi_axis_y: Entry[float | None, Number | None] = Entry()
    """b, semi-axis across rolling (m)."""
    peak_pressure: Entry[float | None, Number | None] = Entry()
    """p0, largest pressure, in place of load (Pa)."""
    file: Entry[str | None, Data | None] = Entry()
    """CSV with the header `x [mm],y [mm],pressure [MPa]`, or with "profile" `x [mm],y
    [mm],distance [um]`, `y [mm],distance [mm]` (across at x = 0) or `x [mm],distance [mm]` (along,
    for a line contact); or .npy in Pa or m, each row along x; or a table of x (m), y (m), pressure
    (Pa) or x (m), y (m), distance (m)."""
    spacing_x: Entry[float | None, Number | None] = Entry()
    """spacing of the columns of an .npy file (m)."""
    spacing_y: Entry[float | None, Number | None] = Entry()
    """spacing of the rows of an .npy file (m)."""
    cells: Entry[int | None, Count | None] = Entry()
    """cells across the contact each way, on which the pressure of profiles is found (64 with
    "wheel-rail"); default: 128."""
    join_distance: Entry[float, Number | None] = Entry()
    """distance up to which neighbouring contacts share a plane (m); default: 8 mm."""
    join_angle: Entry[float, Number | None] = Entry()
    """difference of their angles up to which they do (rad); default: 20 deg."""
    row_motion: Entry[NormalRowMotion, NormalRowMotion | None] = Entry()
    """with what the rows across a curved contact move; default: automatic ("automatic": plane
    where the surface turns by up to 0.2 rad over a contact, surface from 0.3 rad on; "surface":
    every row slips and spins as the surface there; "plane": all rows move with the plane of the
    contact)."""
    method: Entry[NormalMethod, NormalMethod | None] = Entry()
    """how the contacts of two profiles are found; default: half-spaces ("half-spaces": the
    pressure of two elastic half-spaces; "conformal": the same on the curved surface of the rail,
    for contacts that turn by more than 0.3 rad; "kik-piotrowski": patch and pressure from the
    overlap at 0.55 of the approach (virtual penetration); "ellipse-corrected": the same with
    shares of the approach from Hertz's theory, exact for ellipses; "equivalent-ellipse": Hertz's
    ellipse with the curvatures of the distance; "analyn": row by row as in Hertz's ellipse with
    the curvatures there)."""


class TrackFields(TypedDict, total=False):
    """Fields of the section `track`."""

    gauge: Number | None
    """distance of the gauge faces of both rails (m); default: 1435 mm."""
    gauge_depth: Number | None
    """depth below the top of the rail down to which the gauge is measured (m); default: 14 mm."""
    curve_radius: Number | None
    """radius of the curve: positive where the track turns to the left, negative to the right (m);
    default: inf."""
    flange_back_distance: Number | None
    """distance of the flange backs of the wheelset (m); default: 1360 mm."""


class Track(Section, path="track"):
    """Where the profiles are, if the normal contact is that of two profiles."""

    __slots__ = ()
    gauge: Entry[float | None, Number | None] = Entry()
    """distance of the gauge faces of both rails (m); default: 1435 mm."""
    gauge_depth: Entry[float | None, Number | None] = Entry()
    """depth below the top of the rail down to which the gauge is measured (m); default: 14 mm."""
    curve_radius: Entry[float, Number | None] = Entry()
    """radius of the curve: positive where the track turns to the left, negative to the right (m);
    default: inf."""
    flange_back_distance: Entry[float, Number | None] = Entry()
    """distance of the flange backs of the wheelset (m); default: 1360 mm."""


class WheelsetFields(TypedDict, total=False):
    """Fields of the section `wheelset`."""

    side: WheelsetSide | None
    """which wheel is solved; default: right ("right": the wheel at negative y; "left": the wheel
    at positive y)."""
    track_position: Number | None
    """place along the track, of a rail whose profile changes (m); default: 0 m."""
    pitch_angle: Number | None
    """angle around the wheel that is below the axle, of one whose profile changes: it grows in
    rolling forwards (rad); default: 0 rad."""
    lateral_position: Number | None
    """lateral position of the middle of the axle (m); default: 0 mm."""
    yaw_angle: Number | None
    """yaw angle about z (rad); default: 0 mrad."""
    roll_angle: Number | None
    """roll angle about x (rad); default: both wheels rest on their rails."""
    height: Number | None
    """height of the middle of the axle above the nominal radius over z = 0 of the track, in place
    of normal.load (m)."""
    lateral_velocity: Number | None
    """lateral velocity of the middle of the axle (m/s); default: 0 m/s."""
    vertical_velocity: Number | None
    """vertical velocity of the middle of the axle (m/s); default: 0 m/s; under normal.load on
    slices that with which the wheel follows them."""
    yaw_rate: Number | None
    """angular velocity about the vertical axis (rad/s); default: 0 rad/s."""
    roll_rate: Number | None
    """angular velocity about the longitudinal axis (rad/s); default: 0 rad/s."""
    force_axis: WheelsetForceAxis | None
    """axis of kinematics.force_x on the wheel: along the track, or along the wheelset; default:
    track ("track": along the track; "wheelset": across the axle: it turns with the wheelset)."""


class Wheelset(Section, path="wheelset"):
    """Position and motion of the wheelset in the track (x forwards, y to the left, z up), if the
    normal contact is that of two profiles; the wheel turns at kinematics.angular_velocity."""

    __slots__ = ()
    side: Entry[WheelsetSide, WheelsetSide | None] = Entry()
    """which wheel is solved; default: right ("right": the wheel at negative y; "left": the wheel
    at positive y)."""
    track_position: Entry[float, Number | None] = Entry()
    """place along the track, of a rail whose profile changes (m); default: 0 m."""
    pitch_angle: Entry[float, Number | None] = Entry()
    """angle around the wheel that is below the axle, of one whose profile changes: it grows in
    rolling forwards (rad); default: 0 rad."""
    lateral_position: Entry[float, Number | None] = Entry()
    """lateral position of the middle of the axle (m); default: 0 mm."""
    yaw_angle: Entry[float, Number | None] = Entry()
    """yaw angle about z (rad); default: 0 mrad."""
    roll_angle: Entry[float | None, Number | None] = Entry()
    """roll angle about x (rad); default: both wheels rest on their rails."""
    height: Entry[float | None, Number | None] = Entry()
    """height of the middle of the axle above the nominal radius over z = 0 of the track, in place
    of normal.load (m)."""
    lateral_velocity: Entry[float, Number | None] = Entry()
    """lateral velocity of the middle of the axle (m/s); default: 0 m/s."""
    vertical_velocity: Entry[float | None, Number | None] = Entry()
    """vertical velocity of the middle of the axle (m/s); default: 0 m/s; under normal.load on
    slices that with which the wheel follows them."""
    yaw_rate: Entry[float, Number | None] = Entry()
    """angular velocity about the vertical axis (rad/s); default: 0 rad/s."""
    roll_rate: Entry[float, Number | None] = Entry()
    """angular velocity about the longitudinal axis (rad/s); default: 0 rad/s."""
    force_axis: Entry[WheelsetForceAxis, WheelsetForceAxis | None] = Entry()
    """axis of kinematics.force_x on the wheel: along the track, or along the wheelset; default:
    track ("track": along the track; "wheelset": across the axle: it turns with the wheelset)."""


class LeftWheelFields(TypedDict, total=False):
    """Fields of the section `left_wheel`."""

    profile: Data | None
    """its profile; default: wheel.profile; or a table of y (m), z (m)."""
    profile_z: LeftWheelProfileZ | None
    """direction of z in the file; default: wheel.profile_z ("auto": found from the shape (what
    runs is level, sides and flange hang down), else that of the format; "up": upwards; "down":
    downwards)."""
    profile_y: LeftWheelProfileY | None
    """direction of y in the file; default: wheel.profile_y ("auto": found from the flange of a
    wheel and the deeper side of a rail, else that of the format; "outwards": away from the middle
    of the track; "inwards": towards the middle of the track)."""
    profile_scale: Plain | None
    """factor of y and z in the file; default: wheel.profile_scale."""
    profile_smoothing: Number | None
    """length over which it is smoothed (m); default: wheel.profile_smoothing."""
    radius_x: Number | None
    """its nominal rolling radius; the height of the axle and creepage_x are those of
    wheel.radius_x (m); default: wheel.radius_x."""
    flange_back_position: Number | None
    """y of the flange back in its profile, with y outwards (m); default:
    wheel.flange_back_position."""
    longitudinal_displacement: Number | None
    """displacement of the profile's origin forwards from its place in the wheelset, along the axes
    of that (m); default: 0 mm."""
    lateral_displacement: Number | None
    """displacement of that origin to the left (m); default: 0 mm."""
    vertical_displacement: Number | None
    """displacement of that origin upwards (m); default: 0 mm."""
    roll_angle: Number | None
    """turn of the wheel about x through that origin, relative to the wheelset (rad); default: 0
    mrad."""
    yaw_angle: Number | None
    """turn of the wheel about the z that has turned about x (rad); default: 0 mrad."""
    longitudinal_velocity: Number | None
    """velocity of that origin forwards, relative to the wheelset and along its axes (m/s);
    default: 0 m/s."""
    lateral_velocity: Number | None
    """velocity of that origin to the left (m/s); default: 0 m/s."""
    vertical_velocity: Number | None
    """velocity of that origin upwards (m/s); default: 0 m/s."""
    roll_rate: Number | None
    """angular velocity about x relative to the wheelset; −ω yaw_angle if it turns about its own
    axis (rad/s); default: 0 rad/s."""
    pitch_rate: Number | None
    """angular velocity about y beyond that of the wheelset (rad/s); default: 0 rad/s."""
    yaw_rate: Number | None
    """angular velocity about z relative to the wheelset; ω roll_angle if it turns about its own
    axis (rad/s); default: 0 rad/s."""


class LeftWheel(Section, path="left_wheel"):
    """What the left wheel has of its own, and how it deviates from its place."""

    __slots__ = ()
    profile: Entry[str | None, Data | None] = Entry()
    """its profile; default: wheel.profile; or a table of y (m), z (m)."""
    profile_z: Entry[LeftWheelProfileZ | None, LeftWheelProfileZ | None] = Entry()
    """direction of z in the file; default: wheel.profile_z ("auto": found from the shape (what
    runs is level, sides and flange hang down), else that of the format; "up": upwards; "down":
    downwards)."""
    profile_y: Entry[LeftWheelProfileY | None, LeftWheelProfileY | None] = Entry()
    """direction of y in the file; default: wheel.profile_y ("auto": found from the flange of a
    wheel and the deeper side of a rail, else that of the format; "outwards": away from the middle
    of the track; "inwards": towards the middle of the track)."""
    profile_scale: Entry[float | None, Plain | None] = Entry()
    """factor of y and z in the file; default: wheel.profile_scale."""
    profile_smoothing: Entry[float | None, Number | None] = Entry()
    """length over which it is smoothed (m); default: wheel.profile_smoothing."""
    radius_x: Entry[float | None, Number | None] = Entry()
    """its nominal rolling radius; the height of the axle and creepage_x are those of
    wheel.radius_x (m); default: wheel.radius_x."""
    flange_back_position: Entry[float | None, Number | None] = Entry()
    """y of the flange back in its profile, with y outwards (m); default:
    wheel.flange_back_position."""
    longitudinal_displacement: Entry[float | None, Number | None] = Entry()
    """displacement of the profile's origin forwards from its place in the wheelset, along the axes
    of that (m); default: 0 mm."""
    lateral_displacement: Entry[float | None, Number | None] = Entry()
    """displacement of that origin to the left (m); default: 0 mm."""
    vertical_displacement: Entry[float | None, Number | None] = Entry()
    """displacement of that origin upwards (m); default: 0 mm."""
    roll_angle: Entry[float | None, Number | None] = Entry()
    """turn of the wheel about x through that origin, relative to the wheelset (rad); default: 0
    mrad."""
    yaw_angle: Entry[float | None, Number | None] = Entry()
    """turn of the wheel about the z that has turned about x (rad); default: 0 mrad."""
    longitudinal_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin forwards, relative to the wheelset and along its axes (m/s);
    default: 0 m/s."""
    lateral_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin to the left (m/s); default: 0 m/s."""
    vertical_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin upwards (m/s); default: 0 m/s."""
    roll_rate: Entry[float | None, Number | None] = Entry()
    """angular velocity about x relative to the wheelset; −ω yaw_angle if it turns about its own
    axis (rad/s); default: 0 rad/s."""
    pitch_rate: Entry[float | None, Number | None] = Entry()
    """angular velocity about y beyond that of the wheelset (rad/s); default: 0 rad/s."""
    yaw_rate: Entry[float | None, Number | None] = Entry()
    """angular velocity about z relative to the wheelset; ω roll_angle if it turns about its own
    axis (rad/s); default: 0 rad/s."""


class RightWheelFields(TypedDict, total=False):
    """Fields of the section `right_wheel`."""

    profile: Data | None
    """its profile; default: wheel.profile; or a table of y (m), z (m)."""
    profile_z: RightWheelProfileZ | None
    """direction of z in the file; default: wheel.profile_z ("auto": found from the shape (what
    runs is level, sides and flange hang down), else that of the format; "up": upwards; "down":
    downwards)."""
    profile_y: RightWheelProfileY | None
    """direction of y in the file; default: wheel.profile_y ("auto": found from the flange of a
    wheel and the deeper side of a rail, else that of the format; "outwards": away from the middle
    of the track; "inwards": towards the middle of the track)."""
    profile_scale: Plain | None
    """factor of y and z in the file; default: wheel.profile_scale."""
    profile_smoothing: Number | None
    """length over which it is smoothed (m); default: wheel.profile_smoothing."""
    radius_x: Number | None
    """its nominal rolling radius; the height of the axle and creepage_x are those of
    wheel.radius_x (m); default: wheel.radius_x."""
    flange_back_position: Number | None
    """y of the flange back in its profile, with y outwards (m); default:
    wheel.flange_back_position."""
    longitudinal_displacement: Number | None
    """displacement of the profile's origin forwards from its place in the wheelset, along the axes
    of that (m); default: 0 mm."""
    lateral_displacement: Number | None
    """displacement of that origin to the left (m); default: 0 mm."""
    vertical_displacement: Number | None
    """displacement of that origin upwards (m); default: 0 mm."""
    roll_angle: Number | None
    """turn of the wheel about x through that origin, relative to the wheelset (rad); default: 0
    mrad."""
    yaw_angle: Number | None
    """turn of the wheel about the z that has turned about x (rad); default: 0 mrad."""
    longitudinal_velocity: Number | None
    """velocity of that origin forwards, relative to the wheelset and along its axes (m/s);
    default: 0 m/s."""
    lateral_velocity: Number | None
    """velocity of that origin to the left (m/s); default: 0 m/s."""
    vertical_velocity: Number | None
    """velocity of that origin upwards (m/s); default: 0 m/s."""
    roll_rate: Number | None
    """angular velocity about x relative to the wheelset; −ω yaw_angle if it turns about its own
    axis (rad/s); default: 0 rad/s."""
    pitch_rate: Number | None
    """angular velocity about y beyond that of the wheelset (rad/s); default: 0 rad/s."""
    yaw_rate: Number | None
    """angular velocity about z relative to the wheelset; ω roll_angle if it turns about its own
    axis (rad/s); default: 0 rad/s."""


class RightWheel(Section, path="right_wheel"):
    """What the right wheel has of its own, and how it deviates from its place."""

    __slots__ = ()
    profile: Entry[str | None, Data | None] = Entry()
    """its profile; default: wheel.profile; or a table of y (m), z (m)."""
    profile_z: Entry[RightWheelProfileZ | None, RightWheelProfileZ | None] = Entry()
    """direction of z in the file; default: wheel.profile_z ("auto": found from the shape (what
    runs is level, sides and flange hang down), else that of the format; "up": upwards; "down":
    downwards)."""
    profile_y: Entry[RightWheelProfileY | None, RightWheelProfileY | None] = Entry()
    """direction of y in the file; default: wheel.profile_y ("auto": found from the flange of a
    wheel and the deeper side of a rail, else that of the format; "outwards": away from the middle
    of the track; "inwards": towards the middle of the track)."""
    profile_scale: Entry[float | None, Plain | None] = Entry()
    """factor of y and z in the file; default: wheel.profile_scale."""
    profile_smoothing: Entry[float | None, Number | None] = Entry()
    """length over which it is smoothed (m); default: wheel.profile_smoothing."""
    radius_x: Entry[float | None, Number | None] = Entry()
    """its nominal rolling radius; the height of the axle and creepage_x are those of
    wheel.radius_x (m); default: wheel.radius_x."""
    flange_back_position: Entry[float | None, Number | None] = Entry()
    """y of the flange back in its profile, with y outwards (m); default:
    wheel.flange_back_position."""
    longitudinal_displacement: Entry[float | None, Number | None] = Entry()
    """displacement of the profile's origin forwards from its place in the wheelset, along the axes
    of that (m); default: 0 mm."""
    lateral_displacement: Entry[float | None, Number | None] = Entry()
    """displacement of that origin to the left (m); default: 0 mm."""
    vertical_displacement: Entry[float | None, Number | None] = Entry()
    """displacement of that origin upwards (m); default: 0 mm."""
    roll_angle: Entry[float | None, Number | None] = Entry()
    """turn of the wheel about x through that origin, relative to the wheelset (rad); default: 0
    mrad."""
    yaw_angle: Entry[float | None, Number | None] = Entry()
    """turn of the wheel about the z that has turned about x (rad); default: 0 mrad."""
    longitudinal_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin forwards, relative to the wheelset and along its axes (m/s);
    default: 0 m/s."""
    lateral_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin to the left (m/s); default: 0 m/s."""
    vertical_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin upwards (m/s); default: 0 m/s."""
    roll_rate: Entry[float | None, Number | None] = Entry()
    """angular velocity about x relative to the wheelset; −ω yaw_angle if it turns about its own
    axis (rad/s); default: 0 rad/s."""
    pitch_rate: Entry[float | None, Number | None] = Entry()
    """angular velocity about y beyond that of the wheelset (rad/s); default: 0 rad/s."""
    yaw_rate: Entry[float | None, Number | None] = Entry()
    """angular velocity about z relative to the wheelset; ω roll_angle if it turns about its own
    axis (rad/s); default: 0 rad/s."""


class LeftRailFields(TypedDict, total=False):
    """Fields of the section `left_rail`."""

    profile: Data | None
    """its profile; default: rail.profile; or a table of y (m), z (m)."""
    profile_z: LeftRailProfileZ | None
    """direction of z in the file; default: rail.profile_z ("auto": found from the shape (what runs
    is level, sides and flange hang down), else that of the format; "up": upwards; "down":
    downwards)."""
    profile_y: LeftRailProfileY | None
    """direction of y in the file; default: rail.profile_y ("auto": found from the flange of a
    wheel and the deeper side of a rail, else that of the format; "outwards": away from the middle
    of the track; "inwards": towards the middle of the track)."""
    profile_scale: Plain | None
    """factor of y and z in the file; default: rail.profile_scale."""
    profile_smoothing: Number | None
    """length over which it is smoothed (m); default: rail.profile_smoothing."""
    cant: Plain | None
    """its inclination towards the middle; default: rail.cant."""
    origin_y: Number | None
    """y of the origin of its profile in the track, outwards, in place of track.gauge (m); default:
    rail.origin_y."""
    origin_z: Number | None
    """z of that origin in the track (m); default: rail.origin_z."""
    lateral_displacement: Number | None
    """irregularity: displacement to the left from its place in the track (m); default: 0 mm."""
    vertical_displacement: Number | None
    """irregularity: displacement upwards, of a roller's profile on its axle (m); default: 0 mm."""
    roll_angle: Number | None
    """irregularity: turn about x through the origin of its profile (rad); default: 0 mrad."""
    lateral_velocity: Number | None
    """velocity of that origin to the left (m/s); default: 0 m/s."""
    vertical_velocity: Number | None
    """velocity of that origin upwards (m/s); default: 0 m/s."""
    roll_rate: Number | None
    """angular velocity about x (rad/s); default: 0 rad/s."""


class LeftRail(Section, path="left_rail"):
    """What the left rail has of its own, and how it deviates from its place."""

    __slots__ = ()
    profile: Entry[str | None, Data | None] = Entry()
    """its profile; default: rail.profile; or a table of y (m), z (m)."""
    profile_z: Entry[LeftRailProfileZ | None, LeftRailProfileZ | None] = Entry()
    """direction of z in the file; default: rail.profile_z ("auto": found from the shape (what runs
    is level, sides and flange hang down), else that of the format; "up": upwards; "down":
    downwards)."""
    profile_y: Entry[LeftRailProfileY | None, LeftRailProfileY | None] = Entry()
    """direction of y in the file; default: rail.profile_y ("auto": found from the flange of a
    wheel and the deeper side of a rail, else that of the format; "outwards": away from the middle
    of the track; "inwards": towards the middle of the track)."""
    profile_scale: Entry[float | None, Plain | None] = Entry()
    """factor of y and z in the file; default: rail.profile_scale."""
    profile_smoothing: Entry[float | None, Number | None] = Entry()
    """length over which it is smoothed (m); default: rail.profile_smoothing."""
    cant: Entry[float | None, Plain | None] = Entry()
    """its inclination towards the middle; default: rail.cant."""
    origin_y: Entry[float | None, Number | None] = Entry()
    """y of the origin of its profile in the track, outwards, in place of track.gauge (m); default:
    rail.origin_y."""
    origin_z: Entry[float | None, Number | None] = Entry()
    """z of that origin in the track (m); default: rail.origin_z."""
    lateral_displacement: Entry[float | None, Number | None] = Entry()
    """irregularity: displacement to the left from its place in the track (m); default: 0 mm."""
    vertical_displacement: Entry[float | None, Number | None] = Entry()
    """irregularity: displacement upwards, of a roller's profile on its axle (m); default: 0 mm."""
    roll_angle: Entry[float | None, Number | None] = Entry()
    """irregularity: turn about x through the origin of its profile (rad); default: 0 mrad."""
    lateral_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin to the left (m/s); default: 0 m/s."""
    vertical_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin upwards (m/s); default: 0 m/s."""
    roll_rate: Entry[float | None, Number | None] = Entry()
    """angular velocity about x (rad/s); default: 0 rad/s."""


class RightRailFields(TypedDict, total=False):
    """Fields of the section `right_rail`."""

    profile: Data | None
    """its profile; default: rail.profile; or a table of y (m), z (m)."""
    profile_z: RightRailProfileZ | None
    """direction of z in the file; default: rail.profile_z ("auto": found from the shape (what runs
    is level, sides and flange hang down), else that of the format; "up": upwards; "down":
    downwards)."""
    profile_y: RightRailProfileY | None
    """direction of y in the file; default: rail.profile_y ("auto": found from the flange of a
    wheel and the deeper side of a rail, else that of the format; "outwards": away from the middle
    of the track; "inwards": towards the middle of the track)."""
    profile_scale: Plain | None
    """factor of y and z in the file; default: rail.profile_scale."""
    profile_smoothing: Number | None
    """length over which it is smoothed (m); default: rail.profile_smoothing."""
    cant: Plain | None
    """its inclination towards the middle; default: rail.cant."""
    origin_y: Number | None
    """y of the origin of its profile in the track, outwards, in place of track.gauge (m); default:
    rail.origin_y."""
    origin_z: Number | None
    """z of that origin in the track (m); default: rail.origin_z."""
    lateral_displacement: Number | None
    """irregularity: displacement to the left from its place in the track (m); default: 0 mm."""
    vertical_displacement: Number | None
    """irregularity: displacement upwards, of a roller's profile on its axle (m); default: 0 mm."""
    roll_angle: Number | None
    """irregularity: turn about x through the origin of its profile (rad); default: 0 mrad."""
    lateral_velocity: Number | None
    """velocity of that origin to the left (m/s); default: 0 m/s."""
    vertical_velocity: Number | None
    """velocity of that origin upwards (m/s); default: 0 m/s."""
    roll_rate: Number | None
    """angular velocity about x (rad/s); default: 0 rad/s."""


class RightRail(Section, path="right_rail"):
    """What the right rail has of its own, and how it deviates from its place."""

    __slots__ = ()
    profile: Entry[str | None, Data | None] = Entry()
    """its profile; default: rail.profile; or a table of y (m), z (m)."""
    profile_z: Entry[RightRailProfileZ | None, RightRailProfileZ | None] = Entry()
    """direction of z in the file; default: rail.profile_z ("auto": found from the shape (what runs
    is level, sides and flange hang down), else that of the format; "up": upwards; "down":
    downwards)."""
    profile_y: Entry[RightRailProfileY | None, RightRailProfileY | None] = Entry()
    """direction of y in the file; default: rail.profile_y ("auto": found from the flange of a
    wheel and the deeper side of a rail, else that of the format; "outwards": away from the middle
    of the track; "inwards": towards the middle of the track)."""
    profile_scale: Entry[float | None, Plain | None] = Entry()
    """factor of y and z in the file; default: rail.profile_scale."""
    profile_smoothing: Entry[float | None, Number | None] = Entry()
    """length over which it is smoothed (m); default: rail.profile_smoothing."""
    cant: Entry[float | None, Plain | None] = Entry()
    """its inclination towards the middle; default: rail.cant."""
    origin_y: Entry[float | None, Number | None] = Entry()
    """y of the origin of its profile in the track, outwards, in place of track.gauge (m); default:
    rail.origin_y."""
    origin_z: Entry[float | None, Number | None] = Entry()
    """z of that origin in the track (m); default: rail.origin_z."""
    lateral_displacement: Entry[float | None, Number | None] = Entry()
    """irregularity: displacement to the left from its place in the track (m); default: 0 mm."""
    vertical_displacement: Entry[float | None, Number | None] = Entry()
    """irregularity: displacement upwards, of a roller's profile on its axle (m); default: 0 mm."""
    roll_angle: Entry[float | None, Number | None] = Entry()
    """irregularity: turn about x through the origin of its profile (rad); default: 0 mrad."""
    lateral_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin to the left (m/s); default: 0 m/s."""
    vertical_velocity: Entry[float | None, Number | None] = Entry()
    """velocity of that origin upwards (m/s); default: 0 m/s."""
    roll_rate: Entry[float | None, Number | None] = Entry()
    """angular velocity about x (rad/s); default: 0 rad/s."""


class ElasticityFields(TypedDict, total=False):
    """Fields of the section `elasticity`."""

    model: ElasticityModel | None
    """model of the deformation; "half-space" by default with normal.model = "wheel-rail"; default:
    elastic-layer ("elastic-layer": a bed of springs, each coupled with its neighbours; "half-
    space": Boussinesq and Cerruti: exact for bodies that are large compared with the patch;
    "viscoelastic": half-spaces of standard linear solids in steady rolling, which change the
    pressure of "hertz", "line" and "profile", too; "winkler": a bed of springs without coupling;
    "rigid": no deformation: the slip is prescribed)."""
    calibration: ElasticityCalibration | None
    """where the stiffnesses come from; default: "half-space", where no stiffness is given ("half-
    space": stiffnesses with which the springs answer like the half-space on the same patch in
    steady rolling; without coupling those of Kalker 1982)."""
    unlike_bodies: ElasticityUnlikeBodies | None
    """coupling of pressure and tractions where wheel and rail differ in their elastic constants;
    default: coupled ("coupled": pressure displaces the surfaces tangentially, and tractions change
    the pressure of "hertz", "line" and "profile"; "one-way": pressure displaces the surfaces
    tangentially, but does not change; "neglected": neither)."""
    bedding_x: Number | None
    """c, bedding stiffness for displacements along x (N/m^3)."""
    bedding_y: Number | None
    """the same for displacements along y (N/m^3); default: elasticity.bedding_x."""
    coupling_x: Number | None
    """g, coupling stiffness for displacements along x (N/m)."""
    coupling_x_across: Number | None
    """the same between neighbours across rolling, if different (N/m); default:
    elasticity.coupling_x."""
    coupling_y: Number | None
    """g, coupling stiffness for displacements along y (N/m); default: elasticity.coupling_x."""
    coupling_y_across: Number | None
    """the same between neighbours across rolling, if different (N/m); default:
    elasticity.coupling_y."""
    spring_x: Number | None
    """Δc, spring of one cell along x, in place of the stiffnesses per area (N/m)."""
    spring_y: Number | None
    """the same along y (N/m); default: elasticity.spring_x."""
    spring_coupling_x: Number | None
    """Δc_k, spring between neighbouring cells for displacements along x (N/m)."""
    spring_coupling_y: Number | None
    """the same for displacements along y (N/m); default: elasticity.spring_coupling_x."""
    margin: Number | None
    """width of the surroundings of the patch on each side (m); default: eight decay lengths
    √(g/c)."""


class Elasticity(Section, path="elasticity"):
    """How the bodies deform under tangential traction."""

    __slots__ = ()
    model: Entry[ElasticityModel, ElasticityModel | None] = Entry()
    """model of the deformation; "half-space" by default with normal.model = "wheel-rail"; default:
    elastic-layer ("elastic-layer": a bed of springs, each coupled with its neighbours; "half-
    space": Boussinesq and Cerruti: exact for bodies that are large compared with the patch;
    "viscoelastic": half-spaces of standard linear solids in steady rolling, which change the
    pressure of "hertz", "line" and "profile", too; "winkler": a bed of springs without coupling;
    "rigid": no deformation: the slip is prescribed)."""
    calibration: Entry[ElasticityCalibration | None, ElasticityCalibration | None] = Entry()
    """where the stiffnesses come from; default: "half-space", where no stiffness is given ("half-
    space": stiffnesses with which the springs answer like the half-space on the same patch in
    steady rolling; without coupling those of Kalker 1982)."""
    unlike_bodies: Entry[ElasticityUnlikeBodies, ElasticityUnlikeBodies | None] = Entry()
    """coupling of pressure and tractions where wheel and rail differ in their elastic constants;
    default: coupled ("coupled": pressure displaces the surfaces tangentially, and tractions change
    the pressure of "hertz", "line" and "profile"; "one-way": pressure displaces the surfaces
    tangentially, but does not change; "neglected": neither)."""
    bedding_x: Entry[float | None, Number | None] = Entry()
    """c, bedding stiffness for displacements along x (N/m^3)."""
    bedding_y: Entry[float | None, Number | None] = Entry()
    """the same for displacements along y (N/m^3); default: elasticity.bedding_x."""
    coupling_x: Entry[float | None, Number | None] = Entry()
    """g, coupling stiffness for displacements along x (N/m)."""
    coupling_x_across: Entry[float | None, Number | None] = Entry()
    """the same between neighbours across rolling, if different (N/m); default:
    elasticity.coupling_x."""
    coupling_y: Entry[float | None, Number | None] = Entry()
    """g, coupling stiffness for displacements along y (N/m); default: elasticity.coupling_x."""
    coupling_y_across: Entry[float | None, Number | None] = Entry()
    """the same between neighbours across rolling, if different (N/m); default:
    elasticity.coupling_y."""
    spring_x: Entry[float | None, Number | None] = Entry()
    """Δc, spring of one cell along x, in place of the stiffnesses per area (N/m)."""
    spring_y: Entry[float | None, Number | None] = Entry()
    """the same along y (N/m); default: elasticity.spring_x."""
    spring_coupling_x: Entry[float | None, Number | None] = Entry()
    """Δc_k, spring between neighbouring cells for displacements along x (N/m)."""
    spring_coupling_y: Entry[float | None, Number | None] = Entry()
    """the same for displacements along y (N/m); default: elasticity.spring_coupling_x."""
    margin: Entry[float | None, Number | None] = Entry()
    """width of the surroundings of the patch on each side (m); default: eight decay lengths
    √(g/c)."""


class LayerFields(TypedDict, total=False):
    """Fields of the section `layer`."""

    thickness: Number | None
    """h, thickness of the layer; 0: rigid until it yields (m)."""
    shear_modulus: Number | None
    """G, shear modulus of the layer, which is sheared by t h/G (Pa)."""
    yield_stress: Number | None
    """τ_c0, traction at which the layer yields; left out: it is elastic (Pa)."""
    hardening: Number | None
    """k_τ, growth of that with the plastic displacement; negative: it softens; left out: 0
    (N/m^3)."""


class Layer(Section, path="layer"):
    """A third body between the surfaces, such as oxides, leaves or sand; left out: none."""

    __slots__ = ()
    thickness: Entry[float | None, Number | None] = Entry()
    """h, thickness of the layer; 0: rigid until it yields (m)."""
    shear_modulus: Entry[float | None, Number | None] = Entry()
    """G, shear modulus of the layer, which is sheared by t h/G (Pa)."""
    yield_stress: Entry[float | None, Number | None] = Entry()
    """τ_c0, traction at which the layer yields; left out: it is elastic (Pa)."""
    hardening: Entry[float | None, Number | None] = Entry()
    """k_τ, growth of that with the plastic displacement; negative: it softens; left out: 0
    (N/m^3)."""


class ContactLawFields(TypedDict, total=False):
    """Fields of the section `contact_law`."""

    model: ContactLawModel | None
    """measure of sliding; default: incremental ("incremental": valid for any path of sliding;
    "total-displacement": Neuhaus and Sextro 2014, for sliding in one direction; "coulomb": no
    sliding at all up to μ pₙ, the limit k_c → ∞)."""
    stiffness: Number | None
    """k_c, rate at which traction approaches the friction limit (1/m); default: 5e6 1/m where
    there is no roughness."""
    roughness: Heights | RoughnessFields | Roughness | Preset[RoughnessFields] | None
    """Roughness from which k_c follows, in place of stiffness: heights, a spectrum or files."""


class ContactLaw(Section, path="contact_law"):
    """How traction grows with the sliding of rough surfaces."""

    __slots__ = ()
    model: Entry[ContactLawModel, ContactLawModel | None] = Entry()
    """measure of sliding; default: incremental ("incremental": valid for any path of sliding;
    "total-displacement": Neuhaus and Sextro 2014, for sliding in one direction; "coulomb": no
    sliding at all up to μ pₙ, the limit k_c → ∞)."""
    stiffness: Entry[float | None, Number | None] = Entry()
    """k_c, rate at which traction approaches the friction limit (1/m); default: 5e6 1/m where
    there is no roughness."""
    roughness: Entry[
        Roughness, Heights | RoughnessFields | Roughness | Preset[RoughnessFields] | None
    ] = Entry()
    """Roughness from which k_c follows, in place of stiffness: heights, a spectrum or files."""


class RoughnessFields(TypedDict, total=False):
    """Fields of the section `contact_law.roughness`."""

    rms_height: Number | None
    """h_rms of both surfaces together (m)."""
    rms_height_wheel: Number | None
    """h_rms of the wheel (m)."""
    rms_height_rail: Number | None
    """h_rms of the rail (m)."""
    slope_factor: Plain | None
    """γ of the closed form k_c = 2(1 − ν)/(μ0 (2 − ν) γ h_rms); default: 0.45."""
    rms_slope: Plain | None
    """h'_rms, in place of h_rms; with the wavelengths."""
    longest_wavelength: Number | None
    """a self-affine surface for the micro model, its longest wave (m)."""
    roll_off_wavelength: Number | None
    """longer waves have a constant spectrum (m); default:
    contact_law.roughness.longest_wavelength."""
    shortest_wavelength: Number | None
    """its shortest wave (m)."""
    hurst: Plain | None
    """H, its Hurst exponent; default: 0.8."""
    file: Surface | None
    """a measured surface, profile or spectrum for the micro model: .csv, .npy, .x3p or .xyz; or a
    table of x (m), y (m), height (m) or wavelength (m), level (dB)."""
    second_file: Surface | None
    """the surface of the other body, on the same lattice; or a table of x (m), y (m), height (m)
    or wavelength (m), level (dB)."""
    unit: str | None
    """unit of heights in .npy files, of all lengths in .xyz files."""
    spacing: Number | None
    """spacing of the points of an .npy file, or of heights alone (m)."""
    form: ContactLawRoughnessForm | None
    """form removed from the file's heights; default: "plane" ("plane": a tilted plane; "cylinder":
    a circular cylinder in any direction; "sphere": a sphere; "none": nothing)."""
    cutoff_wavelength: Number | None
    """λc: longer waves are removed from the file's heights (Gaussian filter, ISO 16610) (m)."""
    fill_holes: Flag | None
    """whether points without a height are filled smoothly; default: false."""
    square_cells: Flag | None
    """whether cells that are not square are resampled; default: false."""
    cells: Count | None
    """cells of the micro model along x; default: as measured; suitable for a self-affine
    surface."""
    seed: Count | None
    """of the random phases of a self-affine surface or one from a profile; default: 1."""
    hardness: Number | None
    """largest pressure in the micro model: the hardness of the softer body (Pa); default: none,
    elastic bodies."""
    pressures: Series | None
    """mean pressures to which k_c is fitted (Pa); default: three that divide the load of the
    patch."""


class Roughness(Section, path="contact_law.roughness"):
    """Roughness from which k_c follows, in place of stiffness: heights, a spectrum or files."""

    __slots__ = ()
    rms_height: Entry[float | None, Number | None] = Entry()
    """h_rms of both surfaces together (m)."""
    rms_height_wheel: Entry[float | None, Number | None] = Entry()
    """h_rms of the wheel (m)."""
    rms_height_rail: Entry[float | None, Number | None] = Entry()
    """h_rms of the rail (m)."""
    slope_factor: Entry[float | None, Plain | None] = Entry()
    """γ of the closed form k_c = 2(1 − ν)/(μ0 (2 − ν) γ h_rms); default: 0.45."""
    rms_slope: Entry[float | None, Plain | None] = Entry()
    """h'_rms, in place of h_rms; with the wavelengths."""
    longest_wavelength: Entry[float | None, Number | None] = Entry()
    """a self-affine surface for the micro model, its longest wave (m)."""
    roll_off_wavelength: Entry[float | None, Number | None] = Entry()
    """longer waves have a constant spectrum (m); default:
    contact_law.roughness.longest_wavelength."""
    shortest_wavelength: Entry[float | None, Number | None] = Entry()
    """its shortest wave (m)."""
    hurst: Entry[float | None, Plain | None] = Entry()
    """H, its Hurst exponent; default: 0.8."""
    file: Entry[str | None, Surface | None] = Entry()
    """a measured surface, profile or spectrum for the micro model: .csv, .npy, .x3p or .xyz; or a
    table of x (m), y (m), height (m) or wavelength (m), level (dB)."""
    second_file: Entry[str | None, Surface | None] = Entry()
    """the surface of the other body, on the same lattice; or a table of x (m), y (m), height (m)
    or wavelength (m), level (dB)."""
    unit: Entry[str | None, str | None] = Entry()
    """unit of heights in .npy files, of all lengths in .xyz files."""
    spacing: Entry[float | None, Number | None] = Entry()
    """spacing of the points of an .npy file, or of heights alone (m)."""
    form: Entry[ContactLawRoughnessForm | None, ContactLawRoughnessForm | None] = Entry()
    """form removed from the file's heights; default: "plane" ("plane": a tilted plane; "cylinder":
    a circular cylinder in any direction; "sphere": a sphere; "none": nothing)."""
    cutoff_wavelength: Entry[float | None, Number | None] = Entry()
    """λc: longer waves are removed from the file's heights (Gaussian filter, ISO 16610) (m)."""
    fill_holes: Entry[bool | None, Flag | None] = Entry()
    """whether points without a height are filled smoothly; default: false."""
    square_cells: Entry[bool | None, Flag | None] = Entry()
    """whether cells that are not square are resampled; default: false."""
    cells: Entry[int | None, Count | None] = Entry()
    """cells of the micro model along x; default: as measured; suitable for a self-affine
    surface."""
    seed: Entry[int | None, Count | None] = Entry()
    """of the random phases of a self-affine surface or one from a profile; default: 1."""
    hardness: Entry[float | None, Number | None] = Entry()
    """largest pressure in the micro model: the hardness of the softer body (Pa); default: none,
    elastic bodies."""
    pressures: Entry[list[float] | None, Series | None] = Entry()
    """mean pressures to which k_c is fitted (Pa); default: three that divide the load of the
    patch."""


class FrictionFields(TypedDict, total=False):
    """Fields of the section `friction`."""

    model: FrictionModel | None
    """law of friction; default: temperature-linear ("temperature-linear": μ = μ0 (1 − T/T_E), at
    least minimum_coefficient; "constant": μ = μ0; "temperature-piecewise-linear": μ = μ0 up to T =
    0, linear to μ_hot at T = ΔT, μ_hot beyond; "exponential": μ = μ_kin + μ1 2^(−s/s1) + μ2
    2^(−s/s2), μ1 = μ0 − μ_kin − μ2; "rational": μ = μ_kin + μ1/(1 + s/s1) + μ2/(1 + (s/s2)²), μ1 =
    μ0 − μ_kin − μ2; "linear-in-speed": μ = μ_kin + μ1 max(0, 1 − s/2s1) + μ2 max(0, 1 − s/2s2), μ1
    = μ0 − μ_kin − μ2; "polach": μ = μ0 ((1 − A) e^(−B s) + A), Polach 2005)."""
    coefficient: Plain | None
    """μ0, without slip, at the reference temperature, at y = 0; default: 0.4."""
    temperature_at_zero_friction: Number | None
    """T_E, a difference (K); default: 700 K."""
    reference_temperature: Number | None
    """T is counted from it (degC); default: rail.bulk_temperature."""
    minimum_coefficient: Plain | None
    """floor of μ, before speed_model and the variation over y apply; default: 0.0."""
    hot_coefficient: Plain | None
    """μ_hot; above μ0 where friction rises."""
    temperature_range: Number | None
    """ΔT over which μ falls from μ0 to μ_hot, a difference (K)."""
    speed_model: FrictionSpeedModel | None
    """law of the slip speed: μ is that of model times the fall μ/μ0 of this one; default: none
    ("none": friction does not depend on the slip speed; "exponential": μ = μ_kin + μ1 2^(−s/s1) +
    μ2 2^(−s/s2), μ1 = μ0 − μ_kin − μ2; "rational": μ = μ_kin + μ1/(1 + s/s1) + μ2/(1 + (s/s2)²),
    μ1 = μ0 − μ_kin − μ2; "linear-in-speed": μ = μ_kin + μ1 max(0, 1 − s/2s1) + μ2 max(0, 1 −
    s/2s2), μ1 = μ0 − μ_kin − μ2; "polach": μ = μ0 ((1 − A) e^(−B s) + A), Polach 2005)."""
    kinetic_coefficient: Plain | None
    """μ_kin, limit at large slip speeds, at most μ0."""
    half_speed: Number | None
    """s1, slip speed at which the term with μ1 has halved (m/s)."""
    second_coefficient: Plain | None
    """μ2, size of a second term, which needs second_half_speed."""
    second_half_speed: Number | None
    """s2, slip speed at which the second term has halved (m/s)."""
    limit_ratio: Plain | None
    """A, μ(∞)/μ0."""
    decay: Number | None
    """B, rate of the fall with the slip speed (s/m)."""
    memory_distance: Number | None
    """d_c, sliding distance over which friction approaches its law; default: instantly (m)."""
    memory_speed: Number | None
    """s0, smallest slip speed that counts for the memory; default: 0 (m/s)."""
    variation_y: Series | None
    """positions across the patch, ascending, at which variation_factor is given (m)."""
    variation_inclination: Series | None
    """inclinations of the surface of the rail's profile, ascending, in place of positions:
    negative on the gauge face, positive where the surface falls outwards (rad)."""
    variation_factor: Series | None
    """factors on μ, 1 at y = 0 or inclination 0; linear in between, constant outside."""
    variation_file: Data | None
    """CSV with the header `y [mm],factor`, in place of the arrays; or a table of y (m), factor
    (1)."""


class Friction(Section, path="friction"):
    """Coefficient of friction. T is counted from the reference temperature, s is the slip
    speed."""

    __slots__ = ()
    model: Entry[FrictionModel, FrictionModel | None] = Entry()
    """law of friction; default: temperature-linear ("temperature-linear": μ = μ0 (1 − T/T_E), at
    least minimum_coefficient; "constant": μ = μ0; "temperature-piecewise-linear": μ = μ0 up to T =
    0, linear to μ_hot at T = ΔT, μ_hot beyond; "exponential": μ = μ_kin + μ1 2^(−s/s1) + μ2
    2^(−s/s2), μ1 = μ0 − μ_kin − μ2; "rational": μ = μ_kin + μ1/(1 + s/s1) + μ2/(1 + (s/s2)²), μ1 =
    μ0 − μ_kin − μ2; "linear-in-speed": μ = μ_kin + μ1 max(0, 1 − s/2s1) + μ2 max(0, 1 − s/2s2), μ1
    = μ0 − μ_kin − μ2; "polach": μ = μ0 ((1 − A) e^(−B s) + A), Polach 2005)."""
    coefficient: Entry[float, Plain | None] = Entry()
    """μ0, without slip, at the reference temperature, at y = 0; default: 0.4."""
    temperature_at_zero_friction: Entry[float, Number | None] = Entry()
    """T_E, a difference (K); default: 700 K."""
    reference_temperature: Entry[float | None, Number | None] = Entry()
    """T is counted from it (degC); default: rail.bulk_temperature."""
    minimum_coefficient: Entry[float, Plain | None] = Entry()
    """floor of μ, before speed_model and the variation over y apply; default: 0.0."""
    hot_coefficient: Entry[float | None, Plain | None] = Entry()
    """μ_hot; above μ0 where friction rises."""
    temperature_range: Entry[float | None, Number | None] = Entry()
    """ΔT over which μ falls from μ0 to μ_hot, a difference (K)."""
    speed_model: Entry[FrictionSpeedModel, FrictionSpeedModel | None] = Entry()
    """law of the slip speed: μ is that of model times the fall μ/μ0 of this one; default: none
    ("none": friction does not depend on the slip speed; "exponential": μ = μ_kin + μ1 2^(−s/s1) +
    μ2 2^(−s/s2), μ1 = μ0 − μ_kin − μ2; "rational": μ = μ_kin + μ1/(1 + s/s1) + μ2/(1 + (s/s2)²),
    μ1 = μ0 − μ_kin − μ2; "linear-in-speed": μ = μ_kin + μ1 max(0, 1 − s/2s1) + μ2 max(0, 1 −
    s/2s2), μ1 = μ0 − μ_kin − μ2; "polach": μ = μ0 ((1 − A) e^(−B s) + A), Polach 2005)."""
    kinetic_coefficient: Entry[float | None, Plain | None] = Entry()
    """μ_kin, limit at large slip speeds, at most μ0."""
    half_speed: Entry[float | None, Number | None] = Entry()
    """s1, slip speed at which the term with μ1 has halved (m/s)."""
    second_coefficient: Entry[float | None, Plain | None] = Entry()
    """μ2, size of a second term, which needs second_half_speed."""
    second_half_speed: Entry[float | None, Number | None] = Entry()
    """s2, slip speed at which the second term has halved (m/s)."""
    limit_ratio: Entry[float | None, Plain | None] = Entry()
    """A, μ(∞)/μ0."""
    decay: Entry[float | None, Number | None] = Entry()
    """B, rate of the fall with the slip speed (s/m)."""
    memory_distance: Entry[float | None, Number | None] = Entry()
    """d_c, sliding distance over which friction approaches its law; default: instantly (m)."""
    memory_speed: Entry[float | None, Number | None] = Entry()
    """s0, smallest slip speed that counts for the memory; default: 0 (m/s)."""
    variation_y: Entry[list[float] | None, Series | None] = Entry()
    """positions across the patch, ascending, at which variation_factor is given (m)."""
    variation_inclination: Entry[list[float] | None, Series | None] = Entry()
    """inclinations of the surface of the rail's profile, ascending, in place of positions:
    negative on the gauge face, positive where the surface falls outwards (rad)."""
    variation_factor: Entry[list[float] | None, Series | None] = Entry()
    """factors on μ, 1 at y = 0 or inclination 0; linear in between, constant outside."""
    variation_file: Entry[str | None, Data | None] = Entry()
    """CSV with the header `y [mm],factor`, in place of the arrays; or a table of y (m), factor
    (1)."""


class HeatFields(TypedDict, total=False):
    """Fields of the section `heat`."""

    model: HeatModel | None
    """model of the surface temperature; default: duhamel ("duhamel": each cell cools after it was
    heated; "constant-source": Neuhaus and Sextro 2014: never cools; "none": no heating)."""
    partition: Plain | HeatPartition | None
    """share of the wheel, or "velocity"; default: velocity ("velocity": from speeds and
    effusivities of both bodies)."""


class Heat(Section, path="heat"):
    """Frictional heating of both surfaces."""

    __slots__ = ()
    model: Entry[HeatModel, HeatModel | None] = Entry()
    """model of the surface temperature; default: duhamel ("duhamel": each cell cools after it was
    heated; "constant-source": Neuhaus and Sextro 2014: never cools; "none": no heating)."""
    partition: Entry[float | HeatPartition, Plain | HeatPartition | None] = Entry()
    """share of the wheel, or "velocity"; default: velocity ("velocity": from speeds and
    effusivities of both bodies)."""


class CoolingFields(TypedDict, total=False):
    """Fields of the section `cooling`."""

    film_coefficient: Number | None
    """h, heat transfer coefficient between the wheel and the air (W/(m^2 K))."""
    area: Number | None
    """A, surface of the wheel that the air cools (m^2)."""
    air_temperature: Number | None
    """temperature of the air (degC); default: rail.bulk_temperature."""


class Cooling(Section, path="cooling"):
    """What cools the wheel in the long run, for `schlupf bulk`."""

    __slots__ = ()
    film_coefficient: Entry[float | None, Number | None] = Entry()
    """h, heat transfer coefficient between the wheel and the air (W/(m^2 K))."""
    area: Entry[float | None, Number | None] = Entry()
    """A, surface of the wheel that the air cools (m^2)."""
    air_temperature: Entry[float | None, Number | None] = Entry()
    """temperature of the air (degC); default: rail.bulk_temperature."""


class SubsurfaceFields(TypedDict, total=False):
    """Fields of the section `subsurface`."""

    body: SubsurfaceBody | None
    """in which body; default: rail ("rail": the rail; "wheel": the wheel)."""
    depth: Number | None
    """depth of the deepest layer (m); default: twice the larger semi-axis."""
    layers: Count | None
    """number of layers, evenly spaced from the surface on; default: 41."""
    margin: Number | None
    """surroundings of the patch on each side (m); default: half the size of the patch each way."""


class Subsurface(Section, path="subsurface"):
    """Where to compute stresses below the surface, for `schlupf subsurface`."""

    __slots__ = ()
    body: Entry[SubsurfaceBody, SubsurfaceBody | None] = Entry()
    """in which body; default: rail ("rail": the rail; "wheel": the wheel)."""
    depth: Entry[float | None, Number | None] = Entry()
    """depth of the deepest layer (m); default: twice the larger semi-axis."""
    layers: Entry[int, Count | None] = Entry()
    """number of layers, evenly spaced from the surface on; default: 41."""
    margin: Entry[float | None, Number | None] = Entry()
    """surroundings of the patch on each side (m); default: half the size of the patch each way."""


class DamageFields(TypedDict, total=False):
    """Fields of the section `damage`."""

    shear_yield_stress: Number | None
    """k, yield stress in pure shear, for the fatigue index (Ekberg, Kabo and Andersson 2002) (Pa);
    default: 300 MPa."""
    hardness: Number | None
    """H of the softer body, for Archard's law of wear; that of rail steel R260 (Pa); default: 2.7
    GPa."""
    wear_coefficient_mild: Plain | None
    """k of Archard's law for mild wear (Jendel 2002); default: 5e-4."""
    wear_coefficient_severe: Plain | None
    """the same for slip speeds between 0.2 and 0.7 m/s; default: 35e-4."""
    wear_coefficient_catastrophic: Plain | None
    """the same for pressures above 0.8 H; default: 350e-4."""
    wear_map: Data | None
    """CSV with the columns slip_speed, pressure_ratio (p/H) and coefficient, in place of them; or
    a table of slip_speed (m/s), pressure_ratio (1), coefficient (1)."""
    wear_rate_mild: Number | None
    """mass worn per energy, up to 10.4 N/mm^2 (Braghin, Lewis, Dwyer-Joyce and Bruni 2006) (kg/J);
    default: 5.3 ug/J."""
    wear_rate_catastrophic: Number | None
    """the same beyond 77.2 N/mm^2 (kg/J); default: 61.9 ug/J."""
    crack_t_gamma: Series | None
    """Tγ, ascending, at which crack_damage is given; default: Burstow (2004) (N)."""
    crack_damage: Series | None
    """reciprocal of the number of passages until there is a crack; linear in between and
    beyond."""
    melting_temperature: Number | None
    """from which on a surface melts; solidus of iron with 0.75 % of carbon (degC); default: 1390
    degC."""


class Damage(Section, path="damage"):
    """What turns rolling into fatigue and wear, for `schlupf wear` and `schlupf damage`."""

    __slots__ = ()
    shear_yield_stress: Entry[float, Number | None] = Entry()
    """k, yield stress in pure shear, for the fatigue index (Ekberg, Kabo and Andersson 2002) (Pa);
    default: 300 MPa."""
    hardness: Entry[float, Number | None] = Entry()
    """H of the softer body, for Archard's law of wear; that of rail steel R260 (Pa); default: 2.7
    GPa."""
    wear_coefficient_mild: Entry[float | None, Plain | None] = Entry()
    """k of Archard's law for mild wear (Jendel 2002); default: 5e-4."""
    wear_coefficient_severe: Entry[float | None, Plain | None] = Entry()
    """the same for slip speeds between 0.2 and 0.7 m/s; default: 35e-4."""
    wear_coefficient_catastrophic: Entry[float | None, Plain | None] = Entry()
    """the same for pressures above 0.8 H; default: 350e-4."""
    wear_map: Entry[str | None, Data | None] = Entry()
    """CSV with the columns slip_speed, pressure_ratio (p/H) and coefficient, in place of them; or
    a table of slip_speed (m/s), pressure_ratio (1), coefficient (1)."""
    wear_rate_mild: Entry[float, Number | None] = Entry()
    """mass worn per energy, up to 10.4 N/mm^2 (Braghin, Lewis, Dwyer-Joyce and Bruni 2006) (kg/J);
    default: 5.3 ug/J."""
    wear_rate_catastrophic: Entry[float, Number | None] = Entry()
    """the same beyond 77.2 N/mm^2 (kg/J); default: 61.9 ug/J."""
    crack_t_gamma: Entry[list[float] | None, Series | None] = Entry()
    """Tγ, ascending, at which crack_damage is given; default: Burstow (2004) (N)."""
    crack_damage: Entry[list[float] | None, Series | None] = Entry()
    """reciprocal of the number of passages until there is a crack; linear in between and
    beyond."""
    melting_temperature: Entry[float, Number | None] = Entry()
    """from which on a surface melts; solidus of iron with 0.75 % of carbon (degC); default: 1390
    degC."""


class GridFields(TypedDict, total=False):
    """Fields of the section `grid`."""

    cells_x: Count | None
    """cells along rolling; default: 24."""
    cells_y: Count | None
    """cells across rolling; default: 24."""


class Grid(Section, path="grid"):
    """Cells across the contact patch."""

    __slots__ = ()
    cells_x: Entry[int, Count | None] = Entry()
    """cells along rolling; default: 24."""
    cells_y: Entry[int, Count | None] = Entry()
    """cells across rolling; default: 24."""


class SolverFields(TypedDict, total=False):
    """Fields of the section `solver`."""

    driver: SolverDriver | None
    """how the solution is found; default: "steady", and "marching" with a history ("steady": the
    steady state directly; "marching": step by step in time: to the steady state, or along a
    history)."""
    branch: SolverBranch | None
    """which steady state, where friction falls so steeply that there are several, or where two
    motions have the prescribed forces; default: low-slip ("low-slip": the state that is reached
    when the creepages grow from zero; "high-slip": the state that is reached when larger creepages
    fall)."""
    method: SolverMethod | None
    """what is solved: all equations, or a fast method; default: full ("full": the coupled
    equations; "kalker-linear": Kalker's linear theory: forces for small creepages; "shen-hedrick-
    elkins": Shen, Hedrick and Elkins 1983: forces; "polach": Polach 1999 and 2005: forces, with
    k_A and k_S; "table": a look-up table of the half-space with Coulomb's law: forces; "fastsim":
    Kalker 1982: bristles without coupling, with heat; "modified-fastsim": Spiryagin, Polach and
    Cole 2013: FASTSIM with a slope that falls with the creepage)."""
    table: File | None
    """a look-up table of `schlupf table`; default: the standard table, for ν = 0.28."""
    tolerance: Plain | None
    """largest relative residual; default: 1e-6."""
    max_iterations: Count | None
    """maximum number of Newton steps per equilibrium; default: 200."""
    max_steps: Count | None
    """maximum number of time steps to the steady state; default: 2000."""
    sensitivity: Flag | None
    """whether to compute the derivatives of the forces, with the steady driver; default: true."""
    extrapolate: Flag | None
    """whether to extrapolate the forces from this grid and one half as fine, with the steady
    driver; default: false."""
    slip_threshold: Plain | None
    """a cell slides where |t| ≥ this · μ p_n; default: 0.95."""
    polach_area_adhesion: Plain | None
    """k_A, reduction of the slope in the area of adhesion; default: 1.0."""
    polach_area_slip: Plain | None
    """k_S, reduction of the slope in the area of slip, at most k_A; default: 0.4."""


class Solver(SolverSection, path="solver"):
    """What is solved, and how."""

    __slots__ = ()
    driver: Entry[SolverDriver | None, SolverDriver | None] = Entry()
    """how the solution is found; default: "steady", and "marching" with a history ("steady": the
    steady state directly; "marching": step by step in time: to the steady state, or along a
    history)."""
    branch: Entry[SolverBranch, SolverBranch | None] = Entry()
    """which steady state, where friction falls so steeply that there are several, or where two
    motions have the prescribed forces; default: low-slip ("low-slip": the state that is reached
    when the creepages grow from zero; "high-slip": the state that is reached when larger creepages
    fall)."""
    method: Entry[SolverMethod, SolverMethod | None] = Entry()
    """what is solved: all equations, or a fast method; default: full ("full": the coupled
    equations; "kalker-linear": Kalker's linear theory: forces for small creepages; "shen-hedrick-
    elkins": Shen, Hedrick and Elkins 1983: forces; "polach": Polach 1999 and 2005: forces, with
    k_A and k_S; "table": a look-up table of the half-space with Coulomb's law: forces; "fastsim":
    Kalker 1982: bristles without coupling, with heat; "modified-fastsim": Spiryagin, Polach and
    Cole 2013: FASTSIM with a slope that falls with the creepage)."""
    table: Entry[str | None, File | None] = Entry()
    """a look-up table of `schlupf table`; default: the standard table, for ν = 0.28."""
    tolerance: Entry[float, Plain | None] = Entry()
    """largest relative residual; default: 1e-6."""
    max_iterations: Entry[int, Count | None] = Entry()
    """maximum number of Newton steps per equilibrium; default: 200."""
    max_steps: Entry[int, Count | None] = Entry()
    """maximum number of time steps to the steady state; default: 2000."""
    sensitivity: Entry[bool, Flag | None] = Entry()
    """whether to compute the derivatives of the forces, with the steady driver; default: true."""
    extrapolate: Entry[bool, Flag | None] = Entry()
    """whether to extrapolate the forces from this grid and one half as fine, with the steady
    driver; default: false."""
    slip_threshold: Entry[float, Plain | None] = Entry()
    """a cell slides where |t| ≥ this · μ p_n; default: 0.95."""
    polach_area_adhesion: Entry[float, Plain | None] = Entry()
    """k_A, reduction of the slope in the area of adhesion; default: 1.0."""
    polach_area_slip: Entry[float, Plain | None] = Entry()
    """k_S, reduction of the slope in the area of slip, at most k_A; default: 0.4."""


class FastsimFields(TypedDict, total=False):
    """Fields of the section `fastsim`."""

    flexibilities: FastsimFlexibilities | None
    """flexibilities L from Kalker's coefficients; default: three ("three": one each for
    longitudinal, lateral and spin creepage; "one": their mean, weighted with the creepages)."""
    bound: FastsimBound | None
    """what bounds the traction; default: parabolic ("parabolic": μ 2N/(πab) (1 − x²/a² − y²/b²);
    "elliptic": μ p_n: the pressure of Hertz, or of a table)."""
    initial_reduction: Plain | None
    """k0, reduction of the slope at vanishing creepage: k = k0 ((1 − α)/(1 + β ε) + α); default:
    1.0."""
    reduction_limit_ratio: Plain | None
    """α, fraction of k0 at large creepages; default: 0.025."""
    reduction_decay: Plain | None
    """β, rate at which the slope falls with the creepage; default: 0.85."""


class Fastsim(Section, path="fastsim"):
    """The bristles of FASTSIM, plain and modified."""

    __slots__ = ()
    flexibilities: Entry[FastsimFlexibilities, FastsimFlexibilities | None] = Entry()
    """flexibilities L from Kalker's coefficients; default: three ("three": one each for
    longitudinal, lateral and spin creepage; "one": their mean, weighted with the creepages)."""
    bound: Entry[FastsimBound, FastsimBound | None] = Entry()
    """what bounds the traction; default: parabolic ("parabolic": μ 2N/(πab) (1 − x²/a² − y²/b²);
    "elliptic": μ p_n: the pressure of Hertz, or of a table)."""
    initial_reduction: Entry[float, Plain | None] = Entry()
    """k0, reduction of the slope at vanishing creepage: k = k0 ((1 − α)/(1 + β ε) + α); default:
    1.0."""
    reduction_limit_ratio: Entry[float, Plain | None] = Entry()
    """α, fraction of k0 at large creepages; default: 0.025."""
    reduction_decay: Entry[float, Plain | None] = Entry()
    """β, rate at which the slope falls with the creepage; default: 0.85."""


class ElementFields(TypedDict, total=False):
    """Fields of the section `element`."""

    motion: ElementMotion | None
    """how its motion is given; default: velocities ("velocities": v_x, v_y, ω and spin rate: slip
    (v_x − ωR, v_y, ω_z), speed (v_x + ωR)/2; "creepages": ξ, η, φ and the speed)."""
    normal: ElementNormal | None
    """what presses the wheel on the rail; default: load ("load": the normal load; "approach": the
    approach of the bodies, of given radii)."""
    memory: Flag | None
    """whether the elastic shift is its state, so that a wheel at rest sticks; default: true."""
    contact_table: File | None
    """contacts of a wheel with two profiles, a table of `schlupf table CASE`."""
    standstill_speed: Number | None
    """v_s, speed below which slip is no longer divided by the rolling speed (m/s); default: 0.01
    m/s."""


class Element(Section, path="element"):
    """The force element for simulations: what it takes, and how it behaves at standstill."""

    __slots__ = ()
    motion: Entry[ElementMotion, ElementMotion | None] = Entry()
    """how its motion is given; default: velocities ("velocities": v_x, v_y, ω and spin rate: slip
    (v_x − ωR, v_y, ω_z), speed (v_x + ωR)/2; "creepages": ξ, η, φ and the speed)."""
    normal: Entry[ElementNormal, ElementNormal | None] = Entry()
    """what presses the wheel on the rail; default: load ("load": the normal load; "approach": the
    approach of the bodies, of given radii)."""
    memory: Entry[bool, Flag | None] = Entry()
    """whether the elastic shift is its state, so that a wheel at rest sticks; default: true."""
    contact_table: Entry[str | None, File | None] = Entry()
    """contacts of a wheel with two profiles, a table of `schlupf table CASE`."""
    standstill_speed: Entry[float, Number | None] = Entry()
    """v_s, speed below which slip is no longer divided by the rolling speed (m/s); default: 0.01
    m/s."""


class HistoryFields(TypedDict, total=False):
    """Fields of the section `history`."""

    time: Series | None
    """instants, ascending; the wheel is at rest between equal ones (s)."""
    start: HistoryStart | None
    """the state at the first instant; default: rest ("rest": no tangential tractions; "steady":
    steady rolling with the values of the first instant)."""
    creepage_x: Series | None
    """ξ at these instants; likewise the others."""
    creepage_y: Series | None
    """η."""
    spin: Series | None
    """φ (1/m)."""
    speed: Series | None
    """v0 (m/s)."""
    load: Series | None
    """N (N)."""
    force_x: Series | None
    """Fx on the wheel, in place of creepage_x and shifts_x (N)."""
    force_y: Series | None
    """Fy on the wheel, in place of creepage_y and shifts_y (N)."""
    moment_z: Series | None
    """Mz on the wheel, in place of spin and turns (N m)."""
    shift_x: Number | None
    """shift of the wheel over the rail along rolling, at rest, at the first instant; times may be
    left out then (m)."""
    shift_y: Number | None
    """the same across rolling (m)."""
    turn: Number | None
    """turn of the wheel over the rail about z, likewise (rad)."""
    shifts_x: Series | None
    """shifts along rolling, each on the way to its instant, which is the first one or equals the
    one before; without times all are at rest (m)."""
    shifts_y: Series | None
    """the same across rolling (m)."""
    turns: Series | None
    """turns about z, likewise (rad)."""
    lateral_position: Series | None
    """that of the wheelset; likewise the others (m)."""
    yaw_angle: Series | None
    """yaw angle (rad)."""
    roll_angle: Series | None
    """roll angle (rad)."""
    height: Series | None
    """height, in place of load (m)."""
    lateral_velocity: Series | None
    """lateral velocity (m/s)."""
    vertical_velocity: Series | None
    """vertical velocity (m/s)."""
    yaw_rate: Series | None
    """yaw rate (rad/s)."""
    roll_rate: Series | None
    """roll rate (rad/s)."""
    angular_velocity: Series | None
    """angular velocity of the wheel, in place of creepage_x (rad/s)."""
    shift_duration: Number | None
    """how long the motion of the wheelset acts between equal times, as a shift at rest (s);
    default: 0 s."""
    file: Data | None
    """CSV with a header such as `time [s],creepage_x,load [kN]`, in place of the arrays; or a
    table of time (s), shifts_x (m), shifts_y (m), turns (rad), creepage_x (1), creepage_y (1),
    spin (1/m), speed (m/s), load (N), force_x (N), force_y (N), moment_z (N m)."""


class History(Section, path="history"):
    """Transient rolling: values over time, linear in between, from arrays or from a CSV file; and
    shifts at rest before it, between equal times, or alone."""

    __slots__ = ()
    time: Entry[list[float] | None, Series | None] = Entry()
    """instants, ascending; the wheel is at rest between equal ones (s)."""
    start: Entry[HistoryStart, HistoryStart | None] = Entry()
    """the state at the first instant; default: rest ("rest": no tangential tractions; "steady":
    steady rolling with the values of the first instant)."""
    creepage_x: Entry[list[float] | None, Series | None] = Entry()
    """ξ at these instants; likewise the others."""
    creepage_y: Entry[list[float] | None, Series | None] = Entry()
    """η."""
    spin: Entry[list[float] | None, Series | None] = Entry()
    """φ (1/m)."""
    speed: Entry[list[float] | None, Series | None] = Entry()
    """v0 (m/s)."""
    load: Entry[list[float] | None, Series | None] = Entry()
    """N (N)."""
    force_x: Entry[list[float] | None, Series | None] = Entry()
    """Fx on the wheel, in place of creepage_x and shifts_x (N)."""
    force_y: Entry[list[float] | None, Series | None] = Entry()
    """Fy on the wheel, in place of creepage_y and shifts_y (N)."""
    moment_z: Entry[list[float] | None, Series | None] = Entry()
    """Mz on the wheel, in place of spin and turns (N m)."""
    shift_x: Entry[float | None, Number | None] = Entry()
    """shift of the wheel over the rail along rolling, at rest, at the first instant; times may be
    left out then (m)."""
    shift_y: Entry[float | None, Number | None] = Entry()
    """the same across rolling (m)."""
    turn: Entry[float | None, Number | None] = Entry()
    """turn of the wheel over the rail about z, likewise (rad)."""
    shifts_x: Entry[list[float] | None, Series | None] = Entry()
    """shifts along rolling, each on the way to its instant, which is the first one or equals the
    one before; without times all are at rest (m)."""
    shifts_y: Entry[list[float] | None, Series | None] = Entry()
    """the same across rolling (m)."""
    turns: Entry[list[float] | None, Series | None] = Entry()
    """turns about z, likewise (rad)."""
    lateral_position: Entry[list[float] | None, Series | None] = Entry()
    """that of the wheelset; likewise the others (m)."""
    yaw_angle: Entry[list[float] | None, Series | None] = Entry()
    """yaw angle (rad)."""
    roll_angle: Entry[list[float] | None, Series | None] = Entry()
    """roll angle (rad)."""
    height: Entry[list[float] | None, Series | None] = Entry()
    """height, in place of load (m)."""
    lateral_velocity: Entry[list[float] | None, Series | None] = Entry()
    """lateral velocity (m/s)."""
    vertical_velocity: Entry[list[float] | None, Series | None] = Entry()
    """vertical velocity (m/s)."""
    yaw_rate: Entry[list[float] | None, Series | None] = Entry()
    """yaw rate (rad/s)."""
    roll_rate: Entry[list[float] | None, Series | None] = Entry()
    """roll rate (rad/s)."""
    angular_velocity: Entry[list[float] | None, Series | None] = Entry()
    """angular velocity of the wheel, in place of creepage_x (rad/s)."""
    shift_duration: Entry[float, Number | None] = Entry()
    """how long the motion of the wheelset acts between equal times, as a shift at rest (s);
    default: 0 s."""
    file: Entry[str | None, Data | None] = Entry()
    """CSV with a header such as `time [s],creepage_x,load [kN]`, in place of the arrays; or a
    table of time (s), shifts_x (m), shifts_y (m), turns (rad), creepage_x (1), creepage_y (1),
    spin (1/m), speed (m/s), load (N), force_x (N), force_y (N), moment_z (N m)."""


class SectionFields(TypedDict, total=False):
    """Sections with their fields."""

    kinematics: KinematicsFields | Kinematics | Preset[KinematicsFields] | None
    """How the wheel moves over the rail. Braking has a positive creepage and a negative force."""
    wheel: WheelFields | Wheel | Preset[WheelFields] | None
    """The wheel: elastic and thermal constants, temperature, curvature radii."""
    rail: RailFields | Rail | Preset[RailFields] | None
    """The rail: the same fields as the wheel."""
    normal: NormalFields | Normal | Preset[NormalFields] | None
    """Where the normal pressure comes from."""
    track: TrackFields | Track | Preset[TrackFields] | None
    """Where the profiles are, if the normal contact is that of two profiles."""
    wheelset: WheelsetFields | Wheelset | Preset[WheelsetFields] | None
    """Position and motion of the wheelset in the track (x forwards, y to the left, z up), if the
    normal contact is that of two profiles; the wheel turns at kinematics.angular_velocity."""
    left_wheel: LeftWheelFields | LeftWheel | Preset[LeftWheelFields] | None
    """What the left wheel has of its own, and how it deviates from its place."""
    right_wheel: RightWheelFields | RightWheel | Preset[RightWheelFields] | None
    """What the right wheel has of its own, and how it deviates from its place."""
    left_rail: LeftRailFields | LeftRail | Preset[LeftRailFields] | None
    """What the left rail has of its own, and how it deviates from its place."""
    right_rail: RightRailFields | RightRail | Preset[RightRailFields] | None
    """What the right rail has of its own, and how it deviates from its place."""
    elasticity: ElasticityFields | Elasticity | Preset[ElasticityFields] | None
    """How the bodies deform under tangential traction."""
    layer: LayerFields | Layer | Preset[LayerFields] | None
    """A third body between the surfaces, such as oxides, leaves or sand; left out: none."""
    contact_law: ContactLawFields | ContactLaw | Preset[ContactLawFields] | None
    """How traction grows with the sliding of rough surfaces."""
    friction: FrictionFields | Friction | Preset[FrictionFields] | None
    """Coefficient of friction. T is counted from the reference temperature, s is the slip
    speed."""
    heat: HeatFields | Heat | Preset[HeatFields] | None
    """Frictional heating of both surfaces."""
    cooling: CoolingFields | Cooling | Preset[CoolingFields] | None
    """What cools the wheel in the long run, for `schlupf bulk`."""
    subsurface: SubsurfaceFields | Subsurface | Preset[SubsurfaceFields] | None
    """Where to compute stresses below the surface, for `schlupf subsurface`."""
    damage: DamageFields | Damage | Preset[DamageFields] | None
    """What turns rolling into fatigue and wear, for `schlupf wear` and `schlupf damage`."""
    grid: GridFields | Grid | Preset[GridFields] | None
    """Cells across the contact patch."""
    solver: SolverFields | Solver | Preset[SolverFields] | None
    """What is solved, and how."""
    fastsim: FastsimFields | Fastsim | Preset[FastsimFields] | None
    """The bristles of FASTSIM, plain and modified."""
    element: ElementFields | Element | Preset[ElementFields] | None
    """The force element for simulations: what it takes, and how it behaves at standstill."""
    history: HistoryFields | History | Preset[HistoryFields] | None
    """Transient rolling: values over time, linear in between, from arrays or from a CSV file; and
    shifts at rest before it, between equal times, or alone."""


class CaseFields(SectionFields, total=False):
    """Title and sections."""

    title: str | None
    """title of summary and figures; default: wheel on rail."""


class Sections:
    """The title of a case, and its sections."""

    __slots__ = ()
    title: Entry[str, str | None] = Entry()
    """title of summary and figures; default: wheel on rail."""
    kinematics: Entry[
        Kinematics, KinematicsFields | Kinematics | Preset[KinematicsFields] | None
    ] = Entry()
    """How the wheel moves over the rail. Braking has a positive creepage and a negative force."""
    wheel: Entry[Wheel, WheelFields | Wheel | Preset[WheelFields] | None] = Entry()
    """The wheel: elastic and thermal constants, temperature, curvature radii."""
    rail: Entry[Rail, RailFields | Rail | Preset[RailFields] | None] = Entry()
    """The rail: the same fields as the wheel."""
    normal: Entry[Normal, NormalFields | Normal | Preset[NormalFields] | None] = Entry()
    """Where the normal pressure comes from."""
    track: Entry[Track, TrackFields | Track | Preset[TrackFields] | None] = Entry()
    """Where the profiles are, if the normal contact is that of two profiles."""
    left_wheel: Entry[LeftWheel, LeftWheelFields | LeftWheel | Preset[LeftWheelFields] | None] = (
        Entry()
    )
    """What the left wheel has of its own, and how it deviates from its place."""
    right_wheel: Entry[
        RightWheel, RightWheelFields | RightWheel | Preset[RightWheelFields] | None
    ] = Entry()
    """What the right wheel has of its own, and how it deviates from its place."""
    left_rail: Entry[LeftRail, LeftRailFields | LeftRail | Preset[LeftRailFields] | None] = Entry()
    """What the left rail has of its own, and how it deviates from its place."""
    right_rail: Entry[RightRail, RightRailFields | RightRail | Preset[RightRailFields] | None] = (
        Entry()
    )
    """What the right rail has of its own, and how it deviates from its place."""
    elasticity: Entry[
        Elasticity, ElasticityFields | Elasticity | Preset[ElasticityFields] | None
    ] = Entry()
    """How the bodies deform under tangential traction."""
    layer: Entry[Layer, LayerFields | Layer | Preset[LayerFields] | None] = Entry()
    """A third body between the surfaces, such as oxides, leaves or sand; left out: none."""
    contact_law: Entry[
        ContactLaw, ContactLawFields | ContactLaw | Preset[ContactLawFields] | None
    ] = Entry()
    """How traction grows with the sliding of rough surfaces."""
    friction: Entry[Friction, FrictionFields | Friction | Preset[FrictionFields] | None] = Entry()
    """Coefficient of friction. T is counted from the reference temperature, s is the slip
    speed."""
    heat: Entry[Heat, HeatFields | Heat | Preset[HeatFields] | None] = Entry()
    """Frictional heating of both surfaces."""
    cooling: Entry[Cooling, CoolingFields | Cooling | Preset[CoolingFields] | None] = Entry()
    """What cools the wheel in the long run, for `schlupf bulk`."""
    damage: Entry[Damage, DamageFields | Damage | Preset[DamageFields] | None] = Entry()
    """What turns rolling into fatigue and wear, for `schlupf wear` and `schlupf damage`."""
    grid: Entry[Grid, GridFields | Grid | Preset[GridFields] | None] = Entry()
    """Cells across the contact patch."""
    solver: Entry[Solver, SolverFields | Solver | Preset[SolverFields] | None] = Entry()
    """What is solved, and how."""
    fastsim: Entry[Fastsim, FastsimFields | Fastsim | Preset[FastsimFields] | None] = Entry()
    """The bristles of FASTSIM, plain and modified."""
    element: Entry[Element, ElementFields | Element | Preset[ElementFields] | None] = Entry()
    """The force element for simulations: what it takes, and how it behaves at standstill."""
    history: Entry[History, HistoryFields | History | Preset[HistoryFields] | None] = Entry()
    """Transient rolling: values over time, linear in between, from arrays or from a CSV file; and
    shifts at rest before it, between equal times, or alone."""


class Conditions(TypedDict, Generic[V], total=False):
    """Conditions of `schlupf.forces`, with numbers or arrays."""

    creepage_x: V
    """ξ, longitudinal creepage: positive when braking."""
    creepage_y: V
    """η, lateral creepage."""
    spin: V
    """φ, spin creepage."""
    speed: V
    """v0, speed of the vehicle, or of the circumference of a roller."""
    load: V
    """N, normal load; with "wheel-rail" the vertical force on the wheel."""
    kinematics__speed: V
    """v0, speed of the vehicle, or of the circumference of a roller."""
    kinematics__creepage_x: V
    """ξ, longitudinal creepage: positive when braking."""
    kinematics__angular_velocity: V
    """ω of the wheel, in place of creepage_x."""
    kinematics__wheel_radius: V
    """R, rolling radius that goes with angular_velocity or wheel_torque."""
    kinematics__creepage_y: V
    """η, lateral creepage."""
    kinematics__yaw_angle: V
    """α, slip angle, in place of creepage_y."""
    kinematics__spin: V
    """φ, spin creepage."""
    kinematics__force_x: V
    """Fx on the wheel, in place of creepage_x, which is found: negative when braking; of two
    profiles that of all contacts together."""
    kinematics__traction_coefficient: V
    """-Fx/N, in place of creepage_x: positive when braking; of two profiles over the vertical
    force."""
    kinematics__wheel_torque: V
    """T on the wheel about its axle, in place of creepage_x, with Fx = T/wheel_radius (of two
    profiles in balance with the tractions of all contacts): negative when braking."""
    kinematics__force_y: V
    """Fy on the wheel, in place of creepage_y and shifts_y."""
    kinematics__moment_z: V
    """Mz on the wheel, in place of spin and turns."""
    wheel__young_modulus: V
    """E, Young's modulus."""
    wheel__relaxed_modulus: V
    """E∞, Young's modulus after a long time, where young_modulus is the instantaneous one."""
    wheel__retardation_time: V
    """τ, retardation time: under constant stress the rest of the creep falls as exp(-t/τ)."""
    wheel__poisson_ratio: V
    """ν, Poisson's ratio."""
    wheel__conductivity: V
    """λ, thermal conductivity."""
    wheel__density: V
    """ρ, density."""
    wheel__specific_heat: V
    """c, specific heat."""
    wheel__bulk_temperature: V
    """temperature far from the contact."""
    wheel__radius_x: V
    """radius of curvature along rolling: "inf" where straight, negative where concave."""
    wheel__radius_y: V
    """radius of curvature across rolling."""
    wheel__profile_scale: V
    """factor of y and z in the file."""
    wheel__profile_smoothing: V
    """L: what is shorter along the profile is levelled out; 5 mm for a measured one."""
    wheel__flange_back_position: V
    """y of the flange back in the profile, with y outwards."""
    rail__young_modulus: V
    """E, Young's modulus."""
    rail__relaxed_modulus: V
    """E∞, Young's modulus after a long time, where young_modulus is the instantaneous one."""
    rail__retardation_time: V
    """τ, retardation time: under constant stress the rest of the creep falls as exp(-t/τ)."""
    rail__poisson_ratio: V
    """ν, Poisson's ratio."""
    rail__conductivity: V
    """λ, thermal conductivity."""
    rail__density: V
    """ρ, density."""
    rail__specific_heat: V
    """c, specific heat."""
    rail__bulk_temperature: V
    """temperature far from the contact."""
    rail__radius_x: V
    """radius of curvature along rolling: "inf" where straight, negative where concave."""
    rail__radius_y: V
    """radius of curvature across rolling."""
    rail__angular_velocity: V
    """of a roller of radius radius_x, in place of kinematics.speed."""
    rail__profile_scale: V
    """factor of y and z in the file."""
    rail__profile_smoothing: V
    """L: what is shorter along the profile is levelled out; 5 mm for a measured one."""
    rail__cant: V
    """inclination of the rail towards the middle, such as 0.025 for 1:40; 0 for a profile that is
    canted already."""
    rail__origin_y: V
    """y of the origin of the profile in the track, outwards, in place of track.gauge."""
    rail__origin_z: V
    """z of that origin in the track."""
    normal__load: V
    """N, normal load; with "wheel-rail" the vertical force on the wheel."""
    normal__approach: V
    """δ, approach of the bodies since they touch, in place of load, which is found."""
    normal__length: V
    """L, length of a line contact across rolling, on which the whole load acts; with "profile" for
    a file of x alone."""
    normal__semi_axis_x: V
    """a, semi-axis along rolling."""
    normal__semi_axis_y: V
    """b, semi-axis across rolling."""
    normal__peak_pressure: V
    """p0, largest pressure, in place of load."""
    normal__spacing_x: V
    """spacing of the columns of an .npy file."""
    normal__spacing_y: V
    """spacing of the rows of an .npy file."""
    normal__cells: V
    """cells across the contact each way, on which the pressure of profiles is found (64 with
    "wheel-rail")."""
    normal__join_distance: V
    """distance up to which neighbouring contacts share a plane."""
    normal__join_angle: V
    """difference of their angles up to which they do."""
    track__gauge: V
    """distance of the gauge faces of both rails."""
    track__gauge_depth: V
    """depth below the top of the rail down to which the gauge is measured."""
    track__curve_radius: V
    """radius of the curve: positive where the track turns to the left, negative to the right."""
    track__flange_back_distance: V
    """distance of the flange backs of the wheelset."""
    wheelset__track_position: V
    """place along the track, of a rail whose profile changes."""
    wheelset__pitch_angle: V
    """angle around the wheel that is below the axle, of one whose profile changes: it grows in
    rolling forwards."""
    wheelset__lateral_position: V
    """lateral position of the middle of the axle."""
    wheelset__yaw_angle: V
    """yaw angle about z."""
    wheelset__roll_angle: V
    """roll angle about x."""
    wheelset__height: V
    """height of the middle of the axle above the nominal radius over z = 0 of the track, in place
    of normal.load."""
    wheelset__lateral_velocity: V
    """lateral velocity of the middle of the axle."""
    wheelset__vertical_velocity: V
    """vertical velocity of the middle of the axle."""
    wheelset__yaw_rate: V
    """angular velocity about the vertical axis."""
    wheelset__roll_rate: V
    """angular velocity about the longitudinal axis."""
    left_wheel__profile_scale: V
    """factor of y and z in the file."""
    left_wheel__profile_smoothing: V
    """length over which it is smoothed."""
    left_wheel__radius_x: V
    """its nominal rolling radius; the height of the axle and creepage_x are those of
    wheel.radius_x."""
    left_wheel__flange_back_position: V
    """y of the flange back in its profile, with y outwards."""
    left_wheel__longitudinal_displacement: V
    """displacement of the profile's origin forwards from its place in the wheelset, along the axes
    of that."""
    left_wheel__lateral_displacement: V
    """displacement of that origin to the left."""
    left_wheel__vertical_displacement: V
    """displacement of that origin upwards."""
    left_wheel__roll_angle: V
    """turn of the wheel about x through that origin, relative to the wheelset."""
    left_wheel__yaw_angle: V
    """turn of the wheel about the z that has turned about x."""
    left_wheel__longitudinal_velocity: V
    """velocity of that origin forwards, relative to the wheelset and along its axes."""
    left_wheel__lateral_velocity: V
    """velocity of that origin to the left."""
    left_wheel__vertical_velocity: V
    """velocity of that origin upwards."""
    left_wheel__roll_rate: V
    """angular velocity about x relative to the wheelset; −ω yaw_angle if it turns about its own
    axis."""
    left_wheel__pitch_rate: V
    """angular velocity about y beyond that of the wheelset."""
    left_wheel__yaw_rate: V
    """angular velocity about z relative to the wheelset; ω roll_angle if it turns about its own
    axis."""
    right_wheel__profile_scale: V
    """factor of y and z in the file."""
    right_wheel__profile_smoothing: V
    """length over which it is smoothed."""
    right_wheel__radius_x: V
    """its nominal rolling radius; the height of the axle and creepage_x are those of
    wheel.radius_x."""
    right_wheel__flange_back_position: V
    """y of the flange back in its profile, with y outwards."""
    right_wheel__longitudinal_displacement: V
    """displacement of the profile's origin forwards from its place in the wheelset, along the axes
    of that."""
    right_wheel__lateral_displacement: V
    """displacement of that origin to the left."""
    right_wheel__vertical_displacement: V
    """displacement of that origin upwards."""
    right_wheel__roll_angle: V
    """turn of the wheel about x through that origin, relative to the wheelset."""
    right_wheel__yaw_angle: V
    """turn of the wheel about the z that has turned about x."""
    right_wheel__longitudinal_velocity: V
    """velocity of that origin forwards, relative to the wheelset and along its axes."""
    right_wheel__lateral_velocity: V
    """velocity of that origin to the left."""
    right_wheel__vertical_velocity: V
    """velocity of that origin upwards."""
    right_wheel__roll_rate: V
    """angular velocity about x relative to the wheelset; −ω yaw_angle if it turns about its own
    axis."""
    right_wheel__pitch_rate: V
    """angular velocity about y beyond that of the wheelset."""
    right_wheel__yaw_rate: V
    """angular velocity about z relative to the wheelset; ω roll_angle if it turns about its own
    axis."""
    left_rail__profile_scale: V
    """factor of y and z in the file."""
    left_rail__profile_smoothing: V
    """length over which it is smoothed."""
    left_rail__cant: V
    """its inclination towards the middle."""
    left_rail__origin_y: V
    """y of the origin of its profile in the track, outwards, in place of track.gauge."""
    left_rail__origin_z: V
    """z of that origin in the track."""
    left_rail__lateral_displacement: V
    """irregularity: displacement to the left from its place in the track."""
    left_rail__vertical_displacement: V
    """irregularity: displacement upwards, of a roller's profile on its axle."""
    left_rail__roll_angle: V
    """irregularity: turn about x through the origin of its profile."""
    left_rail__lateral_velocity: V
    """velocity of that origin to the left."""
    left_rail__vertical_velocity: V
    """velocity of that origin upwards."""
    left_rail__roll_rate: V
    """angular velocity about x."""
    right_rail__profile_scale: V
    """factor of y and z in the file."""
    right_rail__profile_smoothing: V
    """length over which it is smoothed."""
    right_rail__cant: V
    """its inclination towards the middle."""
    right_rail__origin_y: V
    """y of the origin of its profile in the track, outwards, in place of track.gauge."""
    right_rail__origin_z: V
    """z of that origin in the track."""
    right_rail__lateral_displacement: V
    """irregularity: displacement to the left from its place in the track."""
    right_rail__vertical_displacement: V
    """irregularity: displacement upwards, of a roller's profile on its axle."""
    right_rail__roll_angle: V
    """irregularity: turn about x through the origin of its profile."""
    right_rail__lateral_velocity: V
    """velocity of that origin to the left."""
    right_rail__vertical_velocity: V
    """velocity of that origin upwards."""
    right_rail__roll_rate: V
    """angular velocity about x."""
    elasticity__bedding_x: V
    """c, bedding stiffness for displacements along x."""
    elasticity__bedding_y: V
    """the same for displacements along y."""
    elasticity__coupling_x: V
    """g, coupling stiffness for displacements along x."""
    elasticity__coupling_x_across: V
    """the same between neighbours across rolling, if different."""
    elasticity__coupling_y: V
    """g, coupling stiffness for displacements along y."""
    elasticity__coupling_y_across: V
    """the same between neighbours across rolling, if different."""
    elasticity__spring_x: V
    """Δc, spring of one cell along x, in place of the stiffnesses per area."""
    elasticity__spring_y: V
    """the same along y."""
    elasticity__spring_coupling_x: V
    """Δc_k, spring between neighbouring cells for displacements along x."""
    elasticity__spring_coupling_y: V
    """the same for displacements along y."""
    elasticity__margin: V
    """width of the surroundings of the patch on each side."""
    layer__thickness: V
    """h, thickness of the layer; 0: rigid until it yields."""
    layer__shear_modulus: V
    """G, shear modulus of the layer, which is sheared by t h/G."""
    layer__yield_stress: V
    """τ_c0, traction at which the layer yields; left out: it is elastic."""
    layer__hardening: V
    """k_τ, growth of that with the plastic displacement; negative: it softens; left out: 0."""
    contact_law__stiffness: V
    """k_c, rate at which traction approaches the friction limit."""
    contact_law__roughness__rms_height: V
    """h_rms of both surfaces together."""
    contact_law__roughness__rms_height_wheel: V
    """h_rms of the wheel."""
    contact_law__roughness__rms_height_rail: V
    """h_rms of the rail."""
    contact_law__roughness__slope_factor: V
    """γ of the closed form k_c = 2(1 − ν)/(μ0 (2 − ν) γ h_rms)."""
    contact_law__roughness__rms_slope: V
    """h'_rms, in place of h_rms; with the wavelengths."""
    contact_law__roughness__longest_wavelength: V
    """a self-affine surface for the micro model, its longest wave."""
    contact_law__roughness__roll_off_wavelength: V
    """longer waves have a constant spectrum."""
    contact_law__roughness__shortest_wavelength: V
    """its shortest wave."""
    contact_law__roughness__hurst: V
    """H, its Hurst exponent."""
    contact_law__roughness__spacing: V
    """spacing of the points of an .npy file, or of heights alone."""
    contact_law__roughness__cutoff_wavelength: V
    """λc: longer waves are removed from the file's heights (Gaussian filter, ISO 16610)."""
    contact_law__roughness__cells: V
    """cells of the micro model along x."""
    contact_law__roughness__seed: V
    """of the random phases of a self-affine surface or one from a profile."""
    contact_law__roughness__hardness: V
    """largest pressure in the micro model: the hardness of the softer body."""
    friction__coefficient: V
    """μ0, without slip, at the reference temperature, at y = 0."""
    friction__temperature_at_zero_friction: V
    """T_E, a difference."""
    friction__reference_temperature: V
    """T is counted from it."""
    friction__minimum_coefficient: V
    """floor of μ, before speed_model and the variation over y apply."""
    friction__hot_coefficient: V
    """μ_hot; above μ0 where friction rises."""
    friction__temperature_range: V
    """ΔT over which μ falls from μ0 to μ_hot, a difference."""
    friction__kinetic_coefficient: V
    """μ_kin, limit at large slip speeds, at most μ0."""
    friction__half_speed: V
    """s1, slip speed at which the term with μ1 has halved."""
    friction__second_coefficient: V
    """μ2, size of a second term, which needs second_half_speed."""
    friction__second_half_speed: V
    """s2, slip speed at which the second term has halved."""
    friction__limit_ratio: V
    """A, μ(∞)/μ0."""
    friction__decay: V
    """B, rate of the fall with the slip speed."""
    friction__memory_distance: V
    """d_c, sliding distance over which friction approaches its law; default: instantly."""
    friction__memory_speed: V
    """s0, smallest slip speed that counts for the memory; default: 0."""
    heat__partition: V
    """share of the wheel, or "velocity"."""
    cooling__film_coefficient: V
    """h, heat transfer coefficient between the wheel and the air."""
    cooling__area: V
    """A, surface of the wheel that the air cools."""
    cooling__air_temperature: V
    """temperature of the air."""
    subsurface__depth: V
    """depth of the deepest layer."""
    subsurface__layers: V
    """number of layers, evenly spaced from the surface on."""
    subsurface__margin: V
    """surroundings of the patch on each side."""
    damage__shear_yield_stress: V
    """k, yield stress in pure shear, for the fatigue index (Ekberg, Kabo and Andersson 2002)."""
    damage__hardness: V
    """H of the softer body, for Archard's law of wear; that of rail steel R260."""
    damage__wear_coefficient_mild: V
    """k of Archard's law for mild wear (Jendel 2002)."""
    damage__wear_coefficient_severe: V
    """the same for slip speeds between 0.2 and 0.7 m/s."""
    damage__wear_coefficient_catastrophic: V
    """the same for pressures above 0.8 H."""
    damage__wear_rate_mild: V
    """mass worn per energy, up to 10.4 N/mm^2 (Braghin, Lewis, Dwyer-Joyce and Bruni 2006)."""
    damage__wear_rate_catastrophic: V
    """the same beyond 77.2 N/mm^2."""
    damage__melting_temperature: V
    """from which on a surface melts; solidus of iron with 0.75 % of carbon."""
    grid__cells_x: V
    """cells along rolling."""
    grid__cells_y: V
    """cells across rolling."""
    solver__tolerance: V
    """largest relative residual."""
    solver__max_iterations: V
    """maximum number of Newton steps per equilibrium."""
    solver__max_steps: V
    """maximum number of time steps to the steady state."""
    solver__slip_threshold: V
    """a cell slides where |t| ≥ this · μ p_n."""
    solver__polach_area_adhesion: V
    """k_A, reduction of the slope in the area of adhesion."""
    solver__polach_area_slip: V
    """k_S, reduction of the slope in the area of slip, at most k_A."""
    fastsim__initial_reduction: V
    """k0, reduction of the slope at vanishing creepage: k = k0 ((1 − α)/(1 + β ε) + α)."""
    fastsim__reduction_limit_ratio: V
    """α, fraction of k0 at large creepages."""
    fastsim__reduction_decay: V
    """β, rate at which the slope falls with the creepage."""
    element__standstill_speed: V
    """v_s, speed below which slip is no longer divided by the rolling speed."""
    history__shift_x: V
    """shift of the wheel over the rail along rolling, at rest, at the first instant; times may be
    left out then."""
    history__shift_y: V
    """the same across rolling."""
    history__turn: V
    """turn of the wheel over the rail about z, likewise."""
    history__shift_duration: V
    """how long the motion of the wheelset acts between equal times, as a shift at rest."""
