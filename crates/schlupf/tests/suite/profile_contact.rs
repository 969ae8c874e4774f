//! Normal contact from the shape of both bodies, against closed forms: Hertz, Steuermann,
//! Boussinesq.

use crate::common::{cells, half_space, problem, rolling};
use approx::assert_relative_eq;
use schlupf::elasticity::Winkler;
use schlupf::normal::patch::Patch;
use schlupf::normal::profile::{Profile, UndeformedDistance, relative_radius};
use schlupf::normal::{Grid, Hertz, Line, NormalSummary, PressureSource, Radii};
use schlupf::problem::{Brush, FastMethod, TractionBound};
use schlupf::solver::simplified::FastContact;
use schlupf::{Options, Quantity, Solution, unwatched};
use std::f64::consts::PI;
use std::sync::Arc;

const MODULUS: f64 = 115e9;
const CELLS: usize = Profile::DEFAULT_CELLS;

fn line(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..count).map(|k| from + (to - from) * k as f64 / (count - 1) as f64).collect()
}

/// d(y) every half millimetre from −50 to 50 mm, rolling with the radius R (in m).
fn across(radius: f64, distance: impl Fn(f64) -> f64) -> UndeformedDistance {
    let y = line(-0.05, 0.05, 201);
    let values = y.iter().map(|y| distance(*y)).collect();
    UndeformedDistance::across(y, values, radius).unwrap()
}

/// h(x, y) every millimetre on ±`half` (in m).
fn on_lattice(half: f64, distance: impl Fn(f64, f64) -> f64) -> UndeformedDistance {
    let side = line(-half, half, 1 + (2e3 * half).round() as usize);
    let values = side.iter().flat_map(|y| side.iter().map(|x| distance(*x, *y))).collect();
    UndeformedDistance::on_lattice(side.clone(), side.clone(), values).unwrap()
}

fn pressed(distance: UndeformedDistance, load: f64) -> Profile {
    Profile::new(distance, MODULUS, load, CELLS).unwrap()
}

fn summary(source: &dyn PressureSource) -> NormalSummary {
    source.normal_contact(None).unwrap().summary
}

fn hertz(radii: [f64; 2], load: f64) -> Hertz {
    Hertz::from_curvatures(0.5 / radii[0], 0.5 / radii[1], MODULUS, load).unwrap()
}

fn assert_hertzian(found: &NormalSummary, exact: &NormalSummary) {
    assert_relative_eq!(found.semi_axis_x, exact.semi_axis_x, max_relative = 3e-3);
    assert_relative_eq!(found.semi_axis_y, exact.semi_axis_y, max_relative = 3e-3);
    assert_relative_eq!(found.peak_pressure, exact.peak_pressure, max_relative = 2e-4);
    let [approach, expected] = [found, exact].map(|summary| summary.approach.unwrap());
    assert_relative_eq!(approach, expected, max_relative = 2e-4);
    assert_eq!(found.parts, 1);
}

/// Goal: a parabolic distance gives Hertz's contact, sizes to 0.3 %, pressure and approach to 0.02
/// %. Set-up: relative radii from round to slender patches and lines across, two loads; the
/// distance on a lattice or across alone, off the middle, where a patch is not in the middle of the
/// points. Source: Hertz 1882 through Carlson's integrals.
#[test]
fn hertz_1882_from_the_distance() {
    for radii in [[0.46, 0.3], [0.46, 0.08], [0.46, 2.0], [0.46, 0.013]] {
        for load in [10e3, 80e3] {
            let exact = summary(&hertz(radii, load));
            let profile = across(radii[0], |y| 0.5 * (y - 1.23e-3).powi(2) / radii[1] + 7e-3);
            let found = summary(&pressed(profile, load));
            assert_hertzian(&found, &exact);
            let [x, y] = found.origin.unwrap();
            assert_relative_eq!(x, 0.0, epsilon = 1e-12);
            assert_relative_eq!(y, 1.23e-3, epsilon = 5e-3 * exact.semi_axis_y);
            let (x0, y0) = (-2.1e-3, 0.4e-3);
            let field = on_lattice(0.03, |x, y| {
                0.5 * (x - x0).powi(2) / radii[0] + 0.5 * (y - y0).powi(2) / radii[1]
            });
            let found = summary(&pressed(field, load));
            assert_hertzian(&found, &exact);
            assert_relative_eq!(found.origin.unwrap()[0], x0, epsilon = 5e-3 * exact.semi_axis_x);
        }
    }
}

