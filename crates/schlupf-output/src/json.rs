//! The result as JSON, for other programs. Names and signs are fixed; see the interface page.

use std::io;

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::{Formatter, PrettyFormatter};

use schlupf::kinematics::ReferencePoint;
use schlupf::normal::NormalSummary;
use schlupf::solution::{Instant, Resultant, Solution, Status};
use schlupf::{kinematics, solution};

use crate::contact_law::ContactLaw;
use crate::number::without_sign_of_zero;

/// The result of a case as a JSON document: SI units, temperatures in degC and their rises in K,
/// forces on the wheel. A number that is not finite becomes `null`.
pub fn document(title: &str, solution: &Solution) -> String {
    text(&Document::new(title, solution))
}

/// The same with the k_c that was used and where it comes from, as `contact_law`.
pub fn document_with_law(title: &str, contact_law: &ContactLaw, solution: &Solution) -> String {
    text(&Document { contact_law: Some(contact_law), ..Document::new(title, solution) })
}

/// Name and version of the program.
pub(crate) const PROGRAM: &str = concat!("schlupf ", env!("CARGO_PKG_VERSION"));

/// A status as results name it.
pub(crate) fn status(status: Status) -> &'static str {
    match status {
        Status::Converged => "converged",
        Status::NotConverged => "not-converged",
    }
}

/// A document as text.
pub(crate) fn text(document: &impl Serialize) -> String {
    let mut text = Vec::new();
    let formatter = Numbers { layout: PrettyFormatter::new() };
    // Plain structs of numbers and text with text keys: there is nothing that could fail.
    let _ = document.serialize(&mut Serializer::with_formatter(&mut text, formatter));
    String::from_utf8_lossy(&text).into_owned() + "\n"
}

/// The layout of [`PrettyFormatter`] with 0 for −0.
struct Numbers {
    layout: PrettyFormatter<'static>,
}

/// Hands methods of a formatter on to the layout.
macro_rules! as_layout {
    ($($method:ident($($argument:ident: $kind:ty),*);)*) => {
        $(fn $method<W: ?Sized + io::Write>(
            &mut self,
            writer: &mut W
            $(, $argument: $kind)*
        ) -> io::Result<()> {
            self.layout.$method(writer $(, $argument)*)
        })*
    };
}

impl Formatter for Numbers {
    fn write_f64<W: ?Sized + io::Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        self.layout.write_f64(writer, without_sign_of_zero(value))
    }

    as_layout! {
        begin_array();
        end_array();
        begin_array_value(first: bool);
        end_array_value();
        begin_object();
        end_object();
        begin_object_key(first: bool);
        begin_object_value();
        end_object_value();
    }
}

#[derive(Serialize)]
pub(crate) struct Document<'a> {
    program: &'static str,
    title: &'a str,
    method: &'static str,
    status: &'static str,
    normal: Normal,
    kinematics: Kinematics,
    reference: Reference,
    #[serde(skip_serializing_if = "Option::is_none")]
    contact_law: Option<&'a ContactLaw>,
    force: Vector,
    normalised: Vector,
    traction_coefficient: f64,
    power: Power,
    t_gamma: TGamma,
    temperature: Temperature,
    area: Area,
    sensitivity: Option<Sensitivity>,
    history: History,
    warnings: &'a [String],
    residual: f64,
    work: Work,
}

/// Derivatives of force and moment by each parameter.
#[derive(Serialize)]
struct Sensitivity {
    creepage_x: Vector,
    creepage_y: Vector,
    spin: Vector,
    load: Option<Vector>,
    friction_coefficient: Vector,
    contact_stiffness: Vector,
}

#[derive(Serialize)]
pub(crate) struct Normal {
    load: f64,
    semi_axis_x: f64,
    semi_axis_y: f64,
    peak_pressure: f64,
    approach: Option<f64>,
    origin_x: Option<f64>,
    origin_y: Option<f64>,
    parts: usize,
}

#[derive(Serialize)]
pub(crate) struct Kinematics {
    speed: f64,
    creepage_x: f64,
    creepage_y: f64,
    spin: f64,
}

/// Which point creepages and moments of the document refer to, and both by each.
#[derive(Serialize)]
struct Reference {
    point: &'static str,
    patch: Option<SeenFrom>,
    file: Option<SeenFrom>,
}

/// Creepages at a point, and the moment about it.
#[derive(Serialize)]
struct SeenFrom {
    creepage_x: f64,
    creepage_y: f64,
    spin: f64,
    moment_z: f64,
}

impl Reference {
    fn new(solution: &Solution) -> Self {
        let seen_from = |reference| {
            let (kinematics, force) = solution.seen_from(reference)?;
            Some(SeenFrom {
                creepage_x: kinematics.creepage_x,
                creepage_y: kinematics.creepage_y,
                spin: kinematics.spin,
                moment_z: force.moment_z,
            })
        };
        Self {
            point: solution.reference.name(),
            patch: seen_from(ReferencePoint::Patch),
            file: seen_from(ReferencePoint::File),
        }
    }
}

#[derive(Serialize)]
pub(crate) struct Vector {
    x: f64,
    y: f64,
    moment_z: f64,
}

#[derive(Serialize)]
struct Power {
    friction: f64,
    creep: f64,
    returned: f64,
    into_wheel: f64,
    into_rail: f64,
    exchanged: f64,
}

#[derive(Serialize)]
struct TGamma {
    without_spin: f64,
    with_spin: f64,
}

