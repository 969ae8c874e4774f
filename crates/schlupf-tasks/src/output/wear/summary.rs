//! The damage per wheel passage as text.

use schlupf::analysis::damage::{Melting, PassageWear, ShakedownPoint};

use super::WearReport;
use crate::output::number::significant as number;
use crate::output::report::{reasons, verdict};
use crate::output::summary::{Summary, entry, line};

/// Wear number, fatigue, wear and melting.
pub(super) fn text(report: &WearReport) -> Summary {
    let mut text = Summary::titled(&report.title);
    text.blank();
    line(&mut text, "per wheel passage over a place of the rail, and per revolution of the wheel");
    fatigue(&mut text, report);
    if let Some(wear) = &report.passage.wear {
        text.blank();
        depths(&mut text, report, wear);
    }
    if let Some(melting) = &report.passage.melting {
        text.blank();
        molten(&mut text, report, melting);
    }
    text.blank();
    line(&mut text, verdict(report.solution.status));
    for reason in reasons(&report.warnings) {
        line(&mut text, &format!("  {reason}"));
    }
    text
}

fn fatigue(text: &mut Summary, report: &WearReport) {
    let passage = &report.passage;
    let spin = passage.t_gamma.with_spin;
    let spin = spin.map_or(String::new(), |value| format!("{} N with spin", number(value)));
    entry(text, "Tγ", passage.t_gamma.without_spin, "N", &spin);
    let about = if passage.crack_damage > 0.0 {
        format!("a crack after some {:.0e} such passages", passage.crack_damage.recip())
    } else if passage.crack_damage < 0.0 {
        "wear removes cracks".to_owned()
    } else {
        "no cracks".to_owned()
    };
    entry(text, "crack damage", passage.crack_damage, "", &about);
    let yield_stress = number(report.laws.fatigue.shear_yield_stress / 1e6);
    let about = format!("with k = {yield_stress} MPa");
    entry(text, "fatigue index", passage.fatigue_index, "", &about);
    let point = &passage.shakedown;
    let about = format!("p0/k, at |F|/N = {}", number(point.traction_coefficient));
    entry(text, "load factor", point.load_factor, "", &about);
    entry(text, "  elastic limit", point.elastic_limit, "", "of a line contact that slides");
    entry(text, "  shakedown limit", point.shakedown_limit, "", regime(point));
}

/// Where a point lies in the map.
fn regime(point: &ShakedownPoint) -> &'static str {
    if point.load_factor <= point.elastic_limit {
        "a line contact would be elastic from the first passage on"
    } else if point.load_factor <= point.shakedown_limit {
        "a line contact would yield at first and shake down"
    } else {
        "beyond shakedown of a line contact, which every passage would deform"
    }
}

fn depths(text: &mut Summary, report: &WearReport, wear: &PassageWear) {
    let per_distance = "of friction per distance rolled";
    entry(text, "energy", wear.energy_per_distance, "N", per_distance);
    let [_, density] = report.laws.densities;
    let mass = |mass: f64| format!("deepest, {} mg/m from each body", number(mass * 1e6));
    let archard = mass(wear.archard_volume * density);
    entry(text, "wear, Archard", wear.archard_depth / 1e-9, "nm", &archard);
    entry(text, "wear, energy", wear.energy_depth / 1e-9, "nm", &mass(wear.energy_mass));
}

fn molten(text: &mut Summary, report: &WearReport, melting: &Melting) {
    let [x, y] = [melting.x, melting.y].map(|place| number(place / 1e-3));
    let place = format!("at x = {x} mm, y = {y} mm");
    entry(text, "largest temperature", melting.max_temperature, "°C", &place);
    let limit = format!("hotter than {} °C", number(report.laws.melting_temperature));
    entry(text, "molten", 100.0 * melting.share, "%", &limit);
}
