//! Which way the axes of a profile point, from its shape.
//!
//! The outline is seen from above and from below at equal steps across, so that vertical faces
//! count for nothing. What runs lies at one level over most of the width: sides, grooves and the
//! flange hang down from it. With the mean distances B of what lies below the median height and A
//! of what lies above it, (B − A)/(B + A) is near 1 for the side that runs if z points up, and near
//! −1 if it points down. The tip of a whole flange, and the tread of a crowned wheel, are bumps
//! towards the rail instead.

/// Step across, in m.
const STEP: f64 = 2.5e-4;

/// Depth behind the foremost point of a rail and of a wheel up to which its outline is looked at,
/// in m: less than that of the foot, more than the height of a flange.
const DEPTHS: [f64; 2] = [0.03, 0.06];

/// Mean distance from the median that is as good as none, in m.
const FLAT: f64 = 3e-4;

/// Height of a bump that only a flange or a crown has, in m.
const BUMP: f64 = 5e-3;

/// Evidence that counts as clear, dimensionless.
pub const CLEAR: f64 = 0.1;

/// Width at the ends of a rail within which its depth counts, in m.
const END: f64 = 3e-3;

/// The side of an outline that runs.
struct Running {
    /// y and height in m, z up.
    points: Vec<[f64; 2]>,
}

/// Whether z points down: 1 if the shape says so, −1 if it points up, 0 where it says nothing;
/// dimensionless.
pub fn downwards(points: &[[f64; 2]], is_wheel: bool) -> f64 {
    // Seen from the other body: rails from above, wheels from below.
    let [as_drawn, turned] = [1.0, -1.0].map(|sign| Running::new(points, is_wheel, sign));
    if is_wheel {
        let (up, down) = (as_drawn.bump(), turned.bump());
        if (up - down).abs() > BUMP {
            return (down - up).signum();
        }
    }
    let [up, down] = [as_drawn.level(), turned.level()];
    // A rail beside a groove, or a nose on its base, looks like a running side from both.
    0.5 * (down - up) * (1.0 - up.min(down).max(0.0))
}

/// Whether y points inwards, with z up: 1 if the flange of a wheel is at the largest y, or if a
/// rail reaches `gauge_depth` (in m) below its top only there, −1 if so at the smallest y;
/// dimensionless.
pub fn inwards(points: &[[f64; 2]], is_wheel: bool, gauge_depth: f64) -> f64 {
    if !is_wheel {
        return deep_side(points, gauge_depth);
    }
    let running = Running::new(points, is_wheel, 1.0);
    let clarity = if running.bump() > BUMP { 1.0 } else { running.level().abs() };
    clarity * running.side()
}

/// Depth of the lowest point of a wheel below the level of its tread (in m, z up), and its y in m.
pub fn flange_tip(points: &[[f64; 2]]) -> Option<[f64; 2]> {
    let running = Running::new(points, true, 1.0);
    let lowest = running.points.iter().min_by(|p, q| p[1].total_cmp(&q[1]))?;
    Some([running.median() - lowest[1], lowest[0]])
}

