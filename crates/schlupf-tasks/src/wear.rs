//! Wear, fatigue and melting of one passage.

use schlupf::damage::{Laws, WearMap, of_passage};
use schlupf::error::MethodPurpose;
use schlupf::message::Message;
use schlupf::solution::Power;
use schlupf::{Error, Method, Solution, Warning, Watch};
use schlupf_case::{Case, CaseErrors, CaseFile, FieldNames};
use schlupf_output::wear::WearReport;

use crate::{Notice, TaskError, messages};

/// Whether wear in the cells is to be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cells {
    /// It is.
    Needed,
    /// It is part of the report where the method has cells.
    IfAny,
}

/// A case with its laws of damage.
#[derive(Debug)]
pub struct Plan {
    case: Case,
    laws: Laws,
}

/// Poses the case.
///
/// # Errors
/// A case that is wrong or has a history, and a method without cells where they are needed.
pub fn plan(file: &CaseFile, cells: Cells, watch: Watch) -> Result<Plan, TaskError> {
    let laws = file.damage_laws().map_err(CaseErrors::from)?;
    let case = file.pose(watch)?;
    case.require_steady("wear, fatigue and melting are those")?;
    if cells == Cells::Needed && !case.method.has_fields() {
        let method = case.method.name();
        let error = Error::OtherMethod { purpose: MethodPurpose::Wear, method };
        return Err(CaseErrors::from(case.explain(&error)).into());
    }
    Ok(Plan { case, laws })
}

/// Coefficient of friction (dimensionless) below which steel on steel is not dry: that of a wet
/// rail is 0.2 to 0.3 (Olofsson and Lewis 2006).
const DRY: f64 = 0.2;

/// Part of the creep power that wear may miss without a warning, dimensionless.
const LARGEST_GAP: f64 = 0.05;

/// What to know where the energy of wear is not that of the creep forces, which the solution says
/// itself where it has temperatures.
fn gap(solution: &Solution) -> Option<Message> {
    let Power { friction, creep, .. } = solution.power?;
    let is_told =
        solution.warnings.iter().any(|warning| matches!(warning, Warning::PowerGap { .. }));
    let is_open = (friction - creep).abs() > LARGEST_GAP * creep.abs();
    let gap = Warning::PowerGap { friction, creep, part: LARGEST_GAP };
    let is_fastsim = matches!(solution.method, Method::Fast(method) if method.has_fields());
    (is_open && is_fastsim && !is_told).then(|| gap.message(&FieldNames::CASE))
}

impl Plan {
    /// Solves the case and computes its damage.
    ///
    /// # Errors
    /// Whatever the solver refuses.
    pub fn find(self, watch: Watch) -> Result<WearReport, TaskError> {
        let Self { case, laws } = self;
        let explain = |error: Error| CaseErrors::from(case.explain(&error));
        let solution = case.solver().solve(&case.problem, watch).map_err(explain)?;
        let passage = of_passage(&case.problem, &solution, &laws).map_err(explain)?;
        let without_fields = passage
            .wear
            .is_none()
            .then(|| Notice::NoWear { method: solution.method.name() }.into());
        let molten = passage.melting.filter(|melting| melting.share > 0.0).map(|melting| {
            let (share, temperature) = (melting.share, melting.max_temperature);
            Notice::Molten { share, temperature, limit: laws.melting_temperature }.into()
        });
        let friction = case.problem.friction.cold_coefficient();
        let is_dry = friction >= DRY && case.problem.layer.is_none();
        let is_of_dry_steel = laws.archard.map == WearMap::default();
        let other = (!is_dry && is_of_dry_steel && passage.wear.is_some())
            .then(|| Notice::WearOfDrySteel { friction }.into());
        let own = without_fields.into_iter().chain(molten).chain(other).chain(gap(&solution));
        let warnings = Notice::of_first_contact(&case).into_iter();
        let warnings = warnings.chain(messages(&solution.warnings)).chain(own).collect();
        Ok(WearReport { title: case.title, laws, passage, solution, warnings })
    }
}
