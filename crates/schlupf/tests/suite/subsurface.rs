//! Stresses below the surface: closed forms of Hertz, McEwen, Smith and Liu, results of CONTACT,
//! and what holds for any load.

use std::path::Path;
use std::sync::Arc;

use crate::common::{cells, half_space, problem, rolling};
use schlupf::analysis::subsurface::{Measure, Plane, Stress, SubsurfaceStress, SurfaceLoad};
use schlupf::analysis::temperature_field::Side;
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::normal::{Ellipse, Extent, Grid};
use schlupf::problem::{Brush, FastMethod, Method};
use schlupf::solver::reference::SlidingLineContact;
use schlupf::{Error, Problem, Solution, Status, unwatched};

/// The contact of an ellipse (semi-axes in m) under p0 = 1 GPa, both bodies with the given
/// Poisson's ratio, under Coulomb's law with μ = 0.3.
fn ellipse([a, b]: [f64; 2], poisson_ratio: f64, creepage_x: f64) -> Problem {
    let mut problem = problem(rolling(creepage_x, 0.0, 0.0));
    for body in [&mut problem.interface.wheel, &mut problem.interface.rail] {
        body.material.poisson_ratio = poisson_ratio;
    }
    problem.normal = Arc::new(Ellipse::from_peak_pressure(a, b, P0).unwrap());
    problem.interface.elasticity = half_space();
    problem.interface.contact_law = ContactLaw::Coulomb;
    problem.interface.friction.law = Arc::new(Constant::new(0.3).unwrap());
    problem
}

const P0: f64 = 1e9;

fn solve(problem: &Problem, across: usize) -> Solution {
    let solution = schlupf::solver::solve(problem, &cells(across), &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged);
    solution
}

fn below(problem: &Problem, across: usize, side: Side) -> SubsurfaceStress {
    SubsurfaceStress::new(problem, &solve(problem, across), side).unwrap()
}

/// Equidistant depths from the surface to a given one, in m.
fn depths(deepest: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|k| deepest * k as f64 / count as f64).collect()
}

/// Largest difference of any component, in Pa.
fn difference(one: &Stress, other: &Stress) -> f64 {
    let pairs = one.components().into_iter().zip(other.components());
    pairs.map(|(p, q)| (p - q).abs()).fold(0.0, f64::max)
}

/// Goal: Hertz's stresses on the axis of a circular contact, σzz = −p0/(1 + ζ²) and σxx = σyy =
/// −p0 ((1 + ν) (1 − ζ atan 1/ζ) − ½/(1 + ζ²)) with ζ = z/a (Johnson 1985, (3.45)), within 1 % of
/// p0 from the surface on, on the default grid of 24 cells across.
#[test]
fn hertz_1882_on_the_axis() {
    let (a, nu) = (6e-3, 0.28);
    for side in [Side::Wheel, Side::Rail] {
        let body = below(&ellipse([a, a], nu, 0.0), 24, side);
        for depth in depths(3.0 * a, 60) {
            let zeta = depth / a;
            let angle = if zeta == 0.0 { 0.0 } else { zeta * zeta.recip().atan() };
            let shape = (1.0 + zeta * zeta).recip();
            let across = -P0 * ((1.0 + nu) * (1.0 - angle) - 0.5 * shape);
            let found = body.at([0.0, 0.0], depth);
            let expected = Stress::new([across, across, -P0 * shape, 0.0, 0.0, 0.0]);
            let error = difference(&found, &expected) / P0;
            assert!(error < 0.01, "{side:?}, {zeta}: {error}");
        }
    }
}

/// Goal: the largest shear stress below ellipses of Hertz and its depth (ν = 0.3): 0.325 p0 at
/// 0.665 b for b/a = 0.4, 0.323 p0 at 0.590 b for 0.6, 0.317 p0 at 0.530 b for 0.8, 0.310 p0 at
/// 0.480 a for a circle (Johnson 1985, Table 4.1, b the shorter semi-axis), within 1 %.
#[test]
fn johnson_1985_largest_shear_below_ellipses() {
    for (ratio, largest, depth) in
        [(0.4, 0.325, 0.665), (0.6, 0.323, 0.590), (0.8, 0.317, 0.530), (1.0, 0.310, 0.480)]
    {
        let (a, b) = (8e-3, 8e-3 * ratio);
        for axes in [[a, b], [b, a]] {
            let body = below(&ellipse(axes, 0.3, 0.0), 40, Side::Rail);
            let [largest_shear] = body.largest([Measure::Shear], &unwatched).unwrap();
            let found = largest_shear.below.unwrap();
            assert_eq!(found, largest_shear.anywhere);
            let shear = Measure::Shear.of(&found.stress);
            assert!((shear / P0 / largest - 1.0).abs() < 0.01, "{axes:?}: {found:?}");
            // Hardly any shear is lost within some percent of the depth.
            assert!((found.depth / b - depth).abs() < 0.015, "{axes:?}: {found:?}");
            assert!(found.x.hypot(found.y) < 1e-2 * b, "{axes:?}: {found:?}");
        }
    }
}

