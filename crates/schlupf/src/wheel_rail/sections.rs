//! Surfaces that change along the way: profiles at some places of the track, or at some angles
//! around a wheel, and what is between them.
//!
//! Every section is a curve of its own. Breaks divide it into parts, and the points of a part at
//! the same share of its length belong together: v, which is the arc length of the longest of the
//! sections, counts along the part in all of them. Along the way u, each such path y(u), z(u) is a
//! cubic spline, through its points without a knot next to the ends
//! ([`Interpolation::Through`]), or one with the points as control points
//! ([`Interpolation::Smooth`]), as in CONTACT. So a section that is repeated is itself everywhere,
//! and its own curve at its place.
//!
//! A part may be missing in some sections; it ends at the last one that has it. Before the first
//! and behind the last section the surface does not change, unless sections of a wheel cover its
//! circumference: these go on around it.

use std::f64::consts::{PI, TAU};
use std::sync::{Arc, OnceLock};

use super::profile_curve::{CurvePoint, ProfileCurve};
use super::spline;
use crate::numerics::interpolation::{hermite, hermite_slope};
use crate::reporting::{
    Error, Place, Quantity, Requirement, WheelRailError, require_at, require_finite,
};

/// Weights of other sections below which they do not count, dimensionless.
const NEGLIGIBLE: f64 = 1e-13;

/// Sections by which those around a wheel go on at both ends: the spline forgets its ends by a
/// factor of 2 − √3 from one to the next.
const ROUND: usize = 30;

/// Part of a turn that rounding leaves, dimensionless.
const SAME: f64 = 1e-6;

/// A profile at a place along the way.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Where it is: along the track in m, or around a wheel in rad, positive forwards from the
    /// point below the axle.
    pub place: f64,
    /// Its profile.
    pub curve: ProfileCurve,
    /// Arc lengths at which its parts begin and end, in m, ascending; `None` for those that it does
    /// not have. All sections have as many.
    pub breaks: Vec<Option<f64>>,
}

/// How a surface goes from one section to the next one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Through all sections.
    Through,
    /// Near them, and smoother.
    Smooth,
}

/// A surface through sections.
#[derive(Debug, Clone, PartialEq)]
pub struct Sections {
    /// In m or rad, ascending.
    places: Vec<f64>,
    /// v at the breaks, in m.
    ends: Vec<f64>,
    parts: Vec<Vec<Run>>,
    first: ProfileCurve,
    is_smoothed: bool,
}

/// Neighbouring sections that have a part.
#[derive(Debug, Clone, PartialEq)]
struct Run {
    /// Index of the first of them.
    first: usize,
    curves: Vec<Arc<ProfileCurve>>,
    /// Arc lengths between which the part is in each of them, in m.
    spans: Vec<[f64; 2]>,
    /// v of the part, in m.
    length: f64,
    weights: Weights,
    /// What has been asked for so far: most sections are far away from a wheelset.
    stations: Vec<OnceLock<Station>>,
}

/// A part in a section, over its arc length.
#[derive(Debug, Clone, PartialEq)]
struct Station {
    /// y and z.
    curve: Arc<ProfileCurve>,
    /// Their derivatives with respect to u.
    rate: ProfileCurve,
}

/// A point of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SurfacePoint {
    /// As a point of its section, over v.
    pub point: CurvePoint,
    /// Derivatives of y and z with respect to u, dimensionless or in m.
    pub rate: [f64; 2],
}

/// Weights of other sections in the values and in the slopes of a path at each of the sections.
#[derive(Debug, Clone, PartialEq)]
struct Weights {
    values: Option<Vec<Vec<f64>>>,
    slopes: Vec<Vec<f64>>,
}

impl Sections {
    /// The surface through at least two sections at ascending places; `quantity` is the profile of
    /// the wheel or of the rail, for messages.
    ///
    /// # Errors
    /// A single section, places or breaks that do not ascend, breaks beyond a profile, sections
    /// with different numbers of breaks or without a part, parts of one section only.
    pub fn new(
        sections: &[Section],
        interpolation: Interpolation,
        quantity: Quantity,
    ) -> Result<Self, Error> {
        let [first, _, ..] = sections else {
            let (count, fewest) = (sections.len(), 2);
            return Err(WheelRailError::FewSections { profile: quantity, count, fewest }.into());
        };
        check(sections, quantity)?;
        let curves: Vec<Arc<ProfileCurve>> =
            sections.iter().map(|section| Arc::new(section.curve.clone())).collect();
        let places: Vec<f64> = sections.iter().map(|section| section.place).collect();
        let mut ends = vec![0.0];
        let mut parts = Vec::new();
        for part in 0..first.breaks.len() - 1 {
            let spans: Vec<Option<[f64; 2]>> = sections
                .iter()
                .map(|section| Some([section.breaks[part]?, section.breaks[part + 1]?]))
                .collect();
            let lengths = spans.iter().flatten().map(|[from, to]| to - from);
            let length = lengths.fold(0.0, f64::max);
            let groups = spans.chunk_by(|one, two| one.is_some() == two.is_some());
            let mut start = 0;
            let mut runs = Vec::new();
            for group in groups {
                let own = start..start + group.len();
                start = own.end;
                let spans: Vec<[f64; 2]> = group.iter().flatten().copied().collect();
                if spans.is_empty() {
                    continue;
                }
                if spans.len() == 1 {
                    let (part, place) = (part + 1, places[own.start]);
                    return Err(
                        WheelRailError::LonelyPart { profile: quantity, part, place }.into()
                    );
                }
                let weights = Weights::new(&places[own.clone()], interpolation);
                let stations = vec![OnceLock::new(); spans.len()];
                let (first, curves) = (own.start, curves[own].to_vec());
                runs.push(Run { first, curves, spans, length, weights, stations });
            }
            ends.push(ends[part] + length);
            parts.push(runs);
        }
        let is_smoothed = sections.iter().any(|section| section.curve.smoothing() > 0.0);
        Ok(Self { places, ends, parts, first: first.curve.clone(), is_smoothed })
    }

