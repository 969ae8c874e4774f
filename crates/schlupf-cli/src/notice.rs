//! Notices: what users of results should know about what a command did.

use schlupf::Error;
use schlupf::message::{Message, messages};
use schlupf_case::FieldNames;

const CALIBRATION: &str = "elasticity.calibration";

messages! {
    /// A notice about a field of a case.
    Notice of &'static str:

    /// A file has nothing in it, because the method gives no fields.
    "empty-output" EmptyOutput {
        /// The option that names it.
        option: &'static str,
        /// What is missing.
        what: &'static str,
        /// Name of the method.
        method: &'static str,
    } "solver.method", |subject, words| {
        format!("{option} has {what}: solver.method = {method:?} gives no fields")
    };

    /// A method of a comparison cannot answer for this case.
    "not-available" NotAvailable {
        /// Why.
        reason: String,
    } "solver.method", |subject, words| format!("not available: {reason}");

    /// Loads of the data are far from that of the case.
    "other-loads" OtherLoads {
        /// The one that is farthest, in N.
        of_data: f64,
        /// Load of the case, in N.
        of_case: f64,
    } "normal.load", |subject, words| format!(
        "the data have a load of {of_data:.4e} N, the case one of {of_case:.4e} N: are the units right?"
    );

    /// The patch is beyond the table of calibrated stiffnesses.
    "no-table" NoTable {
        /// Why.
        error: Error,
    } CALIBRATION, |subject, words| error.text(words);

    /// Fitted stiffnesses are far from those of the bodies of the case.
    "foreign-bedding" ForeignBedding {
        /// `x` or `y`.
        component: &'static str,
        /// Bedding over that of half-spaces, dimensionless.
        ratio: f64,
    } CALIBRATION, |subject, words| format!(
        "the bedding for displacement_{component} is {ratio:.1e} times that of half-spaces of the case's \
         bodies: are units and bodies right?"
    );

    /// Displacements that an elastic layer hardly follows.
    "hardly-a-layer" HardlyALayer {
        /// `x` or `y`.
        component: &'static str,
        /// Part of them that it misses, dimensionless.
        deviation: f64,
    } CALIBRATION, |subject, words| format!(
        "the layer misses {:.0} % of displacement_{component}, which is not that of an elastic layer",
        100.0 * deviation
    );

    /// Displacements leave open how far the coupling reaches.
    "open-reach" OpenReach {
        /// `x` or `y`.
        component: &'static str,
        /// `along` or `across` rolling.
        direction: &'static str,
    } CALIBRATION, |subject, words| format!(
        "displacement_{component} does not determine the coupling {direction} rolling: its decay \
         length reached its search bound"
    );
}

impl From<Notice> for Message {
    fn from(notice: Notice) -> Self {
        notice.message(&FieldNames::CASE)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// The codes in the tables of a part of docs/messages.md.
    fn documented(part: usize) -> BTreeSet<String> {
        let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/messages.md");
        let page = std::fs::read_to_string(page).unwrap();
        let part = page.split("\n# ").nth(part).unwrap();
        let rows = part.lines().filter_map(|line| line.strip_prefix("| `")?.split_once('`'));
        rows.map(|(code, _)| code.to_owned()).collect()
    }

    fn all(codes: &[&[&str]]) -> BTreeSet<String> {
        codes.concat().into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn every_warning_is_documented_and_no_other() {
        let codes = [schlupf::Warning::CODES, schlupf_case::Notice::CODES, Notice::CODES];
        assert_eq!(documented(0), all(&codes));
    }

    #[test]
    fn every_error_is_documented_and_no_other() {
        use schlupf::error::{FitError, SurfaceError};
        /// Those of which the code is that of the error within.
        const OUTER: [&str; 4] = ["at-time", "no-rolling-at-patch", "surface", "fit"];
        let mut codes = all(&[Error::CODES, FitError::CODES, SurfaceError::CODES]);
        codes.retain(|code| !OUTER.contains(&code.as_str()));
        assert_eq!(documented(1), codes);
    }
}
