//! Damage over a run as text.

use schlupf::analysis::damage::WearTotal;

use super::DamageReport;
use crate::output::number::significant as number;
use crate::output::report::{Report, reasons, verdict};
use crate::output::summary::{Summary, entry, line};

/// The run, its sums, fatigue and wear.
pub(super) fn text(report: &DamageReport) -> Summary {
    let mut text = Summary::titled(&report.title);
    text.blank();
    run(&mut text, report);
    fatigue(&mut text, report);
    wear(&mut text, report);
    status(&mut text, report);
    text
}

fn run(text: &mut Summary, report: &DamageReport) {
    let damage = &report.damage;
    let states = format!("{} states in {} s", damage.states, number(damage.duration));
    entry(text, "distance", damage.distance / 1e3, "km", &states);
    let mean = format!("{} N of friction per distance", number(damage.energy / damage.distance));
    entry(text, "energy", damage.energy / 1e3, "kJ", &mean);
    let largest = format!(
        "largest {} N, sum {} kJ",
        number(damage.t_gamma.max),
        number(damage.t_gamma.sum / 1e3)
    );
    entry(text, "mean Tγ", damage.t_gamma.mean, "N", &largest);
    text.blank();
}

fn fatigue(text: &mut Summary, report: &DamageReport) {
    let fatigue = &report.damage.fatigue;
    let yield_stress = number(report.laws.fatigue.shear_yield_stress / 1e6);
    let about = format!("largest, with k = {yield_stress} MPa; mean {}", number(fatigue.mean));
    entry(text, "fatigue index", fatigue.max, "", &about);
    let excess = number(fatigue.mean_excess);
    let positive = format!("of the distance with a positive index; mean excess {excess}");
    entry(text, "", 100.0 * fatigue.share, "%", &positive);
    let cracks = &report.damage.cracks;
    let mean = format!("largest per wheel passage; mean {}, by Tγ", number(cracks.mean));
    entry(text, "crack damage", cracks.max, "", &mean);
    text.blank();
}

fn wear(text: &mut Summary, report: &DamageReport) {
    let damage = &report.damage;
    let profile = &damage.profile;
    let laws = [
        ("wear, Archard", &damage.archard, &profile.wheel_archard, &profile.rail_archard),
        ("wear, energy", &damage.energy_wear, &profile.wheel_energy, &profile.rail_energy),
    ];
    for (name, WearTotal { wheel_mass, rail_mass_per_length, .. }, wheel, rail) in laws {
        let deepest = |depth: &[f64]| depth.iter().copied().fold(0.0, f64::max);
        let mass = format!("deepest of the wheel, {} g over the run", number(wheel_mass * 1e3));
        entry(text, name, deepest(wheel) / 1e-6, "µm", &mass);
        let mass = format!(
            "deepest of the rail for a passing wheel, {} mg/m",
            number(rail_mass_per_length * 1e6)
        );
        entry(text, "", deepest(rail) / 1e-9, "nm", &mass);
    }
    text.blank();
}

fn status(text: &mut Summary, report: &DamageReport) {
    match report.left_out.states {
        0 => line(text, verdict(report.status())),
        count => line(
            text,
            &format!("{count} states over {} m are left out", number(report.left_out.distance)),
        ),
    }
    for reason in reasons(&report.warnings) {
        line(text, &format!("  {reason}"));
    }
}