/// Goal: without traction the largest tension is on the surface, at the edge of the contact, where
/// the radial stress is (1 − 2ν) p0/3 (Johnson 1985, §3.4 (b)): the mean over a piece is a little
/// lower.
#[test]
fn johnson_1985_largest_tension_at_the_edge() {
    let (a, nu) = (6e-3, 0.28);
    let body = below(&ellipse([a, a], nu, 0.0), 40, Side::Rail);
    let [found] = body.largest([Measure::Tension], &unwatched).unwrap();
    let share = Measure::Tension.of(&found.surface.stress) / P0 / ((1.0 - 2.0 * nu) / 3.0);
    assert!((0.9..1.005).contains(&share), "{share}");
    let radius = found.surface.x.hypot(found.surface.y) / a;
    assert!((radius - 1.0).abs() < 0.03, "{radius}");
    assert_eq!(found.anywhere, found.surface);
}

/// Goal: in a contact that slides all over, the largest stress of von Mises below the surface does
/// not depend on the cells, wherever the larger one is.
#[test]
fn the_largest_stress_below_hardly_depends_on_the_cells() {
    let of = |across: usize, creepage: f64| {
        let body = below(&ellipse([6e-3, 4e-3], 0.28, creepage), across, Side::Rail);
        let [found] = body.largest([Measure::VonMises], &unwatched).unwrap();
        found.below.unwrap()
    };
    for creepage in [0.001, 0.01] {
        let [coarse, fine] = [16, 48].map(|across| of(across, creepage));
        let [one, other] = [coarse, fine].map(|point| Measure::VonMises.of(&point.stress) / P0);
        assert!((one - other).abs() < 0.003, "{coarse:?}, {fine:?}");
        let apart = [coarse.x - fine.x, coarse.y - fine.y, coarse.depth - fine.depth];
        assert!(apart.into_iter().all(|apart| apart.abs() < 0.1e-3), "{coarse:?}, {fine:?}");
    }
}

/// Goal: stresses have no step where they begin to be interpolated, and are exact two pieces deep.
#[test]
fn stresses_are_continuous_with_depth() {
    for axes in [[6e-3, 6e-3], [8e-3, 2e-3]] {
        let body = below(&ellipse(axes, 0.28, 0.001), 24, Side::Wheel);
        let piece = body.grid().spacing_x.max(body.grid().spacing_y) / 3.0;
        for place in [[0.0, 0.0], [-5.21e-3, 0.4e-3], [5.5e-3, 0.1e-3]] {
            for depth in [body.grid().spacing_y / 3.0, piece, 2.0 * piece] {
                let [above, deeper] = [1.0 - 1e-9, 1.0 + 1e-9].map(|f| body.at(place, f * depth));
                let step = difference(&above, &deeper) / P0;
                assert!(step < 1e-6, "{axes:?}, {place:?}, {depth}: {step}");
            }
        }
    }
}

/// A strip 400 times as wide as it is long, one cell across, under the pressure p0 √(1 − x²/a²) in
/// 80 cells and the traction f times that.
fn strip(a: f64, traction_ratio: f64) -> SubsurfaceStress {
    let grid = Grid::across(&Extent { x: [-a, a], y: [-400.0 * a, 400.0 * a] }, 80, 1);
    let area = |x: f64| {
        let s = (x / a).clamp(-1.0, 1.0);
        0.5 * a * (s * (1.0 - s * s).sqrt() + s.asin())
    };
    let mean = |i: usize| P0 * (area(grid.edge_x(i + 1)) - area(grid.edge_x(i))) / grid.spacing_x;
    let pressure: Vec<f64> = (0..grid.columns).map(mean).collect();
    let traction_x = pressure.iter().map(|p| traction_ratio * p).collect();
    let load = SurfaceLoad { traction_y: vec![0.0; pressure.len()], pressure, traction_x };
    SubsurfaceStress::of_load(grid, load, Side::Wheel, 0.3).unwrap()
}