    /// The same around a wheel. The sections cover its circumference if the way from the last to
    /// the first one, a turn later, is no longer than the longest between two others; the last one
    /// may be the first one again. They may also overlap, from before −π to behind π.
    ///
    /// # Errors
    /// The same, a first section that is another one after a turn, and others beyond ±π.
    pub fn around(sections: &[Section], interpolation: Interpolation) -> Result<Self, Error> {
        let quantity = Quantity::WheelProfile;
        let new = |sections: &[Section]| Self::new(sections, interpolation, quantity);
        let ([first, ..], [.., last]) = (sections, sections) else { return new(sections) };
        check(sections, quantity)?;
        let open = TAU - (last.place - first.place);
        let steps = sections.windows(2).map(|pair| pair[1].place - pair[0].place);
        let longest = steps.fold(0.0, f64::max);
        if open < -SAME || open > longest * (1.0 + SAME) {
            let is_inside = [first, last].iter().all(|end| end.place.abs() <= PI);
            let overlaps = open < 0.0 && first.place <= -PI && last.place >= PI;
            if is_inside || overlaps {
                return new(sections);
            }
            return Err(WheelRailError::PartOfTurn { ends: [first.place, last.place] }.into());
        }
        let mut turn = sections.to_vec();
        if open <= SAME
            && let Some(Section { curve, breaks, .. }) = turn.pop()
            && (curve != first.curve || breaks != first.breaks)
        {
            return Err(WheelRailError::OpenTurn { place: last.place }.into());
        }
        let count = turn.len() as isize;
        let margin = ROUND as isize;
        let section = |k: isize| {
            let Section { place, curve, breaks } = &turn[k.rem_euclid(count) as usize];
            let place = place + TAU * k.div_euclid(count) as f64;
            Section { place, curve: curve.clone(), breaks: breaks.clone() }
        };
        // From before −π to behind π, and what goes on at both ends.
        let turns = ((-PI - first.place) / TAU).floor() as isize;
        let ends = [(turns * count) - margin, (turns + 2) * count + margin];
        let round = new(&(ends[0]..=ends[1]).map(section).collect::<Vec<_>>())?;
        Ok(Self { first: first.curve.clone(), ..round })
    }

    /// The places of the first and of the last section, in m or rad.
    pub fn span(&self) -> [f64; 2] {
        [self.places[0], self.places[self.places.len() - 1]]
    }

    /// The profile of the first section.
    pub(super) fn first(&self) -> &ProfileCurve {
        &self.first
    }

    pub(super) fn is_smoothed(&self) -> bool {
        self.is_smoothed
    }

    /// The largest v, in m.
    pub(super) fn length(&self) -> f64 {
        self.ends[self.ends.len() - 1]
    }

    /// The point at u (in m or rad) and v (in m); `None` where the part is missing.
    pub(super) fn at(&self, u: f64, v: f64) -> Option<SurfacePoint> {
        let part = self.ends.partition_point(|end| *end <= v).clamp(1, self.parts.len()) - 1;
        let along = v - self.ends[part];
        let [from, to] = self.span();
        let inside = u.clamp(from, to);
        let after = self.places.partition_point(|place| *place <= inside);
        let k = after.clamp(1, self.places.len() - 1) - 1;
        let is = |run: &&Run| run.first <= k && k + 1 < run.first + run.stations.len();
        let run = self.parts[part].iter().find(is)?;
        let (one, two) = (k - run.first, k + 1 - run.first);
        let width = self.places[k + 1] - self.places[k];
        let t = (inside - self.places[k]) / width;
        let ([one, one_rate], [two, two_rate]) = (run.at(one, along), run.at(two, along));
        let given = [one, two, one_rate, two_rate];
        let sum = |weights: [f64; 4], of: fn(&CurvePoint) -> [f64; 2]| {
            let parts = given.map(|point| of(&point));
            [0, 1].map(|c| {
                let [a, b, c, d] = [parts[0][c], parts[1][c], parts[2][c], parts[3][c]];
                weights[0] * a + weights[1] * b + width * (weights[2] * c + weights[3] * d)
            })
        };
        let value = hermite(t);
        let point = CurvePoint {
            place: sum(value, |point| point.place),
            tangent: sum(value, |point| point.tangent),
            bend: sum(value, |point| point.bend),
        };
        let is_between = u == inside;
        let slope = || sum(hermite_slope(t), |point| point.place).map(|slope| slope / width);
        Some(SurfacePoint { point, rate: if is_between { slope() } else { [0.0; 2] } })
    }
}

