//! Equivalent conicity: the wavelength of the nonlinear motion (EN 15302) and harmonic
//! linearisation, from given Δr(y) with closed solutions and from profiles that are cones and arcs.

use std::f64::consts::{FRAC_PI_2, PI};

use schlupf::reporting::WheelRailError;
use std::sync::Arc;

use schlupf::wheel_rail::{
    Deviation, Pair, ProfileCurve, RailShape, Roll, RollingRadiusDifference, Sides, Track,
    WheelShape,
};
use schlupf::{Error, Quantity, unwatched};

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(off <= tolerance, "{what}: {found} instead of {expected}, off by {off:.2e}");
}

/// Δr given at equal steps between two lateral positions, in m.
fn given([from, to]: [f64; 2], difference: impl Fn(f64) -> f64) -> RollingRadiusDifference {
    let steps = 4000;
    let at = |k: i32| from + (to - from) * f64::from(k) / f64::from(steps);
    let lateral: Vec<f64> = (0..=steps).map(at).collect();
    let difference = lateral.iter().map(|y| difference(*y)).collect();
    RollingRadiusDifference { lateral, difference, end: None }
}

fn conicities(radii: &RollingRadiusDifference, amplitude: f64) -> [f64; 2] {
    [
        radii.equivalent_conicity(amplitude).unwrap().unwrap(),
        radii.harmonic_conicity(amplitude).unwrap().unwrap(),
    ]
}

/// Klingel 1883: Δr = 2 y tan γ, of every amplitude the conicity γ, also where the cones of both
/// wheels differ in their offset, so that the motion is about another middle.
#[test]
fn klingel_1883_cones() {
    for offset in [0.0, 0.7e-3, -1.3e-3] {
        let radii = given([-8e-3, 8e-3], |y| 0.1 * (y - offset));
        for amplitude in [1e-4, 1e-3, 3e-3, 6e-3] {
            for found in conicities(&radii, amplitude) {
                close("conicity of a cone", found, 0.05, 1e-9);
            }
        }
    }
    assert!(given([-8e-3, 8e-3], |y| y).equivalent_conicity(8.1e-3).is_err());
}

/// Duffing 1918: y″ + αy + βy³ = 0 has the period 4 K(k)/√(α + βŷ²) with k² = βŷ²/(2α + 2βŷ²); its
/// harmonic linearisation is α + ¾βŷ². Stiffening, and softening (k² < 0).
#[test]
fn duffing_1918_cubic_difference() {
    for (linear, cubic) in [(0.1, 4000.0), (0.1, -1000.0), (0.0, 8000.0)] {
        let radii = given([-8e-3, 8e-3], |y| linear * y + cubic * y.powi(3));
        for amplitude in [1e-3, 4e-3, 7e-3] {
            let [nonlinear, harmonic] = conicities(&radii, amplitude);
            // The chords of the cubic are off by some (4 µm/ŷ)².
            close("by the wavelength", nonlinear / duffing(linear, cubic, amplitude), 1.0, 3e-5);
            let expected = 0.5 * (linear + 0.75 * cubic * amplitude * amplitude);
            close("harmonic", harmonic / expected, 1.0, 3e-5);
        }
    }
}

/// Conicity with the period of Duffing's equation, dimensionless.
fn duffing(linear: f64, cubic: f64, amplitude: f64) -> f64 {
    let square = cubic * amplitude * amplitude;
    let period =
        4.0 * elliptic_integral(0.5 * square / (linear + square)) / (linear + square).sqrt();
    0.5 * (2.0 * PI / period).powi(2)
}

/// Complete elliptic integral K of the squared modulus m < 1, by the arithmetic–geometric mean.
fn elliptic_integral(m: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    FRAC_PI_2 / a
}

