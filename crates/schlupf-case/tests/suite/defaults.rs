//! A case file that says nothing is the problem of a builder that is told nothing.

use schlupf::{Options, Problem, unwatched};
use schlupf_case::{CaseFile, Folder, Overrides};

#[test]
fn an_empty_case_is_the_default_problem() {
    let case = CaseFile::from_str("", "empty.toml", Folder::new(""), Overrides::NONE).unwrap();
    let case = case.pose(&unwatched).unwrap();
    let problem = Problem::builder().build().unwrap();
    assert_eq!(format!("{:#?}", case.problem), format!("{problem:#?}"));
    // A case file asks for derivatives, which cost a part of a solution, unless it says otherwise.
    assert_eq!(case.options, Options { sensitivity: true, ..Options::default() });
}
