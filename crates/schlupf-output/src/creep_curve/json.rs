//! Creep curves as JSON, for other programs.

use serde::Serialize;

use schlupf::creep_curve::{
    Abscissa, CreepCurve, Creepages, InitialSlope, Maximum, Path, Point, Spacing,
};

use super::{CurveFamily, Member};
use crate::json::{Kinematics, Normal, PROGRAM, Vector, Work, status, text};

/// The curves as a JSON document: SI units, forces on the wheel. A number that is not finite becomes
/// `null`.
pub fn document(family: &CurveFamily) -> String {
    text(&Document {
        program: PROGRAM,
        title: &family.title,
        path: family.members.first().map(|member| PathEntry::new(&member.curve.path, family)),
        over: family.over.as_deref().map(|field| Over {
            field,
            values: family.members.iter().filter_map(|member| member.value.as_deref()).collect(),
        }),
        curves: family.members.iter().map(Curve::new).collect(),
        warnings: family.warnings(),
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    path: Option<PathEntry>,
    over: Option<Over<'a>>,
    curves: Vec<Curve<'a>>,
    warnings: Vec<String>,
}

/// Which creepages vary; `null` for those that do not.
#[derive(Serialize)]
struct PathEntry {
    abscissa: &'static str,
    start: f64,
    end: f64,
    creepage_x: Option<[f64; 2]>,
    creepage_y: Option<[f64; 2]>,
    spin: Option<[f64; 2]>,
    direction: Option<f64>,
    points: usize,
    spacing: &'static str,
}

impl PathEntry {
    fn new(path: &Path, family: &CurveFamily) -> Self {
        let [start, end] = path.range();
        let varied = |component: fn(&Creepages) -> f64| {
            let ends = [path.start(), path.end()].map(|creepages| component(&creepages));
            (ends[0] != ends[1]).then_some(ends)
        };
        Self {
            abscissa: path.abscissa().name(),
            start,
            end,
            creepage_x: varied(|creepages| creepages.x),
            creepage_y: varied(|creepages| creepages.y),
            spin: varied(|creepages| creepages.spin),
            direction: match path.abscissa() {
                Abscissa::Total { direction } => Some(direction),
                _ => None,
            },
            points: family.sampling.points,
            spacing: match family.sampling.spacing {
                Spacing::Refined => "refined",
                Spacing::Even => "even",
            },
        }
    }
}

#[derive(Serialize)]
struct Over<'a> {
    field: &'a str,
    values: Vec<&'a str>,
}

#[derive(Serialize)]
struct Curve<'a> {
    value: Option<&'a str>,
    method: &'static str,
    normal: Normal,
    /// Where creepages hold, and about which point moments are taken.
    reference: &'static str,
    initial_slope: Option<Slope>,
    maximum: Option<Top>,
    maxima: Vec<Top>,
    points: Points,
    work: Work,
}

impl<'a> Curve<'a> {
    fn new(member: &'a Member) -> Self {
        let curve = &member.curve;
        Self {
            value: member.value.as_deref(),
            method: curve.method.name(),
            normal: (&curve.normal).into(),
            reference: curve.reference.name(),
            initial_slope: curve.initial_slope.as_ref().map(Slope::new),
            maximum: curve.maximum().map(Top::new),
            maxima: curve.maxima.iter().map(Top::new).collect(),
            points: Points::new(curve),
            work: (&curve.work).into(),
        }
    }
}

/// Derivatives with respect to the abscissa.
#[derive(Serialize)]
struct Slope {
    force: Vector,
    normalised: Vector,
    kalker: Option<Vector>,
}

impl Slope {
    fn new(slope: &InitialSlope) -> Self {
        Self {
            force: slope.force.into(),
            normalised: slope.normalised.into(),
            kalker: slope.kalker.map(Vector::from),
        }
    }
}

#[derive(Serialize)]
struct Top {
    abscissa: f64,
    kinematics: Kinematics,
    force: Vector,
    normalised: Vector,
    traction_coefficient: f64,
    saturated: bool,
}

impl Top {
    fn new(maximum: &Maximum) -> Self {
        Self {
            abscissa: maximum.abscissa,
            kinematics: (&maximum.kinematics).into(),
            force: maximum.force.into(),
            normalised: maximum.normalised.into(),
            traction_coefficient: maximum.traction_coefficient,
            saturated: maximum.is_saturated,
        }
    }
}

/// One array per quantity, all of the same length.
#[derive(Serialize)]
struct Points {
    abscissa: Vec<f64>,
    speed: Vec<f64>,
    creepage_x: Vec<f64>,
    creepage_y: Vec<f64>,
    spin: Vec<f64>,
    force_x: Vec<f64>,
    force_y: Vec<f64>,
    moment_z: Vec<f64>,
    normalised_x: Vec<f64>,
    normalised_y: Vec<f64>,
    normalised_moment_z: Vec<f64>,
    traction_coefficient: Vec<f64>,
    friction_power: Vec<f64>,
    creep_power: Vec<f64>,
    max_rise: Vec<f64>,
    contact_area: Vec<f64>,
    stick_area: Vec<f64>,
    slip_area: Vec<f64>,
    status: Vec<&'static str>,
    residual: Vec<f64>,
    newton_iterations: Vec<usize>,
    operator_products: Vec<f64>,
}

impl Points {
    fn new(curve: &CreepCurve) -> Self {
        let column = |value: fn(&Point) -> f64| curve.points.iter().map(value).collect();
        Self {
            abscissa: column(|point| point.abscissa),
            speed: column(|point| point.kinematics.speed),
            creepage_x: column(|point| point.kinematics.creepage_x),
            creepage_y: column(|point| point.kinematics.creepage_y),
            spin: column(|point| point.kinematics.spin),
            force_x: column(|point| point.force.x),
            force_y: column(|point| point.force.y),
            moment_z: column(|point| point.force.moment_z),
            normalised_x: column(|point| point.normalised.x),
            normalised_y: column(|point| point.normalised.y),
            normalised_moment_z: column(|point| point.normalised.moment_z),
            traction_coefficient: column(|point| point.traction_coefficient),
            friction_power: column(|point| point.power.friction),
            creep_power: column(|point| point.power.creep),
            max_rise: column(|point| point.max_rise),
            contact_area: column(|point| point.area.contact),
            stick_area: column(|point| point.area.stick),
            slip_area: column(|point| point.area.slip),
            status: curve.points.iter().map(|point| status(point.status)).collect(),
            residual: column(|point| point.residual),
            newton_iterations: curve.points.iter().map(|p| p.work.newton_iterations).collect(),
            operator_products: column(|point| point.work.operator_products),
        }
    }
}
