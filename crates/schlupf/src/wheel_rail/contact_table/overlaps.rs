//! Regions in which wheel and rail overlap, each with the integrals of its depth d over y,
//!
//! S = ∫ d^1.5 dy and ∫ d^2.5 q dy for q = 1 and for its place and inclination,
//!
//! and their derivatives with respect to the pose. They say where the plane of a contact is, as
//! [`super::super::contact_plane`] places it, and how deep and how wide the overlap is.

use wide::f64x4;

use crate::numerics::lanes::FOUR;
use crate::wheel_rail::contact_plane::Joining;

use super::outlines::{Level, Node, Outlines, Parts, RailAt};
use super::placement::{OfPose, POSE, Placement, Posed};

/// Most regions of a wheel.
pub(super) const MOST: usize = 8;

/// A region of overlap, or several that share a plane; with derivatives with respect to the pose.
#[derive(Debug, Clone, Copy)]
pub(super) struct Overlap {
    /// ∫ d^1.5 dy, in m^2.5.
    pub shape: OfPose,
    /// ∫ d^2.5 dy, in m^3.5.
    pub weight: OfPose,
    /// The same times x and y (in m), the inclination (in rad), and the arc length along the
    /// wheel's profile, in m.
    pub moments: [OfPose; 4],
    /// Ends on the rail, y and z in m.
    pub ends: [[f64; 2]; 2],
}

/// The regions of a wheel, by growing y; those beyond the first few are left out.
#[derive(Debug, Clone, Copy)]
pub(super) struct Overlaps {
    /// Whether there are no more of them, and none is where a profile ends.
    pub is_whole: bool,
    pub count: usize,
    regions: [Overlap; MOST],
}

/// What has been found on the way along the wheel.
struct Search<'a> {
    outlines: &'a Outlines,
    placement: &'a Placement,
    found: Overlaps,
    /// The region that goes on.
    open: Option<Open>,
}

/// Integrals of every fourth node, each with its derivatives.
#[derive(Debug, Clone, Copy)]
struct Open {
    sums: [[f64x4; 1 + POSE]; 6],
    ends: [[f64; 2]; 2],
    /// What the last node stands for, in m.
    width: f64,
}

const ZERO: OfPose = OfPose { value: 0.0, slopes: [0.0; POSE] };
const NONE: Overlap =
    Overlap { shape: ZERO, weight: ZERO, moments: [ZERO; 4], ends: [[0.0; 2]; 2] };

impl Overlaps {
    /// Those of a wheel in its place.
    pub fn new(outlines: &Outlines, placement: &Placement, joining: &Joining) -> Self {
        let found = Self { is_whole: true, count: 0, regions: [NONE; MOST] };
        let mut search = Search { outlines, placement, found, open: None };
        search.all();
        let mut found = search.found;
        found.join(joining);
        found
    }

    pub fn all(&self) -> &[Overlap] {
        &self.regions[..self.count]
    }

    /// Makes one of those that share a plane.
    fn join(&mut self, joining: &Joining) {
        let count = self.count.min(1);
        for k in count..std::mem::replace(&mut self.count, count) {
            let region = self.regions[k];
            let own = &mut self.regions[..self.count];
            let beside = own.iter_mut().rev().find(|other| other.belongs(&region, joining));
            if let Some(other) = beside {
                other.join(&region);
            } else {
                self.regions[self.count] = region;
                self.count += 1;
            }
        }
    }
}