fn steady(normal: Arc<dyn PressureSource>, creepages: [f64; 3]) -> Solution {
    let [xi, eta, phi] = creepages;
    let problem = schlupf::Problem { normal, ..problem(rolling(xi, eta, phi)) }
        .with_interface(|interface| interface.elasticity = half_space());
    schlupf::solver::solve(&problem, &cells(40), &unwatched).unwrap()
}

/// Goal: creep forces of that contact are those of Hertz's to 0.5 %. Set-up: half-space, 40 cells
/// each way; longitudinal, lateral, spin, all together, from both kinds of distance.
#[test]
fn hertz_1882_creep_forces_from_the_distance() {
    let (radii, load) = ([0.46, 0.3], 80e3);
    let elliptic: Arc<dyn PressureSource> = Arc::new(hertz(radii, load));
    let line = across(radii[0], |y| 0.5 * y * y / radii[1]);
    let field = on_lattice(0.03, |x, y| 0.5 * x * x / radii[0] + 0.5 * y * y / radii[1]);
    let sources = [line, field].map(|distance| Arc::new(pressed(distance, load)));
    for creepages in [
        [0.001, 0.0, 0.0],
        [0.0, 0.002, 0.0],
        [0.0, 0.0, 0.5],
        [0.001, 0.0005, 0.3],
        [0.02, 0.0, 0.0],
    ] {
        let exact = steady(Arc::clone(&elliptic), creepages);
        for source in &sources {
            let found = steady(Arc::<Profile>::clone(source), creepages);
            let scale = exact.normalised.x.hypot(exact.normalised.y);
            println!("{creepages:?}: {:?} {:?}", exact.normalised, found.normalised);
            let tolerance = 5e-3 * scale;
            assert_relative_eq!(found.normalised.x, exact.normalised.x, epsilon = tolerance);
            assert_relative_eq!(found.normalised.y, exact.normalised.y, epsilon = tolerance);
            let [moment, expected] =
                [&found, &exact].map(|solution| solution.normalised.moment_z.unwrap());
            assert_relative_eq!(moment, expected, epsilon = 5e-3 * expected.abs().max(0.02));
        }
    }
}

/// Goal: a contact that is not Hertz's: bodies of revolution of fourth order, h = A r⁴,
/// N = (64/15) A a⁵ E*, δ = (8/3) A a⁴.
/// Source: Steuermann 1939; Johnson 1985, §5.3, with n = 2.
#[test]
fn steuermann_1939_fourth_order() {
    let (coefficient, a) = (50.0, 8e-3_f64);
    let load = 64.0 / 15.0 * coefficient * a.powi(5) * MODULUS;
    let field = on_lattice(0.025, |x, y| coefficient * x.hypot(y).powi(4));
    let found = summary(&pressed(field, load));
    assert_relative_eq!(found.semi_axis_x, a, max_relative = 3e-3);
    assert_relative_eq!(found.semi_axis_y, a, max_relative = 3e-3);
    let approach = 8.0 / 3.0 * coefficient * a.powi(4);
    assert_relative_eq!(found.approach.unwrap(), approach, max_relative = 2e-3);
}

/// Loads of two Hertzian contacts that share one, the second being `lower` (in m) farther apart,
/// and their common approach: each sinks by its own approach and by N/(πE* d) under the other.
fn shared(load: f64, [first, second]: [[f64; 2]; 2], lower: f64, apart: f64) -> ([f64; 2], f64) {
    let sinks = |radii: [f64; 2], own: f64, other: f64| {
        summary(&hertz(radii, own)).approach.unwrap() + other / (PI * MODULUS * apart)
    };
    let (mut low, mut high) = (0.5 * load, load);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let rest = load - middle;
        if sinks(first, middle, rest) > sinks(second, rest, middle) + lower {
            high = middle;
        } else {
            low = middle;
        }
    }
    ([low, load - low], sinks(first, low, load - low))
}

