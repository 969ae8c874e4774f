//! `[grid]`, `[solver]` and `[fastsim]`.

use crate::fields::choice::{
    BoundChoice, BranchChoice, Choose, Driver, FlexibilitiesChoice, MethodChoice,
};
use crate::fields::field::Default::{Computed, Text};
use crate::fields::field::{Field, Kind};
use schlupf::problem::MAX_CELLS;
use schlupf::requirement::Requirement::{self, AboveUpTo, AtLeast, Between, Finite};

/// The choice that most of these fields belong to.
pub(super) const METHOD: &str = "solver.method";
/// The method that solves all equations.
pub(super) const FULL: &[&str] = &["full"];
/// The methods with cells, and so with heat.
pub(super) const CELLS: &[&str] = &["full", "fastsim", "modified-fastsim"];
const BRISTLES: &[&str] = &["fastsim", "modified-fastsim"];
const MODIFIED: &[&str] = &["modified-fastsim"];

const PART: Requirement = AboveUpTo(0.0, 1.0);

pub(super) const GRID: &[Field] = &[
    Field::new(
        "grid.cells_x",
        Kind::Count,
        Between(2.0, MAX_CELLS as f64),
        Text("24"),
        "cells along rolling",
    )
    .with(METHOD, CELLS),
    Field::new(
        "grid.cells_y",
        Kind::Count,
        Between(1.0, MAX_CELLS as f64),
        Text("24"),
        "cells across rolling",
    )
    .with(METHOD, CELLS),
];

pub(super) const FIELDS: &[Field] = &[
    Field::new(
        "solver.driver",
        Kind::Choice(Driver::CHOICES),
        Finite,
        Computed("\"steady\", and \"marching\" with a history"),
        "way to the solution",
    )
    .example("steady")
    .with(METHOD, FULL),
    Field::new(
        "solver.branch",
        Kind::Choice(BranchChoice::CHOICES),
        Finite,
        Text("low-slip"),
        "which steady state where friction falls so fast that there are several",
    )
    .with(METHOD, FULL),
    Field::new(
        "solver.method",
        Kind::Choice(MethodChoice::CHOICES),
        Finite,
        Text("full"),
        "what is solved: all equations, or a fast method",
    ),
    Field::new(
        "solver.tolerance",
        Kind::Number,
        Between(1e-13, 0.1),
        Text("1e-6"),
        "largest relative residual",
    )
    .with(METHOD, FULL),
    Field::new(
        "solver.max_iterations",
        Kind::Count,
        AtLeast(1.0),
        Text("200"),
        "most Newton steps for one equilibrium",
    )
    .with(METHOD, FULL),
    Field::new(
        "solver.max_steps",
        Kind::Count,
        AtLeast(1.0),
        Text("2000"),
        "most time steps on the way to the steady state",
    )
    .with(METHOD, FULL),
    Field::new(
        "solver.sensitivity",
        Kind::Flag,
        Finite,
        Text("true"),
        "whether to find the derivatives of the forces too, in the steady driver",
    )
    .with(METHOD, FULL),
    Field::new(
        "solver.slip_threshold",
        Kind::Number,
        AboveUpTo(0.0, 0.999),
        Text("0.95"),
        "a cell slides where |t| ≥ this · μ p_n",
    )
    .with(METHOD, CELLS),
    Field::new(
        "solver.polach_area_adhesion",
        Kind::Number,
        PART,
        Text("1.0"),
        "k_A, reduction of the slope in the area of adhesion",
    )
    .with(METHOD, &["polach"]),
    Field::new(
        "solver.polach_area_slip",
        Kind::Number,
        PART,
        Text("0.4"),
        "k_S, reduction of the slope in the area of slip, at most k_A",
    )
    .with(METHOD, &["polach"]),
];

pub(super) const FASTSIM: &[Field] = &[
    Field::new(
        "fastsim.flexibilities",
        Kind::Choice(FlexibilitiesChoice::CHOICES),
        Finite,
        Text("three"),
        "flexibilities L from Kalker's coefficients",
    )
    .with(METHOD, BRISTLES),
    Field::new(
        "fastsim.bound",
        Kind::Choice(BoundChoice::CHOICES),
        Finite,
        Text("parabolic"),
        "what bounds the traction",
    )
    .with(METHOD, BRISTLES),
    Field::new(
        "fastsim.initial_reduction",
        Kind::Number,
        PART,
        Text("1.0"),
        "k0, reduction of the slope at vanishing creepage: k = k0 ((1 − α)/(1 + β ε) + α)",
    )
    .with(METHOD, MODIFIED),
    Field::new(
        "fastsim.reduction_limit_ratio",
        Kind::Number,
        Between(0.0, 1.0),
        Text("0.025"),
        "α, part of k0 that is left at large creepages",
    )
    .with(METHOD, MODIFIED),
    Field::new(
        "fastsim.reduction_decay",
        Kind::Number,
        Between(0.0, 1e6),
        Text("0.85"),
        "β, rate at which the slope falls with the creepage",
    )
    .with(METHOD, MODIFIED),
];
