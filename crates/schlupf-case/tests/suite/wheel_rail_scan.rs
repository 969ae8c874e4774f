//! Random positions of a wheelset, into the flange, with yaw, loads and friction: contacts and
//! forces are found at each of them.

use std::fmt::Write;
use std::sync::Arc;

use schlupf::numerics::parallel;
use schlupf::wheel_rail::{Side, WheelSolution};
use schlupf::{Status, unwatched};
use schlupf_case::{CaseFile, Overrides};

/// Coarse cells, which cost little; steep contacts are the harder the coarser they are.
const HEAD: &str = "\
[normal]
model = \"wheel-rail\"
load = \"80 kN\"
cells = 32
[kinematics]
speed = \"20 m/s\"
[elasticity]
model = \"half-space\"
[contact_law]
model = \"coulomb\"
[friction]
model = \"constant\"
[heat]
model = \"none\"
[grid]
cells_x = 8
cells_y = 8
[rail]
profile = \"60E1\"
cant = 0.025
[wheel]
";

/// The built-in pair.
fn built_in() -> CaseFile {
    read("profile = \"S1002\"", &[])
}

/// A wheel as it is measured, smoothed: a cone 1:20 that a root of 14 mm joins to a flange of 70°
/// with a tip of 13 mm, 28 mm high, each 0.2 mm, with noise of 2 µm.
fn measured() -> CaseFile {
    let mut random = Random(7);
    let mut text = String::from("y_mm,z_mm\n");
    let [steep, flat] = [70_f64.to_radians(), 0.05_f64.atan()];
    let (root, tip, step) = (14.0, 13.0, 0.2);
    // From the field side inwards, by the angle of the surface: cone, root, flange, tip.
    let arc = root * (steep - flat);
    let lengths = [81.0, arc, 8.0, tip * (steep + 0.9)];
    let (mut y, mut z, mut angle) = (55.0_f64, 55.0 * 0.05, flat);
    for k in 0..(lengths.iter().sum::<f64>() / step) as usize {
        let mut noise = || random.between([-2e-3, 2e-3]);
        writeln!(text, "{:.5},{:.5}", y + noise(), z + noise()).unwrap();
        if (lengths[0]..lengths[0] + arc).contains(&(k as f64 * step)) {
            angle = (angle + step / root).min(steep);
        }
        if k as f64 * step >= lengths[..3].iter().sum() {
            angle -= step / tip;
        }
        y -= step * angle.cos();
        z -= step * angle.sin();
    }
    let wheel = "profile = \"measured.csv\"\nprofile_z = \"up\"\nprofile_smoothing = \"5 mm\"";
    read(wheel, &[("measured.csv", &text)])
}

fn read(wheel: &str, files: &[(&str, &str)]) -> CaseFile {
    let files = files.iter().map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec()));
    let files: std::collections::BTreeMap<String, Vec<u8>> = files.collect();
    let text = format!("{HEAD}{wheel}\n");
    CaseFile::from_str(&text, "scan.toml", Arc::new(files), Overrides::NONE).unwrap()
}

/// Knuth's generator.
struct Random(u64);

impl Random {
    fn between(&mut self, [from, to]: [f64; 2]) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A state: its lateral position in m, and fields of the case.
    fn state(&mut self) -> (f64, Vec<String>) {
        let lateral = 1e-3 * self.between([-11.0, 11.0]);
        let fields = vec![
            format!("wheelset.yaw_angle={} mrad", self.between([-10.0, 10.0])),
            format!("normal.load={} kN", 5.0 * 30_f64.powf(self.between([0.0, 1.0]))),
            format!("friction.coefficient={}", self.between([0.05, 0.6])),
            format!("kinematics.creepage_x={}", self.between([-5e-3, 5e-3])),
            format!(
                "wheelset.side={}",
                ["left", "right"][usize::from(self.between([0.0, 2.0]) > 1.0)]
            ),
        ];
        (lateral, fields)
    }
}

