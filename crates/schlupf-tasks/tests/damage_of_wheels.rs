//! Damage of runs in which a wheel has several contacts, or none.

use std::any::Any;
use std::fs;
use std::path::Path;

use schlupf::analysis::damage::{Laws, RunDamage};
use schlupf::unwatched;
use schlupf_case::{CaseFile, Folder, InputFile, Overrides};
use schlupf_tasks::output::damage::DamageReport;
use schlupf_tasks::request::Field;
use schlupf_tasks::study::scratch;
use schlupf_tasks::{Asked, Face, Given, TaskError, Value, Wanted, find};

/// The right wheel on its flange, where the vertical force is far from the normal ones.
const WHEEL: &str = r#"
[kinematics]
speed = "20 m/s"
[wheel]
profile = "S1002"
radius_x = "460 mm"
[rail]
profile = "60E1"
cant = 0.025
[normal]
model = "wheel-rail"
load = "80 kN"
cells = 32
[wheelset]
side = "right"
[contact_law]
model = "coulomb"
[friction]
model = "constant"
coefficient = 0.35
[grid]
cells_x = 12
cells_y = 12
"#;

fn damage(folder: &Path, case: &str, states: &str) -> RunDamage {
    fs::write(folder.join("case.toml"), case).unwrap();
    fs::write(folder.join("states.csv"), states).unwrap();
    let study = "case = \"case.toml\"\n[states]\nfile = \"states.csv\"\n";
    fs::write(folder.join("run.toml"), study).unwrap();
    let task = find("damage").unwrap();
    let run = Value::File(InputFile::at(&folder.join("run.toml")));
    let run = |_: &Field| Ok::<_, TaskError>(vec![run.clone()]);
    let work = (task.read)(&Asked::new(Face::Functions, (task.fields)(), run).unwrap()).unwrap();
    let text = CaseFile::default_text();
    let case = CaseFile::from_str(&text, "default", Folder::new(""), Overrides::NONE).unwrap();
    let given = Given { is_default: true, scratch: &scratch, ..Given::of(&case) };
    let found = work(&given, &Wanted::default(), &unwatched).unwrap();
    let report: &dyn Any = &*found.report;
    report.downcast_ref::<DamageReport>().unwrap().damage.clone()
}

/// Each contact counts with its own normal force and where it is: the energy is that of all of them
/// over the speed of the vehicle, the fatigue index T/N − 2πabk/(3N) (Ekberg, Kabo and Andersson
/// 2002) the largest of them, and the worn volume lies within their widths on the profile of the
/// wheel. With the vertical force in place of the normal one the index would be two thirds lower.
#[test]
fn every_contact_of_a_wheel_wears_where_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let states = "distance [m],wheelset.lateral_position [mm]\n0,-6.5\n10,-6.5\n20,-6.5\n";
    let found = damage(folder.path(), WHEEL, states);
    let assignments = &["wheelset.lateral_position=-6.5 mm".to_owned()];
    let set = Overrides { option: "set", assignments };
    let file = CaseFile::from_str(WHEEL, "a case", Folder::new(""), set).unwrap();
    let case = file.pose(&unwatched).unwrap();
    let wheel = case.wheel.as_ref().unwrap();
    let vertical = wheel.force[2];
    assert!((vertical / 80e3 - 1.0).abs() < 1e-3, "{vertical}");
    let main = &wheel.contacts[0].solution;
    assert!(main.normal.load > 1.5 * vertical, "{}", main.normal.load);

    let yield_stress = Laws::default().fatigue.shear_yield_stress;
    let index = |contact: &schlupf::wheel_rail::Contact| {
        let (solution, normal) = (&contact.solution, &contact.solution.normal);
        let area = std::f64::consts::TAU * normal.semi_axis_x * normal.semi_axis_y;
        (solution.force.tangential() - area * yield_stress / 3.0) / normal.load
    };
    let expected = wheel.contacts.iter().map(index).fold(f64::MIN, f64::max);
    assert!((found.fatigue.max - expected).abs() < 0.02, "{} {expected}", found.fatigue.max);
    let power: f64 =
        wheel.contacts.iter().map(|contact| contact.solution.power.unwrap().friction).sum();
    let energy = power / 20.0 * 20.0;
    assert!((found.energy / energy - 1.0).abs() < 0.02, "{} {energy}", found.energy);
    assert_eq!((found.states, found.distance), (3, 20.0));

    let profile = &found.profile;
    for (y, depth) in profile.y.iter().zip(&profile.wheel_archard) {
        let is_within = wheel.contacts.iter().any(|contact| {
            let half_width = 1.05 * contact.solution.normal.semi_axis_y + 1e-4;
            (y - contact.wheel_position).abs() < half_width
        });
        assert!(is_within || *depth == 0.0, "{y} {depth}");
    }
}

/// A wheel that lifts adds to the distance of the run, and to nothing else: along the distance, and
/// along time, where its speed is that of the row before.
#[test]
fn a_wheel_that_lifts_belongs_to_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let case = "kinematics.creepage_x = 0.002\n[grid]\ncells_x = 10\ncells_y = 10\n";
    let loaded = "distance [m],normal.load [kN]\n0,80\n10,80\n20,80\n";
    let all = damage(folder.path(), case, loaded);
    let lifted = "distance [m],normal.load [kN]\n0,80\n10,0\n20,80\n";
    let some = damage(folder.path(), case, lifted);
    assert_eq!((some.states, some.distance), (3, 20.0));
    assert!((some.energy / (0.5 * all.energy) - 1.0).abs() < 1e-9);
    assert!((some.t_gamma.mean / (0.5 * all.t_gamma.mean) - 1.0).abs() < 1e-9);
    assert!((some.archard.wheel_mass / (0.5 * all.archard.wheel_mass) - 1.0).abs() < 1e-9);
    let over_time = "time [s],normal.load [kN]\n0,80\n1,0\n2,80\n";
    let over_time = damage(folder.path(), case, over_time);
    assert!((over_time.distance - 2.0 * over_time.distance / over_time.duration).abs() < 1e-9);
    assert_eq!(over_time.duration, 2.0);
}
