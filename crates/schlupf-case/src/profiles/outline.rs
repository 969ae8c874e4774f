//! The line on which the points of a file lie: their order along it, and the part of it that runs.
//!
//! Points that follow each other without turning back are in order. Otherwise they are sorted along
//! the shortest tree that connects them (Prim 1957): on points of a line this is the line itself.
//! Where an outline folds back on itself, as at a rolled lip, that tree branches; then the order of
//! the file stands, and points are sorted only around the places where it is lost. What branches
//! even so is no line.

use schlupf::wheel_rail::LEAST_SPACING;

use super::points::Row;

/// Cosine of the turn from one step to the next that no outline makes, dimensionless: 150°.
const TURNS_BACK: f64 = -0.866;

/// Longest branch that is noise of a measurement, in m.
pub const LONGEST_TWIG: f64 = 5e-4;

/// Fewest points of a loop, whose ends are at most its largest step apart.
const FEWEST_OF_LOOP: usize = 5;

/// Length of a line in the order of the file over that of the shortest tree below which it is a
/// line with a sharp corner, dimensionless.
const AS_SHORT: f64 = 1.01;

/// Fewest points of one pass of a measurement, and of an overlap of two.
const FEWEST_OF_PASS: usize = 5;
const FEWEST_OF_OVERLAP: usize = 3;

/// Largest step along the line within a pass, in points.
const LONGEST_STRIDE: usize = 5;

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
    let points = match turns_back(&spaced).first().map(|k| spaced[*k]) {
        None => distinct,
        Some(first) if spaced.len() > MOST_SORTED => return Err(NoLine::TooMany(first)),
        Some(_) => sorted(&spaced, &mut changes)?,
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
    steps.sort_by(f64::total_cmp);
    steps.get(steps.len() / 2).copied().unwrap_or(0.0)
}

