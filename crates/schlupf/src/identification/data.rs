//! Measured points of creep curves.

use crate::error::Error;
use crate::kinematics::Kinematics;

/// Which component of the force was measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Component {
    /// Along rolling.
    Longitudinal,
    /// Across rolling.
    Lateral,
}

impl Component {
    /// Its place among (x, y).
    pub fn index(self) -> usize {
        match self {
            Self::Longitudinal => 0,
            Self::Lateral => 1,
        }
    }
}

/// Under which condition a force was measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condition {
    /// Speed and creepages.
    pub kinematics: Kinematics,
    /// Normal load (in N), if it is another than that of the problem.
    pub load: Option<f64>,
}

/// A measured point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DataPoint {
    /// Under which condition.
    pub condition: Condition,
    /// Which component of the force.
    pub component: Component,
    /// Force on the rail over the load, −Fx/N or −Fy/N, dimensionless: as creep curves show it, of the
    /// sign of the creepage.
    pub force_ratio: f64,
    /// Standard deviation of the measurement, dimensionless, where it is known.
    pub standard_deviation: Option<f64>,
}

/// Checks points by themselves.
pub(super) fn check(data: &[DataPoint]) -> Result<(), Error> {
    const RATIO: &str = "force_ratio";
    const DEVIATION: &str = "standard_deviation";
    for point in data {
        point.condition.kinematics.check()?;
        crate::error::require_finite(RATIO, point.force_ratio, "")?;
        if let Some(load) = point.condition.load {
            crate::error::require_positive("normal.load", load, "N")?;
        }
        if let Some(deviation) = point.standard_deviation {
            crate::error::require_positive(DEVIATION, deviation, "")?;
        }
    }
    let known = data.iter().filter(|point| point.standard_deviation.is_some()).count();
    if known != 0 && known != data.len() {
        return Err(Error::Contradiction {
            quantity: DEVIATION,
            reason: format!(
                "all points or none must have a standard deviation, but {known} of {} have one",
                data.len()
            ),
        });
    }
    check_signs(data)
}

/// Forces must have the sign of the creepage, as a whole.
fn check_signs(data: &[DataPoint]) -> Result<(), Error> {
    let work: f64 = data
        .iter()
        .map(|point| {
            let motion = &point.condition.kinematics;
            let creepage = [motion.creepage_x, motion.creepage_y][point.component.index()];
            point.force_ratio * creepage
        })
        .sum();
    if work >= 0.0 {
        return Ok(());
    }
    Err(Error::Contradiction {
        quantity: "force_ratio",
        reason: "the forces have the opposite sign of the creepages: they must be those on the \
                 rail, -Fx/N over creepage_x and -Fy/N over creepage_y, as creep curves show them"
            .to_owned(),
    })
}
