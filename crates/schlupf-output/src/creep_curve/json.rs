//! Creep curves as JSON, for other programs.

use serde::Serialize;

use schlupf::Method;
use schlupf::creep_curve::{Abscissa, CreepCurve, Creepages, InitialSlope, Maximum, Path, Spacing};
use schlupf::kinematics::ReferencePoint;
use schlupf::message::Message;
use schlupf::normal::NormalSummary;
use schlupf::solution::Work;

use super::{CurveFamily, Member};
use crate::json::{PROGRAM, text};
use crate::table::Arrays;

/// The curves as a JSON document: SI units, forces on the wheel. A number that is not finite
/// becomes `null`.
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
        warnings: &family.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    path: Option<PathEntry>,
    over: Option<Over<'a>>,
    curves: Vec<Curve<'a>>,
    warnings: &'a [Message],
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
            abscissa: path.abscissa().quantity().name(),
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
    method: Method,
    normal: &'a NormalSummary,
    /// Where creepages hold, and about which point moments are taken.
    reference: ReferencePoint,
    initial_slope: Option<InitialSlope>,
    maximum: Option<&'a Maximum>,
    maxima: &'a [Maximum],
    points: Points<'a>,
    work: &'a Work,
}

impl<'a> Curve<'a> {
    fn new(member: &'a Member) -> Self {
        let curve = &member.curve;
        Self {
            value: member.value.as_deref(),
            method: curve.method,
            normal: &curve.normal,
            reference: curve.reference,
            initial_slope: curve.initial_slope,
            maximum: curve.maximum(),
            maxima: &curve.maxima,
            points: Points {
                abscissa: curve.points.iter().map(|point| point.abscissa).collect(),
                others: Arrays(curve),
            },
            work: &curve.work,
        }
    }
}

/// One array per quantity, all of the same length.
#[derive(Serialize)]
struct Points<'a> {
    abscissa: Vec<f64>,
    #[serde(flatten)]
    others: Arrays<'a, CreepCurve>,
}
