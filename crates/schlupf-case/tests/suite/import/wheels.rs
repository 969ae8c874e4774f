//! Wheels on rails and unlike bodies against CONTACT (rev. 2707): forces within 1.5 % of μN,
//! pressures within 3 %.

use std::path::Path;
use std::sync::Arc;

use super::support::{one, posed, rows};
use schlupf::wheel_rail::WheelSolution;
use schlupf_case::import::contact::{self, ImportedCase, Options};
use schlupf_case::{CaseFile, Folder, Overrides, Source};

/// A row of a table: its name, and its numbers.
struct Row(String, Vec<f64>);

fn table(name: &str) -> Vec<Row> {
    let row = |row: Vec<String>| {
        let numbers = row.iter().skip(1).map(|value| value.parse().unwrap());
        Row(row[0].clone(), numbers.collect())
    };
    rows(name).into_iter().map(row).collect()
}

/// An input of module 1 with a wheel of r = 460 mm.
struct Input<'a> {
    /// C1 P B T N F S.
    digits: &'a str,
    /// E.
    wheelset: u8,
    friction: f64,
    /// Rail: its place and its profile.
    rail: &'a str,
    /// Deviations of the rail.
    deviations: &'a str,
    wheel: &'a str,
    /// Position and velocity of the wheelset, and deviations of the wheel.
    motion: &'a str,
}

impl Input<'_> {
    fn case(&self) -> ImportedCase {
        let Self { digits, wheelset, friction, rail, deviations, wheel, motion } = self;
        let text = format!(
            " 1 MODULE\n {digits}\n 002203{wheelset}\n 0000321\n 999 100 30 1 1e-5\n \
             {friction} {friction}\n 0.28 0.28 82000. 82000.\n 0.1 0.1 1.0 90d 8.0 4.0\n {rail}\n \
             {deviations}\n 1360. -70. 460.\n {wheel}\n {motion}\n 0 MODULE\n"
        );
        let source = Arc::new(Source { name: "wheel.inp".to_owned(), text });
        let options = Options { stem: "wheel".to_owned(), ..Options::default() };
        let mut import = contact::import(&source, &options);
        assert!(import.errors.is_empty(), "{:#?}", import.errors);
        import.cases.remove(0)
    }

    fn solved(&self) -> Arc<WheelSolution> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let text = self.case().text;
        let file = CaseFile::from_str(&text, "wheel.toml", Folder::new(folder), Overrides::NONE);
        let case = file.unwrap_or_else(|errors| panic!("{errors}\n{text}"));
        case.pose(&schlupf::unwatched).unwrap().wheel.unwrap()
    }
}

const RAIL: &str = "14.0 0 1435.0 0.0\n 'data/profile_uic60_canted.csv' 0 1.0 0.0";
const WHEEL: &str = "'data/profile_s1002.csv' 0 1.0 0.0";
const NONE: &str = "0 0 0 0 0 0";

/// The contacts of a wheel are those of the rows of a case and place.
fn assert_agrees(wheel: &WheelSolution, (case, place): (&str, f64), friction: f64) {
    let rows = table("contact_wheels.csv");
    let rows: Vec<&Row> = rows.iter().filter(|row| row.0 == case && row.1[0] == place).collect();
    assert_eq!(wheel.contacts.len(), rows.len(), "{case} {place}");
    let load: f64 = rows.iter().map(|row| row.1[2]).sum();
    for Row(_, numbers) in rows {
        let [_, y, normal, along, across, pressure] = numbers[..] else { panic!("{numbers:?}") };
        let off = |contact: &schlupf::wheel_rail::Contact| (-1e3 * contact.position[1] - y).abs();
        let contact =
            wheel.contacts.iter().min_by(|one, other| off(one).total_cmp(&off(other))).unwrap();
        let (solution, limit) = (&contact.solution, 0.015 * friction * load);
        let found = [solution.normal.load, -solution.force.x, solution.force.y];
        for (found, expected) in found.into_iter().zip([normal, along, across]) {
            let limit = if expected == normal { 0.015 * load } else { limit };
            assert!((found - expected).abs() < limit, "{case} {place}: {found}, not {expected}");
        }
        let ratio = 1e-6 * solution.normal.peak_pressure / pressure;
        assert!((ratio - 1.0).abs() < 0.03, "{case} {place}: pressure {ratio}");
        assert!(off(contact) < 0.03, "{case} {place}: {} mm off", off(contact));
    }
}

