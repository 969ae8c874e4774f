//! Forces from a look-up table of the half-space with Coulomb's law, with their derivatives.

use crate::bodies::Kinematics;
use crate::problem::Problem;
use crate::problem::look_up_table::{AtShape, LookUpTable, NormalisedForce};
use crate::solution::{Resultant, Sensitivity};

use super::EllipticContact;
use super::elliptic_contact::friction_state;

/// A table on the patch of one contact.
///
/// ```
/// use schlupf::bodies::Kinematics;
/// use schlupf::solver::simplified::{EllipticContact, TableContact};
/// use schlupf::analysis::table_building::{NothingKept, TableOptions, build};
/// use schlupf::{Problem, unwatched};
///
/// let options = TableOptions {
///     axis_ratios: [1.0, 1.4],
///     tolerance: 0.3,
///     states: 10,
///     ..TableOptions::default()
/// };
/// let table = build(&options, &NothingKept, &unwatched)?.table;
/// let problem = Problem::builder().build()?;
/// let contact = TableContact::new(&table, EllipticContact::new(&problem)?);
/// // At standstill the forces go by the slip velocities; here with 1 cm/s in place of the speed.
/// let force = contact.standstill_force([0.0, 0.5, 0.0], 0.0, 0.01, 24e3);
/// assert!(force.force.y < -0.9 * 24e3);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct TableContact<'a> {
    table: &'a LookUpTable,
    at: AtShape,
    contact: EllipticContact,
}

/// A force with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableForce {
    /// On the wheel, in N and N m.
    pub force: Resultant,
    /// Derivatives of Fx (in N), Fy (in N) and Mz (in N m), a row each, with respect to ξ, η
    /// (dimensionless) and φ (in 1/m), or to the slip velocities (in m/s and rad/s).
    pub slopes: [[f64; 3]; 3],
    /// Whether the table covers the shape of the patch.
    pub is_covered: bool,
}

impl TableForce {
    /// In the frame turned by π about the normal.
    fn turned(&self) -> Self {
        let signs = [-1.0, -1.0, 1.0];
        let Resultant { x, y, moment_z } = self.force;
        Self {
            force: Resultant { x: -x, y: -y, moment_z },
            slopes: std::array::from_fn(|row| {
                std::array::from_fn(|column| signs[row] * signs[column] * self.slopes[row][column])
            }),
            ..*self
        }
    }

    /// Between this one and another, of which it takes a share, dimensionless.
    fn mixed(&self, other: &Self, share: f64) -> Self {
        let mix = |one: f64, two: f64| one + share * (two - one);
        let rest = self.force.scaled(1.0 - share, 1.0 - share);
        Self {
            force: rest.plus(share, &other.force),
            slopes: std::array::from_fn(|row| {
                std::array::from_fn(|k| mix(self.slopes[row][k], other.slopes[row][k]))
            }),
            is_covered: self.is_covered && other.is_covered,
        }
    }
}

impl<'a> TableContact<'a> {
    /// A table for a contact. Its creep coefficients take account of its own Poisson's ratio.
    pub fn new(table: &'a LookUpTable, contact: EllipticContact) -> Self {
        Self::at(table, Self::shape(table, &contact), contact)
    }

    /// What depends on the shape of the patch alone.
    pub(crate) fn shape(table: &LookUpTable, contact: &EllipticContact) -> AtShape {
        let c = contact.coefficients;
        let axis_ratio = contact.normal.semi_axis_x / contact.normal.semi_axis_y;
        table.at(axis_ratio, Some([c.c11, c.c22, c.c23, c.c33]))
    }

    pub(crate) fn at(table: &'a LookUpTable, at: AtShape, contact: EllipticContact) -> Self {
        Self { table, at, contact }
    }

    /// The force under a motion, with a friction limit μN in N; without one (a wheel that lifts
    /// off) no force. Allocates nothing.
    pub fn force(&self, motion: &Kinematics, limit: f64) -> TableForce {
        let creepages = [motion.creepage_x, motion.creepage_y, motion.spin];
        self.scaled(&self.normalised(creepages, limit), limit, 1.0)
    }

