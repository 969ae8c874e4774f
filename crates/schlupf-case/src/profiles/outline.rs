//! The line on which the points of a file lie: their order along it, and the part of it that runs.
//!
//! The order of a file is known within runs, in which the line neither turns back nor jumps. A run
//! where an earlier one was is a second pass and left out. Where the line turns back twice or more
//! within a few points its order is lost, and they are sorted along the shortest tree that connects
//! them (Prim 1957): on points of a line this is the line itself. The runs are then joined by the
//! shortest tree that keeps them whole. Where that branches, as where an outline folds back on
//! itself at a rolled lip or has few points, the order of the file stands if the line does not
//! cross itself.

use std::collections::HashSet;
use std::ops::Range;

use schlupf::wheel_rail::LEAST_SPACING;

use super::points::Row;

/// Cosine of the turn from one step to the next that no outline makes, dimensionless: 150°.
const TURNS_BACK: f64 = -0.866;

/// Longest branch that is noise of a measurement, in m.
pub const LONGEST_TWIG: f64 = 5e-4;

/// Fewest points of a loop, whose ends are at most its largest step apart.
const FEWEST_OF_LOOP: usize = 5;

/// Length of a step in the order of the file over that of another one up to which that order
/// stands, dimensionless.
const AS_SHORT: f64 = 1.01;

/// Fewest points of one pass of a measurement, and of an overlap of two.
const FEWEST_OF_PASS: usize = 10;
const FEWEST_OF_OVERLAP: usize = 3;

/// Distance of two passes over the same part, in m.
const SAME_PART: f64 = 1e-3;

/// Most points between two in which a line turns back while its order is lost.
const LONGEST_STRIDE: usize = 5;

/// Points on either side of one that show where the line goes there.
const AROUND: usize = 10;

/// Steps over the usual one from which on one is a jump, dimensionless.
pub const JUMP: f64 = 5.0;

/// Most points that are sorted: the work grows with their square.
const MOST_SORTED: usize = 20_000;

/// Points along a line.
pub struct Outline {
    pub points: Vec<Row>,
    /// Whether the last one is next to the first one.
    pub is_closed: bool,
    /// What was done to the order.
    pub changes: Vec<Change>,
}

/// What was done to the points.
#[derive(Debug, Clone, PartialEq)]
pub enum Change {
    /// Rows that were there before were left out.
    Repeated { count: usize, first: Row },
    /// Points were sorted.
    Sorted { count: usize, first: Row },
    /// Points on which the line turns back, as noise makes them, were left out.
    Beside { count: usize, first: Row },
    /// Two passes cover the same part: the second one was left out there.
    Overlap { ends: [Row; 2], count: usize, distance: f64 },
}

/// Why points are no line.
#[derive(Debug, Clone, PartialEq)]
pub enum NoLine {
    /// It branches here.
    Branches(Row),
    /// Too many to be sorted, the first of them out of order here.
    TooMany(Row),
}

/// The outline through rows in any order.
pub fn outline(rows: &[Row]) -> Result<Outline, NoLine> {
    let mut changes = Vec::new();
    let distinct = distinct(rows, &mut changes);
    let spaced = spaced(&distinct);
    let turn = turns_back(&spaced).first().map(|k| spaced[*k]);
    let has_jump = jumps(&spaced).contains(&true);
    let points = match turn {
        Some(first) if spaced.len() > MOST_SORTED => return Err(NoLine::TooMany(first)),
        None if !has_jump || spaced.len() > MOST_SORTED => distinct,
        _ => sorted(&first_passes(&spaced, &mut changes), &mut changes)?,
    };
    let largest = steps(&points).fold(0.0, f64::max);
    let ends = points.first().zip(points.last());
    let is_closed = points.len() > FEWEST_OF_LOOP
        && ends.is_some_and(|(first, last)| distance(first, last) <= largest);
    Ok(Outline { points, is_closed, changes })
}

/// Distance of two points, in m.
pub fn distance(one: &Row, two: &Row) -> f64 {
    (two.place[0] - one.place[0]).hypot(two.place[1] - one.place[1])
}

fn steps(points: &[Row]) -> impl Iterator<Item = f64> {
    points.windows(2).map(|pair| distance(&pair[0], &pair[1]))
}