/// Rails that are out of place and move, and a wheelset that is bent and moves.
#[test]
fn irregularities_of_a_wheelset() {
    for (digits, case) in [("1203100", "irregular_right"), ("0203100", "irregular_left")] {
        let input = Input {
            digits,
            wheelset: 5,
            friction: 0.3,
            rail: RAIL,
            deviations: "1.5 -0.8 4e-3 10. -5. 0.02",
            wheel: WHEEL,
            motion: "0.0 1.0 10000. 0.0 2e-3 0.0\n 2000. 4. 0.0 0.0 3e-3 -4.35\n \
                     0.5 -0.4 0.2 1.5e-3 -2e-3 0.0\n 5. -8. 6. 0.01 -0.02 0.05",
        };
        assert_agrees(&input.solved(), (case, 0.0), 0.3);
    }
}

/// A worn flat with its middle under the axle, on its way there, and past the rail.
#[test]
fn a_flat_on_the_rail() {
    for pitch in [0.0, 0.012, 0.03, 0.06] {
        let motion = format!("0. 0. 80000. 0. 0. {pitch}\n 20000. 0. 0. 0. 0. -43.478");
        let input = Input {
            digits: "1203100",
            wheelset: 3,
            friction: 0.35,
            rail: RAIL,
            deviations: NONE,
            wheel: "'cases/wheel_flat.slcw' 0 1.0 0.0 1",
            motion: &motion,
        };
        assert_agrees(&input.solved(), ("flat", pitch), 0.35);
    }
}

/// A wheel on the wing rail, on both wing and nose, and on the nose of a crossing.
#[test]
fn from_the_wing_to_the_nose() {
    for place in [150.0, 170.0, 192.0, 205.0] {
        let motion = format!("{place} 0. 80000. 0. 0. 0.\n 20000. 0. 0. 0. 0. -43.478");
        let input = Input {
            digits: "1203100",
            wheelset: 3,
            friction: 0.35,
            rail: "-1.0 750. 0. 0.\n 'cases/crossing_nose.slcs' 0 1.0 0.0 1",
            deviations: NONE,
            wheel: WHEEL,
            motion: &motion,
        };
        assert_agrees(&input.solved(), ("crossing", place), 0.35);
    }
}

/// Pressure and tractions of unlike bodies change each other.
#[test]
fn a_soft_wheel_on_steel() {
    for row in rows("contact_unlike_bodies.csv") {
        let number = |k: usize| row[k].parse::<f64>().unwrap();
        let text = format!(
            " 3 MODULE\n 203100\n 022020\n 0000311\n 999 100 30 20 1e-6\n 2000. {} {} {}\n 0.3 0.3\n \
             0.0 0.075 10000.\n 0.30 0.28 3000. 82000.\n 1\n 80 80 -3. -3. 0.075 0.075\n 1 1\n \
             0.005 0. 0.005 0. 0. 0.\n 0 MODULE\n",
            row[0], row[1], row[2]
        );
        let case = posed(&one(&text));
        let solution = case.solver().solve(&case.problem, &schlupf::unwatched).unwrap();
        let found = [solution.force.x, solution.force.y];
        for (found, expected) in found.into_iter().zip([number(3), number(4)]) {
            assert!((found - expected).abs() < 0.005 * 600.0, "{row:?}: {found}");
        }
        let ratio = 1e-6 * solution.normal.peak_pressure / number(6);
        assert!((ratio - 1.0).abs() < 0.005, "{row:?}: pressure {ratio}");
    }
}
