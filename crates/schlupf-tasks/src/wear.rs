//! Wear, fatigue and melting of one passage.

use schlupf::damage::{Laws, of_passage};
use schlupf::{Error, Watch};
use schlupf_case::{Case, CaseErrors, CaseFile};
use schlupf_output::wear::WearReport;

use crate::{Notice, TaskError, messages};

/// A case with its laws of damage.
#[derive(Debug)]
pub struct Plan {
    case: Case,
    laws: Laws,
}

/// Poses the case.
///
/// # Errors
/// A case that is wrong or has a history.
pub fn plan(file: &CaseFile, watch: Watch) -> Result<Plan, TaskError> {
    let laws = file.damage_laws().map_err(CaseErrors::from)?;
    let case = file.pose(watch)?;
    case.require_steady("wear, fatigue and melting are those")?;
    Ok(Plan { case, laws })
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
        let own = without_fields.into_iter().chain(molten);
        let warnings = Notice::of_first_contact(&case).into_iter();
        let warnings = warnings.chain(messages(&solution.warnings)).chain(own).collect();
        Ok(WearReport { title: case.title, laws, passage, solution, warnings })
    }
}
