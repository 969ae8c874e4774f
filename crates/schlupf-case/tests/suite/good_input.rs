//! What legal case files mean.

use std::fmt::Write;
use std::fs;

use approx::assert_relative_eq;
use schlupf::analysis::calibration::KalkerBed;
use schlupf::bodies::Material;
use schlupf::elasticity::HalfSpace;
use schlupf::elasticity::elastic_layer::{ElasticLayer, LayerStiffness};
use schlupf::interface::friction::FrictionState;
use schlupf::interface::heat::Partition;
use schlupf::normal::{Extent, Grid};
use schlupf::{Quantity, unwatched};
use schlupf_case::{Case, CaseFile, ElasticityModel, Folder, Overrides, Place, field};

fn texts(notices: &[schlupf::reporting::Message]) -> Vec<String> {
    notices.iter().map(|notice| notice.text.clone()).collect()
}

fn read(text: &str, overrides: &[&str]) -> Case {
    let overrides: Vec<String> = overrides.iter().map(|text| (*text).to_owned()).collect();
    match CaseFile::from_str(
        text,
        "case.toml",
        Folder::new(""),
        Overrides { option: "--set", assignments: &overrides },
    )
    .and_then(|file| file.pose(&unwatched))
    {
        Ok(case) => case,
        Err(errors) => panic!("{errors}"),
    }
}

#[test]
fn an_empty_file_is_a_steel_wheel_on_a_steel_rail() {
    let case = read("", &[]);
    assert_eq!(case.problem.interface.wheel, schlupf::bodies::Body::STEEL);
    assert_eq!(case.problem.interface.rail, schlupf::bodies::Body::STEEL);
    assert_eq!(case.problem.kinematics.creepage_x, 0.0);
    let expected = schlupf::Options { sensitivity: true, ..schlupf::Options::default() };
    assert_eq!(case.options, expected);
    let normal = case.problem.normal.normal_contact(None).unwrap().summary;
    assert_relative_eq!(normal.load, 80e3, max_relative = 1e-14);
}

#[test]
fn creepages_follow_from_the_motion_of_the_wheel() {
    let text = "[kinematics]\nspeed = \"30 m/s\"\nangular_velocity = \"60 rad/s\"\n\
                wheel_radius = \"0.5 m\"\nyaw_angle = \"30 deg\"";
    let kinematics = read(text, &[]).problem.kinematics;
    assert_relative_eq!(kinematics.creepage_x, 0.75_f64.sqrt() - 1.0, max_relative = 1e-14);
    assert_relative_eq!(kinematics.creepage_y, -0.5, max_relative = 1e-14);
    let by_creepage = text.replace("yaw_angle = \"30 deg\"", "creepage_y = -0.5");
    let same = read(&by_creepage, &[]).problem.kinematics;
    assert_relative_eq!(same.creepage_x, kinematics.creepage_x, max_relative = 1e-13);
}

#[test]
fn the_rolling_radius_is_that_of_the_wheel_by_default() {
    let text = "[kinematics]\nspeed = \"30 m/s\"\nangular_velocity = \"60 rad/s\"\n\
                [wheel]\nradius_x = \"0.4 m\"";
    assert_relative_eq!(read(text, &[]).problem.kinematics.creepage_x, 0.2, max_relative = 1e-13);
}

#[test]
fn temperatures_are_in_degrees_whatever_the_unit() {
    let text = "[rail]\nbulk_temperature = \"323.15 K\"\n[heat]\npartition = \"velocity\"";
    let problem = read(text, &[]).problem;
    assert_relative_eq!(problem.interface.rail.bulk_temperature, 50.0, max_relative = 1e-14);
    // Friction counts from the rail's temperature unless told otherwise.
    assert_relative_eq!(
        problem.interface.friction.reference_temperature,
        50.0,
        max_relative = 1e-14
    );
    assert!(matches!(problem.interface.heat.partition, Partition::Velocity));
}

/// Half to each only where that is asked for: both surfaces are equally hot.
#[test]
fn the_partition_follows_from_the_velocities_by_default() {
    let partition = |text| read(text, &[]).problem.interface.heat.partition;
    assert!(matches!(partition(""), Partition::Velocity));
    assert!(matches!(partition("[heat]\npartition = 0.5"), Partition::Given(0.5)));
}

