//! `[grid]`, `[solver]`, `[fastsim]` and `[element]`.

use super::{NORMAL_MODEL, WHEEL_RAIL, quantity};
use crate::fields::choice::{
    BoundChoice, BranchChoice, Choose, DriverChoice, ElementMotion, ElementNormal,
    FlexibilitiesChoice, MethodChoice,
};
use crate::fields::field::Default::{Computed, Nothing, Text};
use crate::fields::field::{Field, Kind, Section};
use crate::fields::path::FieldPath;
use crate::units::Measure;
use schlupf::problem::MAX_CELLS;
use schlupf::reporting::Requirement::{self, AboveUpTo, AtLeast, Between, Finite};

/// The choice that most of these fields belong to.
pub(super) const METHOD: FieldPath = field!("solver.method");
/// The method that solves all equations.
pub(super) const FULL: &[&str] = &["full"];
/// The methods with cells, and so with heat.
pub(super) const CELLS: &[&str] = &["full", "fastsim", "modified-fastsim"];
/// Methods with derivatives.
const DIFFERENTIABLE: &[&str] = &["full", "table"];
const BRISTLES: &[&str] = &["fastsim", "modified-fastsim"];
const MODIFIED: &[&str] = &["modified-fastsim"];

const PART: Requirement = AboveUpTo(0.0, 1.0);

section! {
    Grid "grid"
        "Cells across the contact patch.";

    "cells_x" [CellsX] Kind::Count, Between(2.0, MAX_CELLS as f64), Text("24"),
        "cells along rolling", with(METHOD, CELLS);
    "cells_y" [CellsY] Kind::Count, Between(1.0, MAX_CELLS as f64), Text("24"),
        "cells across rolling", with(METHOD, CELLS), default_else(NORMAL_MODEL, &["line"], "1");
}

section! {
    Solver "solver"
        "What is solved, and how.";

    "driver" [Driver] Kind::Choice(DriverChoice::CHOICES), Finite,
        Computed("\"steady\", and \"marching\" with a history"),
        "how the solution is found", example("steady"), with(METHOD, FULL);
    "branch" [Branch] Kind::Choice(BranchChoice::CHOICES), Finite, Text("low-slip"),
        "which steady state, where friction falls so steeply that there are several, or where two \
         motions have the prescribed forces";
    "method" [Method] Kind::Choice(MethodChoice::CHOICES), Finite, Text("full"),
        "what is solved: all equations, or a fast method";
    "table" [LookUpTable] Kind::Path, Finite, Computed("the standard table, for ν = 0.28"),
        "a look-up table of `schlupf table`", example("table.npz"), with(METHOD, &["table"]);
    "tolerance" [Tolerance] Kind::Number, Between(1e-13, 0.1), Text("1e-6"),
        "largest relative residual", with(METHOD, FULL);
    "max_iterations" [MaxIterations] Kind::Count, AtLeast(1.0), Text("200"),
        "maximum number of Newton steps per equilibrium", with(METHOD, FULL);
    "max_steps" [MaxSteps] Kind::Count, AtLeast(1.0), Text("2000"),
        "maximum number of time steps to the steady state", with(METHOD, FULL);
    "sensitivity" [Sensitivities] Kind::Flag, Finite, Text("true"),
        "whether to compute the derivatives of the forces, with the steady driver",
        with(METHOD, DIFFERENTIABLE);
    "extrapolate" [Extrapolate] Kind::Flag, Finite, Text("false"),
        "whether to extrapolate the forces from this grid and one half as fine, with the steady \
         driver",
        with(METHOD, FULL);
    "slip_threshold" [SlipThreshold] Kind::Number, AboveUpTo(0.0, 0.999), Text("0.95"),
        "a cell slides where |t| ≥ this · μ p_n", with(METHOD, CELLS);
    "polach_area_adhesion" [PolachAreaAdhesion] Kind::Number, PART, Text("1.0"),
        "k_A, reduction of the slope in the area of adhesion", with(METHOD, &["polach"]);
    "polach_area_slip" [PolachAreaSlip] Kind::Number, PART, Text("0.4"),
        "k_S, reduction of the slope in the area of slip, at most k_A", with(METHOD, &["polach"]);
}

section! {
    Fastsim "fastsim"
        "The bristles of FASTSIM, plain and modified.";

    "flexibilities" [] Kind::Choice(FlexibilitiesChoice::CHOICES), Finite, Text("three"),
        "flexibilities L from Kalker's coefficients", with(METHOD, BRISTLES);
    "bound" [TractionBound] Kind::Choice(BoundChoice::CHOICES), Finite, Text("parabolic"),
        "what bounds the traction", with(METHOD, BRISTLES);
    "initial_reduction" [InitialReduction] Kind::Number, PART, Text("1.0"),
        "k0, reduction of the slope at vanishing creepage: k = k0 ((1 − α)/(1 + β ε) + α)",
        with(METHOD, MODIFIED);
    "reduction_limit_ratio" [ReductionLimitRatio] Kind::Number, Between(0.0, 1.0), Text("0.025"),
        "α, fraction of k0 at large creepages", with(METHOD, MODIFIED);
    "reduction_decay" [ReductionDecay] Kind::Number, Between(0.0, 1e6), Text("0.85"),
        "β, rate at which the slope falls with the creepage", with(METHOD, MODIFIED);
}

section! {
    Element "element"
        "The force element for simulations: what it takes, and how it behaves at standstill.";

    "motion" [] Kind::Choice(ElementMotion::CHOICES), Finite, Text("velocities"),
        "how its motion is given";
    "normal" [] Kind::Choice(ElementNormal::CHOICES), Finite, Text("load"),
        "what presses the wheel on the rail";
    "memory" [] Kind::Flag, Finite, Text("true"),
        "whether the elastic shift is its state, so that a wheel at rest sticks";
    "contact_table" [ContactTable] Kind::Path, Finite, Nothing,
        "contacts of a wheel with two profiles, a table of `schlupf table CASE`",
        example("contacts.npz"), with(NORMAL_MODEL, WHEEL_RAIL);
    "standstill_speed" [StandstillSpeed] quantity(&Measure::SPEED), Between(1e-9, 10.0),
        Text("0.01 m/s"), "v_s, speed below which slip is no longer divided by the rolling speed";
}