/// The usual step from one point to the next, in m.
pub fn median_step(points: &[Row]) -> f64 {
    let mut steps: Vec<f64> = steps(points).collect();
    steps.sort_unstable_by(f64::total_cmp);
    steps.get(steps.len() / 2).copied().unwrap_or(0.0)
}

/// Without rows that were there before.
fn distinct(rows: &[Row], changes: &mut Vec<Change>) -> Vec<Row> {
    let mut seen = HashSet::new();
    let mut kept: Vec<Row> = Vec::with_capacity(rows.len());
    let mut repeated: Vec<Row> = Vec::new();
    let last = rows.len().saturating_sub(1);
    for (k, row) in rows.iter().enumerate() {
        if seen.insert(row.place.map(f64::to_bits)) {
            kept.push(*row);
        } else if k < last && k > 0 && rows[k - 1].place != row.place {
            repeated.push(*row);
        }
    }
    if let Some(first) = repeated.first() {
        changes.push(Change::Repeated { count: repeated.len(), first: *first });
    }
    kept
}

/// Those that a curve runs through.
fn spaced(points: &[Row]) -> Vec<Row> {
    let mut kept: Vec<Row> = Vec::with_capacity(points.len());
    for point in points {
        if kept.last().is_none_or(|last| distance(last, point) >= LEAST_SPACING) {
            kept.push(*point);
        }
    }
    kept
}

/// Where the line turns back: from one step to the next by more than an outline does, and not only
/// from noise, with which it still goes on the way that the points around go.
fn turns_back(points: &[Row]) -> Vec<usize> {
    let end = points.len().saturating_sub(1);
    let turns = |k: &usize| {
        let vector =
            |from: usize, to: usize| [0, 1].map(|c| points[to].place[c] - points[from].place[c]);
        let dot = |p: [f64; 2], q: [f64; 2]| p[0] * q[0] + p[1] * q[1];
        let (before, after) = (vector(k - 1, *k), vector(*k, k + 1));
        let sharp = TURNS_BACK * before[0].hypot(before[1]) * after[0].hypot(after[1]);
        let (from, to) = (k.saturating_sub(AROUND), (k + AROUND).min(end));
        let way = vector(from, to);
        let goes_on = dot(vector(from, *k), vector(*k, to)) > 0.0
            && dot(before, way) > 0.0
            && dot(after, way) > 0.0;
        dot(before, after) < sharp && !goes_on
    };
    (1..end).filter(turns).collect()
}

/// Which steps to the next point are long.
fn long_steps(points: &[Row]) -> Vec<bool> {
    let longest = JUMP * median_step(points);
    steps(points).map(|step| step > longest).collect()
}

/// Which steps are jumps over those around, too. Long steps after each other lead through the
/// corners of an outline with few points.
fn jumps(points: &[Row]) -> Vec<bool> {
    let steps: Vec<f64> = steps(points).collect();
    let length = |k: Option<usize>| k.and_then(|k| steps.get(k)).copied().unwrap_or(0.0);
    let is_jump = |(k, is_long): (usize, bool)| {
        is_long && steps[k] > JUMP * length(k.checked_sub(1)).max(length(Some(k + 1)))
    };
    long_steps(points).into_iter().enumerate().map(is_jump).collect()
}

/// The points along the line that they form.
fn sorted(points: &[Row], changes: &mut Vec<Change>) -> Result<Vec<Row>, NoLine> {
    let mut line = line(points)?;
    if line.first() > line.last() {
        line.reverse();
    }
    let mut place = vec![None; points.len()];
    for (position, k) in line.iter().enumerate() {
        place[*k] = Some(position);
    }
    let beside = place.iter().zip(points).filter(|(place, _)| place.is_none());
    let beside: Vec<Row> = beside.map(|(_, point)| *point).collect();
    if let Some(first) = beside.first() {
        changes.push(Change::Beside { count: beside.len(), first: *first });
    }
    let given: Vec<(usize, usize)> =
        place.iter().enumerate().filter_map(|(k, place)| Some((k, (*place)?))).collect();
    let is_apart = |pair: &&[(usize, usize)]| pair[0].1.abs_diff(pair[1].1) > 1;
    let apart: Vec<usize> = given.windows(2).filter(is_apart).map(|pair| pair[1].0).collect();
    if let Some(after) = apart.first() {
        let turns = turns_back(points);
        let first = turns.into_iter().find(|k| k + 1 >= *after).filter(|k| k <= after);
        let first = points[first.unwrap_or(*after)];
        changes.push(Change::Sorted { count: apart.len(), first });
    }
    Ok(line.into_iter().map(|k| points[k]).collect())
}

