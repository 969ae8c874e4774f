//! Numbers far from those of any material, contact or track, which a wrong unit or a
//! percentage makes, are warned of; hints name units with which a number is a usual value.

use std::collections::BTreeMap;
use std::sync::Arc;

use schlupf::unwatched;
use schlupf_case::{CaseFile, Overrides};

use crate::support::{assert_errors, read};

fn warned(text: &str) -> Vec<(&'static str, String)> {
    let notices = read(text, &[]).unwrap().notices;
    notices.into_iter().map(|notice| (notice.code, notice.text)).collect()
}

#[test]
fn numbers_a_thousand_times_off_are_warned_of() {
    for (text, part) in [
        (
            "[friction]\ncoefficient = 1.6",
            "coefficient is 1.6, but is usually between 1e-3 and 1.5",
        ),
        ("[friction]\ncoefficient = 40", "coefficient is 40"),
        ("[kinematics]\ncreepage_x = -1.0", "not a percentage: 1 % is 0.01"),
        (
            "[kinematics]\ncreepage_x = -1.0",
            "creepage_x is -1, but is usually above -1 and below 1",
        ),
        ("[kinematics]\ncreepage_x = -5", "creepage_x is -5"),
        ("[wheel]\ndensity = \"7.85 kg/m^3\"", "is 7.85 kg/m^3"),
        ("[rail]\ndensity = \"7850 g/cm^3\"", "is 7.85e6 kg/m^3"),
        ("[wheel]\nconductivity = \"50 kW/(m K)\"", "is 50000 W/(m K), but is usually between 0.1"),
        ("[wheel]\nconductivity = \"50 kW/(m K)\"", ": is its unit right?"),
        ("[wheel]\nconductivity = \"50 mW/(m K)\"", "is 0.05 W/(m K)"),
        ("[wheel]\nspecific_heat = \"0.45 J/(kg K)\"", "is 0.45 J/(kg K)"),
        ("[wheel]\nspecific_heat = \"450 kJ/(kg K)\"", "is 4.5e5 J/(kg K)"),
        ("[layer]\nthickness = \"0.5 m\"\nshear_modulus = \"8 GPa\"", "thickness is 0.5 m"),
        ("[normal]\nload = \"80 MN\"", "normal.load is 8e7 N"),
        ("[history]\ntime = [\"0 s\", \"1 s\"]\ncreepage_x = [0.0, -2.0]", "creepage_x is -2"),
    ] {
        let warnings = warned(text);
        let [(code, message)] = &warnings[..] else { panic!("{text:?}: {warnings:?}") };
        assert_eq!(*code, "unusual-value", "{text:?}: {message}");
        assert!(message.starts_with("case.toml:"), "{message}");
        assert!(message.contains(part), "{text:?}: {part:?} is not in {message:?}");
    }
    let track = "[normal]\nmodel = \"wheel-rail\"\nload = \"80 kN\"\n[wheel]\nprofile = \"S1002\"\n\
                 [rail]\nprofile = \"60E1\"\ncant = 0.4\n[track]\ngauge = \"1.435 mm\"\n";
    let files: Arc<BTreeMap<String, Vec<u8>>> = Arc::default();
    let file = CaseFile::from_str(track, "case.toml", files, Overrides::NONE).unwrap();
    let texts: Vec<String> = file.notices().into_iter().map(|notice| notice.text).collect();
    assert!(
        texts[0].contains("rail.cant is 0.4, but is usually finite and at most ±0.1"),
        "{texts:?}"
    );
    assert!(texts[1].contains("track.gauge is 1.435e-3 m"), "{texts:?}");
}

/// Creepages and loads of a file of a history, too.
#[test]
fn a_file_over_time_is_looked_at() {
    let text = "time [s],creepage_x,load [kN]\n0,0,80\n1,-1.5,80\n2,-2.5,80\n";
    let files = BTreeMap::from([("h.csv".to_owned(), text.as_bytes().to_vec())]);
    let case = "history.file = \"h.csv\"";
    let file = CaseFile::from_str(case, "case.toml", Arc::new(files), Overrides::NONE).unwrap();
    let notices = file.pose(&unwatched).unwrap().notices;
    let [notice] = &notices[..] else { panic!("{notices:?}") };
    assert_eq!((notice.code, notice.quantity.as_str()), ("unusual-value", "history.creepage_x"));
    assert!(notice.text.contains("case.toml:1:16: history.creepage_x is -2.5"), "{}", notice.text);
}

/// What the chosen models do not use is none of their numbers.
#[test]
fn fields_without_effect_are_not_looked_at() {
    let ellipse = "[normal]\nmodel = \"ellipse\"\nsemi_axis_x = \"6 mm\"\nsemi_axis_y = \"5 mm\"\nload = \"80 kN\"\n";
    let warnings = warned(&format!("{ellipse}[rail]\nradius_y = \"4600 m\""));
    assert_eq!(warnings.iter().map(|(code, _)| *code).collect::<Vec<_>>(), ["no-effect"]);
}

/// A material is given whole, say by its name: what the other models make of it is no mistake.
#[test]
fn constants_of_a_material_are_not_warned_of_without_heat() {
    let steel = "[wheel]\nconductivity = \"50 W/(m K)\"\ndensity = \"7850 kg/m^3\"\n";
    assert_eq!(warned(&format!("{steel}[heat]\nmodel = \"none\"")), []);
}

/// `radius_x = 460` was told `"460 m"`, and `"80,000 N"` to use a point: then it is 80 N.
#[test]
fn hints_name_units_with_which_a_number_is_usual() {
    assert_errors(&[
        ("[wheel]\nradius_x = 460", "wheel.radius_x", &["quotes, such as \"460 mm\")"]),
        ("[wheel]\nradius_x = \"460\"", "wheel.radius_x", &["missing (such as 460 mm)"]),
        ("[rail]\nradius_y = 300", "rail.radius_y", &["such as \"300 mm\")"]),
        ("[normal]\nload = 80", "normal.load", &["such as \"80 N\" or \"80 kN\")"]),
        ("[normal]\nload = 80000", "normal.load", &["such as \"80000 N\")"]),
        ("[wheel]\ndensity = 7.85", "wheel.density", &["such as \"7.85 g/cm^3\")"]),
        ("[track]\ngauge = 1435", "track.gauge", &["such as \"1435 mm\")"]),
        ("[normal]\nload = \"80,000 N\"", "normal.load", &["write 80000 N or 80 N"]),
        ("[kinematics]\ncreepage_x = \"0,008\"", "kinematics.creepage_x", &["write 0.008"]),
        ("[kinematics]\ncreepage_x = 0,008", "", &["not TOML", "write 0.008"]),
        ("[normal]\nload = 80,000", "", &["not TOML", "write 80000 or 80"]),
    ]);
}

#[test]
fn spin_may_be_an_angle_per_length() {
    for text in ["2 1/m", "2 rad/m", "0.002 rad/mm", "0.002 1/mm"] {
        let case = read(&format!("kinematics.spin = \"{text}\""), &[]).unwrap();
        assert!((case.problem.kinematics.spin - 2.0).abs() < 1e-12, "{text}");
    }
}