    /// The force under slip velocities of the wheel over the rail along and across rolling (in m/s)
    /// and about the normal (in rad/s), at a rolling speed v (in m/s) that may vanish: creepages
    /// are slip velocities over √(v² + v_s²), with v_s (in m/s, above 0) the speed below which the
    /// forces go by the slip velocities alone. A negative speed is that of rolling backwards: the
    /// frame turned by π rolls forwards, so the lateral force of a spin changes its sign; between
    /// ∓v_s the forces pass from the one direction to the other. Derivatives, with respect to the
    /// slip velocities, are finite. `limit` is μN in N. Allocates nothing.
    pub fn standstill_force(
        &self,
        slip: [f64; 3],
        speed: f64,
        standstill_speed: f64,
        limit: f64,
    ) -> TableForce {
        let reference = speed.hypot(standstill_speed);
        let creepages = slip.map(|slip| slip / reference);
        let forwards =
            |creepages| self.scaled(&self.normalised(creepages, limit), limit, reference);
        let place = (speed / standstill_speed).clamp(-1.0, 1.0);
        // Of the direction forwards, with a slope that ends at both speeds.
        let share = 0.5 + 0.25 * place * (3.0 - place * place);
        let backwards = || {
            let [xi, eta, spin] = creepages;
            forwards([-xi, -eta, spin]).turned()
        };
        if share >= 1.0 {
            forwards(creepages)
        } else if share <= 0.0 {
            backwards()
        } else {
            backwards().mixed(&forwards(creepages), share)
        }
    }

    fn normalised(&self, [xi, eta, spin]: [f64; 3], limit: f64) -> NormalisedForce {
        // Without load or friction no force: any state will do, as it is multiplied by nothing.
        let limit = if limit > 0.0 { limit } else { 1.0 };
        let unit = self.unit(limit);
        let creepages = [unit * xi, unit * eta, unit * self.contact.lever() * spin];
        self.table.force_at(&self.at, creepages)
    }

    /// G ab/(μN).
    fn unit(&self, limit: f64) -> f64 {
        let normal = &self.contact.normal;
        self.contact.shear_modulus * normal.semi_axis_x * normal.semi_axis_y / limit
    }

    /// With derivatives with respect to the creepages times `speed`.
    fn scaled(&self, normalised: &NormalisedForce, limit: f64, speed: f64) -> TableForce {
        let lever = self.contact.lever();
        let arms = [1.0, 1.0, lever];
        let slope = if limit > 0.0 { limit * self.unit(limit) / speed } else { 0.0 };
        let [x, y, moment] = normalised.force;
        TableForce {
            force: Resultant::new(limit * x, limit * y, limit * lever * moment),
            slopes: std::array::from_fn(|row| {
                std::array::from_fn(|column| {
                    arms[row] * arms[column] * slope * normalised.by_creepage[row][column]
                })
            }),
            is_covered: normalised.is_covered,
        }
    }

    /// The derivatives of the forces of a problem; the load changes the patch by its exponent.
    pub(super) fn sensitivity(&self, problem: &Problem) -> Sensitivity {
        let motion = &problem.kinematics;
        let load = self.contact.normal.load;
        let friction = problem.interface.friction.law.respond(&friction_state(problem));
        let limit = friction.coefficient * load;
        let TableForce { force, slopes, .. } = self.force(motion, limit);
        let column = |k: usize| Resultant::new(slopes[0][k], slopes[1][k], slopes[2][k]);
        let creepages = [motion.creepage_x, motion.creepage_y, motion.spin];
        // How the force changes if all creepages do by the same part, and with them alone.
        let along = |parts: [f64; 3]| {
            (0..3)
                .fold(Resultant::default(), |sum, k| sum.plus(parts[k] * creepages[k], &column(k)))
        };
        // F = μN f(ξ/μN …).
        let by_limit = force.plus(-1.0, &along([1.0; 3])).scaled(limit.recip(), limit.recip());
        let by_slip = load * friction.by_slip_speed;
        let [along_x, along_y] = slip_directions(motion).map(|part| by_slip * motion.speed * part);
        let by_load = problem.normal.load_exponent().map(|exponent| {
            let grown = along([2.0 * exponent, 2.0 * exponent, 3.0 * exponent]);
            let moment = Resultant::new(0.0, 0.0, exponent * force.moment_z.unwrap_or(0.0));
            let by_size = grown.plus(1.0, &moment).scaled(load.recip(), load.recip());
            by_limit.scaled(friction.coefficient, friction.coefficient).plus(1.0, &by_size)
        });
        let by_cold = load * friction.by_cold_coefficient;
        Sensitivity {
            creepage_x: column(0).plus(along_x, &by_limit),
            creepage_y: column(1).plus(along_y, &by_limit),
            spin: column(2),
            load: by_load,
            friction_coefficient: by_limit.scaled(by_cold, by_cold),
            contact_stiffness: Resultant::default(),
        }
    }
}

/// Derivatives of √(ξ² + η²), which the friction law takes, with respect to both.
fn slip_directions(motion: &Kinematics) -> [f64; 2] {
    let total = motion.creepage_x.hypot(motion.creepage_y);
    if total > 0.0 { [motion.creepage_x / total, motion.creepage_y / total] } else { [0.0; 2] }
}