/// Whether y and z may be swapped: an outline much higher than wide, or one that goes from end to
/// end along z and comes back along y.
pub fn is_high(points: &[[f64; 2]], is_closed: bool) -> bool {
    let range = |k: usize| {
        let values = || points.iter().map(|point| point[k]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return false };
    let across = |k: usize| (last[k] - first[k]).abs() / range(k);
    let ratio = range(1) / range(0);
    !is_closed && (ratio > 2.0 || ratio > 1.2 && across(1) > 0.8 && across(0) < 0.6)
}

impl Running {
    /// What is seen of the outline with z times a sign. Where it is seen from the same side with y
    /// both growing and falling along it, as from the open end of a head, only the greater part
    /// counts.
    fn new(points: &[[f64; 2]], is_wheel: bool, sign: f64) -> Self {
        let from_above = if is_wheel { -1.0 } else { 1.0 };
        let range = points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| {
            [low.min(p[0]), high.max(p[0])]
        });
        let count = ((range[1] - range[0]) / STEP) as usize;
        let at = |k: usize| range[0] + (k as f64 + 0.5) * STEP;
        let mut seen: Vec<Option<(f64, bool)>> = vec![None; count];
        for pair in points.windows(2) {
            let grows = pair[1][0] > pair[0][0];
            let [p, q] = if grows { [pair[0], pair[1]] } else { [pair[1], pair[0]] };
            let first = ((p[0] - range[0]) / STEP - 0.5).ceil().max(0.0) as usize;
            for (k, place) in seen.iter_mut().enumerate().skip(first) {
                if at(k) > q[0] || q[0] <= p[0] {
                    break;
                }
                let z = p[1] + (q[1] - p[1]) * (at(k) - p[0]) / (q[0] - p[0]);
                let height = sign * z;
                if place.is_none_or(|(known, _)| from_above * (height - known) > 0.0) {
                    *place = Some((height, grows));
                }
            }
        }
        let growing = seen.iter().flatten().filter(|(_, grows)| *grows).count();
        let most = 2 * growing >= seen.iter().flatten().count();
        let line = seen.iter().enumerate().filter_map(|(k, seen)| {
            let (height, grows) = (*seen)?;
            (grows == most).then_some([at(k), height])
        });
        let points: Vec<[f64; 2]> = line.collect();
        let foremost = points.iter().map(|point| from_above * point[1]).fold(f64::MIN, f64::max);
        let depth = DEPTHS[usize::from(is_wheel)];
        let is_near = |point: &[f64; 2]| foremost - from_above * point[1] < depth;
        Self { points: points.into_iter().filter(is_near).collect() }
    }

    fn median(&self) -> f64 {
        let mut heights: Vec<f64> = self.points.iter().map(|point| point[1]).collect();
        heights.sort_unstable_by(f64::total_cmp);
        heights.get(heights.len() / 2).copied().unwrap_or(0.0)
    }

    /// (B − A)/(B + A), dimensionless.
    fn level(&self) -> f64 {
        let median = self.median();
        let [mut below, mut above] = [0.0; 2];
        for [_, height] in &self.points {
            below += (median - height).max(0.0);
            above += (height - median).max(0.0);
        }
        (below - above) / (below + above + FLAT * (1 + self.points.len()) as f64)
    }

    /// Height of the largest bump downwards with higher ground on both sides, in m.
    fn bump(&self) -> f64 {
        let heights = || self.points.iter().map(|point| point[1]);
        let highest = |heights: &mut dyn Iterator<Item = f64>| -> Vec<f64> {
            let mut most = f64::NEG_INFINITY;
            heights
                .map(|height| {
                    most = most.max(height);
                    most
                })
                .collect()
        };
        let before = highest(&mut heights());
        let mut after = highest(&mut heights().rev());
        after.reverse();
        let ground = before.into_iter().zip(after).map(|(before, after)| before.min(after));
        ground.zip(heights()).map(|(ground, height)| ground - height).fold(0.0, f64::max)
    }

    /// Where what hangs down is: −1 at the smallest y, 1 at the largest; dimensionless.
    fn side(&self) -> f64 {
        let (Some(first), Some(last)) = (self.points.first(), self.points.last()) else {
            return 0.0;
        };
        let (middle, half) = (0.5 * (first[0] + last[0]), 0.5 * (last[0] - first[0]));
        let median = self.median();
        let [mut sum, mut moment] = [0.0; 2];
        for [y, height] in &self.points {
            let depth = (median - height).max(0.0);
            sum += depth;
            moment += depth * (y - middle);
        }
        if sum > 0.0 && half > 0.0 { moment / (sum * half) } else { 0.0 }
    }
}

/// Which end of a rail alone reaches down to where the gauge is measured, z up.
fn deep_side(points: &[[f64; 2]], gauge_depth: f64) -> f64 {
    let y = || points.iter().map(|point| point[0]);
    let [from, to] = [y().fold(f64::INFINITY, f64::min), y().fold(f64::NEG_INFINITY, f64::max)];
    let top = points.iter().map(|point| point[1]).fold(f64::NEG_INFINITY, f64::max);
    let depth = |is_near: &dyn Fn(f64) -> bool| {
        let near = points.iter().filter(|point| is_near(point[0]));
        near.map(|point| top - point[1]).fold(0.0, f64::max)
    };
    let [low, high] = [depth(&|y| y < from + END), depth(&|y| y > to - END)];
    let alone = |one: f64, other: f64| {
        f64::from(u8::from(one >= gauge_depth && other < SHALLOW * gauge_depth))
    };
    alone(high, low) - alone(low, high)
}

/// Part of the gauge depth that the outer side of such a rail does not reach, dimensionless.
const SHALLOW: f64 = 0.6;