impl Search<'_> {
    /// Goes along the wheel.
    fn all(&mut self) {
        let last = self.outlines.levels.len() - 1;
        for index in 0..self.outlines.levels[last].parts.len() {
            self.parts(last, index);
        }
        self.close();
    }

    /// Goes through parts of a level that may overlap.
    fn parts(&mut self, level: usize, index: usize) {
        let of_level = &self.outlines.levels[level];
        let parts = &of_level.parts[index];
        let is_apart = is_apart(self.outlines, self.placement, (of_level, parts));
        for (lane, is_apart) in is_apart.into_iter().enumerate() {
            let child = FOUR * index + lane;
            if is_apart {
                self.close();
            } else if level > 0 {
                self.parts(level - 1, child);
            } else {
                self.block(&self.outlines.blocks[child]);
            }
        }
    }

    /// Adds what overlaps of four nodes: as a rule all of it is of one region.
    fn block(&mut self, nodes: &Node<f64x4>) {
        let posed = self.placement.at(nodes);
        let [_, y, z] = posed.place;
        let (rail, is_seen) = self.outlines.rail_at_four(y);
        let depth = rail.z - z;
        let [depths, arcs, widths] = [depth, nodes.arc, nodes.width].map(f64x4::to_array);
        let [ys, heights] = [y, rail.z].map(f64x4::to_array);
        let mut own = [0.0; FOUR];
        for lane in 0..FOUR {
            if is_seen[lane] && depths[lane] > 0.0 {
                let at = [ys[lane], heights[lane]];
                if self.open.is_none() {
                    self.found.is_whole &= self.outlines.rail(at[0] - widths[lane]).is_some();
                }
                let open = self.open.get_or_insert(Open::at(at));
                (open.ends[1], open.width) = (at, widths[lane]);
                self.found.is_whole &= !self.outlines.is_end(arcs[lane]);
                own[lane] = 1.0;
            } else if self.open.is_some() {
                self.add(nodes, (&posed, &rail, depth), std::mem::take(&mut own));
                self.close();
            }
        }
        self.add(nodes, (&posed, &rail, depth), own);
    }

    /// Adds those of four nodes that are of the open region.
    fn add(
        &mut self,
        nodes: &Node<f64x4>,
        (posed, rail, depth): (&Posed<f64x4>, &RailAt<f64x4>, f64x4),
        own: [f64; FOUR],
    ) {
        let Some(open) = self.open.as_mut().filter(|_| own != [0.0; FOUR]) else { return };
        let nodes = Node { width: nodes.width * f64x4::from(own), ..*nodes };
        open.add(self.placement, &nodes, (posed, rail, depth.max(f64x4::ZERO)));
    }

    /// Ends the region that is open, for which there may be no room.
    fn close(&mut self) {
        // Most parts end no region; to take one copies its integrals, even if there is none.
        if self.open.is_none() {
            return;
        }
        let Some(open) = self.open.take() else { return };
        self.found.is_whole &= self.outlines.rail(open.ends[1][0] + open.width).is_some();
        match self.found.regions.get_mut(self.found.count) {
            Some(region) => {
                *region = open.summed();
                self.found.count += 1;
            }
            None => self.found.is_whole = false,
        }
    }
}

impl Open {
    /// That begins at y and z of the rail, in m.
    fn at(at: [f64; 2]) -> Self {
        Self { sums: [[f64x4::ZERO; 1 + POSE]; 6], ends: [at; 2], width: 0.0 }
    }

