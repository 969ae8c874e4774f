//! Times of studies, as Markdown: `cargo xtask bench`. What can be counted is asserted by tests.

use std::fs;
use std::path::Path;
use std::time::Instant;

use rayon::ThreadPoolBuilder;
use schlupf::unwatched;
use schlupf_tasks::study::Study;
use schlupf_tasks::study::run::run;

/// What a study solves.
struct Kind {
    name: &'static str,
    /// Fields of the case.
    case: &'static str,
    grids: &'static [usize],
    /// States to measure on the coarsest grid.
    states: usize,
}

const KINDS: [Kind; 6] = [
    Kind {
        name: "half-space, Eq. (8)",
        case: "elasticity.model = \"half-space\"\nheat.model = \"none\"\nfriction.model = \"constant\"",
        grids: &[20, 40, 80],
        states: 4000,
    },
    Kind {
        name: "half-space, Eq. (8), heat",
        case: "elasticity.model = \"half-space\"",
        grids: &[20, 40],
        states: 2000,
    },
    Kind {
        name: "half-space, Coulomb",
        case: "elasticity.model = \"half-space\"\nheat.model = \"none\"\n\
               friction.model = \"constant\"\ncontact_law.model = \"coulomb\"",
        grids: &[20, 40],
        states: 1000,
    },
    Kind { name: "elastic layer, Eq. (8), heat", case: "", grids: &[20, 40], states: 2000 },
    Kind { name: "FASTSIM", case: "solver.method = \"fastsim\"", grids: &[20], states: 20_000 },
    Kind {
        name: "Polach",
        case: "solver.method = \"polach\"\nheat.model = \"none\"\nfriction.model = \"constant\"",
        grids: &[20],
        states: 100_000,
    },
];

/// Creepages of the states, as in a run of a vehicle.
const RANGES: &str = "[sample.range]\nkinematics.creepage_x = [-0.01, 0.01]\n\
                      kinematics.creepage_y = [-0.01, 0.01]\n\
                      kinematics.spin = [\"-1 1/m\", \"1 1/m\"]\n";

/// Where the issue sets its limits: states on a half-space with so many cells across.
const MANY: usize = 100_000;
const CELLS: usize = 20;

fn main() {
    // `cargo test --all-targets` runs benchmarks too, without this argument.
    if !std::env::args().any(|argument| argument == "--bench") {
        println!("run by `cargo xtask bench`");
        return;
    }
    // First, because the peak of the memory stays.
    println!("{}\n", many());
    println!("{}\n", cores());
    println!("{}\n", crossing());
    println!("{}", sizes());
}

/// What solving a study has taken, in s, and what of it were seconds of a processor.
struct Taken {
    elapsed: f64,
    processor: f64,
}

fn solved(kind: &Kind, cells: usize, states: usize, threads: usize) -> Taken {
    let folder = tempfile::tempdir().unwrap();
    let Kind { case, .. } = kind;
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("case.toml", &format!("{case}\ngrid.cells_x = {cells}\ngrid.cells_y = {cells}\n"));
    let sample = format!("[sample]\nmethod = \"sobol\"\ncount = {states}\n");
    write("study.toml", &format!("case = \"case.toml\"\n{sample}{RANGES}"));
    let study = Study::from_path(&folder.path().join("study.toml"), None).unwrap();
    let table = folder.path().join("table.parquet");
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let (start, before) = (Instant::now(), processor_time());
    let report = pool.install(|| run(&study, [1, 1], &table, &unwatched)).unwrap();
    let taken =
        Taken { elapsed: start.elapsed().as_secs_f64(), processor: processor_time() - before };
    assert!(report.is_converged(), "{}: {report:?}", kind.name);
    assert_eq!(report.rows, states);
    taken
}

/// A wheel at places along the crossing of the gallery, from the wing rail to the nose.
fn crossing() -> String {
    const PLACES: usize = 60;
    let folder = tempfile::tempdir().unwrap();
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/crossing_nose.toml");
    let case = case.canonicalize().unwrap();
    let places: Vec<String> = (0..PLACES).map(|k| format!("\"{} mm\"", 140 + k)).collect();
    let text = format!(
        "case = \"{}\"\n[vary]\n\"wheelset.track_position\" = [{}]\n",
        case.display(),
        places.join(", ")
    );
    let path = folder.path().join("study.toml");
    fs::write(&path, text).unwrap();
    let study = Study::from_path(&path, None).unwrap();
    let table = folder.path().join("table.parquet");
    let start = Instant::now();
    let report = run(&study, [1, 1], &table, &unwatched).unwrap();
    assert!(report.is_converged() && report.rows == PLACES, "{report:?}");
    format!(
        "{PLACES} places along a crossing (cases/crossing_nose.toml): {:.1} s on all cores",
        start.elapsed().as_secs_f64()
    )
}

/// Cost of a million states by what is solved.
fn sizes() -> String {
    let mut lines = vec![
        "Random creepages and spins on one core, tables as Parquet:\n\n\
         | solved | cells across | ms a state | core hours for 10⁶ states |\n|---|--:|--:|--:|"
            .to_owned(),
    ];
    for kind in &KINDS {
        for &cells in kind.grids {
            let coarser = cells * cells / (kind.grids[0] * kind.grids[0]);
            let states = kind.states / coarser;
            let Taken { processor, .. } = solved(kind, cells, states, 1);
            let each = processor / states as f64;
            lines.push(format!(
                "| {} | {cells} | {:.3} | {:.2} |",
                kind.name,
                1e3 * each,
                1e6 * each / 3600.0,
            ));
        }
    }
    lines.join("\n")
}

/// Two cores against one.
fn cores() -> String {
    let kind = &KINDS[0];
    let best = |threads| {
        let times = (0..3).map(|_| solved(kind, CELLS, 10_000, threads).elapsed);
        times.fold(f64::INFINITY, f64::min)
    };
    let [one, two] = [best(1), best(2)];
    format!(
        "10000 states ({}, {CELLS} cells across): {one:.1} s on one core, {two:.1} s on two, \
         {:.2} times as fast",
        kind.name,
        one / two
    )
}

/// Many states, and the memory that they take.
fn many() -> String {
    let kind = &KINDS[0];
    solved(kind, CELLS, MANY / 10, 2);
    let before = peak_memory();
    let Taken { elapsed, .. } = solved(kind, CELLS, MANY, 2);
    let after = peak_memory();
    format!(
        "{MANY} states ({}, {CELLS} cells across) on two cores: {elapsed:.0} s; peak memory \
         {before:.0} MB after a tenth as many, {after:.0} MB after all",
        kind.name
    )
}

/// User and system time of this process in s, where the system tells.
fn processor_time() -> f64 {
    /// Ticks of Linux.
    const TICKS: f64 = 100.0;
    let stat = fs::read_to_string(Path::new("/proc/self/stat")).unwrap_or_default();
    // Behind the name of the program, which may have spaces.
    let fields = stat.rsplit_once(')').map_or("", |(_, fields)| fields);
    let ticks = fields.split_whitespace().skip(11).take(2);
    ticks.filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() / TICKS
}

/// The largest memory that this process has had, in MB, where the system tells.
fn peak_memory() -> f64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.unwrap_or(f64::NAN) / 1024.0
}