#[test]
fn concave_radii_and_negative_creepages_are_legal() {
    let text = "[kinematics]\ncreepage_x = -0.1\ncreepage_y = -0.1\n\
                [wheel]\nradius_y = \"-400 mm\"\n[rail]\nradius_x = inf\nradius_y = \"300 mm\"";
    read(text, &[]);
}

#[test]
fn semi_axes_come_with_load_or_peak_pressure() {
    let text = "[normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\nsemi_axis_y = \"5 mm\"\n";
    let peak = read(&format!("{text}peak_pressure = \"1 GPa\""), &[]);
    let load = 2.0 / 3.0 * std::f64::consts::PI * 6e-3 * 5e-3 * 1e9;
    let summary = peak.problem.normal.normal_contact(None).unwrap().summary;
    assert_relative_eq!(summary.load, load, max_relative = 1e-13);
    let loaded = read(text, &["normal.load=90 kN"]);
    let summary = loaded.problem.normal.normal_contact(None).unwrap().summary;
    assert_relative_eq!(summary.load, 90e3, max_relative = 1e-13);
}

/// Whatever has an approach finds the load: it is no condition then, and a state has another
/// approach. A line contact is solved on the half-space, in one row, unless asked otherwise.
#[test]
fn an_approach_takes_the_place_of_the_load() {
    let load = |case: &Case| case.problem.normal.normal_contact(None).unwrap().summary.load;
    let line = "[normal]\nmodel = \"line\"\nlength = \"20 mm\"\n";
    for text in ["", line] {
        let by_load = read(text, &["normal.load=30 kN"]);
        let found = by_load.problem.normal.normal_contact(None).unwrap().summary;
        let approach = format!("normal.approach={} m", found.approach.unwrap());
        let case = read(text, &[&approach]);
        assert_relative_eq!(load(&case), 30e3, max_relative = 1e-10);
        let condition = |assignment: &str| {
            let assignments = &[assignment.to_owned()];
            let overrides = Overrides { option: "--set", assignments };
            let file = CaseFile::from_str(text, "case.toml", Folder::new(""), overrides);
            file.unwrap().condition(field!("normal.load"))
        };
        assert_eq!(condition(&approach), None);
        assert_eq!(condition("normal.load=30 kN"), Some(Quantity::Load));
    }
    let line = read(line, &["normal.load=30 kN"]);
    assert_eq!((line.elasticity, line.options.cells_y), (ElasticityModel::HalfSpace, 1));
}

#[test]
fn fields_of_another_model_are_noticed_unless_an_override_chose_the_model() {
    let text = "[elasticity]\nmodel = \"winkler\"\ncoupling_x = \"3e7 N/m\"\n\
                bedding_x = \"1e13 N/m^3\"";
    let notices = read(text, &[]).notices;
    assert_eq!(
        texts(&notices),
        ["case.toml:3:14: elasticity.coupling_x has no effect with elasticity.model = \"winkler\""]
    );
    let layer = text.replace("winkler", "elastic-layer");
    assert_eq!(texts(&read(&layer, &["elasticity.model=winkler"]).notices), [""; 0]);
    assert_eq!(read(&layer, &["heat.model=none", "heat.partition=0.4"]).notices.len(), 1);
}

/// What is not given along y is as along x, and what is not given across rolling as along it.
#[test]
fn couplings_across_rolling_may_be_their_own() {
    let text = "[elasticity]\nbedding_x = \"1e13 N/m^3\"\ncoupling_x = \"4e7 N/m\"\n\
                coupling_x_across = \"2e7 N/m\"\ncoupling_y = \"5e7 N/m\"";
    let stiffness = |coupling_along_x: f64, coupling_along_y: f64| LayerStiffness {
        bedding: 1e13,
        coupling_along_x,
        coupling_along_y,
    };
    let expected = ElasticLayer::new(stiffness(4e7, 2e7), stiffness(5e7, 5e7), None).unwrap();
    let elasticity = read(text, &[]).problem.interface.elasticity;
    assert_eq!(format!("{elasticity:?}"), format!("{expected:?}"));
}