/// The order of points along the line that they form.
fn line(points: &[Row]) -> Result<Vec<usize>, NoLine> {
    let (order, mut is_step) = mended(points);
    if is_step.contains(&false) {
        let tree = Tree::new(points, &[]);
        let line = tree.longest_path();
        if tree.beside(&line).is_none() {
            return Ok(line);
        }
    }
    let rows: Vec<Row> = order.iter().map(|k| points[*k]).collect();
    for (is_step, is_jump) in is_step.iter_mut().zip(jumps(&rows)) {
        *is_step &= !is_jump;
    }
    let tree = Tree::new(&rows, &is_step);
    let mut line = tree.longest_path();
    if let Some(branch) = tree.beside(&line) {
        if crosses_itself(&rows) {
            return Err(NoLine::Branches(rows[branch]));
        }
        line = (0..rows.len()).collect();
    }
    let along: Vec<Row> = line.iter().map(|k| rows[*k]).collect();
    match turns_back(&along).windows(2).find(|k| k[1] == k[0] + 1) {
        Some(turns) => Err(NoLine::Branches(along[turns[0]])),
        None => Ok(line.into_iter().map(|k| order[k]).collect()),
    }
}

/// Whether a line crosses itself.
fn crosses_itself(points: &[Row]) -> bool {
    // Twice the area of the triangle of three points, in m².
    let area = |p: &Row, q: &Row, r: &Row| {
        let [to_q, to_r] = [q, r].map(|to| [0, 1].map(|c| to.place[c] - p.place[c]));
        to_q[0] * to_r[1] - to_q[1] * to_r[0]
    };
    let is_between = |one: &[Row], two: &[Row]| {
        area(&one[0], &one[1], &two[0]) * area(&one[0], &one[1], &two[1]) < 0.0
    };
    points.windows(2).enumerate().any(|(k, one)| {
        let mut later = points[k + 1..].windows(2);
        later.any(|two| is_between(one, two) && is_between(two, one))
    })
}

/// The points in the order of the file, sorted where that turns back as far as what is around tells
/// how, and which of the steps from one to the next are known.
fn mended(points: &[Row]) -> (Vec<usize>, Vec<bool>) {
    let end = points.len() - 1;
    // Whether the ends are in order does not show in them.
    let marks = std::iter::once(0).chain(turns_back(points)).chain([end]);
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for mark in marks {
        match groups.last_mut().filter(|group| mark - group[group.len() - 1] <= LONGEST_STRIDE) {
            Some(group) => group.push(mark),
            None => groups.push(vec![mark]),
        }
    }
    // A sharp corner turns back once.
    groups.retain(|group| group.len() > 1);
    let mut order = Vec::new();
    let mut lost = Vec::new();
    let mut next = 0;
    for group in groups {
        let (from, to) =
            (group[0].saturating_sub(1).max(next), (group[group.len() - 1] + 1).min(end));
        let fixed = [(from > 0).then_some(0), (to < end).then_some(to - from)];
        let path = Tree::new(&points[from..=to], &[]).line_between(fixed);
        let turns = group.iter().filter(|k| (1..end).contains(*k)).count();
        let is_lost = path.is_none() && turns > 1;
        let path = path.unwrap_or_else(|| (0..=to - from).collect());
        order.extend(next..from);
        let start = order.len();
        order.extend(path.into_iter().map(|k| from + k));
        if is_lost {
            // It may be lost before the line turns back.
            lost.push(start.saturating_sub(LONGEST_STRIDE)..order.len() + LONGEST_STRIDE);
        }
        next = to + 1;
    }
    order.extend(next..=end);
    let is_step = (0..order.len()).map(|k| !lost.iter().any(|range| range.contains(&k))).collect();
    (order, is_step)
}

