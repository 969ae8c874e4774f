//! Wear, fatigue and melting per wheel passage.

use crate::output::wear::WearReport;
use schlupf::analysis::damage::{Laws, WearMap, of_passage};
use schlupf::reporting::{Message, MethodPurpose};
use schlupf::solution::Power;
use schlupf::{Error, Method, Solution, Warning, Watch};
use schlupf_case::{Case, CaseErrors, FieldNames};

use crate::request::Nothing;
use crate::task::{Found, Given, Task, Wanted};
use crate::{Notice, TaskError, messages};

/// `wear`: the section `[damage]` of the case has the laws.
pub struct Wear;

impl Task for Wear {
    const NAME: &'static str = "wear";
    const ABOUT: &'static str = "Compute wear, fatigue and melting per wheel passage";
    const SOURCES: &'static str = "Wear: Archard (1953) with coefficients of Jendel (2002); Braghin, Lewis, \
                                   Dwyer-Joyce and Bruni (2006). Fatigue: Ekberg, Kabo and Andersson (2002), \
                                   Burstow (2004). Shakedown: Johnson and Jefferis (1963).";
    type Request = Nothing;
    type Report = WearReport;

    fn run(
        of: &Given,
        _request: Nothing,
        wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<WearReport>, TaskError> {
        let laws = of.case.damage_laws()?;
        let case = of.case.pose(watch)?;
        case.require_steady("wear, fatigue and melting are those")?;
        let needs_cells = wanted.table || wanted.file(WearReport::PROFILE).is_some();
        if needs_cells && !case.method.has_fields() {
            let method = case.method.name();
            let error = Error::OtherMethod { purpose: MethodPurpose::Wear, method };
            return Err(case.explain(&error).into());
        }
        Ok(passage(case, laws, watch)?.into())
    }
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
    let is_fastsim = matches!(&solution.method, Method::Fast(method) if method.has_fields());
    (is_open && is_fastsim && !is_told).then(|| gap.message(&FieldNames::CASE))
}

/// Solves the case and computes its damage.
fn passage(case: Case, laws: Laws, watch: Watch) -> Result<WearReport, TaskError> {
    let explain = |error: Error| CaseErrors::from(case.explain(&error));
    let solution = case.steady_state(case.solver(), watch).map_err(explain)?;
    let passage = of_passage(&case.problem, &solution, &laws).map_err(explain)?;
    let without_fields =
        passage.wear.is_none().then(|| Notice::NoWear { method: solution.method.name() }.into());
    let molten = passage.melting.filter(|melting| melting.share > 0.0).map(|melting| {
        let (share, temperature) = (melting.share, melting.max_temperature);
        Notice::Molten { share, temperature, limit: laws.melting_temperature }.into()
    });
    let friction = case.problem.interface.friction.cold_coefficient();
    let is_dry = friction >= DRY && case.problem.interface.layer.is_none();
    let is_of_dry_steel = laws.archard.map == WearMap::default();
    let other = (!is_dry && is_of_dry_steel && passage.wear.is_some())
        .then(|| Notice::WearOfDrySteel { friction }.into());
    let own = without_fields.into_iter().chain(molten).chain(other).chain(gap(&solution));
    let warnings = Notice::of_first_contact(&case).into_iter();
    let warnings = warnings.chain(messages(&solution.warnings)).chain(own).collect();
    Ok(WearReport { title: case.title, laws, passage, solution, warnings })
}