/// Without stiffnesses a Winkler bedding has Kalker's for the patch.
#[test]
fn kalker_1982_a_bedding_without_stiffnesses() {
    let steel = Material::STEEL;
    let bodies = HalfSpace::new(&steel, &steel).unwrap();
    for text in ["", "calibration = \"half-space\""] {
        let interface =
            read(&format!("[elasticity]\nmodel = \"winkler\"\n{text}"), &[]).problem.interface;
        let grid = Grid::across(&Extent { x: [-6e-3, 6e-3], y: [1e-3, 9e-3] }, 8, 8);
        let bed = KalkerBed { bodies }.on([6e-3, 4e-3]).unwrap();
        let found = interface.elasticity.compliance(&grid).unwrap();
        assert_eq!(format!("{found:?}"), format!("{bed:?}"));
    }
}

#[test]
fn discrete_springs_replace_the_stiffnesses_per_area() {
    read(
        "[elasticity]\nspring_x = \"1e6 N/m\"\nspring_coupling_x = \"1e7 N/m\"\nmargin = \"12 mm\"",
        &[],
    );
}

#[test]
fn a_history_is_read_from_arrays_and_files_alike() {
    let arrays = "[history]\ntime = [\"0 s\", \"1 ms\"]\ncreepage_x = [0, 0.002]\n\
                  load = [\"80 kN\", \"60 kN\"]";
    let expected = read(arrays, &[]).history;
    let folder = tempfile::tempdir().unwrap();
    let table = "# made up\r\ntime [ms],creepage_x,load [kN]\r\n0,0,80\r\n1,0.002,60\r\n";
    fs::write(folder.path().join("h.csv"), table).unwrap();
    let path = folder.path().join("case.toml");
    fs::write(&path, "[history]\nfile = \"h.csv\"").unwrap();
    assert_eq!(
        CaseFile::from_path(&path, Overrides::NONE).unwrap().pose(&unwatched).unwrap().history,
        expected
    );
    assert_eq!(expected.unwrap().load, Some(vec![80e3, 60e3]));
}

#[test]
fn coulombs_law_needs_no_stiffness() {
    let text = "[contact_law]\nmodel = \"coulomb\"\nstiffness = \"5e6 1/m\"\n\
                roughness.rms_height = \"1 um\"";
    let case = read(text, &[]);
    assert!(case.problem.interface.contact_law.is_coulomb());
    assert_eq!(case.law_stiffness.stiffness, f64::INFINITY);
    assert_eq!(
        texts(&case.notices),
        [
            "case.toml:3:13: contact_law.stiffness has no effect with contact_law.model = \"coulomb\"",
            "case.toml:4:24: contact_law.roughness.rms_height has no effect with contact_law.model = \
             \"coulomb\"",
        ]
    );
}

#[test]
fn the_speed_over_time_is_read() {
    let text = "[history]\ntime = [\"0 s\", \"1 ms\"]\nspeed = [\"108 km/h\", \"20 m/s\"]";
    let history = read(text, &[]).history.unwrap();
    assert_eq!(history.speed, Some(vec![30.0, 20.0]));
    assert_eq!((history.creepage_x, history.load), (None, None));
}

/// The rolling radius counts for damage and heat per revolution, too, as does that which is its
/// default; not on two profiles, whose nominal radius it is.
#[test]
fn a_rolling_radius_is_noticed_on_two_profiles_only() {
    let text = "[kinematics]\nwheel_radius = \"0.4 m\"";
    assert_eq!(texts(&read(text, &[]).notices), [""; 0]);
    let ellipse = "[wheel]\nradius_x = \"0.2 m\"\n[normal]\nmodel = \"ellipse\"\nload = \"50 kN\"\n\
                   semi_axis_x = \"5 mm\"\nsemi_axis_y = \"5 mm\"\n";
    assert_eq!(texts(&read(ellipse, &[]).notices), [""; 0]);
    let profiles = "[wheel]\nprofile = \"S1002\"\n[rail]\nprofile = \"60E1\"\n\
                    [normal]\nmodel = \"wheel-rail\"\nload = \"80 kN\"\n";
    let posed = read(&format!("{text}\n{profiles}"), &[]);
    let expected = "case.toml:2:16: kinematics.wheel_radius has no effect with normal.model = \
                    \"wheel-rail\"";
    assert_eq!(texts(&posed.notices), [expected]);
    let turning = |case: &Case| case.wheel.as_ref().unwrap().angular_velocity;
    assert_eq!(turning(&posed), turning(&read(profiles, &[])));
}