/// Without the points of a later run where an earlier one was.
fn first_passes(points: &[Row], changes: &mut Vec<Change>) -> Vec<Row> {
    let is_long = long_steps(points);
    let runs = runs(points, &is_long);
    let mut is_left_out = vec![false; points.len()];
    for (j, later) in runs.iter().enumerate() {
        for earlier in &runs[..j] {
            let there = &points[earlier.clone()];
            let usual = median_step(there);
            let near = later.clone().filter(|k| !is_left_out[*k]).filter_map(|k| {
                let (distance, place) = beside(there, usual, &points[k])?;
                Some((k, distance, place))
            });
            let near: Vec<(usize, f64, usize)> = near.collect();
            let goes_on = later.start == earlier.end && !is_long[earlier.end - 1];
            let ends = j + 1 == runs.len() || near.len() < later.len();
            let is_lip = goes_on && ends && 2 * near.len() < there.len();
            if near.len() < FEWEST_OF_OVERLAP || is_lip {
                continue;
            }
            changes.push(Change::Overlap {
                ends: [near[0].2, near[near.len() - 1].2].map(|place| there[place]),
                count: near.len(),
                distance: near.iter().map(|(_, distance, _)| *distance).fold(0.0, f64::max),
            });
            for (k, ..) in near {
                is_left_out[k] = true;
            }
        }
    }
    let kept = points.iter().zip(is_left_out).filter(|(_, is_left_out)| !is_left_out);
    kept.map(|(point, _)| *point).collect()
}

/// Parts of the points in which the line neither turns back nor has long steps.
fn runs(points: &[Row], is_long: &[bool]) -> Vec<Range<usize>> {
    let mut is_end = is_long.to_vec();
    // After a long step the line may turn back without an end.
    for k in turns_back(points).into_iter().filter(|k| !is_long[k - 1]) {
        is_end[k] = true;
    }
    let ends = (1..points.len()).filter(|k| is_end[k - 1]);
    let mut start = 0;
    let mut runs: Vec<Range<usize>> = Vec::new();
    for end in ends.chain([points.len()]) {
        runs.push(start..end);
        start = end;
    }
    runs.retain(|run| run.len() >= FEWEST_OF_PASS);
    // Shuffled points have some by chance.
    let covered: usize = runs.iter().map(Range::len).sum();
    if 10 * covered < 9 * points.len() { Vec::new() } else { runs }
}

/// Distance of a point from a run (in m) and the nearest point of that, if it was passed there: up
/// to one of its usual steps beyond its ends.
fn beside(run: &[Row], usual: f64, point: &Row) -> Option<(f64, usize)> {
    let to_step = |(k, pair): (usize, &[Row])| {
        let vector = |to: &Row| [0, 1].map(|c| to.place[c] - pair[0].place[c]);
        let (along, to) = (vector(&pair[1]), vector(point));
        let length = along[0].hypot(along[1]);
        let place = (to[0] * along[0] + to[1] * along[1]) / length;
        let is_end = [k == 0, k + 2 == run.len()];
        let [before, after] = is_end.map(|is_end| if is_end { usual } else { 0.0 });
        let near = place.clamp(-before, length + after);
        let off = [0, 1].map(|c| to[c] - near / length * along[c]);
        let is_beyond = place < -before && is_end[0] || place > length + after && is_end[1];
        (off[0].hypot(off[1]), k + usize::from(2.0 * place > length), is_beyond)
    };
    let nearest = run.windows(2).enumerate().map(to_step).min_by(|p, q| p.0.total_cmp(&q.0));
    let (distance, place, is_beyond) = nearest?;
    (!is_beyond && distance < SAME_PART).then_some((distance, place))
}

/// The shortest tree that connects points.
struct Tree {
    /// Neighbours of each point, with their distances in m.
    beside: Vec<Vec<(usize, f64)>>,
}

impl Tree {
    /// That of points of which some steps to the next one are known to belong to it, and the others
    /// do where nothing else is clearly shorter.
    fn new(points: &[Row], is_step: &[bool]) -> Self {
        let count = points.len();
        let mut beside = vec![Vec::new(); count];
        let mut nearest = vec![(f64::INFINITY, 0); count];
        let mut is_in = vec![false; count];
        let mut next = 0;
        for _ in 1..count {
            is_in[next] = true;
            let mut best = (f64::INFINITY, 0);
            for k in (0..count).filter(|k| !is_in[*k]) {
                let apart = match next.abs_diff(k) {
                    1 if is_step.get(next.min(k)) == Some(&true) => 0.0,
                    1 => distance(&points[next], &points[k]) / AS_SHORT,
                    _ => distance(&points[next], &points[k]),
                };
                if apart < nearest[k].0 {
                    nearest[k] = (apart, next);
                }
                if nearest[k].0 < best.0 {
                    best = (nearest[k].0, k);
                }
            }
            let new = best.1;
            let old = nearest[new].1;
            let length = distance(&points[old], &points[new]);
            beside[old].push((new, length));
            beside[new].push((old, length));
            next = new;
        }
        Self { beside }
    }

