//! Normal contact of bodies of any shape, against closed forms and published numbers.

use approx::assert_relative_eq;
use schlupf::normal::rough_contact::{
    Boundary, RoughContact, RoughContactOptions, RoughContactSolution,
};
use schlupf::normal::{Hertz, PressureSource};
use schlupf::solver::reference::Westergaard;
use schlupf::surface::synthesis::{Roughness, SelfAffine};
use schlupf::surface::{HeightMap, Lattice};
use schlupf::unwatched;
use std::f64::consts::{PI, TAU};

const MODULUS: f64 = 115e9;

fn solve(contact: &mut RoughContact, load: f64) -> RoughContactSolution {
    let solution = contact.solve(load, &RoughContactOptions::default(), &unwatched).unwrap();
    assert!(solution.is_converged, "{} {}", solution.residual, solution.iterations);
    let area = contact.distance().lattice().cell_area();
    let carried: f64 = solution.pressure.iter().map(|pressure| pressure * area).sum();
    assert_relative_eq!(carried, load, max_relative = 1e-12);
    assert!(solution.pressure.iter().all(|pressure| *pressure >= 0.0));
    solution
}

fn paraboloid(lattice: Lattice, curvatures: [f64; 2]) -> HeightMap {
    let [a, b] = curvatures;
    HeightMap::from_fn(lattice, |x, y| a * x * x + b * y * y).unwrap()
}

/// Goal: Hertz contact of a sphere and of an ellipse of a/b near 2, alone on the half-space.
/// Set-up: undeformed distance A x² + B y² on 128² cells, some 85 of them across the contact.
/// Source: Hertz 1882 through Carlson's integrals.
#[test]
fn hertz_1882_sphere_and_ellipsoid() {
    for curvatures in [[1.0, 1.0], [0.6, 1.8]] {
        let load = 80e3;
        let hertz = Hertz::from_curvatures(curvatures[0], curvatures[1], MODULUS, load).unwrap();
        let exact = hertz.normal_contact(None).unwrap().summary;
        let side = 1.5 * 2.0 * exact.semi_axis_x.max(exact.semi_axis_y);
        let lattice = Lattice::square(128, side);
        let distance = paraboloid(lattice, curvatures);
        let mut contact = RoughContact::new(distance, MODULUS, Boundary::Free).unwrap();
        let solution = solve(&mut contact, load);
        let peak = solution.pressure.iter().copied().fold(0.0, f64::max);
        assert_relative_eq!(peak, exact.peak_pressure, max_relative = 2e-3);
        assert_relative_eq!(solution.approach, exact.approach.unwrap(), max_relative = 1e-3);
        let area = PI * exact.semi_axis_x * exact.semi_axis_y;
        assert_relative_eq!(solution.corrected_contact_area, area, max_relative = 1e-2);
        let (mut error, mut squares) = (0.0, 0.0);
        for ([x, y], pressure) in lattice.points().zip(&solution.pressure) {
            let dome = 1.0 - (x / exact.semi_axis_x).powi(2) - (y / exact.semi_axis_y).powi(2);
            let expected = exact.peak_pressure * dome.max(0.0).sqrt();
            error += (pressure - expected).powi(2);
            squares += expected * expected;
        }
        let error = (error / squares).sqrt();
        println!("{curvatures:?}: {} iterations, pressure {error:.5}", solution.iterations);
        assert!(error < 0.01, "{error}");
        assert!(!solution.touches_edge && solution.iterations <= 14, "{}", solution.iterations);
    }
}

