//! The result as JSON, for other programs. Names and signs are fixed; see the interface page.

use std::io;

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::{Formatter, PrettyFormatter};

use schlupf::Method;
use schlupf::bodies::{Kinematics, ReferencePoint};
use schlupf::normal::NormalSummary;
use schlupf::reporting::Message;
use schlupf::solution::{
    Area, Extrapolation, Instant, Power, Resultant, Sensitivity, Solution, Status, TGamma,
    Temperature, Work,
};
use schlupf::wheel_rail::WheelSolution;

use crate::output::contact_law::ContactLaw;
use crate::output::number::without_sign_of_zero;
use crate::output::solution::wheel::WheelDocument;
use crate::output::table::{Arrays, Row};

/// Name and version of the program.
pub(crate) const PROGRAM: &str = concat!("schlupf ", env!("CARGO_PKG_VERSION"));

/// A document as text.
pub(crate) fn text(document: &impl Serialize) -> String {
    let mut text = Vec::new();
    let formatter = Numbers { layout: PrettyFormatter::new() };
    // Plain structs of numbers and text with text keys: nothing can fail.
    let _ = document.serialize(&mut Serializer::with_formatter(&mut text, formatter));
    String::from_utf8_lossy(&text).into_owned() + "\n"
}

/// The layout of [`PrettyFormatter`] with 0 for −0.
struct Numbers {
    layout: PrettyFormatter<'static>,
}

/// Forwards methods of a formatter to the layout.
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

/// A solution with its title, and the k_c used if the method has one.
#[derive(Serialize)]
pub(crate) struct Document<'a> {
    program: &'static str,
    title: &'a str,
    method: Method,
    status: Status,
    normal: &'a NormalSummary,
    kinematics: KinematicsEntry,
    reference: Reference,
    #[serde(skip_serializing_if = "Option::is_none")]
    contact_law: Option<&'a ContactLaw>,
    force: &'a Resultant,
    normalised: &'a Resultant,
    traction_coefficient: f64,
    power: Row<'a, Power>,
    t_gamma: &'a TGamma,
    temperature: Temperatures<'a>,
    area: &'a Area,
    sensitivity: Option<&'a Sensitivity>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extrapolation: Option<&'a Extrapolation>,
    history: Arrays<'a, [Instant]>,
    #[serde(flatten)]
    wheel: Option<WheelDocument<'a>>,
    warnings: &'a [Message],
    residual: f64,
    work: &'a Work,
}

#[derive(Serialize)]
struct Temperatures<'a> {
    #[serde(flatten)]
    largest: Row<'a, Temperature>,
    peclet_wheel: f64,
    peclet_rail: f64,
}

/// Speed and creepages. What speed that is follows from the case.
#[derive(Serialize)]
pub(super) struct KinematicsEntry {
    speed: f64,
    creepage_x: f64,
    creepage_y: f64,
    spin: f64,
}

impl KinematicsEntry {
    pub fn of(motion: &Kinematics) -> Self {
        let Kinematics { speed, creepage_x, creepage_y, spin, .. } = *motion;
        Self { speed, creepage_x, creepage_y, spin }
    }
}

/// The reference point of creepages and moments in the document, and their values for each of the
/// points.
#[derive(Serialize)]
struct Reference {
    point: ReferencePoint,
    patch: Option<SeenFrom>,
    file: Option<SeenFrom>,
}

/// Creepages at a point, and the moment about it.
#[derive(Serialize)]
struct SeenFrom {
    creepage_x: f64,
    creepage_y: f64,
    spin: f64,
    moment_z: Option<f64>,
}

impl Reference {
    fn new(solution: &Solution) -> Self {
        let seen_from = |reference| {
            let (kinematics, force) = solution.seen_from(reference)?;
            let Kinematics { creepage_x, creepage_y, spin, .. } = kinematics;
            Some(SeenFrom { creepage_x, creepage_y, spin, moment_z: force.moment_z })
        };
        Self {
            point: solution.reference,
            patch: seen_from(ReferencePoint::Patch),
            file: seen_from(ReferencePoint::File),
        }
    }
}

impl<'a> Document<'a> {
    /// The document of a solution.
    pub(crate) fn new(title: &'a str, solution: &'a Solution, warnings: &'a [Message]) -> Self {
        let [peclet_wheel, peclet_rail] = solution.peclet;
        Self {
            program: PROGRAM,
            title,
            method: solution.method.clone(),
            status: solution.status,
            normal: &solution.normal,
            kinematics: KinematicsEntry::of(&solution.kinematics),
            reference: Reference::new(solution),
            contact_law: None,
            force: &solution.force,
            normalised: &solution.normalised,
            traction_coefficient: solution.traction_coefficient,
            power: Row(solution.power.as_ref()),
            t_gamma: &solution.t_gamma,
            temperature: Temperatures {
                largest: Row(solution.temperature.as_ref()),
                peclet_wheel,
                peclet_rail,
            },
            area: &solution.area,
            sensitivity: solution.sensitivity.as_ref(),
            extrapolation: solution.extrapolation.as_ref(),
            history: Arrays(&solution.history),
            wheel: None,
            warnings,
            residual: solution.residual,
            work: &solution.work,
        }
    }

    /// The same with the k_c used and its origin.
    pub(crate) fn with_law(self, contact_law: Option<&'a ContactLaw>) -> Self {
        Self { contact_law, ..self }
    }

    /// The same with all contacts of a wheel, and the status of all of them.
    pub(crate) fn with_wheel(self, wheel: Option<&'a WheelSolution>, status: Status) -> Self {
        Self { wheel: wheel.map(WheelDocument::new), status, ..self }
    }
}