/// Without rows that were there before.
fn distinct(rows: &[Row], changes: &mut Vec<Change>) -> Vec<Row> {
    let mut seen = std::collections::HashSet::new();
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

/// Where the line turns back.
fn turns_back(points: &[Row]) -> Vec<usize> {
    let turns = |k: &usize| {
        let step = |from: usize| [0, 1].map(|c| points[from + 1].place[c] - points[from].place[c]);
        let (before, after) = (step(k - 1), step(*k));
        let along = before[0] * after[0] + before[1] * after[1];
        along < TURNS_BACK * before[0].hypot(before[1]) * after[0].hypot(after[1])
    };
    (1..points.len().saturating_sub(1)).filter(turns).collect()
}

/// The points along the line that they form.
fn sorted(points: &[Row], changes: &mut Vec<Change>) -> Result<Vec<Row>, NoLine> {
    let tree = Tree::new(points, &[]);
    let mut line = tree.longest_path();
    if let Some(branch) = tree.beside(&line) {
        line = folded(points, &tree).ok_or(NoLine::Branches(points[branch]))?;
    }
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
    let given: Vec<usize> = place.iter().copied().flatten().collect();
    let left_out = overlaps(points, &line, &given, changes);
    if left_out.is_empty() {
        let is_apart = |pair: &[usize]| pair[0].abs_diff(pair[1]) > 1;
        let count = given.windows(2).filter(|pair| is_apart(pair)).count();
        let is_moved = |k: &usize| {
            let around: Vec<usize> = place[k - 1..=k + 1].iter().copied().flatten().collect();
            around.windows(2).any(is_apart)
        };
        let turns = turns_back(points);
        let first = turns.iter().find(|k| is_moved(k)).or(turns.first()).filter(|_| count > 0);
        changes.extend(first.map(|k| Change::Sorted { count, first: points[*k] }));
    }
    let is_kept = |k: &usize| !left_out.contains(k);
    Ok(line.into_iter().filter(is_kept).map(|k| points[k]).collect())
}

/// The line through points of which the shortest tree branches: that of the file, but for the
/// places where its order is lost. It is one if it is hardly longer than the tree.
fn folded(points: &[Row], shortest: &Tree) -> Option<Vec<usize>> {
    let (order, is_step) = mended(points);
    let rows: Vec<Row> = order.iter().map(|k| points[*k]).collect();
    let tree = Tree::new(&rows, &is_step);
    let line = tree.longest_path();
    let along: Vec<Row> = line.iter().map(|k| rows[*k]).collect();
    let is_line = tree.beside(&line).is_none()
        && is_corner(&turns_back(&along))
        && steps(&along).sum::<f64>() < AS_SHORT * shortest.length();
    is_line.then(|| line.into_iter().map(|k| order[k]).collect())
}

/// Whether a line that turns back in these points is in order: out of order it turns back twice in
/// a row, in a sharp corner once.
fn is_corner(turns: &[usize]) -> bool {
    turns.windows(2).all(|k| k[1] > k[0] + 1)
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
    let mut order = Vec::new();
    let mut lost = Vec::new();
    let mut next = 0;
    for mut group in groups {
        let (from, to) = (group[0].saturating_sub(1), (group[group.len() - 1] + 1).min(end));
        let fixed = [(from > 0).then_some(0), (to < end).then_some(to - from)];
        let path = Tree::new(&points[from..=to], &[]).line_between(fixed);
        group.retain(|k| (1..end).contains(k));
        let is_lost = path.is_none() && !is_corner(&group);
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
    let is_step = (0..order.len()).map(|k| !lost.iter().any(|range| range.contains(&k))).collect();
    (order, is_step)
}

/// Points of a later pass of a measurement where an earlier one was. `given` has the positions
/// along the line in the order of the file.
fn overlaps(
    points: &[Row],
    line: &[usize],
    given: &[usize],
    changes: &mut Vec<Change>,
) -> std::collections::HashSet<usize> {
    let mut left_out = std::collections::HashSet::new();
    let passes = passes(given);
    let covered: usize = passes.iter().map(Vec::len).sum();
    if 10 * covered < 9 * given.len() {
        return left_out;
    }
    let ends = |pass: &[usize]| {
        let least = pass.iter().min().copied().unwrap_or(0);
        [least, pass.iter().max().copied().unwrap_or(0)]
    };
    for (k, later) in passes.iter().enumerate() {
        for earlier in &passes[..k] {
            let [from, to] = [ends(earlier), ends(later)];
            let common = from[0].max(to[0])..=from[1].min(to[1]);
            let within = |pass: &[usize]| -> Vec<usize> {
                let inside = pass.iter().filter(|position| common.contains(position));
                inside.map(|position| line[*position]).collect()
            };
            let [old, new] = [within(earlier), within(later)];
            if old.len().min(new.len()) < FEWEST_OF_OVERLAP {
                continue;
            }
            let off = |k: &usize| {
                let nearest = old.iter().map(|other| distance(&points[*k], &points[*other]));
                nearest.fold(f64::INFINITY, f64::min)
            };
            changes.push(Change::Overlap {
                ends: [*common.start(), *common.end()].map(|position| points[line[position]]),
                count: new.len(),
                distance: new.iter().map(off).fold(0.0, f64::max),
            });
            left_out.extend(new);
        }
    }
    left_out
}

/// Long runs of positions that go one way.
fn passes(given: &[usize]) -> Vec<Vec<usize>> {
    let mut passes: Vec<Vec<usize>> = Vec::new();
    for position in given {
        let goes_on = passes.last().is_some_and(|pass| {
            let last = pass[pass.len() - 1];
            let is_near = last.abs_diff(*position) <= LONGEST_STRIDE;
            let is_same_way = pass.len() < 2 || (last > pass[pass.len() - 2]) == (*position > last);
            is_near && is_same_way
        });
        match passes.last_mut().filter(|_| goes_on) {
            Some(pass) => pass.push(*position),
            None => passes.push(vec![*position]),
        }
    }
    passes.retain(|pass| pass.len() >= FEWEST_OF_PASS);
    passes
}

/// The shortest tree that connects points.
struct Tree {
    /// Neighbours of each point, with their distances in m.
    beside: Vec<Vec<(usize, f64)>>,
}

impl Tree {
    /// That of points of which some steps to the next one are known to belong to it.
    fn new(points: &[Row], is_step: &[bool]) -> Self {
        let count = points.len();
        let mut beside = vec![Vec::new(); count];
        let is_known = |j: usize, k: usize| {
            j.abs_diff(k) == 1 && is_step.get(j.min(k)).copied().unwrap_or(false)
        };
        let mut nearest = vec![(f64::INFINITY, 0); count];
        let mut is_in = vec![false; count];
        let mut next = 0;
        for _ in 1..count {
            is_in[next] = true;
            let mut best = (f64::INFINITY, 0);
            for k in (0..count).filter(|k| !is_in[*k]) {
                let is_known = is_known(next, k);
                let apart = if is_known { 0.0 } else { distance(&points[next], &points[k]) };
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

    /// Its length, in m.
    fn length(&self) -> f64 {
        0.5 * self.beside.iter().flatten().map(|(_, length)| length).sum::<f64>()
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