/// `strip` against the closed form, within 1 % of p0 from a cell below the surface on, with σyy =
/// ν (σxx + σzz) of plane strain.
fn compare_line(traction_ratio: f64) {
    let a = 4e-3;
    let body = strip(a, traction_ratio);
    let line = SlidingLineContact { half_length: a, peak_pressure: P0, traction_ratio };
    for z in [0.025, 0.05, 0.1, 0.3, 0.5, 0.786, 1.0, 2.0, 4.0] {
        for x in [-2.0, -1.1, -0.95, -0.7, -0.3, 0.0, 0.1, 0.5, 0.9, 1.05, 1.5] {
            let found = body.at([x * a, 0.0], z * a);
            let [xx, zz, xz] = line.stress(x * a, z * a);
            let expected = Stress::new([xx, 0.3 * (xx + zz), zz, 0.0, xz, 0.0]);
            let error = difference(&found, &expected) / P0;
            assert!(error < 0.01, "x = {x} a, z = {z} a: {error}");
        }
    }
}

#[test]
fn mcewen_1949_line_contact() {
    compare_line(0.0);
}

#[test]
fn smith_and_liu_1953_sliding_line_contact() {
    compare_line(1.0 / 3.0);
    compare_line(-0.5);
}

/// A line of `data/contact_subsurface.csv`: the case, the place (in mm, depth last), the mean
/// stress and that of von Mises (in MPa), and the components.
struct Reference {
    case: usize,
    place: [f64; 3],
    hydrostatic: f64,
    von_mises: f64,
    stress: Stress,
}

fn references() -> Vec<Reference> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/contact_subsurface.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let line = |record: csv::StringRecord| {
        let n: Vec<f64> = record.iter().map(|field| field.parse().unwrap()).collect();
        Reference {
            case: n[0] as usize,
            place: [n[1], n[2], n[3]],
            hydrostatic: n[4],
            von_mises: n[5],
            stress: Stress::new([n[6], n[9], n[11], n[7], n[8], n[10]]),
        }
    };
    reader.records().map(|record| line(record.unwrap())).collect()
}

/// Goal: the stresses of CONTACT below a = b = 6 mm, p0 = 1 GPa, ν = 0.28, without traction and
/// with that of ξ = 0.0011 under μ = 0.3, within 1 % of p0 below 0.5 mm, on the default grid of 24
/// cells and on the 80 of the reference; von Mises's stress too. Body 1 of CONTACT is the wheel.
#[test]
fn vollebregt_2022_stresses_below_a_partly_sliding_contact() {
    let references = references();
    assert_eq!(references.len(), 1208);
    for across in [24, 80] {
        let bodies =
            [0.0, 0.0011].map(|xi| below(&ellipse([6e-3, 6e-3], 0.28, xi), across, Side::Wheel));
        let mut worst = [0.0_f64; 2];
        let deep: Vec<&Reference> =
            references.iter().filter(|point| point.place[2] > 0.5).collect();
        assert_eq!(deep.len(), 1004);
        for reference in deep {
            let [x, y, z] = reference.place.map(|value| 1e-3 * value);
            let found = bodies[reference.case - 1].at([x, y], z) * 1e-6;
            let invariants = [
                found.von_mises() - reference.von_mises,
                found.hydrostatic() - reference.hydrostatic,
            ];
            let error = invariants
                .into_iter()
                .fold(difference(&found, &reference.stress), |e, i| e.max(i.abs()));
            let error = 1e6 * error / P0;
            worst[reference.case - 1] = worst[reference.case - 1].max(error);
        }
        println!("{across} cells: largest error {worst:.4?} of p0");
        assert!(worst.iter().all(|error| *error < 0.01), "{across} cells: {worst:?}");
    }
}

/// A cell under pressure and both tractions, in a body with the given Poisson's ratio.
fn patch_of_cells(side: Side, poisson_ratio: f64) -> SubsurfaceStress {
    let grid = Grid::across(&Extent { x: [-3e-3, 2e-3], y: [-1e-3, 2.5e-3] }, 5, 7);
    let field = |seed: usize| (0..grid.len()).map(|k| 1e8 * ((k * seed) % 11) as f64).collect();
    let load = SurfaceLoad { pressure: field(3), traction_x: field(5), traction_y: field(7) };
    SubsurfaceStress::of_load(grid, load, side, poisson_ratio).unwrap()
}