    #[inline]
    fn add(
        &mut self,
        placement: &Placement,
        node: &Node<f64x4>,
        (posed, rail, depth): (&Posed<f64x4>, &RailAt<f64x4>, f64x4),
    ) {
        let splat = f64x4::splat;
        let [x, y, _] = posed.place;
        let [by_roll, by_yaw] = placement.slopes(node, posed);
        let deeper = |by: [f64x4; 3]| rail.slope * by[1] - by[2];
        let deepening = [rail.slope, splat(-1.0), deeper(by_roll), deeper(by_yaw)];
        let forwards = [f64x4::ZERO, f64x4::ZERO, by_roll[0], by_yaw[0]];
        let across = [splat(1.0), f64x4::ZERO, by_roll[1], by_yaw[1]];
        // A slope that leans with the wheel covers less of y.
        let leaning = |rotation: &[[f64; 3]; 3]| {
            node.width * (splat(rotation[1][1]) + splat(rotation[1][2]) * node.slope)
        };
        let width = leaning(&placement.wheel.rotation);
        let [by_roll, by_yaw] = [0, 1].map(|k| leaning(&placement.turned[k].rotation));
        let wider = [f64x4::ZERO, f64x4::ZERO, by_roll, by_yaw];
        let root = depth.sqrt();
        let power = depth * root;
        let [deep, thin] = [width * power * splat(2.5), width * root * splat(1.5)];
        let (one, two) = (width * power, width * power * depth);
        let by: [f64x4; POSE] =
            std::array::from_fn(|k| deepening[k] * deep + wider[k] * power * depth);
        let [shape, weight, of_x, of_y, of_inclination, of_arc] = &mut self.sums;
        add(shape, one, |k| deepening[k] * thin + wider[k] * power);
        add(weight, two, |k| by[k]);
        add(of_x, two * x, |k| by[k] * x + forwards[k] * two);
        add(of_y, two * y, |k| by[k] * y + across[k] * two);
        let (inclination, bend) = (rail.inclination, two * rail.bend);
        add(of_inclination, two * inclination, |k| by[k] * inclination + across[k] * bend);
        add(of_arc, two * node.arc, |k| by[k] * node.arc);
    }

    fn summed(&self) -> Overlap {
        let [shape, weight, moments @ ..] = self.sums.map(|sum| {
            let [value, slopes @ ..] = sum.map(f64x4::reduce_add);
            OfPose { value, slopes }
        });
        Overlap { shape, weight, moments, ends: self.ends }
    }
}

/// Adds an integrand and its derivatives.
#[inline]
fn add(sum: &mut [f64x4; 1 + POSE], value: f64x4, slope: impl Fn(usize) -> f64x4) {
    sum[0] += value;
    for k in 0..POSE {
        sum[1 + k] += slope(k);
    }
}

impl Overlap {
    /// As neighbouring regions of the exact contacts do.
    fn belongs(&self, next: &Self, joining: &Joining) -> bool {
        let [end, start] = [self.ends[1], next.ends[0]];
        let away =
            if end[0] > start[0] { 0.0 } else { (start[0] - end[0]).hypot(start[1] - end[1]) };
        let inclination = |of: &Self| of.moments[2].value / of.weight.value;
        let turn = (inclination(next) - inclination(self)).abs();
        away <= joining.distance && turn <= joining.angle
    }

    fn join(&mut self, other: &Self) {
        self.shape = self.shape + other.shape;
        self.weight = self.weight + other.weight;
        for (own, more) in self.moments.iter_mut().zip(other.moments) {
            *own = *own + more;
        }
        if other.ends[1][0] > self.ends[1][0] {
            self.ends[1] = other.ends[1];
        }
    }
}