/// Vertical force on a wheel over its load, minus one.
fn error_of_force(wheel: &WheelSolution, load: f64) -> f64 {
    (wheel.force[2] / load - 1.0).abs()
}

/// Solves so many random states of a pair. Every wheel carries its load: to 10⁻⁴, or where cells
/// that come and go at a steep flange make the force jump over it, to 3·10⁻³ with a warning; both
/// wheels are on one axle. At least a tenth of all states has a flange in contact.
fn scan(file: &CaseFile, seed: u64, count: usize) {
    let mut random = Random(seed);
    let states: Vec<_> = (0..count).map(|_| random.state()).collect();
    let solved = parallel::try_map(states, |(lateral, fields)| {
        let case = file.with("the scan", &fields).map_err(|error| error.to_string())?;
        let place = format!("{lateral} m, {fields:?}");
        let wheels = case.wheels_at(lateral, &unwatched);
        let wheels = wheels.map_err(|error| format!("{place}: {error}"))?;
        let load = fields[1]["normal.load=".len()..].trim_end_matches(" kN").parse::<f64>();
        let load = 1e3 * load.unwrap();
        for wheel in &wheels {
            assert_eq!(wheel.status(), Status::Converged, "{place}");
            let is_jump = wheel.warnings().iter().any(|warning| warning.code() == "jumping-force");
            let off = error_of_force(wheel, load);
            assert!(off < if is_jump { 3.1e-3 } else { 1.1e-4 }, "{place}: {off}");
        }
        assert_eq!([wheels[0].side, wheels[1].side], [Side::Left, Side::Right]);
        let apart = (wheels[0].height - wheels[1].height).abs();
        assert!(apart < 1e-6, "{place}: {apart}");
        let contacts = wheels.iter().flat_map(|wheel| &wheel.contacts);
        Ok::<_, String>(contacts.map(|contact| contact.angle.abs()).fold(0.0, f64::max) > 0.7)
    });
    let flanges = solved.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(flanges.len(), count);
    let flanges = flanges.iter().filter(|is_flange| **is_flange).count();
    assert!(10 * flanges > count, "{flanges} of seed {seed}");
}

#[test]
fn random_positions_have_contacts() {
    scan(&built_in(), 1, 20);
    scan(&measured(), 2, 20);
}

/// Positions at which height and friction in turns come back to the same two states for ever,
/// because a row of cells comes into contact between both: the flange at 1.2 rad, where a last
/// digit of the friction ratio counts sevenfold in the vertical force.
#[test]
fn steep_flanges_whose_force_jumps_are_found() {
    for (lateral, yaw, load, friction, side) in [
        (
            -6.472_634_297_805_291e-3,
            7.565_216_390_244_792,
            12.274_042_792_909_729,
            0.386_971_531,
            "right",
        ),
        (
            -7.097_048_168_700_519e-3,
            8.806_688_151_852_946,
            30.019_285_169_014_16,
            0.481_243_072,
            "right",
        ),
    ] {
        let fields = [
            format!("wheelset.yaw_angle={yaw} mrad"),
            format!("normal.load={load} kN"),
            format!("friction.coefficient={friction}"),
            format!("wheelset.side={side}"),
        ];
        let case = built_in().with("the flange", &fields).unwrap();
        for wheel in case.wheels_at(lateral, &unwatched).unwrap() {
            let off = error_of_force(&wheel, 1e3 * load);
            assert!(wheel.status() == Status::Converged && off < 1e-3, "{lateral}: {off}");
            assert!(wheel.rounds < 20, "{lateral}: {} rounds", wheel.rounds);
        }
    }
}

/// The same at two thousand positions.
#[test]
#[ignore = "long: cargo xtask long"]
fn two_thousand_random_positions_have_contacts() {
    scan(&built_in(), 3, 1000);
    scan(&measured(), 4, 1000);
}
