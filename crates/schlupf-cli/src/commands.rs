//! The commands that do not solve.

use std::fmt::Write;
use std::io::ErrorKind;
use std::path::Path;

use schlupf::solver::viscoelastic_rolling;
use schlupf_case::{
    Case, CaseErrors, Effective, FieldNames, FieldPath, Place, Preset, conditions, field, fields,
    schema as case_schema, template, template_with,
};
use schlupf_tasks::contact_law;
use schlupf_tasks::output::significant;

use crate::arguments::{CheckArguments, InitArguments, STANDARD_STREAM};
use crate::failure::{Failure, SUCCESS};
use crate::outputs::{self, Output};
use crate::progress::Progress;
use crate::read_case::read_case;
use crate::{profiles, report, stdout};

/// `schlupf check`: reads a case and says what it would solve.
pub fn check(arguments: &CheckArguments) -> Result<u8, Failure> {
    let progress = Progress::start();
    progress.stage("posing the problem");
    let file = read_case(&arguments.case)?;
    profiles::check(arguments, &file)?;
    if file.given().any(|path| path.starts_with("damage.")) {
        file.damage_laws().map_err(CaseErrors::from)?;
    }
    let posed = file.pose(&progress.watch());
    drop(progress);
    let height = posed.as_ref().ok().and_then(|case| Some(case.wheel.as_ref()?.height));
    profiles::draw(arguments, &file, height.unwrap_or(0.0))?;
    if posed.is_err() {
        // What was read of profiles may say why.
        file.notices().iter().for_each(report::warn);
        stdout::write(&profiles::text(&file))?;
    }
    let case = posed?;
    if file.given().any(|path| path == field!("element.contact_table")) {
        case.element().map_err(CaseErrors::from)?;
    }
    let explain = |error| Failure::Case(case.explain(&error).into());
    let rolling = viscoelastic_rolling(&case.problem, &schlupf::unwatched).map_err(explain)?;
    let source = &rolling.as_ref().unwrap_or(&case.problem).normal;
    let normal = source.normal_contact(None).map_err(explain)?.summary;
    let beyond = case.problem.interface.beyond_elastic(normal.peak_pressure);
    let beyond = schlupf_tasks::messages(&beyond);
    case.notices.iter().cloned().chain(beyond).for_each(|message| report::warn(&message));
    let of_wheel = case.wheel.iter().flat_map(|wheel| wheel.warnings());
    of_wheel.for_each(|warning| report::warn(&warning.message(&FieldNames::CASE)));
    let effective = case.effective();
    let mut text = format!(
        "{}\n\npatch      a = {} mm, b = {} mm, load {} kN, largest pressure {} MPa\n\
         {}{}{}\nfields in effect\n",
        case.title,
        significant(normal.semi_axis_x / 1e-3),
        significant(normal.semi_axis_y / 1e-3),
        significant(normal.load / 1e3),
        significant(normal.peak_pressure / 1e6),
        resolution(&case, &effective),
        creepages(&case, &effective),
        profiles::text(&file),
    );
    let is_default = |field: &Effective| matches!(field.place, Place::Default);
    let given = effective.iter().filter(|field| !is_default(field));
    let given: Vec<&str> = given.map(|field| field.path.section()).collect();
    // Defaults of a section for another command would only be in the way.
    let is_of_other =
        |field: &Effective| !field.tasks.is_empty() && !given.contains(&field.path.section());
    for field in effective.into_iter().filter(|field| !is_of_other(field)) {
        let origin = match field.place {
            Place::Default => "  (default)",
            Place::Override { .. } => "  (--set)",
            Place::Text { .. } | Place::File { .. } => "",
        };
        let tasks: Vec<String> = field.tasks.iter().map(|name| format!("schlupf {name}")).collect();
        let is_for_all = tasks.is_empty();
        let command =
            if is_for_all { String::new() } else { format!("  ({} only)", tasks.join(", ")) };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {:40} {}{origin}{command}", field.path, field.value);
    }
    stdout::write(&text)?;
    Ok(SUCCESS)
}

/// Lines with the grid and the contact law, where the method has them.
fn resolution(case: &Case, effective: &[Effective]) -> String {
    let counts = |section: &str| effective.iter().any(|field| field.path.starts_with(section));
    let mut lines = String::new();
    if counts("grid.") {
        let [x, y] = [case.options.cells_x, case.options.cells_y];
        // Writing to a string cannot fail.
        let _ = writeln!(lines, "cells      {x} x {y} across the patch");
    }
    if counts("contact_law.") {
        let law = contact_law::of(case);
        let (stiffness, from) = (significant(law.stiffness), law.from.name());
        let _ = writeln!(lines, "k_c        {stiffness} 1/m, {from}");
    }
    lines
}

/// A line with the creepages where they follow from the motion of the wheel.
fn creepages(case: &Case, effective: &[Effective]) -> String {
    const MOTION: &[FieldPath] = &fields!["kinematics.angular_velocity", "kinematics.yaw_angle"];
    if effective.iter().all(|field| !MOTION.contains(&field.path)) {
        return String::new();
    }
    let kinematics = &case.problem.kinematics;
    let [x, y] = [kinematics.creepage_x, kinematics.creepage_y].map(significant);
    format!("creepages  ξ = {x}, η = {y}\n")
}

/// `schlupf init`: writes a commented case file.
pub fn init(arguments: &InitArguments) -> Result<u8, Failure> {
    let named = |preset: &&Preset| Some(&preset.name) == arguments.condition.as_ref();
    let text = conditions().find(named).map_or_else(template, template_with);
    let path = &arguments.file;
    if path == Path::new(STANDARD_STREAM) {
        stdout::write(&text)?;
        return Ok(SUCCESS);
    }
    outputs::check(&[Output { option: "FILE".to_owned(), path: path.to_owned() }], None)?;
    if arguments.force {
        outputs::write(&[(path.clone(), text.into_bytes())], None)?;
    } else {
        outputs::write_new(path, text.as_bytes()).map_err(|failure| match failure {
            Failure::File { path, cause } if cause.kind() == ErrorKind::AlreadyExists => {
                let advice = "there is a file already; --force overwrites it";
                Failure::File { path, cause: std::io::Error::new(cause.kind(), advice) }
            }
            failure => failure,
        })?;
    }
    let path = path.display();
    stdout::write(&format!("wrote {path}; `schlupf solve {path}` solves it\n"))?;
    Ok(SUCCESS)
}

/// `schlupf schema`: prints the JSON schema of a case file.
pub fn schema() -> Result<u8, Failure> {
    stdout::write(&format!("{:#}\n", case_schema()))?;
    Ok(SUCCESS)
}
