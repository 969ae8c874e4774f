//! Time of a call through the C interface, as Markdown: part of `cargo xtask bench`.

#[path = "../tests/common/mod.rs"]
mod common;

use std::hint::black_box;
use std::time::Instant;

use common::{Handle, METHODS};
use schlupf::element::{Given, Rows, Status};
use schlupf::wheel_rail::ContactTableOptions;
use schlupf_case::{CaseFile, Folder, Overrides, contact_table};

/// Calls of a round, and rounds, of which the best counts.
type Effort = (u32, usize);
const FAST: Effort = (1000, 300);
const FULL: Effort = (200, 5);

fn main() {
    // `cargo test --all-targets` runs benchmarks too, without this argument.
    if !std::env::args().any(|argument| argument == "--bench") {
        println!("run by `cargo xtask bench`");
        return;
    }
    println!(
        "A call through the C interface, the load varying, with outputs, rates and derivatives:\n\n\
         | method | creepages, no states: µs | velocities and memory: µs |\n\
         |---|--:|--:|"
    );
    let plain = ["element.motion=creepages", "element.memory=false"];
    for method in METHODS {
        let [one, other] = [&plain[..], &[]].map(|set| 1e6 * time((method, set), true, FAST));
        println!("| {method} | {one:.3} | {other:.3} |");
    }
    println!(
        "\nThe full equations on a half-space, 20 × 20 cells, by creepages:\n\n\
         | contact law | forces: ms | with derivatives: ms |\n|---|--:|--:|"
    );
    let full = ["elasticity.model=half-space", "grid.cells_x=20", "grid.cells_y=20"];
    for law in ["incremental", "coulomb"] {
        let law_of = format!("contact_law.model={law}");
        let set = [&plain[..], &full, &[law_of.as_str()]].concat();
        let [one, other] = [false, true].map(|by| 1e3 * time(("full", &set), by, FULL));
        println!("| {law} | {one:.2} | {other:.2} |");
    }
    wheel();
}

/// Of a call, in s, with derivatives or without.
fn time(
    (method, overrides): (&str, &[&str]),
    with_derivatives: bool,
    (calls, rounds): Effort,
) -> f64 {
    let method = format!("solver.method={method}");
    let (element, _) = Handle::new(common::CASE, &[&[method.as_str()], overrides].concat());
    let (mut inputs, states) = (element.start(), vec![0.0; element.counts()[2]]);
    let (load, mut found) = (inputs[4], element.room(1));
    if !with_derivatives {
        found.derivatives.clear();
    }
    let mut best = f64::INFINITY;
    for _ in 0..rounds {
        let start = Instant::now();
        for k in 0..calls {
            // There and back.
            let part = (2.0 * f64::from(k) / f64::from(calls) - 1.0).abs();
            inputs[4] = load * (1.0 + 0.5 * part);
            element.evaluate(black_box(&inputs), black_box(&states), black_box(&mut found));
        }
        assert_eq!(found.status, 0, "{}", element.message());
        best = best.min(start.elapsed().as_secs_f64());
    }
    best / f64::from(calls)
}

/// A wheel on a rail, whose table is made first, as Markdown.
fn wheel() {
    let case = include_str!("../../../cases/wheel_on_rail.toml");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("contacts.npz");
    let file = CaseFile::from_str(case, "case", Folder::new(""), Overrides::NONE).expect("a case");
    let options =
        ContactTableOptions { tolerance: 0.02, poses: 1, ..ContactTableOptions::default() };
    let posed = file.pose(&schlupf::unwatched).expect("a wheel");
    let (table, errors) =
        posed.contact_table(&options, &schlupf::unwatched).expect("a table of its contacts");
    let bytes = contact_table::to_bytes(&table, &errors).expect("bytes");
    std::fs::write(&path, bytes).expect("a file");
    let table = format!("element.contact_table={}", path.display());
    println!(
        "\nA wheel on a rail from tables, with derivatives, on its tread and at the root of its \
         flange:\n\n| method | tread: µs | root: µs |\n|---|--:|--:|"
    );
    for method in ["polach", "shen-hedrick-elkins", "table"] {
        let method_of = format!("solver.method={method}");
        let times = ["0 mm", "-6 mm"].map(|lateral| {
            let place = format!("wheelset.lateral_position={lateral}");
            time_of_wheel(case, &[&table, &method_of, &place])
        });
        println!("| {method} | {:.2} | {:.2} |", times[0], times[1]);
    }
    let times = [false, true].map(|by| time_of_vehicle(case, &table, by));
    println!(
        "\n8 wheels × 10 000 states by tables, half of them at the root, on all cores: {:.2} s, \
         {:.2} s with derivatives",
        times[0], times[1]
    );
}

/// Of the wheels of a vehicle in many states, in s.
fn time_of_vehicle(case: &str, table: &str, has_derivatives: bool) -> f64 {
    const ROWS: usize = 40_000;
    let of_place = |lateral: &str| {
        let assignments = &[table, "solver.method=table", lateral].map(str::to_owned);
        let set = Overrides { assignments, ..Overrides::NONE };
        let file = CaseFile::from_str(case, "case", Folder::new(""), set).expect("a case");
        let posed = file.pose(&schlupf::unwatched).expect("a wheel");
        let mut element = posed.element().expect("an element");
        let width = element.outputs().len();
        let mut inputs = element.start().repeat(ROWS);
        for (k, row) in inputs.chunks_mut(element.inputs().len()).enumerate() {
            row[0] += 1e-4 * k as f64 / ROWS as f64;
        }
        let mut outputs = vec![0.0; ROWS * width];
        let mut derivatives = vec![0.0; ROWS * width * element.inputs().len()];
        let mut status = vec![Status::Found; ROWS];
        let rows = Rows {
            outputs: &mut outputs,
            rates: &mut [],
            derivatives: has_derivatives.then_some(&mut derivatives),
            status: &mut status,
        };
        let start = Instant::now();
        element.evaluate_rows(Given { inputs: &inputs, states: &[] }, rows).expect("rows");
        assert!(status.iter().all(|status| *status == Status::Found));
        start.elapsed().as_secs_f64()
    };
    let places = ["wheelset.lateral_position=0 mm", "wheelset.lateral_position=-6 mm"];
    places.into_iter().map(of_place).sum()
}

/// Of a call at lateral positions side by side, in µs.
fn time_of_wheel(case: &str, overrides: &[&str]) -> f64 {
    let (element, _) = Handle::new(case, overrides);
    let (mut inputs, mut found) = (element.start(), element.room(1));
    let ((calls, rounds), lateral) = (FAST, inputs[0]);
    let mut best = f64::INFINITY;
    for _ in 0..rounds {
        let start = Instant::now();
        for k in 0..calls {
            inputs[0] = lateral + 1e-5 * f64::from(k) / f64::from(calls);
            element.evaluate(black_box(&inputs), &[], black_box(&mut found));
        }
        assert_eq!(found.status, 0, "{}", element.message());
        best = best.min(start.elapsed().as_secs_f64());
    }
    1e6 * best / f64::from(calls)
}
