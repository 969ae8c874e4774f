//! What a case can be asked, in a browser: cases are text, files are bytes, results are JSON and
//! arrays.
//!
//! ```js
//! const files = new Files();
//! const sliding = new Case("", "case.toml", ["kinematics.creepage_x=0.002"], files);
//! const { tables } = sliding.ask("solve", "{}");
//! ```

#![cfg(target_family = "wasm")]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]
#![allow(clippy::needless_pass_by_value, reason = "arrays of JavaScript arrive by value")]

use std::any::Any;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

use js_sys::{Array, Float64Array, Function, Object, Reflect};
use schlupf::Progress;
use schlupf::solution::Fields;
use schlupf_case::fields::{self, Kind};
use schlupf_case::{CaseError, CaseErrors, FieldPath, InputFile, Overrides, Setting, field};
use schlupf_tasks::output::solution::SolutionReport;
use schlupf_tasks::output::summary::Line;
use schlupf_tasks::output::table::{ColumnValues, Values};
use schlupf_tasks::output::{Report, profiles};
use schlupf_tasks::request::Field;
use schlupf_tasks::states::{self, StateSolver};
use schlupf_tasks::{Asked, Entry, Face, Given, TaskError, Value, Wanted, solve};
use serde_json::{Value as Json, json};
use wasm_bindgen::prelude::*;

/// What messages call the assignments of the page.
const OPTION: &str = "explorer";

/// Sections and fields of a case, tasks and presets, as JSON.
#[wasm_bindgen]
pub fn catalogue() -> String {
    schlupf_tasks::catalogue().to_string()
}

thread_local! {
    static WATCHER: RefCell<Option<Function>> = const { RefCell::new(None) };
}

/// Takes a function that is told how far a computation has got: what is counted, the number done,
/// and the total and the residual where they are known.
#[wasm_bindgen]
pub fn watch(watcher: Function) {
    WATCHER.set(Some(watcher));
}

/// Who computes hears nothing until it is done: to stop it, its worker is ended.
fn told(Progress { stage, done, total, change, .. }: Progress) -> ControlFlow<()> {
    WATCHER.with_borrow(|watcher| {
        let Some(watcher) = watcher else { return };
        let (total, change) = (total.map(|total| total as f64), change.map(JsValue::from));
        // What it does with that does not concern the computation.
        let _ = watcher.call4(
            &JsValue::NULL,
            &stage.counted().into(),
            &(done as f64).into(),
            &total.into(),
            &change.into(),
        );
    });
    ControlFlow::Continue(())
}

/// Takes the bytes of the standard table of creep forces, which the method `table` needs.
#[wasm_bindgen]
pub fn provide_table(bytes: &[u8]) {
    schlupf_case::look_up_table::provide(bytes);
}

/// Files that a case may name.
#[wasm_bindgen]
#[derive(Default)]
pub struct Files(BTreeMap<String, Vec<u8>>);

#[wasm_bindgen]
impl Files {
    /// None.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a file, or puts it in place of another one of this name.
    pub fn set(&mut self, name: String, bytes: Vec<u8>) {
        self.0.insert(name, bytes);
    }
}

/// A case that was read and checked.
#[wasm_bindgen]
pub struct Case {
    file: schlupf_case::CaseFile,
    files: Arc<BTreeMap<String, Vec<u8>>>,
    /// Keeps what one state has set up for the next.
    solver: StateSolver,
}

#[wasm_bindgen]
impl Case {
    /// From a TOML text, with assignments `section.field=value`. An error is an array of what is
    /// wrong: field, message, place and help.
    #[wasm_bindgen(constructor)]
    pub fn new(
        text: &str,
        name: &str,
        assignments: Vec<String>,
        files: &Files,
    ) -> Result<Self, JsValue> {
        let files = Arc::new(files.0.clone());
        let overrides = Overrides { option: OPTION, assignments: &assignments };
        let file = schlupf_case::CaseFile::from_str(text, name, files.clone(), overrides);
        let file = file.map_err(|errors| of_case(&errors))?;
        let solver = StateSolver::new(file.clone(), Vec::new()).as_asked();
        Ok(Self { file, files, solver })
    }