/// Goal: a contact of a wave against a flat, width and pressure to 1 % and better.
/// Set-up: 2048 cells along the wave, periodic, loads from light to nearly full contact.
/// Source: Westergaard 1939.
#[test]
fn westergaard_1939_wave() {
    let wave = Westergaard { amplitude: 1e-7, wavelength: 1e-4, contact_modulus: MODULUS };
    let lattice = Lattice { columns: 2048, rows: 2, spacing_x: 1e-4 / 2048.0, spacing_y: 2e-7 };
    let height = |x: f64, _: f64| wave.amplitude * (1.0 - (TAU * x / wave.wavelength).cos());
    let distance = HeightMap::from_fn(lattice, height).unwrap();
    let mut contact = RoughContact::new(distance, MODULUS, Boundary::Periodic).unwrap();
    for share in [0.05, 0.2, 0.5, 0.8] {
        let mean = share * wave.closing_pressure();
        let solution = solve(&mut contact, mean * lattice.area());
        let fraction = solution.contact_area / lattice.area();
        assert_relative_eq!(fraction, wave.contact_fraction(mean), max_relative = 0.01);
        let peak = wave.pressure(mean, 0.0);
        for ([x, _], pressure) in lattice.points().zip(&solution.pressure) {
            assert_relative_eq!(*pressure, wave.pressure(mean, x), epsilon = 0.01 * peak);
        }
        println!("p/p* = {share}: {} iterations", solution.iterations);
        assert!(solution.iterations <= 17, "{}", solution.iterations);
    }
}

/// Goal: full contact is linear, p = p̄ + p* cos cos with p* = √2 π E*Δ/λ, and opens below p*.
/// Source: Johnson, Greenwood and Higginson 1985, Eq. 8.
#[test]
fn johnson_greenwood_higginson_1985_full_contact() {
    let (amplitude, wavelength) = (1e-7, 1e-4);
    let lattice = Lattice::square(64, wavelength);
    let wave = |x: f64, y: f64| (TAU * x / wavelength).cos() * (TAU * y / wavelength).cos();
    let distance = HeightMap::from_fn(lattice, |x, y| amplitude * (1.0 - wave(x, y))).unwrap();
    let mut contact = RoughContact::new(distance, MODULUS, Boundary::Periodic).unwrap();
    let closing = 2.0_f64.sqrt() * PI * MODULUS * amplitude / wavelength;
    let full = solve(&mut contact, 1.01 * closing * lattice.area());
    assert_relative_eq!(full.contact_area, lattice.area());
    for ([x, y], pressure) in lattice.points().zip(&full.pressure) {
        let expected = closing * (1.01 + wave(x, y));
        assert_relative_eq!(*pressure, expected, epsilon = 1e-5 * closing);
    }
    // Almost closed: the open part is 3/(2π) (1 − p̄/p*) of the area (their Eq. 15).
    let nearly = solve(&mut contact, 0.9 * closing * lattice.area());
    let open = 1.0 - nearly.corrected_contact_area / lattice.area();
    assert_relative_eq!(open, 3.0 / TAU * 0.1, max_relative = 0.15);
}

/// Goal: contact area and largest pressure of a two-dimensional wave under a light load: every
/// crest is in contact like a sphere by itself. Set-up: 1024² cells, h = Δ (1 − cos cos) with two
/// crests of radius λ²/(4π²Δ) a period, 0.02 % of the closing pressure; spots of some 21 cells
/// radius. Source: Johnson, Greenwood and Higginson 1985, Eq. 13; Hertz 1882.
#[test]
fn johnson_greenwood_higginson_1985_light_load() {
    let (amplitude, wavelength) = (1e-7, 1e-4);
    let lattice = Lattice::square(1024, wavelength);
    let wave = |x: f64, y: f64| (TAU * x / wavelength).cos() * (TAU * y / wavelength).cos();
    let distance = HeightMap::from_fn(lattice, |x, y| amplitude * (1.0 - wave(x, y))).unwrap();
    let mut contact = RoughContact::new(distance, MODULUS, Boundary::Periodic).unwrap();
    let closing = 2.0_f64.sqrt() * PI * MODULUS * amplitude / wavelength;
    let solution = solve(&mut contact, 2e-4 * closing * lattice.area());
    let load = 0.5 * solution.load;
    let radius = wavelength * wavelength / (TAU * TAU * amplitude);
    let spot = (0.75 * load * radius / MODULUS).cbrt();
    let expected = 2.0 * PI * spot * spot;
    println!("A/A Hertz = {}", solution.corrected_contact_area / expected);
    assert_relative_eq!(solution.corrected_contact_area, expected, max_relative = 0.01);
    let peak = solution.pressure.iter().copied().fold(0.0, f64::max);
    assert_relative_eq!(peak, 1.5 * load / (PI * spot * spot), max_relative = 0.01);
}