#[test]
fn a_layer_may_end_at_the_patch() {
    read("[elasticity]\nmargin = \"0 mm\"", &[]);
}

#[test]
fn the_effective_fields_tell_where_they_come_from() {
    let text =
        "title = \"x\"\n[elasticity]\nbedding_x = \"1.0e13 N/m^3\"\ncoupling_x = \"3e7 N/m\"";
    let case = read(text, &["normal.load=60 kN"]);
    let effective = case.effective();
    let find = |path| effective.iter().find(|field| field.path == path).unwrap();
    assert!(matches!(find(field!("title")).place, Place::Text { .. }));
    assert!(matches!(find(field!("normal.load")).place, Place::Override { .. }));
    assert_eq!(find(field!("normal.load")).value, "\"60 kN\"");
    assert_eq!(find(field!("elasticity.bedding_y")).value, "\"1.0e13 N/m^3\"");
    assert!(effective.iter().all(|field| field.path != field!("normal.semi_axis_x")));
}

/// Both files hold the same pressure on 2 by 3 points with spacings 1 mm and 2 mm.
#[test]
fn pressure_tables_come_as_csv_and_npy() {
    let folder = tempfile::tempdir().unwrap();
    let mut csv = "x [mm],y [mm],pressure [MPa]\n".to_owned();
    for (x, y) in [(-1, -1), (0, -1), (1, -1), (-1, 1), (0, 1), (1, 1)] {
        writeln!(csv, "{x},{y},100").unwrap();
    }
    fs::write(folder.path().join("p.csv"), csv).unwrap();
    let header = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }\n";
    let mut npy = b"\x93NUMPY\x01\x00".to_vec();
    npy.extend((header.len() as u16).to_le_bytes());
    npy.extend(header.as_bytes());
    npy.extend([100e6_f64; 6].iter().flat_map(|pressure| pressure.to_le_bytes()));
    fs::write(folder.path().join("p.npy"), npy).unwrap();
    let load = |text: &str| {
        let text = format!("[normal]\nmodel = \"tabulated\"\n{text}");
        let case =
            CaseFile::from_str(&text, "case.toml", Folder::new(folder.path()), Overrides::NONE)
                .unwrap()
                .pose(&unwatched)
                .unwrap();
        case.problem.normal.normal_contact(None).unwrap().summary.load
    };
    let csv = load("file = \"p.csv\"");
    let npy = load("file = \"p.npy\"\nspacing_x = \"1 mm\"\nspacing_y = \"2 mm\"");
    assert_relative_eq!(csv, npy, max_relative = 1e-12);
    assert_relative_eq!(load("file = \"p.csv\"\nload = \"1 kN\""), 1e3, max_relative = 1e-12);
}

/// μ of a `[friction]` section at a temperature over the reference, a slip speed and y, in SI
/// units.
fn friction(section: &str, [temperature, slip_speed, y]: [f64; 3]) -> f64 {
    let case = read(&format!("[friction]\n{section}"), &[]);
    assert_eq!(texts(&case.notices), [""; 0], "{section}");
    let state = FrictionState { temperature, slip_speed, y };
    case.problem.interface.friction.law.respond(&state).coefficient
}

