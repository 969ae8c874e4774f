//! A summary for people, in engineering units.

use std::fmt::Write;

use schlupf::solution::{Solution, Status};

use crate::number::significant as number;

/// The result on one screen of a terminal: forces on the wheel, temperatures, areas, work, status and
/// warnings.
pub fn text(title: &str, solution: &Solution) -> String {
    let mut text = format!("{title}\n\n");
    normal_contact(&mut text, solution);
    forces(&mut text, solution);
    heat(&mut text, solution);
    work(&mut text, solution);
    for warning in &solution.warnings {
        line(&mut text, &format!("warning: {warning}"));
    }
    text
}

fn normal_contact(text: &mut String, solution: &Solution) {
    let Solution { normal, kinematics, .. } = solution;
    let (a, b) = (normal.semi_axis_x / 1e-3, normal.semi_axis_y / 1e-3);
    entry(text, "load", normal.load / 1e3, "kN", "");
    entry(text, "semi-axes", a, "mm", &format!("along rolling, {} mm across", number(b)));
    entry(text, "largest pressure", normal.peak_pressure / 1e6, "MPa", "");
    if let Some(approach) = normal.approach {
        entry(text, "approach", approach / 1e-3, "mm", "");
    }
    let speed = kinematics.speed;
    entry(text, "speed", speed, "m/s", &format!("{} km/h", number(speed * 3.6)));
    let creepages = format!(
        "longitudinal, {} lateral, spin {} 1/m",
        number(kinematics.creepage_y),
        number(kinematics.spin)
    );
    entry(text, "creepage", kinematics.creepage_x, "", &creepages);
    text.push('\n');
}

fn forces(text: &mut String, solution: &Solution) {
    let Solution { force, normalised, power, t_gamma, .. } = solution;
    let over = |value: f64, bound: &str| format!("{} {bound}", number(value));
    line(text, "on the wheel");
    entry(text, "longitudinal force", force.x / 1e3, "kN", &over(normalised.x, "μ0 N"));
    entry(text, "lateral force", force.y / 1e3, "kN", &over(normalised.y, "μ0 N"));
    entry(text, "moment", force.moment_z, "N m", &over(normalised.moment_z, "μ0 N √(ab)"));
    entry(text, "traction coefficient", solution.traction_coefficient, "", "|F|/N");
    entry(text, "T-gamma", t_gamma.without_spin, "N", &over(t_gamma.with_spin, "N with spin"));
    let creep = format!("creep power {} kW", number(power.creep / 1e3));
    entry(text, "friction power", power.friction / 1e3, "kW", &creep);
    text.push('\n');
}

fn heat(text: &mut String, solution: &Solution) {
    let Solution { temperature, area, .. } = solution;
    let place = format!(
        "at x = {} mm, y = {} mm",
        number(temperature.x / 1e-3),
        number(temperature.y / 1e-3)
    );
    entry(text, "largest temp. rise", temperature.max_rise, "K", &place);
    let wheel = format!("to {} °C", number(temperature.max_wheel));
    entry(text, "  wheel", temperature.max_rise_wheel, "K", &wheel);
    let rail = format!("to {} °C", number(temperature.max_rail));
    entry(text, "  rail", temperature.max_rise_rail, "K", &rail);
    let share = |part: f64| format!("{} % slides", number(100.0 * part / area.contact));
    entry(text, "contact area", area.contact / 1e-6, "mm²", &share(area.slip));
    text.push('\n');
}

fn work(text: &mut String, solution: &Solution) {
    let work = &solution.work;
    let done = format!(
        "{} cells, {} time steps, {} Newton iterations, {} products",
        work.cells,
        work.steps,
        work.newton_iterations,
        number(work.operator_products)
    );
    let status = match solution.status {
        Status::Converged => "converged",
        Status::NotConverged => "NOT CONVERGED: do not trust these numbers",
    };
    line(text, &format!("{status}, relative residual {}", number(solution.residual)));
    line(text, &done);
}

/// One quantity: its name, value and unit in columns, and a remark.
fn entry(text: &mut String, name: &str, value: f64, unit: &str, remark: &str) {
    line(text, &format!("{name:<22}{:>11} {unit:<4} {remark}", number(value)));
}

fn line(text: &mut String, line: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}", line.trim_end());
}