/// Goal: two patches, their loads, places and forces. Set-up: arcs across of 80 mm and 40 mm
/// relative radius 40 mm apart, the second 10 µm lower; a Winkler bedding, which does not couple
/// them. Source: Hertz 1882 for each, Boussinesq 1885 for what one does to the other.
#[test]
fn boussinesq_1885_two_patches_share_the_load() {
    let (load, lower, apart) = (60e3, 10e-6, 40e-3);
    let radii = [[0.46, 0.08], [0.46, 0.04]];
    let arc = |y: f64, k: usize| 0.5 * y * y / radii[k][1];
    let distance =
        across(radii[0][0], |y| arc(y + 0.5 * apart, 0).min(arc(y - 0.5 * apart, 1) + lower));
    let profile = pressed(distance, load);
    let contact = profile.normal_contact(None).unwrap();
    let (loads, approach) = shared(load, radii, lower, apart);
    let exact = [0, 1].map(|k| summary(&hertz(radii[k], loads[k])));
    assert_eq!(contact.summary.parts, 2);
    assert_relative_eq!(contact.summary.approach.unwrap(), approach, max_relative = 2e-3);
    let peak = exact[0].peak_pressure.max(exact[1].peak_pressure);
    assert_relative_eq!(contact.summary.peak_pressure, peak, max_relative = 3e-3);
    let width = apart + exact[0].semi_axis_y + exact[1].semi_axis_y;
    assert_relative_eq!(2.0 * contact.summary.semi_axis_y, width, max_relative = 1e-3);
    let patch = Patch::new(&contact, Grid::across(&contact.extent(), 24, 120));
    let carried: f64 =
        patch.cells.iter().filter(|cell| cell.y < 0.0).map(|cell| cell.pressure).sum();
    assert_relative_eq!(carried * patch.grid.cell_area(), loads[0], max_relative = 3e-3);
    assert_forces_add_up(Arc::new(profile), radii, loads);
}

/// Without coupling and spin two patches have the forces of both together.
fn assert_forces_add_up(both: Arc<dyn PressureSource>, radii: [[f64; 2]; 2], loads: [f64; 2]) {
    let force = |normal: Arc<dyn PressureSource>, cells_y: usize| {
        let problem = schlupf::Problem { normal, ..problem(rolling(0.001, 0.0005, 0.0)) }
            .with_interface(|interface| {
                interface.elasticity = Arc::new(Winkler::new(2e13, 2e13).unwrap());
            });
        let options = Options { cells_x: 40, cells_y, ..Options::default() };
        let force = schlupf::solver::solve(&problem, &options, &unwatched).unwrap().force;
        [force.x, force.y]
    };
    let alone = [0, 1].map(|k| force(Arc::new(hertz(radii[k], loads[k])), 40));
    let together = force(both, 200);
    for c in 0..2 {
        assert_relative_eq!(together[c], alone[0][c] + alone[1][c], max_relative = 5e-3);
    }
}

/// Goal: a distance at few points, and a pressure that no steel stands, are told with the results.
#[test]
fn doubtful_profiles_are_told() {
    let warnings = |points: usize, load: f64| {
        let y = line(-0.02, 0.02, points);
        let distance = y.iter().map(|y| 0.5 * y * y / 0.1).collect();
        let distance = UndeformedDistance::across(y, distance, 0.46).unwrap();
        steady(Arc::new(pressed(distance, load)), [0.001, 0.0, 0.0])
            .warnings
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join("\n")
    };
    assert_eq!(warnings(81, 60e3), "");
    let few = warnings(11, 60e3);
    assert!(
        few.contains("undeformed_distance: the distance is given at 1 point across the patch"),
        "{few}"
    );
    let hard = warnings(81, 3e6);
    assert!(hard.contains("check load and radii and their units"), "{hard}");
}

/// Goal: a small patch beside a large one is found although a coarse look sees one cell of it, or
/// nothing.
#[test]
fn a_small_second_patch_is_found() {
    let (load, apart) = (60e3, 60e-3);
    let radii = [[0.46, 0.3], [0.46, 0.005]];
    for share in [0.97, 0.995] {
        // As much lower that it carries the rest.
        let own = [share * load, (1.0 - share) * load];
        let sinks = [0, 1].map(|k| {
            let alone = summary(&hertz(radii[k], own[k])).approach.unwrap();
            alone + own[1 - k] / (PI * MODULUS * apart)
        });
        let lower = sinks[0] - sinks[1];
        let y = line(-0.02, 0.07, 361);
        let arc = |y: f64, k: usize| 0.5 * y * y / radii[k][1];
        let values = y.iter().map(|y| arc(*y, 0).min(arc(y - apart, 1) + lower)).collect();
        let distance = UndeformedDistance::across(y, values, 0.46).unwrap();
        let found = summary(&pressed(distance, load));
        assert_eq!(found.parts, 2);
        let large = summary(&hertz(radii[0], own[0])).semi_axis_y;
        assert_relative_eq!(2.0 * found.semi_axis_y, apart + large, max_relative = 2e-2);
    }
}