/// Whether parts of the wheel cannot overlap: they are beside the rail, or the gap at their middle
/// is larger than what closes it at most over their length. That is how fast their tangent nears
/// that of the rail, which is exact in every pose; curvatures where bodies are concave; and, in a
/// wheel of radius R that yaws by ψ, that points with another slope s are R tan²ψ s further across
/// and R tan²ψ s²/2 higher.
fn is_apart(
    outlines: &Outlines,
    placement: &Placement,
    (level, parts): (&Level, &Parts),
) -> [bool; FOUR] {
    let Parts { middle, half, concavity, turn, fall } = parts;
    let (roll, lean) = (placement.attitude.roll, placement.lean());
    let posed = placement.at(middle);
    let [_, y, z] = posed.place;
    let [_, across, up] = placement.tangent(middle, &posed);
    let (rail, is_seen) = outlines.rail_at_four(y);
    let reach = parts.reach(roll, lean);
    let [roll, lean] = [roll.abs(), lean].map(f64x4::splat);
    let steepness = rail.slope.abs() + roll;
    let nearing = (up - rail.slope * across).abs() * *half;
    let wheel = *concavity * (f64x4::ONE + roll * rail.slope.abs()) * *half * *half;
    let rising = outlines.rising(level, y) * reach * reach;
    let turned = middle.radius * lean * (*fall + steepness * *turn);
    // What is of higher order is less than a tenth of it.
    let closed = nearing + ((wheel + rising) * f64x4::HALF + turned) * f64x4::splat(1.1);
    let [gap, closed] = [z - rail.z, closed].map(f64x4::to_array);
    let [y, reach] = [y, reach].map(f64x4::to_array);
    std::array::from_fn(|lane| {
        if is_seen[lane] {
            gap[lane] > closed[lane]
        } else {
            outlines.beside_rail(y[lane]) > reach[lane]
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reporting::Quantity;
    use crate::wheel_rail::pose::Attitude;
    use crate::wheel_rail::{Deviation, Pair, ProfileCurve, RailShape, Track, WheelShape};

    /// Of depths below the origin.
    fn curve(quantity: Quantity, z: impl Fn(f64) -> f64) -> ProfileCurve {
        let points = (-350..=350).map(|k| 1e-4 * f64::from(k)).map(|y| [y, -z(y)]);
        ProfileCurve::new(&points.collect::<Vec<_>>(), 0.0, quantity).unwrap()
    }

    /// A conical wheel with a hollow tread and a flange, on a rail of 300 mm with a lip at its
    /// side; or flank on flank, worn to straight lines of 70°.
    fn worn(is_straight: bool) -> Pair {
        let bump = |y: f64, at: f64, width: f64| (-((y - at) / width).powi(2)).exp();
        let flank = |y: f64| 2.75 * (-18e-3 - y).max(0.0);
        let wheel = curve(Quantity::WheelProfile, |y| {
            if is_straight {
                return flank(y) + y / 40.0;
            }
            y / 40.0 - 1.5e-3 * bump(y, 3e-3, 9e-3) + 12e-3 * bump(y, -34e-3, 9e-3)
        });
        let rail = curve(Quantity::RailProfile, |y| {
            if is_straight {
                return flank(y - 1e-3) + (y * y) / 0.6;
            }
            let crown = (0.3 - (0.09 - y * y).sqrt()) + 40.0 * (y.abs() - 0.026).max(0.0).powi(2);
            crown - 0.3e-3 * bump(y, 22e-3, 2e-3)
        });
        let wheel = WheelShape {
            profile: wheel.into(),
            nominal_radius: 0.46,
            flange_back_position: -70e-3,
            deviation: Deviation::default(),
        };
        Pair::new(&wheel, &RailShape::new(rail, 0.0), &Track::default()).unwrap()
    }

    /// What is passed over would add nothing: all nodes, against the parts that may overlap.
    #[test]
    fn no_overlap_is_passed_over() {
        let mut seed = 1_u64;
        let mut random = |low: f64, high: f64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            low + (high - low) * (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let pairs = [worn(false), worn(true)];
        let outlines = pairs.each_ref().map(Outlines::new);
        let mut counts = [0; MOST + 1];
        for k in 0..6000 {
            let (pair, outlines) = (&pairs[k % 2], &outlines[k % 2]);
            let attitude = Attitude {
                lateral: random(-12e-3, 12e-3),
                roll: random(-0.02, 0.02),
                yaw: random(-0.04, 0.04),
            };
            let placement = Placement::new(pair, attitude, random(-4e-3, 2e-3));
            let empty = Overlaps { is_whole: true, count: 0, regions: [NONE; MOST] };
            let [mut all, mut some] = [0, 1].map(|_| Search {
                outlines,
                placement: &placement,
                found: empty,
                open: None,
            });
            outlines.blocks.iter().for_each(|block| all.block(block));
            all.close();
            some.all();
            let weights = |of: &Search| of.found.regions.map(|region| region.weight);
            assert_eq!(weights(&all), weights(&some), "{attitude:?}");
            assert_eq!(all.found.count, some.found.count);
            assert_eq!(all.found.is_whole, some.found.is_whole, "{attitude:?}");
            counts[all.found.count] += 1;
        }
        assert!(counts[..4].iter().all(|count| *count > 4), "{counts:?}");
    }
}
