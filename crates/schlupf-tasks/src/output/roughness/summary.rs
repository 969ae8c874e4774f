//! A rough surface, its contact and its k_c as text.

use std::f64::consts::TAU;

use schlupf::interface::roughness::TYPICAL_GAMMA;

use super::RoughnessReport;
use crate::output::number::significant as number;
use crate::output::report::{Report, verdict};
use crate::output::summary::{Summary, entry, line};

/// Statistics, contact area and k_c on one terminal screen.
pub(super) fn text(report: &RoughnessReport) -> Summary {
    let mut text = Summary::titled(&report.title);
    text.blank();
    surface(&mut text, report);
    contact(&mut text, report);
    stiffness(&mut text, report);
    let verdict = verdict(report.status());
    let points = report.result.normal.points();
    let iterations: usize = points.iter().map(|point| point.iterations).sum();
    let count = points.len();
    line(&mut text, &format!("{verdict}; {count} loads, {iterations} iterations"));
    text
}

fn surface(text: &mut Summary, report: &RoughnessReport) {
    let (lattice, statistics) = (report.surface.lattice(), &report.result.statistics);
    let micrometres = |value: f64| number(value / 1e-6);
    let cells = format!(
        "{} x {} cells of {} µm, {} x {} mm",
        lattice.columns,
        lattice.rows,
        micrometres(lattice.spacing_x),
        number(lattice.length_x() / 1e-3),
        number(lattice.length_y() / 1e-3)
    );
    line(text, &cells);
    let height = |text: &mut Summary, name: &str, value: f64, remark: &str| {
        entry(text, name, value / 1e-6, "µm", remark);
    };
    height(text, "Sa", statistics.arithmetic_mean_height, "arithmetical mean height");
    let rms = "root mean square height, h_rms";
    height(text, "Sq", statistics.root_mean_square_height, rms);
    let parts = format!(
        "maximum height: peak {} µm, pit {} µm",
        micrometres(statistics.peak_height),
        micrometres(statistics.pit_depth)
    );
    height(text, "Sz", statistics.maximum_height, &parts);
    entry(text, "Ssk", statistics.skewness, "", "skewness; 0 for Gaussian heights");
    entry(text, "Sku", statistics.kurtosis, "", "kurtosis; 3 for Gaussian heights");
    let gradient = "root mean square gradient, from differences";
    entry(text, "Sdq", statistics.root_mean_square_gradient, "", gradient);
    entry(text, "h'_rms", statistics.spectral_gradient, "", "the same, from the spectrum");
    if let Some(law) = report.spectrum.power_law() {
        let [long, short] = law.wave_numbers.map(|q| micrometres(TAU / q));
        let range = format!("Hurst exponent of the spectrum from {long} to {short} µm");
        entry(text, "H", (1e3 * law.hurst_exponent).round() / 1e3, "", &range);
    } else {
        let none = "Hurst exponent: no self-affine spectrum over half a decade";
        line(text, &format!("{:<22}{:>11} {:<4} {none}", "H", "-", ""));
    }
    for remark in &report.remarks {
        line(text, remark);
    }
    text.blank();
}

fn contact(text: &mut Summary, report: &RoughnessReport) {
    let hardness = if report.hardness.is_finite() {
        let largest = report.result.normal.largest_pressure() / 1e6;
        format!(
            "hardness {} GPa, flattened by {} MPa before",
            number(report.hardness / 1e9),
            number(largest)
        )
    } else {
        "elastic".to_owned()
    };
    let bodies = format!(
        "E* = {} GPa, ν = {}, μ0 = {}, {hardness}",
        number(report.contact_modulus / 1e9),
        number(report.bodies.poisson_ratio),
        number(report.bodies.friction_coefficient),
    );
    line(text, &bodies);
    let result = &report.result;
    line(
        text,
        &format!(
            "{:>14}{:>14}{:>14}{:>18}{:>14}",
            "p (MPa)", "contact (%)", "k_c (1/m)", "rms error (%)", "largest (%)"
        ),
    );
    for (curve, fit) in result.tangential.iter().zip(&result.stiffness.fits) {
        let percent = |value: f64| number((1e4 * value).round() / 100.0);
        let row = format!(
            "{:>14}{:>14}{:>14}{:>18}{:>14}",
            number(curve.mean_pressure / 1e6),
            percent(result.normal.corrected_contact_fraction(curve.mean_pressure)),
            number(fit.stiffness),
            percent(fit.root_mean_square_error),
            percent(fit.largest_error)
        );
        line(text, &row);
    }
    spots(text, report);
    text.blank();
}

/// Pressures in the spots under the largest mean pressure.
fn spots(text: &mut Summary, report: &RoughnessReport) {
    let normal = &report.result.normal;
    let Some(last) = normal.points().last() else { return };
    let gigapascal = |value: f64| number((value / 1e7).round() / 100.0);
    let yields = if report.hardness.is_finite() {
        let percent = (1e4 * last.plastic_fraction).round() / 100.0;
        format!("; {} % of the surface has yielded there", number(percent))
    } else {
        String::new()
    };
    line(
        text,
        &format!(
            "in the spots at {} MPa: mean {} GPa, largest {} GPa{yields}; areas are corrected for their perimeter",
            number(last.mean_pressure / 1e6),
            gigapascal(normal.mean_spot_pressure(last.mean_pressure)),
            gigapascal(last.spot_pressure)
        ),
    );
}

fn stiffness(text: &mut Summary, report: &RoughnessReport) {
    let result = &report.result;
    let common = &result.stiffness.common;
    let percent = |value: f64| number((1e3 * value).round() / 10.0);
    let remark = format!(
        "for all pressures: Eq. (8) misses {} % of μp (rms), at most {} %; k_c varies by {} %",
        percent(common.root_mean_square_error),
        percent(common.largest_error),
        percent(result.stiffness.spread)
    );
    entry(text, "k_c", common.stiffness, "1/m", &remark);
    let gamma = match result.gamma {
        Some(gamma) => format!("; found γ = {}", number((1e3 * gamma).round() / 1e3)),
        None => String::new(),
    };
    let closed = format!("2(1 − ν)/(μ0 (2 − ν) γ h_rms) with γ = {TYPICAL_GAMMA}{gamma}");
    entry(text, "closed form", result.closed_form, "1/m", &closed);
    text.blank();
}