    /// Distances along the tree from some points (in m), and from where each is reached.
    fn from(&self, starts: &[usize]) -> (Vec<f64>, Vec<usize>) {
        let count = self.beside.len();
        let (mut away, mut before) = (vec![f64::INFINITY; count], (0..count).collect::<Vec<_>>());
        let mut open = starts.to_vec();
        for k in starts {
            away[*k] = 0.0;
        }
        while let Some(k) = open.pop() {
            for (other, length) in &self.beside[k] {
                if away[*other].is_infinite() {
                    away[*other] = away[k] + length;
                    before[*other] = k;
                    open.push(*other);
                }
            }
        }
        (away, before)
    }

    /// The path from a point to another one, or to the one that is farthest along the tree.
    fn path(&self, start: usize, end: Option<usize>) -> Vec<usize> {
        let (away, before) = self.from(&[start]);
        let farthest = (0..away.len()).max_by(|j, k| away[*j].total_cmp(&away[*k]));
        let mut path = vec![end.or(farthest).unwrap_or(start)];
        while let Some(k) = path.last().copied().filter(|k| *k != start) {
            path.push(before[k]);
        }
        path.reverse();
        path
    }

    fn longest_path(&self) -> Vec<usize> {
        let from_first = self.path(0, None);
        self.path(from_first[from_first.len() - 1], None)
    }

    /// The path from one end to the other, as far as they are fixed, if nothing but noise is
    /// beside.
    fn line_between(&self, fixed: [Option<usize>; 2]) -> Option<Vec<usize>> {
        let path = match fixed {
            [Some(start), end] => self.path(start, end),
            [None, Some(end)] => self.path(end, None).into_iter().rev().collect(),
            [None, None] => self.longest_path(),
        };
        self.beside(&path).is_none().then_some(path)
    }

    /// Where the longest branch leaves a line, if it is no noise.
    fn beside(&self, line: &[usize]) -> Option<usize> {
        let (away, before) = self.from(line);
        let end = (0..away.len()).max_by(|j, k| away[*j].total_cmp(&away[*k]))?;
        if away[end] <= LONGEST_TWIG {
            return None;
        }
        let mut k = end;
        while away[k] > 0.0 {
            k = before[k];
        }
        Some(k)
    }
}

/// The part of an outline from its inmost to its outmost point that faces the other body. y points
/// outwards and z up.
pub fn running_part(outline: &[Row], is_closed: bool, is_wheel: bool) -> Vec<Row> {
    let across = |j: &usize, k: &usize| outline[*j].place[0].total_cmp(&outline[*k].place[0]);
    let ends = (0..outline.len()).min_by(across).zip((0..outline.len()).max_by(across));
    let Some((inmost, outmost)) = ends else { return Vec::new() };
    let from_to = |from: usize, to: usize| -> Vec<Row> {
        let to = if to < from { to + outline.len() } else { to };
        (from..=to).map(|k| outline[k % outline.len()]).collect()
    };
    let reversed = |mut rows: Vec<Row>| {
        rows.reverse();
        rows
    };
    if !is_closed {
        let is_outwards = inmost <= outmost;
        let rows = from_to(inmost.min(outmost), inmost.max(outmost));
        return if is_outwards { rows } else { reversed(rows) };
    }
    let [one, two] = [from_to(inmost, outmost), reversed(from_to(outmost, inmost))];
    if (area(&one) < area(&two)) == is_wheel { one } else { two }
}

/// ∫ z dy, in m².
fn area(rows: &[Row]) -> f64 {
    let part = |pair: &[Row]| {
        let [p, q] = [pair[0].place, pair[1].place];
        0.5 * (p[1] + q[1]) * (q[0] - p[0])
    };
    rows.windows(2).map(part).sum()
}
