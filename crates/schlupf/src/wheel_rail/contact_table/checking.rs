//! How far contacts of a table are from exact ones.

use crate::reporting::{Error, Watch};
use crate::wheel_rail::equilibrium::Lowering;
use crate::wheel_rail::gap::Gap;
use crate::wheel_rail::pose::Attitude;
use crate::wheel_rail::pressed::Pressed;
use crate::wheel_rail::pressing::Accuracy;
use crate::wheel_rail::virtual_penetration::NormalMethod;

use super::contacts::{ContactTable, TabulatedContact};

/// Cells across an exact contact each way.
const CELLS: usize = 48;

/// Lateral positions, in m.
const LATERAL: [f64; 2] = [-8e-3, 8e-3];

/// Part of the force of a wheel below which the place of a contact does not count, dimensionless.
const SMALL: f64 = 0.01;

/// An error over random poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Half of them are below this, in the unit of the error.
    pub median: f64,
    /// 90 % are below this, in the unit of the error.
    pub ninety_percent: f64,
    /// 99 % are below this, in the unit of the error.
    pub ninety_nine_percent: f64,
    /// The largest, in the unit of the error.
    pub largest: f64,
}

/// Errors of the contacts of a table in random poses, and what was missed in making it.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactTableErrors {
    /// Whether the normal force between nodes is within the tolerance: otherwise the nodes were
    /// used up.
    pub is_within_tolerance: bool,
    /// Nodes without an exact contact, which have the values of their neighbours.
    pub failed_nodes: usize,
    /// Number of poses.
    pub poses: usize,
    /// Of the normal force of a contact over those of all contacts of the wheel, dimensionless.
    pub load: Spread,
    /// Of the place of a contact on the rail, in m.
    pub place: Spread,
    /// Of its angle, in rad.
    pub angle: Spread,
    /// Of the centre of pressure, along rolling and across, in m.
    pub centre: Spread,
}

impl Spread {
    fn of(mut errors: Vec<f64>) -> Self {
        errors.sort_unstable_by(f64::total_cmp);
        let last = errors.len().saturating_sub(1);
        let at = |part: f64| errors.get((part * last as f64) as usize).copied().unwrap_or(0.0);
        Self {
            median: at(0.5),
            ninety_percent: at(0.9),
            ninety_nine_percent: at(0.99),
            largest: at(1.0),
        }
    }
}

impl ContactTable {
    /// The errors in so many poses that the table covers. Poses without an exact contact, beside
    /// the rail or at the end of a profile, do not count.
    pub(super) fn errors(
        &self,
        poses: usize,
        (is_within_tolerance, failed_nodes): (bool, usize),
        watch: Watch,
    ) -> Result<ContactTableErrors, Error> {
        let [_, roll, yaw, deepest] = self.grid.axes.map(|axis| axis.end());
        let depths = [self.grid.axes[3].start, deepest].map(f64::exp);
        let pose = |k: usize| {
            // A sequence that fills four dimensions evenly (Roberts 2018).
            let share = |power: i32| (k as f64 + 0.5) * 1.167_303_978_261_418_7_f64.powi(-power);
            let between =
                |power: i32, [low, high]: [f64; 2]| low + (high - low) * share(power).fract();
            let attitude = Attitude {
                lateral: between(1, LATERAL),
                roll: between(2, [-roll, roll]),
                yaw: between(3, [-yaw, yaw]),
            };
            (attitude, between(4, depths))
        };
        let found = crate::numerics::parallel::try_map((0..poses).collect(), |k| {
            let (attitude, depth) = pose(k);
            self.compared(attitude, depth, watch)
        })?;
        let rows: Vec<[f64; 5]> = found.iter().flatten().flatten().copied().collect();
        let loads = rows.iter().map(|[load, ..]| *load).collect();
        let large = || rows.iter().filter(|row| row[4] > SMALL);
        let spread = |k: usize| Spread::of(large().map(|row| row[k]).collect());
        Ok(ContactTableErrors {
            is_within_tolerance,
            failed_nodes,
            poses: found.iter().flatten().count(),
            load: Spread::of(loads),
            place: spread(1),
            angle: spread(2),
            centre: spread(3),
        })
    }

    /// For each exact contact of a pose the errors of the load, the place, the angle and the centre
    /// of that next to it, and its part of the load; then the loads of those next to none.
    fn compared(
        &self,
        attitude: Attitude,
        depth: f64,
        watch: Watch,
    ) -> Result<Option<Vec<[f64; 5]>>, Error> {
        let Ok(gap) = Gap::new(&self.pair, &attitude) else { return Ok(None) };
        let lowering = Lowering {
            pair: &self.pair,
            gap: &gap,
            attitude,
            joining: self.joining,
            contact_modulus: self.contact_modulus,
            poisson_ratio: 0.0,
            method: NormalMethod::HalfSpaces,
            watch,
        };
        let exact = match lowering.at(depth, &[], Accuracy::Cells(CELLS)) {
            Err(Error::Stopped {}) => return Err(Error::Stopped {}),
            Err(_) => return Ok(None),
            Ok(exact) => exact,
        };
        let Attitude { lateral, roll, yaw } = attitude;
        let found = self.contacts([lateral, lowering.touch() - depth, roll, yaw]);
        let total: f64 = exact.iter().map(|contact| contact.force).sum();
        let mut others: Vec<&TabulatedContact> = found.by_place().collect();
        let own: Vec<Option<&TabulatedContact>> = exact
            .iter()
            .map(|contact| {
                let away =
                    |of: &TabulatedContact| (of.position[1].value - contact.plane.origin[1]).abs();
                let near = (0..others.len())
                    .min_by(|one, two| away(others[*one]).total_cmp(&away(others[*two])));
                near.map(|near| others.remove(near))
            })
            .collect();
        let row = |(contact, near): (&Pressed, Option<&TabulatedContact>)| {
            let [x, y, _] = contact.plane.origin;
            let share = contact.force / total;
            let Some(near) = near else { return [share, 0.0, 0.0, 0.0, 0.0] };
            let away = |of: &TabulatedContact| (of.position[1].value - y).abs();
            let centre = contact.centre();
            let off = [0, 1].map(|k| near.centre[k].value - centre[k]);
            [
                (near.load.value - contact.force).abs() / total,
                (near.position[0].value - x).hypot(away(near)),
                (near.inclination.value - contact.plane.inclination).abs(),
                off[0].hypot(off[1]),
                share,
            ]
        };
        let surplus = others.iter().map(|of| [of.load.value / total, 0.0, 0.0, 0.0, 0.0]);
        Ok(Some(exact.iter().zip(own).map(row).chain(surplus).collect()))
    }
}