/// Cylinders between two cones, as wheels whose flange root comes into contact at a distance d: the
/// wheelset crosses 2d at a constant slope, and the period is 2π/ω + 4d/(ω(ŷ − d)). Harmonic
/// linearisation is larger there (0.066 against 0.058 at 2.5 mm). Below d nothing brings the
/// wheelset back, and the conicity is zero.
#[test]
fn a_dead_band_separates_both_methods() {
    let (band, slope) = (2e-3, 0.6);
    let beyond = |y: f64| slope * (y.abs() - band).max(0.0).copysign(y);
    let radii = given([-8e-3, 8e-3], beyond);
    for amplitude in [2.5e-3, 3e-3, 5e-3] {
        let natural = slope.sqrt();
        let period = 2.0 * PI / natural + 4.0 * band / (natural * (amplitude - band));
        let [nonlinear, harmonic] = conicities(&radii, amplitude);
        close("by the wavelength", nonlinear, 0.5 * (2.0 * PI / period).powi(2), 1e-6);
        // The describing function of a dead band.
        let part: f64 = band / amplitude;
        let share = 1.0 - 2.0 / PI * (part.asin() + part * (1.0 - part * part).sqrt());
        close("harmonic", harmonic, 0.5 * slope * share, 1e-6);
    }
    // Rounding of a profile does not change that.
    let noisy = given([-8e-3, 8e-3], |y| beyond(y) + 2e-9 * (1e6 * y).sin());
    for radii in [&radii, &noisy] {
        close("in the band", radii.equivalent_conicity(1e-3).unwrap().unwrap(), 0.0, 2e-5);
    }
}

/// Two wheels that are not alike: Δr has one slope left and another right of its zero, which is off
/// the middle. Each half of the motion takes π/√b, and both turning points have the same ∫ Δr dy.
#[test]
fn unequal_wheels_move_about_their_equilibrium() {
    let (zero, [left, right]) = (0.8e-3, [0.2_f64, 0.8]);
    let radii =
        given([-9e-3, 8e-3], |y| if y < zero { left * (y - zero) } else { right * (y - zero) });
    let period = PI / left.sqrt() + PI / right.sqrt();
    for amplitude in [1e-3, 3e-3, 5e-3] {
        let found = radii.equivalent_conicity(amplitude).unwrap().unwrap();
        close("conicity", found, 0.5 * (2.0 * PI / period).powi(2), 1e-6);
        // The mean of Δr vanishes about another middle; between both cones in any case.
        let harmonic = radii.harmonic_conicity(amplitude).unwrap().unwrap();
        assert!(0.5 * left < harmonic && harmonic < 0.5 * right, "{harmonic}");
    }
}

/// A difference that drives the wheelset away from the middle: no motion has that amplitude, and
/// harmonic linearisation is negative. Beyond, where it comes back, there is one.
#[test]
fn no_motion_has_an_amplitude_from_which_it_is_driven_away() {
    let radii = given([-8e-3, 8e-3], |y| -0.1 * y + 8000.0 * y.powi(3));
    assert_eq!(radii.equivalent_conicity(2e-3).unwrap(), None);
    assert!(radii.harmonic_conicity(2e-3).unwrap().unwrap() < 0.0);
    // Duffing's equation with two wells, passed from one side to the other.
    let found = radii.equivalent_conicity(6e-3).unwrap().unwrap();
    close("over the middle", found / duffing(-0.1, 8000.0, 6e-3), 1.0, 1e-5);
    let away = given([-8e-3, 8e-3], |y| -0.1 * y);
    assert_eq!(away.equivalent_conicity(6e-3).unwrap(), None);
}

