//! A text summary in engineering units.

use schlupf::Method;
use schlupf::bodies::ReferencePoint;
use schlupf::solution::{Power, Solution, Status, Temperature};

use super::SolutionReport;
use crate::output::number::significant as number;
use crate::output::report::{reasons, verdict};
use crate::output::summary::{
    Summary, entry, friction_power, line, moment, unit_of_power, without_noise,
};

/// The result on one terminal screen: forces on the wheel, temperatures, areas, work and status.
pub(crate) fn text(report: &SolutionReport) -> Summary {
    let SolutionReport { title, contact_law, solution, .. } = report;
    let mut text = Summary::titled(title);
    text.blank();
    if let Some(wheel) = &report.wheel {
        super::wheel::summary(&mut text, wheel);
    }
    normal_contact(&mut text, solution);
    if let Some(law) = contact_law.as_ref().filter(|law| law.is_coulomb()) {
        line(&mut text, &format!("{:<22}{}", "contact law", law.remark()));
    } else if let Some(law) = contact_law {
        entry(&mut text, "contact stiffness", law.stiffness, "1/m", &law.remark());
    }
    text.blank();
    forces(&mut text, solution);
    heat_and_areas(&mut text, solution);
    work(&mut text, report);
    text
}

fn normal_contact(text: &mut Summary, solution: &Solution) {
    let Solution { normal, kinematics, .. } = solution;
    let (a, b) = (normal.semi_axis_x / 1e-3, normal.semi_axis_y / 1e-3);
    entry(text, "load", normal.load / 1e3, "kN", "");
    entry(text, "semi-axes", a, "mm", &format!("along rolling, {} mm across", number(b)));
    entry(text, "largest pressure", normal.peak_pressure / 1e6, "MPa", "");
    if let Some(approach) = normal.approach {
        entry(text, "approach", approach / 1e-3, "mm", "");
    }
    if normal.parts > 1 {
        let remark = "separate; the semi-axes are half the extent of all together";
        entry(text, "parts of the patch", normal.parts as f64, "", remark);
    }
    if let Some([x, y]) = normal.origin {
        let (x, y) = (without_noise(x / 1e-3, x / a * 1e-3), without_noise(y / 1e-3, y / b * 1e-3));
        let remark = format!("along rolling, {} mm across, in the file", number(y));
        entry(text, "origin", x, "mm", &remark);
    }
    let speed = kinematics.speed;
    entry(text, "speed", speed, "m/s", &format!("{} km/h", number(speed * 3.6)));
    let creepages = format!(
        "longitudinal, {} lateral, spin {} 1/m",
        number(kinematics.creepage_y),
        number(kinematics.spin)
    );
    entry(text, "creepage", kinematics.creepage_x, "", &creepages);
    if normal.origin.is_some() {
        reference(text, solution);
    }
}

/// The reference point of creepages and moment, and both for the other point.
fn reference(text: &mut Summary, solution: &Solution) {
    let name = |point| match point {
        ReferencePoint::Patch => "the middle of the patch",
        ReferencePoint::File => "the origin of the file",
    };
    let (here, there) = match solution.reference {
        ReferencePoint::Patch => (ReferencePoint::Patch, ReferencePoint::File),
        ReferencePoint::File => (ReferencePoint::File, ReferencePoint::Patch),
    };
    line(text, &format!("  creepages and moment are those at {}", name(here)));
    if let Some((kinematics, force)) = solution.seen_from(there) {
        let [x, y] = [kinematics.creepage_x, kinematics.creepage_y].map(number);
        let moment = number(force.moment_z);
        line(text, &format!("  at {} {x}, {y}, moment {moment} N m", name(there)));
    }
}

