//! The solution of a case: steady rolling, or rolling over time.

use schlupf::message::Message;
use schlupf::rolling::marching::march;
use schlupf::wheel_rail::WheelSolution;
use schlupf::{Error, Method, Solution, Watch};
use schlupf_case::{Case, Rolling};
use schlupf_output::solution::SolutionReport;

use crate::{contact_law, messages};

/// What to know about a wheel and about its contacts but the first, whose warnings are those of the
/// solution.
pub(crate) fn of_wheel(wheel: &WheelSolution) -> Vec<Message> {
    let own = wheel.warnings();
    let others = (2..).zip(wheel.contacts.iter().skip(1)).flat_map(|(k, contact)| {
        messages(&contact.solution.warnings)
            .map(move |message| message.about(&format!("contact {k}")))
    });
    messages(&own).chain(others).collect()
}

/// Solves what a case asks for: see [`Case::rolling`].
///
/// ```
/// use schlupf_case::{CaseFile, Folder, Overrides};
/// use schlupf_tasks::solve::solve;
///
/// let text = "kinematics.creepage_x = 0.002\ngrid = { cells_x = 10, cells_y = 10 }";
/// let file = CaseFile::from_str(text, "a case", Folder::new(""), Overrides::NONE)?;
/// let case = file.pose(&schlupf::unwatched)?;
/// let rolling = case.rolling(None)?;
/// let report = solve(&case, rolling, &schlupf::unwatched)?;
/// assert!(report.solution.force.x < 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve(case: &Case, rolling: Rolling, watch: Watch) -> Result<SolutionReport, Error> {
    let solution = match rolling {
        Rolling::Steady(mut solver) => solver.solve(&case.problem, watch)?,
        Rolling::Transient(transient) => march(&transient, &case.options, watch)?,
    };
    Ok(report(case, solution))
}

/// A solution of a case, with all contacts of its wheel if it has one.
pub fn report(case: &Case, solution: Solution) -> SolutionReport {
    let contact_law = (solution.method == Method::Full).then(|| contact_law::of(case));
    let wheel = case.wheel.clone();
    let of_wheel = wheel.iter().flat_map(|wheel| of_wheel(wheel));
    let warnings = case.notices.iter().cloned().chain(messages(&solution.warnings));
    let warnings = warnings.chain(of_wheel).collect();
    SolutionReport { title: case.title.clone(), contact_law, solution, wheel, warnings }
}