    /// Its text with all assignments in it.
    pub fn toml(&self) -> Result<String, JsValue> {
        self.file.edited(&[], Path::new("")).map_err(|error| of_case(&error.into()))
    }

    /// Values of its fields by path, numbers in SI units; the paths of those that are given, and of
    /// those that have an effect.
    pub fn fields(&self) -> String {
        let value = |field: &fields::Field| {
            let value = match self.file.value(field.path)? {
                Setting::Number(number) if matches!(field.kind, Kind::Count) => {
                    json!(number as i64)
                }
                Setting::Number(number) => json!(number),
                Setting::Text(text) => json!(text),
                Setting::Flag(flag) => json!(flag),
                Setting::Choice(name) => json!(name),
                Setting::Series(numbers) => json!(numbers),
            };
            Some((field.path.to_string(), value))
        };
        let values: serde_json::Map<String, Json> = fields::all().filter_map(value).collect();
        let given: Vec<String> = self.file.given().map(|path| path.to_string()).collect();
        let effective: Vec<&str> = self.file.effective().map(|field| field.path.as_str()).collect();
        json!({ "values": values, "given": given, "effective": effective }).to_string()
    }

    /// Both profiles in the track, with the axle at its nominal height: places of rail and wheel
    /// and the nominal radius, in m; and which way is outwards. Null in a case without profiles.
    pub fn outlines(&self) -> String {
        let Ok(wheel) = self.file.wheel() else { return Json::Null.to_string() };
        let [rail, wheel_line] = profiles::outlines(wheel).map(|places| {
            let along = |axis: usize| places.iter().map(|place| place[axis]).collect::<Vec<f64>>();
            json!({ "y": along(0), "z": along(1) })
        });
        let outwards = wheel.side.outwards();
        let radius = wheel.pair().nominal_radius();
        json!({ "outwards": outwards, "radius": radius, "rail": rail, "wheel": wheel_line })
            .to_string()
    }

    /// Solves rolling over time, and keeps the fields of every so many steps.
    pub fn play(&self, every: usize) -> Result<Answer, JsValue> {
        let solved = || -> Result<_, CaseErrors> {
            let mut case = self.file.pose(&told)?;
            case.options.fields_every = every;
            let rolling = case.rolling(None)?;
            let report = solve::solve(&case, rolling, &told);
            report.map_err(|error| case.explain(&error).into())
        };
        solved().map(|report| Answer(Box::new(report))).map_err(|errors| of_case(&errors))
    }

    /// The same wheel with contacts by Kik and Piotrowski and tractions by FASTSIM, which take a
    /// tenth of the time; nothing for a case that cannot be solved so, or is already.
    pub fn quick(&self) -> Option<Self> {
        let is =
            |path, name| matches!(self.file.value(path), Some(Setting::Choice(own)) if own == name);
        let is_exact =
            is(field!("solver.method"), "full") && is(field!("normal.method"), "half-spaces");
        if self.file.wheel().is_err() || !is_exact {
            return None;
        }
        let quick = QUICK.map(|(path, value)| format!("{path}={value}"));
        let file = self.file.with(OPTION, &quick).ok()?;
        let solver = StateSolver::new(file.clone(), Vec::new()).as_asked();
        Some(Self { file, files: Arc::clone(&self.files), solver })
    }

    /// Solves steady rolling with other values of fields, by their paths, in SI units: starts from
    /// what was solved before.
    pub fn solve(&mut self, paths: Vec<String>, values: &[f64]) -> Result<Answer, JsValue> {
        let field = |path: &String| fields::named(path, || OWN);
        let fields = paths.iter().map(field).collect::<Result<_, _>>();
        self.solver.vary(fields.map_err(|error| of_case(&error.into()))?);
        let entries: Vec<_> = values.iter().map(|value| states::Entry::Number(*value)).collect();
        match self.solver.solve(&entries, OPTION, &told) {
            Ok((case, solution)) => Ok(Answer(Box::new(solve::report(case, solution)))),
            Err(failure) => Err(of_case(&failure.errors(&self.file))),
        }
    }