/// Another load is another patch around the same origin; coming back to a load solves nothing.
#[test]
fn the_origin_stays_when_the_load_changes() {
    // Steeper on one side, so that the patch grows towards the other.
    let distance = across(0.46, |y| 0.5 * y * y / if y < 0.0 { 0.08 } else { 0.3 });
    let profile = pressed(distance, 60e3);
    let full = profile.normal_contact(None).unwrap();
    let light = profile.normal_contact(Some(20e3)).unwrap();
    assert_eq!(full.summary.origin, light.summary.origin);
    let (outer, inner) = (full.extent(), light.extent());
    assert!(outer.y[0] < inner.y[0] && inner.y[1] < outer.y[1]);
    assert!((inner.y[0] + inner.y[1]).abs() > 0.05 * inner.y[1], "{inner:?}");
    assert_relative_eq!(outer.y[0], -outer.y[1], max_relative = 1e-9);
    // The lowest point of the distance stays where it is.
    let origin = full.summary.origin.unwrap();
    assert!(inner.y[0] < -origin[1] && -origin[1] < inner.y[1]);
    let again = profile.normal_contact(None).unwrap();
    assert_eq!(again.summary, full.summary);
}

/// Whoever asks for the derivative by the load gets none, and all others.
#[test]
fn there_is_no_derivative_by_the_load() {
    let profile = pressed(across(0.46, |y| 0.5 * y * y / 0.3), 60e3);
    assert_eq!(profile.load_exponent(), None);
    let problem =
        schlupf::Problem { normal: Arc::new(profile), ..problem(rolling(0.001, 0.0, 0.0)) }
            .with_interface(|interface| interface.elasticity = half_space());
    let options = Options { sensitivity: true, ..cells(16) };
    let solution = schlupf::solver::solve(&problem, &options, &unwatched).unwrap();
    let sensitivity = solution.sensitivity.unwrap();
    assert!(sensitivity.load.is_none() && sensitivity.creepage_x.x < 0.0);
}

/// A fast contact that takes over another load has the patch of that load.
#[test]
fn a_fast_contact_follows_the_load_of_a_profile() {
    let shape = || across(0.46, |y| 0.5 * y * y / if y < 0.0 { 0.08 } else { 0.3 });
    let problem = |normal: Profile| schlupf::Problem {
        normal: Arc::new(normal),
        ..problem(rolling(0.001, 0.0005, 0.1))
    };
    let motion = rolling(0.002, 0.0, 0.0);
    let brush = Brush { bound: TractionBound::Elliptic, ..Brush::KALKER };
    for method in [FastMethod::KalkerLinear, FastMethod::Fastsim(brush)] {
        let of = |load: f64| {
            FastContact::new(&problem(pressed(shape(), load)), method.clone(), &cells(20)).unwrap()
        };
        let mut contact = of(60e3);
        contact.set_load(30e3).unwrap();
        let force = contact.force(&motion).unwrap();
        let fresh = of(30e3).force(&motion).unwrap();
        assert_relative_eq!(force.x, fresh.x, max_relative = 1e-6);
    }
}

/// What has no contact within the points that are given is refused, with the place.
#[test]
fn a_contact_that_runs_out_of_the_distance_is_refused() {
    let refuse = |distance: UndeformedDistance| {
        let error = pressed(distance, 80e3).normal_contact(None).unwrap_err();
        assert!(error.quantity() == Quantity::UndeformedDistance, "{error}");
        error.to_string()
    };
    let short = |from: f64, to: f64| {
        let y = line(from, to, 41);
        let values = y.iter().map(|y| 0.5 * y * y / 0.3).collect();
        UndeformedDistance::across(y, values, 0.46).unwrap()
    };
    let message = refuse(short(-2e-3, 0.03));
    assert!(message.contains("reaches the edge") && message.contains("y = -2.0"), "{message}");
    assert!(refuse(short(1e-3, 0.03)).contains("y = 1.0"));
    assert!(refuse(across(0.46, |_| 1e-3)).contains("reaches the edge"));
    assert!(refuse(across(0.46, |y| -y * y)).contains("wheel minus rail"));
    assert!(refuse(on_lattice(4e-3, |x, y| x * x + y * y)).contains("reaches the edge"));
    let huge = pressed(across(0.46, |y| y * y), 1e9).normal_contact(None).unwrap_err();
    assert!(huge.to_string().contains("reaches the edge"), "{huge}");
}

/// Rolling bodies that do not close up along rolling, and legal ones.
#[test]
fn the_relative_radius_follows_from_both_bodies() {
    assert_relative_eq!(relative_radius([0.46, f64::INFINITY]).unwrap(), 0.46);
    assert_relative_eq!(relative_radius([0.5, 0.5]).unwrap(), 0.25);
    let flat = relative_radius([f64::INFINITY; 2]).unwrap_err().to_string();
    assert!(flat.contains("wheel_radius_x") && flat.contains("zero"), "{flat}");
    let groove = relative_radius([0.5, -0.4]).unwrap_err().to_string();
    assert!(groove.contains("must be positive"), "{groove}");
}