impl Run {
    /// Arc length over v in a section, dimensionless.
    fn scale(&self, k: usize) -> f64 {
        (self.spans[k][1] - self.spans[k][0]) / self.length
    }

    /// Point and derivative with respect to u in a section, at v (in m) from the beginning of the
    /// part.
    fn at(&self, k: usize, along: f64) -> [CurvePoint; 2] {
        let Station { curve, rate } = self.stations[k].get_or_init(|| self.station(k));
        let scale = self.scale(k);
        let s = self.spans[k][0] + scale * along;
        [curve.at(s), rate.at(s)].map(|point| over_v(point, scale))
    }

    fn station(&self, k: usize) -> Station {
        Station {
            curve: match &self.weights.values {
                Some(values) => Arc::new(self.mixed(k, &values[k])),
                None => Arc::clone(&self.curves[k]),
            },
            rate: self.mixed(k, &self.weights.slopes[k]),
        }
    }

    /// The sum of the paths in all sections with weights (dimensionless or per unit of u), over the
    /// arc length of one of them.
    fn mixed(&self, own: usize, weights: &[f64]) -> ProfileCurve {
        let largest = weights.iter().fold(0.0_f64, |largest, weight| largest.max(weight.abs()));
        let counts = |k: &usize| weights[*k].abs() > NEGLIGIBLE * largest;
        let others: Vec<usize> = (0..self.curves.len()).filter(counts).collect();
        self.curves[own].mapped(self.spans[own], |s| {
            let along = (s - self.spans[own][0]) / self.scale(own);
            let mut sum = [[0.0; 2]; 2];
            for k in &others {
                let scale = self.scale(*k);
                let point = self.curves[*k].at(self.spans[*k][0] + scale * along);
                let by_length = weights[*k] * scale / self.scale(own);
                sum[0] = [0, 1].map(|c| sum[0][c] + weights[*k] * point.place[c]);
                sum[1] = [0, 1].map(|c| sum[1][c] + by_length * point.tangent[c]);
            }
            sum
        })
    }
}

/// A point of a curve with its derivatives over v, of which the arc length is a multiple
/// (dimensionless).
fn over_v(CurvePoint { place, tangent, bend }: CurvePoint, scale: f64) -> CurvePoint {
    CurvePoint {
        place,
        tangent: tangent.map(|part| scale * part),
        bend: bend.map(|part| scale * scale * part),
    }
}

fn check(sections: &[Section], quantity: Quantity) -> Result<(), Error> {
    let count = sections[0].breaks.len();
    let mut before = f64::NEG_INFINITY;
    for (k, section) in sections.iter().enumerate() {
        let index = k + 1;
        require_finite(quantity, section.place)?;
        let breaks: Vec<f64> = section.breaks.iter().flatten().copied().collect();
        let is_ascending = breaks.windows(2).all(|pair| pair[0] < pair[1]);
        let mut ends = section.breaks.iter().map(Option::is_some);
        let (first, last) = (ends.clone().position(|is| is), ends.rposition(|is| is));
        let is_whole = first
            .zip(last)
            .is_some_and(|(first, last)| last > first && last - first + 1 == breaks.len());
        if section.place <= before || section.breaks.len() != count || !is_ascending || !is_whole {
            return Err(WheelRailError::Section { profile: quantity, index }.into());
        }
        for arc in breaks {
            let inside = Requirement::Between(0.0, section.curve.length());
            require_at(quantity, inside, arc, Place::Index(index))?;
        }
        before = section.place;
    }
    Ok(())
}

impl Weights {
    fn new(places: &[f64], interpolation: Interpolation) -> Self {
        let count = places.len();
        if interpolation == Interpolation::Through {
            let mut slopes = vec![vec![0.0; count]; count];
            for k in 0..count {
                let mut unit = vec![0.0; count];
                unit[k] = 1.0;
                for (row, slope) in slopes.iter_mut().zip(spline::slopes(places, &unit)) {
                    row[k] = slope;
                }
            }
            return Self { values: None, slopes };
        }
        let rows = (0..count).map(|k| spline::control(places, k));
        let (values, slopes) = rows.unzip();
        Self { values: Some(values), slopes }
    }
}
