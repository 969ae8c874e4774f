//! Steady solutions and products, by criterion: `cargo bench --package schlupf`.

mod common;

use std::hint::black_box;
use std::time::Duration;

use common::{Bodies, Case, POINTS, Product, cold, creep_curve, solve};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion};
use schlupf::solver::SteadySolver;
use schlupf::{solver, unwatched};

const BODIES: [Bodies; 2] = [Bodies::Layer, Bodies::HalfSpace];

/// From this many cells across on a solution takes so long that few must do.
const LARGE: usize = 80;

/// Points of the creep curve of which one measurement consists, in its middle.
const SEQUENCE: usize = 4;

/// Without heat on all grids, with heat on the usual one.
fn cases() -> impl Iterator<Item = Case> {
    BODIES.into_iter().flat_map(|bodies| {
        let grids = [24, 40, 80, 160].map(|cells| Case { bodies, is_heated: false, cells });
        grids.into_iter().chain([Case { bodies, is_heated: true, cells: 24 }])
    })
}

fn label(case: &Case) -> BenchmarkId {
    let heat = if case.is_heated { " with heat" } else { "" };
    BenchmarkId::new(format!("{}{heat}", case.name()), case.cells)
}

fn size_sample(group: &mut BenchmarkGroup<WallTime>, case: &Case) {
    group.sample_size(if case.cells >= LARGE { 10 } else { 50 });
}

fn group<'a>(criterion: &'a mut Criterion, name: &str) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
    group
}

/// A solution on its own, from the set-up on.
fn cold_solve(criterion: &mut Criterion) {
    let mut group = group(criterion, "cold solve");
    for case in cases() {
        let (problem, options) = (cold(&case.at_rest()), case.options());
        size_sample(&mut group, &case);
        group.bench_function(label(&case), |bencher| {
            bencher.iter(|| solver::solve(black_box(&problem), &options, &unwatched).unwrap());
        });
    }
}

/// Neighbouring points of a creep curve, there and back, each from those before.
fn warm_points(criterion: &mut Criterion) {
    let mut group = group(criterion, "8 warm points");
    for case in cases() {
        let curve = creep_curve(&case.at_rest());
        let there = &curve[POINTS / 2..POINTS / 2 + SEQUENCE];
        let mut solver = SteadySolver::new(&case.curve_options());
        size_sample(&mut group, &case);
        group.bench_function(label(&case), |bencher| {
            bencher.iter(|| {
                for problem in there.iter().chain(there.iter().rev()) {
                    black_box(solve(&mut solver, problem));
                }
            });
        });
    }
}

/// u = A t.
fn product(criterion: &mut Criterion) {
    let mut group = group(criterion, "product");
    for case in cases().filter(|case| !case.is_heated) {
        let mut product = Product::new(&case);
        size_sample(&mut group, &case);
        group.bench_function(label(&case), |bencher| bencher.iter(|| product.run()));
    }
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    cold_solve(&mut criterion);
    warm_points(&mut criterion);
    product(&mut criterion);
    criterion.final_summary();
}
