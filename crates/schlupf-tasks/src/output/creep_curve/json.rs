//! Creep curves as JSON, for other programs.

use serde::Serialize;

use schlupf::Method;
use schlupf::analysis::creep_curve::{Abscissa, CreepCurve, Creepages, InitialSlope, Maximum};
use schlupf::bodies::ReferencePoint;
use schlupf::normal::NormalSummary;
use schlupf::reporting::Message;
use schlupf::solution::Work;

use super::{CreepMap, CurveFamily, Member};
use crate::output::json::{PROGRAM, text};
use crate::output::table::Arrays;

/// The curves as a JSON document: SI units, forces on the wheel. A number that is not finite
/// becomes `null`.
pub fn document(family: &CurveFamily) -> String {
    text(&Document {
        program: PROGRAM,
        title: &family.title,
        path: family.members.first().map(|member| PathEntry::new(&member.curve, family.spacing)),
        over: OneOrMore::of(
            family
                .over
                .iter()
                .enumerate()
                .map(|(k, field)| Over { field, values: texts(family, k) }),
        ),
        map: family.map(),
        curves: family.members.iter().map(Curve::new).collect(),
        warnings: &family.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    path: Option<PathEntry>,
    over: Option<OneOrMore<Over<'a>>>,
    map: Option<CreepMap>,
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
    fn new(curve: &CreepCurve, spacing: &'static str) -> Self {
        let path = &curve.path;
        let [start, end] = path.range();
        let varied = |component: fn(&Creepages) -> f64| {
            let ends = [path.start(), path.end()].map(|creepages| component(&creepages));
            (ends[0] != ends[1]).then_some(ends)
        };
        Self {
            abscissa: path.quantity().name(),
            start,
            end,
            creepage_x: varied(|creepages| creepages.x),
            creepage_y: varied(|creepages| creepages.y),
            spin: varied(|creepages| creepages.spin),
            direction: match path.abscissa() {
                Some(Abscissa::Total { direction }) => Some(direction),
                _ => None,
            },
            points: curve.points.len(),
            spacing,
        }
    }
}

/// What belongs to one field or to each of several.
#[derive(Serialize)]
#[serde(untagged)]
enum OneOrMore<T> {
    One(T),
    More(Vec<T>),
}

impl<T> OneOrMore<T> {
    fn of(entries: impl Iterator<Item = T>) -> Option<Self> {
        let mut entries: Vec<T> = entries.collect();
        match entries.len() {
            0 | 1 => entries.pop().map(Self::One),
            _ => Some(Self::More(entries)),
        }
    }
}

/// The different values of a field, in their order.
fn texts(family: &CurveFamily, field: usize) -> Vec<&str> {
    let mut texts: Vec<&str> = Vec::new();
    for value in family.members.iter().filter_map(|member| member.values.get(field)) {
        if !texts.contains(&value.text.as_str()) {
            texts.push(&value.text);
        }
    }
    texts
}

#[derive(Serialize)]
struct Over<'a> {
    field: &'a str,
    values: Vec<&'a str>,
}

#[derive(Serialize)]
struct Curve<'a> {
    value: Option<OneOrMore<&'a str>>,
    method: Method,
    normal: &'a NormalSummary,
    /// Reference point of creepages and moments.
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
            value: OneOrMore::of(member.values.iter().map(|value| value.text.as_str())),
            method: curve.method.clone(),
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