/// Values by hand: each law at its half speed, or half way down.
#[test]
fn every_friction_law_is_read() {
    let terms = "coefficient = 0.3\nkinetic_coefficient = 0.1\nhalf_speed = \"3.6 km/h\"\n\
                 second_coefficient = 0.04\nsecond_half_speed = \"0.5 m/s\"\n";
    let polach = "coefficient = 0.55\nlimit_ratio = 0.4\ndecay = \"0.60 s/m\"\n";
    let piecewise = "coefficient = 0.3\nhot_coefficient = 0.2\ntemperature_range = \"800 K\"";
    let table = "variation_y = [\"-5 mm\", \"0 mm\"]\nvariation_factor = [0.5, 1]\n";
    for (name, fields, state, expected) in [
        ("constant", "coefficient = 0.3", [500.0, 9.0, 1.0], 0.3),
        ("temperature-linear", "", [350.0, 9.0, 1.0], 0.2),
        ("temperature-piecewise-linear", piecewise, [400.0, 9.0, 1.0], 0.25),
        ("exponential", terms, [500.0, 1.0, 1.0], 0.1 + 0.16 / 2.0 + 0.04 / 4.0),
        ("rational", terms, [500.0, 1.0, 1.0], 0.1 + 0.16 / 2.0 + 0.04 / 5.0),
        ("linear-in-speed", terms, [500.0, 1.0, 1.0], 0.1 + 0.16 / 2.0),
        ("polach", polach, [500.0, 1e3, 1.0], 0.22),
        ("constant", table, [500.0, 9.0, -2.5e-3], 0.3),
    ] {
        let found = friction(&format!("model = \"{name}\"\n{fields}"), state);
        assert_relative_eq!(found, expected, max_relative = 1e-12);
    }
}

#[test]
fn a_law_of_temperature_is_multiplied_by_the_fall_of_one_of_speed() {
    let text =
        "coefficient = 0.55\nspeed_model = \"polach\"\nlimit_ratio = 0.4\ndecay = \"0.6 s/m\"";
    assert_relative_eq!(friction(text, [350.0, 1e3, 0.0]), 0.11, max_relative = 1e-12);
    let varying =
        format!("{text}\nvariation_y = [\"0 mm\", \"1 mm\"]\nvariation_factor = [1, 0.5]");
    assert_relative_eq!(friction(&varying, [350.0, 1e3, 1.0]), 0.055, max_relative = 1e-12);
}

#[test]
fn friction_over_y_comes_from_a_file_too() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("f.csv"), "y [mm],factor\n-5,0.5\n0,1\n").unwrap();
    let text = "[friction]\nmodel = \"constant\"\nvariation_file = \"f.csv\"";
    let case = CaseFile::from_str(text, "case.toml", Folder::new(folder.path()), Overrides::NONE)
        .unwrap()
        .pose(&unwatched)
        .unwrap();
    let state = FrictionState { y: -2.5e-3, ..FrictionState::default() };
    let response = case.problem.interface.friction.law.respond(&state);
    assert_relative_eq!(response.coefficient, 0.3, max_relative = 1e-12);
    assert_eq!(case.files(), [(field!("friction.variation_file"), folder.path().join("f.csv"))]);
}

#[test]
fn fields_of_another_friction_law_are_noticed() {
    let notices = |text: &str, overrides: &[&str]| {
        let notices = read(&format!("[friction]\n{text}"), overrides).notices;
        notices.iter().map(|notice| notice.text.replace("case.toml:", "")).collect::<Vec<_>>()
    };
    assert_eq!(
        notices("half_speed = \"1 m/s\"", &[]),
        [
            "2:14: friction.half_speed has no effect with friction.model = \"temperature-linear\" and \
             friction.speed_model = \"none\""
        ]
    );
    let polach = "model = \"polach\"\nlimit_ratio = 0.4\ndecay = \"0.6 s/m\"\n";
    assert_eq!(
        notices(&format!("{polach}speed_model = \"rational\"\nkinetic_coefficient = 0.1"), &[]),
        [
            "5:15: friction.speed_model has no effect with friction.model = \"polach\"",
            "6:23: friction.kinetic_coefficient has no effect with friction.model = \"polach\"",
        ]
    );
    assert_eq!(notices(polach, &["friction.model=constant"]), [""; 0]);
    let second = "model = \"rational\"\nkinetic_coefficient = 0.1\nhalf_speed = \"1 m/s\"\n\
                  second_half_speed = \"1 m/s\"";
    assert_eq!(
        notices(second, &[]),
        ["5:21: friction.second_half_speed has no effect without friction.second_coefficient"]
    );
}