/// Goal: div σ = 0 two pieces deep and below, by central differences, in the contact frame (z up):
/// the depth grows upwards in the wheel and downwards in the rail.
#[test]
fn stresses_are_in_equilibrium() {
    for (side, up) in [(Side::Wheel, 1.0), (Side::Rail, -1.0)] {
        for poisson_ratio in [0.0, 0.28, 0.5] {
            let body = patch_of_cells(side, poisson_ratio);
            for place in [[0.3e-3, 0.7e-3, 2.1e-3], [-2.5e-3, 3e-3, 3e-3], [6e-3, -4e-3, 5e-3]] {
                let step = 1e-6;
                let slope = |axis: usize| {
                    let moved = |by: f64| {
                        let mut place = place;
                        place[axis] += by;
                        body.at([place[0], place[1]], place[2])
                    };
                    let direction = if axis == 2 { up } else { 1.0 };
                    let [ahead, behind] = [moved(step), moved(-step)];
                    (ahead + behind * -1.0) * (direction / (2.0 * step))
                };
                let [by_x, by_y, by_z] = [0, 1, 2].map(slope);
                let sums = [
                    [by_x.xx, by_y.xy, by_z.xz],
                    [by_x.xy, by_y.yy, by_z.yz],
                    [by_x.xz, by_y.yz, by_z.zz],
                ];
                for terms in sums {
                    let scale = terms.iter().map(|term| term.abs()).fold(1e6, f64::max);
                    let residual = terms.iter().sum::<f64>().abs();
                    assert!(residual < 1e-5 * scale, "{side:?}, {poisson_ratio}: {terms:?}");
                }
            }
        }
    }
}

/// Goal: on the surface σzz = −p, and σxz and σyz are those of the traction on the wheel with the
/// sign turned, in both bodies.
#[test]
fn the_surface_carries_the_loads() {
    for (side, sign) in [(Side::Wheel, -1.0), (Side::Rail, 1.0)] {
        let body = patch_of_cells(side, 0.28);
        let layer = body.layer(0.0, [1, 2]);
        let inner = body.grid();
        for (k, stress) in layer.stress.iter().enumerate() {
            let (column, row) = (k % (inner.columns + 2), k / (inner.columns + 2));
            let is_inside =
                (1..=inner.columns).contains(&column) && (2..inner.rows + 2).contains(&row);
            let load = |seed: usize| {
                let cell = || inner.index(column - 1, row - 2);
                if is_inside { 1e8 * ((cell() * seed) % 11) as f64 } else { 0.0 }
            };
            for (found, expected) in
                [(stress.zz, -load(3)), (stress.xz, sign * load(5)), (stress.yz, sign * load(7))]
            {
                assert!((found - expected).abs() < 1.0, "{side:?}, {k}: {found} {expected}");
            }
        }
    }
}

/// Goal: the layer by Fourier transform is the sum of the closed forms, at every point.
#[test]
fn layers_are_the_sums_of_the_closed_forms() {
    let body = patch_of_cells(Side::Rail, 0.3);
    let volume = body.volume(&[0.0, 1e-4, 2e-3, 5e-2], [3, 1], &unwatched).unwrap();
    let grid = &volume.grid;
    for (k, layer) in volume.layers.iter().enumerate() {
        for row in 0..grid.rows {
            for column in 0..grid.columns {
                let direct = body.at([grid.x(column), grid.y(row)], layer.depth);
                let error = difference(&direct, &volume.at(k, column, row)) / P0;
                assert!(error < 1e-12, "{k}, {column}, {row}: {error}");
            }
        }
    }
}

/// Goal: x and y are equivalent, and so are the two sides of the contact.
#[test]
fn turned_loads_turn_the_stresses() {
    let body = patch_of_cells(Side::Rail, 0.3);
    let grid = *body.grid();
    let turned = Grid {
        columns: grid.rows,
        rows: grid.columns,
        spacing_x: grid.spacing_y,
        spacing_y: grid.spacing_x,
        origin_x: grid.origin_y,
        origin_y: grid.origin_x,
    };
    let field = |seed: usize| -> Vec<f64> {
        let cells = (0..turned.rows).flat_map(|j| (0..turned.columns).map(move |i| (i, j)));
        cells.map(|(i, j)| 1e8 * ((grid.index(j, i) * seed) % 11) as f64).collect()
    };
    let load = SurfaceLoad { pressure: field(3), traction_x: field(7), traction_y: field(5) };
    let other = SubsurfaceStress::of_load(turned, load, Side::Rail, 0.3).unwrap();
    for [x, y, z] in [[1e-4, 2e-4, 1e-3], [4e-3, -3e-3, 2e-3]] {
        let Stress { xx, yy, zz, xy, xz, yz } = other.at([y, x], z);
        let back = Stress { xx: yy, yy: xx, zz, xy, xz: yz, yz: xz };
        assert!(difference(&body.at([x, y], z), &back) < 1e-6);
    }
}