#[derive(Serialize)]
struct Temperature {
    max_rise: f64,
    max_rise_wheel: f64,
    max_rise_rail: f64,
    max_wheel: f64,
    max_rail: f64,
    x: f64,
    y: f64,
    peclet_wheel: f64,
    peclet_rail: f64,
}

#[derive(Serialize)]
struct Area {
    contact: f64,
    stick: f64,
    slip: f64,
}

/// One array per quantity, all of the same length.
#[derive(Serialize)]
struct History {
    time: Vec<f64>,
    distance: Vec<f64>,
    speed: Vec<f64>,
    creepage_x: Vec<f64>,
    creepage_y: Vec<f64>,
    spin: Vec<f64>,
    load: Vec<f64>,
    force_x: Vec<f64>,
    force_y: Vec<f64>,
    moment_z: Vec<f64>,
    friction_power: Vec<f64>,
    creep_power: Vec<f64>,
    stored_energy: Vec<f64>,
    max_rise: Vec<f64>,
}

#[derive(Serialize)]
pub(crate) struct Work {
    newton_iterations: usize,
    operator_products: f64,
    sensitivity_products: usize,
    outer_iterations: usize,
    steps: usize,
    cells: usize,
}

impl<'a> Document<'a> {
    /// The document of a solution.
    pub(crate) fn new(title: &'a str, solution: &'a Solution) -> Self {
        let Solution { normal, kinematics, power, t_gamma, temperature, area, work, .. } = solution;
        Self {
            program: PROGRAM,
            title,
            method: solution.method.name(),
            status: status(solution.status),
            normal: normal.into(),
            kinematics: kinematics.into(),
            reference: Reference::new(solution),
            contact_law: None,
            force: solution.force.into(),
            normalised: solution.normalised.into(),
            traction_coefficient: solution.traction_coefficient,
            power: Power {
                friction: power.friction,
                creep: power.creep,
                returned: power.returned,
                into_wheel: power.into_wheel,
                into_rail: power.into_rail,
                exchanged: power.exchanged,
            },
            t_gamma: TGamma { without_spin: t_gamma.without_spin, with_spin: t_gamma.with_spin },
            temperature: Temperature {
                max_rise: temperature.max_rise,
                max_rise_wheel: temperature.max_rise_wheel,
                max_rise_rail: temperature.max_rise_rail,
                max_wheel: temperature.max_wheel,
                max_rail: temperature.max_rail,
                x: temperature.x,
                y: temperature.y,
                peclet_wheel: solution.peclet[0],
                peclet_rail: solution.peclet[1],
            },
            area: Area { contact: area.contact, stick: area.stick, slip: area.slip },
            sensitivity: solution.sensitivity.as_ref().map(Sensitivity::from),
            history: History::new(&solution.history),
            warnings: &solution.warnings,
            residual: solution.residual,
            work: work.into(),
        }
    }
}

impl From<&NormalSummary> for Normal {
    fn from(normal: &NormalSummary) -> Self {
        Self {
            load: normal.load,
            semi_axis_x: normal.semi_axis_x,
            semi_axis_y: normal.semi_axis_y,
            peak_pressure: normal.peak_pressure,
            approach: normal.approach,
            origin_x: normal.origin.map(|[x, _]| x),
            origin_y: normal.origin.map(|[_, y]| y),
            parts: normal.parts,
        }
    }
}

impl From<&kinematics::Kinematics> for Kinematics {
    fn from(kinematics: &kinematics::Kinematics) -> Self {
        Self {
            speed: kinematics.speed,
            creepage_x: kinematics.creepage_x,
            creepage_y: kinematics.creepage_y,
            spin: kinematics.spin,
        }
    }
}

impl From<&solution::Work> for Work {
    fn from(work: &solution::Work) -> Self {
        Self {
            newton_iterations: work.newton_iterations,
            operator_products: work.operator_products,
            sensitivity_products: work.sensitivity_products,
            outer_iterations: work.outer_iterations,
            steps: work.steps,
            cells: work.cells,
        }
    }
}

impl From<&solution::Sensitivity> for Sensitivity {
    fn from(sensitivity: &solution::Sensitivity) -> Self {
        Self {
            creepage_x: sensitivity.creepage_x.into(),
            creepage_y: sensitivity.creepage_y.into(),
            spin: sensitivity.spin.into(),
            load: sensitivity.load.map(Vector::from),
            friction_coefficient: sensitivity.friction_coefficient.into(),
            contact_stiffness: sensitivity.contact_stiffness.into(),
        }
    }
}

impl From<Resultant> for Vector {
    fn from(resultant: Resultant) -> Self {
        Self { x: resultant.x, y: resultant.y, moment_z: resultant.moment_z }
    }
}

impl History {
    fn new(history: &[Instant]) -> Self {
        let column = |value: fn(&Instant) -> f64| history.iter().map(value).collect();
        Self {
            time: column(|instant| instant.time),
            distance: column(|instant| instant.distance),
            speed: column(|instant| instant.kinematics.speed),
            creepage_x: column(|instant| instant.kinematics.creepage_x),
            creepage_y: column(|instant| instant.kinematics.creepage_y),
            spin: column(|instant| instant.kinematics.spin),
            load: column(|instant| instant.load),
            force_x: column(|instant| instant.force.x),
            force_y: column(|instant| instant.force.y),
            moment_z: column(|instant| instant.force.moment_z),
            friction_power: column(|instant| instant.friction_power),
            creep_power: column(|instant| instant.creep_power),
            stored_energy: column(|instant| instant.stored_energy),
            max_rise: column(|instant| instant.max_rise),
        }
    }
}