/// A wheel and a rail of given profiles (y and z in mm), the rail's origin 750 mm from the middle
/// of the track as that of the wheel's profile.
fn pair(wheel: &[[f64; 2]], rail: &[[f64; 2]]) -> Sides<Arc<Pair>> {
    let curve = |points: &[[f64; 2]], quantity| {
        let points: Vec<[f64; 2]> = points.iter().map(|point| point.map(|c| 1e-3 * c)).collect();
        ProfileCurve::new(&points, 0.0, quantity).unwrap()
    };
    let wheel = WheelShape {
        profile: curve(wheel, Quantity::WheelProfile).into(),
        nominal_radius: 0.46,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let inmost = rail.iter().map(|point| 1e-3 * point[0]).fold(f64::INFINITY, f64::min);
    let rail = RailShape::new(curve(rail, Quantity::RailProfile), 0.0);
    let track = Track { gauge: 2.0 * (0.75 + inmost), gauge_depth: 0.9, ..Track::default() };
    Sides::both(Arc::new(Pair::new(&wheel, &rail, &track).unwrap()))
}

/// An arc of a radius, with its centre below, of a slope tan δ at y = z = 0; in mm and rad.
fn arc(radius: f64, slope: f64) -> Vec<[f64; 2]> {
    let at = |k: i32| {
        let here = 5e-4 * f64::from(k) - slope;
        [radius * (here.sin() + slope.sin()), radius * (here.cos() - slope.cos())]
    };
    let half = (40.0 / radius / 5e-4) as i32;
    (-half..=half).map(at).collect()
}

fn without_roll(pairs: &Sides<Arc<Pair>>, largest: f64) -> RollingRadiusDifference {
    RollingRadiusDifference::new(pairs, (largest, 200), Roll::Neglected, &unwatched).unwrap()
}

/// Cones of slope tan γ on round rails without roll: Δr = 2 y tan γ, whatever the rails.
#[test]
fn cones_from_their_profiles() {
    let cone: Vec<[f64; 2]> =
        (-300..=300).map(|k| 0.2 * f64::from(k)).map(|y| [y, 0.05 * y]).collect();
    let radii = without_roll(&pair(&cone, &arc(300.0, 0.0)), 8e-3);
    for amplitude in [1e-3, 3e-3, 8e-3] {
        for found in conicities(&radii, amplitude) {
            close("conicity of a cone 1:20", found, 0.05, 2e-6);
        }
    }
}

/// Wickens 1965: hollow wheels of radius R on rails of radius r touch where both have the same
/// slope, so a lateral motion y changes sin δ by y/(R − r) on both sides, and the rolling radii by
/// Δr = R (√(1 − s₋²) − √(1 − s₊²)), s± = sin δ₀ ± y/(R − r). The conicity of small amplitudes is
/// R tan δ₀/(R − r); of others that of the wavelength that follows from this Δr.
#[test]
fn wickens_1965_hollow_wheels_on_round_rails() {
    let (hollow, round, angle) = (500.0, 300.0, 0.05_f64);
    let radii = without_roll(&pair(&arc(hollow, angle), &arc(round, angle)), 6e-3);
    let difference = |y: f64| {
        let height = |s: f64| (1.0 - s * s).sqrt();
        let shift = 1e3 * y / (hollow - round);
        1e-3 * hollow * (height(angle.sin() - shift) - height(angle.sin() + shift))
    };
    for (y, found) in radii.lateral.iter().zip(&radii.difference) {
        // Contacts are found on lines 0.02 mm apart, with slopes of up to 0.1.
        close("Δr", *found, difference(*y), 1e-6);
    }
    let small = hollow * angle.tan() / (hollow - round);
    for found in conicities(&radii, 3e-4) {
        close("conicity of small amplitudes", found / small, 1.0, 2e-3);
    }
    for amplitude in [2e-3, 6e-3] {
        // Half the time from one turning point to the other, by sinusoidal places.
        let (steps, mut quarter) = (4000, 0.0);
        let simpson = |from: f64, to: f64| {
            let middle = 0.5 * (from + to);
            (difference(from) + 4.0 * difference(middle) + difference(to)) * (to - from) / 6.0
        };
        for k in 0..steps {
            let phase = FRAC_PI_2 * (f64::from(k) + 0.5) / f64::from(steps);
            let y = amplitude * phase.sin();
            let speed = (2.0 * simpson(y, amplitude)).sqrt();
            quarter += amplitude * phase.cos() / speed * FRAC_PI_2 / f64::from(steps);
        }
        let expected = 0.5 * (FRAC_PI_2 / quarter).powi(2);
        let found = radii.equivalent_conicity(amplitude).unwrap().unwrap();
        close("conicity", found / expected, 1.0, 1e-4);
    }
}

/// A rail that ends under the contact limits the positions, and says why.
#[test]
fn positions_end_where_a_profile_does() {
    let hollow = arc(500.0, 0.05);
    let mut short = arc(300.0, 0.05);
    // The contact moves by 1.5 mm on the rail for each mm of the wheelset.
    short.retain(|point| point[0] > -6.0);
    let radii = without_roll(&pair(&hollow, &short), 8e-3);
    let [first, last] = radii.ends();
    close("last position", last, 4e-3, 1e-4);
    close("first position", first, -last, 1e-15);
    let error = radii.end.clone().unwrap();
    let Error::WheelRail { error: WheelRailError::AtProfileEnd { profile, end, .. } } = error
    else {
        panic!("{error}")
    };
    assert_eq!(profile, Quantity::RailProfile);
    close("end of the rail", end, 1e-3 * short[0][0], 3e-5);
    assert!(radii.equivalent_conicity(3.9e-3).unwrap().is_some());
    assert!(radii.equivalent_conicity(5e-3).is_err());
    assert_eq!(radii.at(5e-3), None);
}