    /// Does a task with a request, which is an object of its fields; some do more for figures.
    pub fn ask(&self, task: &str, request: &str, figures: bool) -> Result<Answer, JsValue> {
        let refused = |message: String| of_case(&CaseError::new("", message, OWN).into());
        let task = schlupf_tasks::find(task).ok_or_else(|| refused(format!("no task {task}")))?;
        let request: Json = serde_json::from_str(request).map_err(|e| refused(e.to_string()))?;
        let wanted = Wanted { figures, ..Wanted::default() };
        let found = self.done(task, &request, &wanted);
        found.map(Answer).map_err(|error| match error {
            TaskError::Case(errors) => of_case(&errors),
            other @ TaskError::Request(_) => refused(other.to_string()),
        })
    }
}

/// What makes a wheel quick to solve.
const QUICK: [(FieldPath, &str); 3] = [
    (field!("normal.method"), "\"kik-piotrowski\""),
    (field!("solver.method"), "\"fastsim\""),
    (field!("fastsim.bound"), "\"elliptic\""),
];

/// Where a request is wrong.
const OWN: schlupf_case::Place = schlupf_case::Place::Default;

impl Case {
    fn done(
        &self,
        task: &Entry,
        request: &Json,
        wanted: &Wanted,
    ) -> Result<Box<dyn Report>, TaskError> {
        let asked = Asked::new(Face::Functions, (task.fields)(), |field| {
            let value = request.get(field.name).filter(|value| !value.is_null());
            value.map(|value| self.converted(field, value)).into_iter().collect()
        })?;
        let work = (task.read)(&asked)?;
        let found = work(&Given::of(&self.file), wanted, &told)?;
        match found.failure {
            Some(errors) if found.report.status() == schlupf::Status::Converged => {
                Err(errors.into())
            }
            _ => Ok(found.report),
        }
    }

    fn converted(&self, field: &Field, value: &Json) -> Result<Value, CaseError> {
        Ok(match value {
            Json::Bool(flag) => Value::Flag(*flag),
            Json::Number(number) => Value::Number(number.as_f64().unwrap_or(f64::NAN)),
            Json::String(name) if field.form.is_file() => {
                Value::File(InputFile::new(name.clone(), self.files.clone()))
            }
            Json::String(text) => Value::Text(text.clone()),
            Json::Array(parts) => {
                let parts = parts.iter().map(|part| self.converted(field, part));
                Value::List(parts.collect::<Result<_, _>>()?)
            }
            Json::Null | Json::Object(_) => {
                let message = format!("{} must be text, a number or several of them", field.name);
                return Err(CaseError::new("", message, OWN));
            }
        })
    }
}

/// What a task has found.
#[wasm_bindgen]
pub struct Answer(Box<dyn Report>);

#[wasm_bindgen]
impl Answer {
    /// The documented JSON.
    pub fn json(&self) -> String {
        self.0.json()
    }

    /// `converged` or `not-converged`, the lines of the summary (an entry is name, value, unit and
    /// remark) and warnings, as JSON.
    pub fn told(&self) -> String {
        let line = |line: &Line| match line {
            Line::Entry { name, value, unit, remark } => json!([name, value, unit, remark]),
            other => json!(other.to_string()),
        };
        let summary: Vec<Json> = self.0.summary().lines.iter().map(line).collect();
        let warning = |w: &schlupf::reporting::Message| json!({ "code": w.code, "text": w.text });
        let warnings: Vec<Json> = self.0.warnings().iter().map(warning).collect();
        let status = self.0.status().name();
        json!({ "status": status, "summary": summary, "warnings": warnings }).to_string()
    }