/// FASTSIM bounds the traction by a paraboloid, but presses with the pressure of the contact.
#[test]
fn fastsim_presses_as_the_contact_does() {
    let problem = ellipse([6e-3, 4e-3], 0.28, 0.0);
    let method = Method::Fast(FastMethod::Fastsim(Brush::KALKER));
    let solution = method.solver(&cells(16)).solve(&problem, &unwatched).unwrap();
    let fast = SubsurfaceStress::new(&problem, &solution, Side::Rail).unwrap();
    let full = below(&problem, 16, Side::Rail);
    for place in [[0.0, 0.0], [3e-3, 1e-3], [-5e-3, -2e-3]] {
        for depth in [0.0, 5e-4, 3e-3] {
            let [one, other] = [&fast, &full].map(|body| body.at(place, depth));
            assert!(difference(&one, &other) < 1e-9 * P0, "{place:?}, {depth}");
        }
    }
}

/// Vertical planes through layers have the stresses at their points, and between two rows of points
/// the mean of both.
#[test]
fn sections_are_vertical_planes() {
    let body = below(&ellipse([6e-3, 4e-3], 0.28, 0.002), 12, Side::Rail);
    let (depths, margins) = ([1e-3, 2e-3], [2, 3]);
    let volume = body.volume(&depths, margins, &unwatched).unwrap();
    let (columns, rows) = (volume.grid.columns, volume.grid.rows);
    let [x, y] = [volume.grid.x(columns / 3), volume.grid.y(rows / 4)];
    let across = volume.section(Plane::AcrossRolling { x });
    let along = volume.section(Plane::AlongRolling { y: y + 0.5 * volume.grid.spacing_y });
    for (layer, depth) in depths.into_iter().enumerate() {
        assert_eq!((across[layer].len(), along[layer].len()), (rows, columns));
        for (row, found) in across[layer].iter().enumerate() {
            let there = body.at([x, volume.grid.y(row)], depth);
            assert!(difference(found, &there) < 1e-6 * P0, "{depth} {row}");
        }
        for (column, found) in along[layer].iter().enumerate() {
            let beside = [y, y + volume.grid.spacing_y];
            let [one, other] = beside.map(|y| body.at([volume.grid.x(column), y], depth));
            let middle = one * 0.5 + other * 0.5;
            assert!(difference(found, &middle) < 1e-6 * P0, "{depth} {column}");
        }
    }
}

/// Goal: the resultant of σzz over a plane below is the load: what misses beyond the plane falls
/// with the cube of its width.
#[test]
fn a_plane_below_carries_the_load() {
    let problem = ellipse([6e-3, 3e-3], 0.28, 0.002);
    let solution = solve(&problem, 16);
    let body = SubsurfaceStress::new(&problem, &solution, Side::Rail).unwrap();
    let layer = body.layer(2e-3, [50, 100]);
    let sum: f64 = layer.stress.iter().map(|stress| stress.zz).sum();
    let found = -sum * body.grid().cell_area();
    assert!((found / solution.normal.load - 1.0).abs() < 1e-3, "{found}");
}

/// Loads of another number than cells, loads that are not finite, and methods without fields are
/// refused.
#[test]
fn what_has_no_stresses_is_refused() {
    let grid = Grid::across(&Extent { x: [-1e-3, 1e-3], y: [-1e-3, 1e-3] }, 2, 2);
    let load = |count: usize, value: f64| SurfaceLoad {
        pressure: vec![1e6; grid.len()],
        traction_x: vec![value; count],
        traction_y: vec![0.0; grid.len()],
    };
    let refused =
        |load: SurfaceLoad| SubsurfaceStress::of_load(grid, load, Side::Rail, 0.3).unwrap_err();
    assert!(matches!(refused(load(3, 0.0)), Error::WrongCount { expected: 12, count: 3, .. }));
    assert!(matches!(refused(load(12, f64::NAN)), Error::Invalid { .. }));
    let problem = ellipse([6e-3, 6e-3], 0.28, 0.001);
    let method = Method::Fast(FastMethod::KalkerLinear);
    let solution = method.solver(&cells(10)).solve(&problem, &unwatched).unwrap();
    let error = SubsurfaceStress::new(&problem, &solution, Side::Rail).unwrap_err();
    assert!(error.to_string().contains("kalker-linear"), "{error}");
}
