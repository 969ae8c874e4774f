//! `schlupf bulk`.

use std::path::Path;
use std::process::ExitCode;

use schlupf::bulk_temperature::{self, BulkTemperature, Cooling, bulk_temperature};
use schlupf::{Error, Status};
use schlupf_case::{Case, CaseErrors};
use schlupf_output::bulk_temperature::{Report, document, text};

use crate::arguments::BulkArguments;
use crate::commands::read_case;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::outputs::{self, Input};
use crate::progress::Progress;
use crate::report;

/// Finds the bulk temperature of the wheel and writes the balance.
pub fn run(arguments: &BulkArguments) -> Result<ExitCode, Failure> {
    let case = read_case(&arguments.case)?;
    let cooling = case.require_cooling().map_err(CaseErrors::from)?;
    let explain = |error: Error| Failure::Case(case.explain(&error).into());
    case.require_steady("the bulk temperature is that").map_err(CaseErrors::from)?;
    bulk_temperature::check(&case.problem, &cooling).map_err(explain)?;
    check_outputs(arguments, &case)?;
    let mut balance = find(&case, &cooling).map_err(explain)?;
    balance.solution.warnings.splice(0..0, case.notices.iter().cloned());
    let report = Report {
        title: case.title.clone(),
        cooling,
        rail_temperature: case.problem.rail.bulk_temperature,
        wheel_radius: case.wheel_radius(),
        balance,
    };
    write(arguments, &report)?;
    match report.balance.solution.status {
        Status::Converged => Ok(ExitCode::SUCCESS),
        Status::NotConverged => {
            report::warn(&format!(
                "not converged: {:.1e} W of heat are left over after {} steady states",
                report.balance.surplus(),
                report.balance.iterations
            ));
            Ok(ExitCode::from(NOT_CONVERGED))
        }
    }
}

fn find(case: &Case, cooling: &Cooling) -> Result<BulkTemperature, Error> {
    let progress = Progress::start();
    let mut solver = case.solver();
    bulk_temperature(&case.problem, &mut *solver, cooling, &progress.watch())
}

fn check_outputs(arguments: &BulkArguments, case: &Case) -> Result<(), Failure> {
    let json = arguments.report.json_file();
    let outputs: Vec<(&str, &Path)> = json.map(|path| ("--json", path)).into_iter().collect();
    outputs::check(&outputs, &Input::of_case(&arguments.case, case))
}

fn write(arguments: &BulkArguments, report: &Report) -> Result<(), Failure> {
    if let Some(path) = arguments.report.json_file() {
        outputs::write(&[(path.to_owned(), document(report).into_bytes())], None)?;
    }
    arguments.report.print(|| document(report), || text(report))
}