/// Goal: an approach in place of a load is the same contact: that of Hertz by its closed form, and
/// that of any distance at the approach found under a load, with its load to 10⁻⁴ and its sizes to
/// the accuracy of cells. Set-up: steel; a parabola and two patches across, a fourth power on a
/// lattice. Source: Hertz 1882.
#[test]
fn hertz_1882_by_approach() {
    let load = 80e3;
    let exact = summary(&hertz([0.46, 0.3], load));
    let approach = exact.approach.unwrap();
    let flat = Radii { x: f64::INFINITY, y: f64::INFINITY };
    let found = Hertz::from_approach(Radii { x: 0.46, y: 0.3 }, flat, MODULUS, approach).unwrap();
    assert_relative_eq!(summary(&found).load, load, max_relative = 1e-12);
    let parabola = |y: f64| y * y / (2.0 * 0.3);
    let found = Profile::from_approach(across(0.46, parabola), MODULUS, approach, CELLS).unwrap();
    assert_relative_eq!(summary(&found).load, load, max_relative = 3e-4);
    assert_hertzian(&summary(&found), &exact);

    let arcs = |y: f64| {
        let arc = |middle: f64, radius: f64| (y - middle).powi(2) / (2.0 * radius);
        arc(-0.02, 0.08).min(arc(0.02, 0.04) + 10e-6)
    };
    for distance in [
        across(0.46, parabola),
        across(0.46, arcs),
        on_lattice(0.02, |x, y| (x * x + y * y).powi(2) * 1e3),
    ] {
        let by_load = summary(&pressed(distance.clone(), load));
        let approach = by_load.approach.unwrap();
        let source = Profile::from_approach(distance, MODULUS, approach, CELLS).unwrap();
        let found = summary(&source);
        assert_eq!((found.approach, found.parts), (Some(approach), by_load.parts));
        assert_relative_eq!(found.load, load, max_relative = 1e-4);
        assert_relative_eq!(found.peak_pressure, by_load.peak_pressure, max_relative = 1e-3);
        assert_relative_eq!(found.semi_axis_x, by_load.semi_axis_x, max_relative = 3e-3);
        assert_relative_eq!(found.semi_axis_y, by_load.semi_axis_y, max_relative = 3e-3);
        // Under that load it is the same contact, about the same origin.
        let again = source.normal_contact(Some(found.load)).unwrap().summary;
        assert_eq!(again, found);
    }
}

/// Goal: a distance along x on a length is the line contact of its closed form, by load and by
/// approach; two cylinders side by side share the load; and the ends of the points are refused.
/// Set-up: R = 0.5 m on 200 mm, every 20 µm. Source: Hertz 1882, [`Line`].
#[test]
fn hertz_1882_line_contact_from_the_distance() {
    let (radius, length, load) = (0.5, 0.2, 35.78e3);
    let x = line(-4e-3, 4e-3, 401);
    let of = |distance: &dyn Fn(f64) -> f64| {
        UndeformedDistance::along(x.clone(), x.iter().map(|x| distance(*x)).collect(), length)
    };
    let cylinder = |x: f64| x * x / (2.0 * radius);
    let exact = summary(&Line::new([radius, f64::INFINITY], length, MODULUS, load).unwrap());
    let off = of(&|x| cylinder(x - 1e-3)).unwrap();
    let found = summary(&pressed(off.clone(), load));
    assert_hertzian(&found, &exact);
    assert_relative_eq!(found.origin.unwrap()[0], 1e-3, max_relative = 1e-3);
    let approach = exact.approach.unwrap();
    let by_approach = Profile::from_approach(off, MODULUS, approach, CELLS).unwrap();
    assert_relative_eq!(summary(&by_approach).load, load, max_relative = 3e-4);

    let two = of(&|x| cylinder(x.abs() - 2e-3)).unwrap();
    let found = pressed(two, load).normal_contact(None).unwrap();
    assert_eq!(found.summary.parts, 2);
    let patch = Patch::new(&found, Grid::across(&found.extent(), 60, 1));
    assert_eq!(patch.strips.len(), 2);
    assert_relative_eq!(patch.load(), load, max_relative = 1e-9);

    let error = pressed(of(&|x| -cylinder(x)).unwrap(), load).normal_contact(None).unwrap_err();
    assert!(error.to_string().contains("reaches the edge of the given distance"), "{error}");
}