fn forces(text: &mut Summary, solution: &Solution) {
    let Solution { force, normalised, t_gamma, .. } = solution;
    let x = without_noise(force.x, normalised.x);
    let y = without_noise(force.y, normalised.y);
    let traction = if x == 0.0 && y == 0.0 { 0.0 } else { solution.traction_coefficient };
    let over = |value: Option<f64>, bound: &str| {
        format!("{} {bound}", number(value.map(|value| without_noise(value, value))))
    };
    line(text, "on the wheel");
    entry(text, "longitudinal force", x / 1e3, "kN", &over(Some(normalised.x), "μ0 N"));
    entry(text, "lateral force", y / 1e3, "kN", &over(Some(normalised.y), "μ0 N"));
    let remark = over(normalised.moment_z, "μ0 N √(ab)");
    entry(text, "moment", moment(force, normalised), "N m", &remark);
    entry(text, "traction coefficient", traction, "", "|F|/N");
    entry(
        text,
        "T-gamma",
        t_gamma.without_spin,
        "N",
        &format!("{} N with spin", number(t_gamma.with_spin)),
    );
    friction_power(text, solution);
    if solution.method.has_fields() && solution.temperature.is_none() {
        // Without a heat model friction heats nothing.
        return text.blank();
    }
    let (watts, unit) = unit_of_power(solution);
    let into = |heat: fn(&Power) -> f64| solution.power.as_ref().map(|power| heat(power) / watts);
    let rail = number(into(|power| power.into_rail));
    let remark = format!("into the wheel, {rail} {unit} into the rail");
    entry(text, "  heat", into(|power| power.into_wheel), unit, &remark);
    text.blank();
}

fn heat_and_areas(text: &mut Summary, solution: &Solution) {
    if let Some(temperature) = &solution.temperature {
        heat(text, solution, temperature);
    }
    let area = &solution.area;
    let share = area.slip.map(|slip| 100.0 * slip / area.contact);
    let slides = share.map_or_else(String::new, |share| format!("{} % slides", number(share)));
    entry(text, "contact area", area.contact / 1e-6, "mm²", &slides);
    text.blank();
}

fn heat(text: &mut Summary, solution: &Solution, temperature: &Temperature) {
    let mut place = String::new();
    if temperature.max_rise != 0.0 {
        let (x, y) = (number(temperature.x / 1e-3), number(temperature.y / 1e-3));
        place = format!("at x = {x} mm, y = {y} mm");
    }
    if solution.status == Status::NotConverged {
        place.push_str("  (not settled)");
    }
    entry(text, "largest temp. rise", temperature.max_rise, "K", &place);
    let wheel = format!("to {} °C", number(temperature.max_wheel));
    entry(text, "  wheel", temperature.max_rise_wheel, "K", &wheel);
    let rail = format!("to {} °C", number(temperature.max_rail));
    entry(text, "  rail", temperature.max_rise_rail, "K", &rail);
    let [wheel, rail] = solution.peclet;
    entry(
        text,
        "Péclet number",
        wheel,
        "",
        &format!("v a/κ of the wheel, {} of the rail", number(rail)),
    );
}

fn work(text: &mut Summary, report: &SolutionReport) {
    let solution = &report.solution;
    let work = &solution.work;
    if solution.method != Method::Full {
        fast_work(text, solution);
        return;
    }
    let steps = if work.steps > 0 { format!("{} time steps, ", work.steps) } else { String::new() };
    let done = format!(
        "{} cells, {steps}{} Newton iterations, {} products with the compliance",
        work.cells,
        work.newton_iterations,
        number(work.operator_products)
    );
    let status = verdict(solution.status);
    line(text, &format!("{status}, relative residual {}", number(solution.residual)));
    for reason in reasons(&report.warnings) {
        line(text, &format!("  {reason}"));
    }
    line(text, &done);
}

/// A fast method does not iterate, so nothing can fail to converge.
fn fast_work(text: &mut Summary, solution: &Solution) {
    let name = solution.method.name();
    let cells = solution.work.cells;
    if cells == 0 {
        line(text, &format!("by the fast method {name:?}"));
    } else {
        line(text, &format!("by the fast method {name:?}, {cells} cells"));
    }
}