    /// The table as CSV.
    pub fn csv(&self) -> Option<String> {
        self.0.csv()
    }

    /// The cells of each table of fields, one row for each: an array with the numbers of columns
    /// and rows of the grid, its spacing, the centre of its first cell and that of the patch beside
    /// the place of a contact (in m), and for frames the time (in s).
    pub fn grids(&self) -> String {
        let Some(report) = (&*self.0 as &dyn Any).downcast_ref::<SolutionReport>() else {
            return "[]".to_owned();
        };
        let own = report
            .solutions()
            .into_iter()
            .map(|solution| (&solution.fields, solution.normal.origin.unwrap_or_default(), None));
        let frames = report.solution.field_history.iter();
        let frames = frames.map(|at| (&at.fields, [0.0; 2], Some(at.time)));
        let grid = |(fields, centre, time): (&Fields, [f64; 2], Option<f64>)| {
            let grid = &fields.grid;
            json!({
                "columns": grid.columns,
                "rows": grid.rows,
                "spacing": [grid.spacing_x, grid.spacing_y],
                "origin": [grid.x(0), grid.y(0)],
                "centre": centre,
                "cells": fields.cell,
                "time": time,
            })
        };
        own.chain(frames).map(grid).collect::<Json>().to_string()
    }

    /// The figures that the command draws: an array of name and SVG.
    pub fn figures(&self) -> Result<Array, JsValue> {
        let refused = |message: String| of_case(&CaseError::new("", message, OWN).into());
        let drawings = self.0.drawings().map_err(|error| refused(error.to_string()))?;
        let each = drawings
            .into_iter()
            .map(|(name, svg)| Array::of2(&JsValue::from(name), &JsValue::from(svg)));
        Ok(each.collect())
    }

    /// Tables by name, each an array of tables; a table has columns by name, each with its values,
    /// the name of its quantity, symbol, unit, description and defining equation.
    pub fn tables(&self) -> Object {
        let tables = Object::new();
        for (name, columns) in self.0.tables() {
            let table = Object::new();
            for column in columns {
                set(&table, column.name, &of_column(column));
            }
            let members = Reflect::get(&tables, &name.into()).ok().filter(Array::is_array);
            let members: Array = members.map_or_else(Array::new, JsCast::unchecked_into);
            members.push(&table);
            set(&tables, name, &members);
        }
        tables
    }
}

fn of_column(ColumnValues { quantity, values, .. }: ColumnValues) -> Object {
    let of_numbers = |numbers: &[f64]| JsValue::from(Float64Array::from(numbers));
    let values = match values {
        Values::Numbers(numbers) => of_numbers(&numbers),
        Values::Counts(counts) => {
            of_numbers(&counts.iter().map(|count| *count as f64).collect::<Vec<_>>())
        }
        Values::Flags(flags) => {
            of_numbers(&flags.iter().map(|flag| f64::from(u8::from(*flag))).collect::<Vec<_>>())
        }
        Values::Names(names) => names.into_iter().map(JsValue::from).collect::<Array>().into(),
    };
    let column = Object::new();
    set(&column, "values", &values);
    set(&column, "quantity", &quantity.name().into());
    set(&column, "symbol", &quantity.symbol().into());
    set(&column, "units", &quantity.unit().into());
    set(&column, "long_name", &quantity.description().into());
    set(&column, "definition", &quantity.definition().into());
    column
}

/// Setting a property of a plain object cannot fail.
fn set(object: &Object, name: &str, value: &JsValue) {
    let _ = Reflect::set(object, &name.into(), value);
}

fn of_case(errors: &CaseErrors) -> JsValue {
    let each = errors.iter().map(|error| {
        json!({
            "field": error.field,
            "message": error.message,
            "place": error.place.to_string(),
            "help": error.help,
        })
    });
    each.collect::<Json>().to_string().into()
}