/// A rough surface of the tests: E* and h'_rms of one.
fn rough(cells: usize, seed: u64) -> HeightMap {
    let spectrum = SelfAffine {
        roughness: Roughness::Gradient(0.1),
        hurst_exponent: 0.8,
        longest_wavelength: 0.125e-3,
        roll_off_wavelength: 0.125e-3,
        shortest_wavelength: 8e-3 / cells as f64,
    };
    spectrum.surface(Lattice::square(cells, 1e-3), seed).unwrap()
}

/// Goal: κ = (A/A₀) E* h'_rms/p̄ of randomly rough surfaces, from 4 to 10 % of contact. Set-up:
/// Hurst exponent 0.8, wavelengths from an eighth of the side (longer ones make pieces of their own
/// of a surface) to 8 cells, 512² cells, five seeds, three loads. Source: Hyun et al. 2004 and
/// Persson et al. 2005: κ from 2.2 to 2.5 without correction of the area; Yastrebov, Anciaux and
/// Molinari 2015, 2017: 2.1 to 2.35 with it.
#[test]
fn yastrebov_2015_area_of_rough_surfaces() {
    let pressures = [0.018, 0.03, 0.042];
    let mut means = [[0.0; 2]; 3];
    let mut fractions = [0.0; 3];
    for seed in 1..=5 {
        let distance = rough(512, seed).distance_to_plane();
        let mut contact = RoughContact::new(distance, MODULUS, Boundary::Periodic).unwrap();
        for (k, pressure) in pressures.into_iter().enumerate() {
            let area = contact.distance().lattice().area();
            let solution = solve(&mut contact, pressure * 0.1 * MODULUS * area);
            let fraction = solution.contact_area / area;
            means[k][0] += fraction / pressure / 5.0;
            means[k][1] += solution.corrected_contact_area / area / pressure / 5.0;
            fractions[k] += fraction / 5.0;
            assert!(solution.iterations <= 30, "{}", solution.iterations);
        }
    }
    for ([plain, corrected], fraction) in means.into_iter().zip(fractions) {
        println!("A/A₀ = {fraction:.4}: κ = {plain:.3}, corrected {corrected:.3}");
        assert!((0.04..=0.1).contains(&fraction), "{fraction}");
        assert!((2.2..=2.5).contains(&plain), "{plain}");
        assert!((2.1..=2.35).contains(&corrected), "{corrected}");
    }
}

/// Goal: iterations hardly grow with the grid, nor the load's place between light and full contact.
#[test]
fn iterations_hardly_grow_with_the_grid() {
    for (cells, limit) in [(128, 22), (256, 26)] {
        for pressure in [1e-3, 1e-2, 0.1, 0.4] {
            let distance = rough(cells, 3).distance_to_plane();
            let mut contact = RoughContact::new(distance, MODULUS, Boundary::Periodic).unwrap();
            let area = contact.distance().lattice().area();
            let solution = solve(&mut contact, pressure * 0.1 * MODULUS * area);
            println!("{cells}, {pressure}: {} iterations", solution.iterations);
            assert!(solution.iterations <= limit, "{}", solution.iterations);
        }
    }
}

/// Goal: under a hardness the pressure stays below it and the load is carried; where it yields gap
/// is not positive; with all of the contact yielding the area is N/H.
/// Source: Bowden and Tabor 1939: A = N/H.
#[test]
fn bowden_tabor_1939_soft_material() {
    let distance = rough(128, 1).distance_to_plane();
    let area = distance.lattice().area();
    let load = 0.03 * 0.1 * MODULUS * area;
    let elastic = {
        let contact = RoughContact::new(distance.clone(), MODULUS, Boundary::Periodic);
        solve(&mut contact.unwrap(), load)
    };
    for (hardness, share) in [(5e9, 0.02), (2e9, 0.5), (0.5e9, 0.9)] {
        let contact = RoughContact::new(distance.clone(), MODULUS, Boundary::Periodic).unwrap();
        let mut contact = contact.with_hardness(hardness).unwrap();
        let solution = solve(&mut contact, load);
        println!("H = {hardness}: {} iterations", solution.iterations);
        let yielding = solution.plastic_area / solution.contact_area;
        assert!(yielding >= share, "{hardness} {yielding}");
        assert!(solution.contact_area > elastic.contact_area);
        assert!(solution.contact_area >= load / hardness);
        for (pressure, gap) in solution.pressure.iter().zip(&solution.gap) {
            assert!(*pressure <= hardness);
            assert!(*pressure < hardness || *gap <= 1e-12, "{gap}");
        }
        if share > 0.8 {
            assert_relative_eq!(solution.contact_area, load / hardness, max_relative = 0.1);
        }
        assert!(solution.iterations <= 16, "{}", solution.iterations);
    }
}

/// Goal: nothing keeps the iteration from converging: loads that change by orders of magnitude up
/// and down, from a single summit to almost closed or all but yielding, any boundary, any surface.
#[test]
fn every_contact_converges() {
    let mut most = 0;
    for seed in 0..12 {
        let distance = rough(128, seed).resampled(40 + 3 * seed as usize, 50).unwrap();
        let distance = distance.distance_to_plane();
        let area = distance.lattice().area();
        for boundary in [Boundary::Periodic, Boundary::Free] {
            for hardness in [f64::INFINITY, 0.05 * MODULUS] {
                let contact = RoughContact::new(distance.clone(), MODULUS, boundary).unwrap();
                let mut contact = contact.with_hardness(hardness).unwrap();
                for share in [1e-7, 0.3, 1e-4, 1e-2, 0.48, 0.1, 1e-6] {
                    let solution = solve(&mut contact, share * 0.1 * MODULUS * area);
                    most = most.max(solution.iterations);
                }
            }
        }
    }
    println!("at most {most} iterations");
    assert!(most <= 22, "{most}");
}

/// Goal: units and direction do not matter: the transposed surface, lengths in other units.
#[test]
fn scaling_and_transposition_leave_the_contact() {
    let lattice = Lattice { columns: 48, rows: 30, spacing_x: 1e-5, spacing_y: 2e-5 };
    let height = |x: f64, y: f64| 1e-8 * ((3e4 * x).sin() + (2e4 * y + 1e4 * x).cos());
    let turned = Lattice { columns: 30, rows: 48, spacing_x: 2e-2, spacing_y: 1e-2 };
    let first = HeightMap::from_fn(lattice, height).unwrap();
    let second = HeightMap::from_fn(turned, |x, y| 1e3 * height(y * 1e-3, x * 1e-3)).unwrap();
    for boundary in [Boundary::Periodic, Boundary::Free] {
        let [one, two] =
            [(&first, 1.0, 1.0), (&second, 2.0, 1e6)].map(|(surface, modulus, area)| {
                let distance = surface.distance_to_plane();
                let mut contact = RoughContact::new(distance, modulus, boundary).unwrap();
                solve(&mut contact, 1e-11 * area * modulus)
            });
        assert_relative_eq!(one.approach, two.approach * 1e-3, max_relative = 1e-5);
        assert_relative_eq!(one.contact_area, two.contact_area * 1e-6, max_relative = 1e-9);
    }
}

/// Goal: what is not solved says so, and what cannot be is refused.
#[test]
fn honest_about_failure() {
    let distance = rough(64, 1).distance_to_plane();
    let mut contact = RoughContact::new(distance, MODULUS, Boundary::Periodic).unwrap();
    let options = RoughContactOptions { max_iterations: 3, ..RoughContactOptions::default() };
    let solution = contact.press(1e8, &options, &unwatched).unwrap();
    assert!(!solution.is_converged && solution.residual > options.tolerance);
    assert_eq!(solution.iterations, 3);
    let mut contact = contact.with_hardness(5e7).unwrap();
    let message = contact.press(1e8, &options, &unwatched).unwrap_err().to_string();
    assert!(message.contains("load must be positive and below"), "{message}");
    let message = contact.press(f64::NAN, &options, &unwatched).unwrap_err().to_string();
    assert!(message.contains("mean_pressure must be positive"), "{message}");
    let flat = HeightMap::from_fn(Lattice::square(8, 1.0), |_, _| 0.0).unwrap();
    let message = RoughContact::new(flat, MODULUS, Boundary::Periodic).unwrap_err().to_string();
    assert!(message.contains("flat"), "{message}");
}
