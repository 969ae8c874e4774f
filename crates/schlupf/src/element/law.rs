//! Forces of a contact by a method.

use std::sync::Arc;

use crate::bodies::Kinematics;
use crate::normal::NormalSummary;
use crate::numerics::dual::Dual;
use crate::problem::look_up_table::{AtShape, LookUpTable};
use crate::problem::{AreaReduction, FastMethod};
use crate::reporting::Error;
use crate::solver::simplified::{EllipticContact, TableContact, polach, shen_hedrick_elkins};
use crate::{Method, Options, Problem};

use super::acting::Acting;
use super::solved::Solved;

/// A method for a contact.
#[derive(Debug, Clone)]
pub(super) struct Law {
    kind: Kind,
    contact: EllipticContact,
}

#[derive(Debug, Clone)]
enum Kind {
    KalkerLinear,
    ShenHedrickElkins,
    Polach(AreaReduction),
    Table(Arc<LookUpTable>, Box<AtShape>),
    Solved(Box<Solved>),
}

/// Rows that are some 0.1 ms of work of a fast method.
pub(super) const FAST_ROWS: usize = 512;

/// Friction that counts as none, dimensionless.
const NO_FRICTION: f64 = 1e-12;

/// Creepages, friction limit and the semi-axis along rolling, on which the forces of a fast method
/// depend: the axes grow alike.
const VARIABLES: usize = 5;

impl Law {
    /// # Errors
    /// What a solver rejects.
    pub fn new(
        problem: &Problem,
        (method, options): (&Method, &Options),
        contact: &EllipticContact,
    ) -> Result<Self, Error> {
        let kind = match method {
            Method::Fast(FastMethod::KalkerLinear) => Kind::KalkerLinear,
            Method::Fast(FastMethod::ShenHedrickElkins) => Kind::ShenHedrickElkins,
            Method::Fast(FastMethod::Polach(reduction)) => Kind::Polach(*reduction),
            Method::Fast(FastMethod::Table(table)) => {
                let shape = Box::new(TableContact::shape(table, contact));
                Kind::Table(Arc::clone(table), shape)
            }
            Method::Fast(FastMethod::Fastsim(..) | FastMethod::ModifiedFastsim(..))
            | Method::Full => Kind::Solved(Box::new(Solved::new(problem, method, options)?)),
        };
        Ok(Self { kind, contact: *contact })
    }

    /// Whether it has a moment.
    pub fn has_moment(&self) -> bool {
        !matches!(self.kind, Kind::Polach(..))
    }

    /// Whether its forces are bounded.
    pub fn has_limit(&self) -> bool {
        !matches!(self.kind, Kind::KalkerLinear)
    }

    /// Fx, Fy (in N) and Mz (in N m, zero where the method has none); `None` where a solver does
    /// not find them.
    pub fn force<const N: usize>(&mut self, acting: &Acting<Dual<N>>) -> Option<[Dual<N>; 3]> {
        let Acting { creepages: [xi, eta, spin], limit, semi_axes: [a, _], .. } = *acting;
        if limit.value <= NO_FRICTION * acting.load.value {
            return Some([Dual::from(0.0); 3]);
        }
        if let Kind::Solved(solved) = &mut self.kind {
            return solved.force(acting);
        }
        let creepages = [xi, eta, spin].map(|creepage| creepage.value);
        let found =
            self.differentiated(creepages, (limit.value, acting.semi_axes.map(|axis| axis.value)));
        let variables = [xi, eta, spin, limit, a];
        Some(found.map(|force| force.of(&variables)))
    }

    /// Rows that one element evaluates in turn where there are many: of a solver as many as its
    /// set-up is worth.
    pub fn rows_in_turn(&self) -> usize {
        match &self.kind {
            Kind::Solved(solved) => solved.rows_in_turn(),
            _ => FAST_ROWS,
        }
    }

    /// Forgets what a solver found.
    pub fn forget(&mut self) {
        if let Kind::Solved(solved) = &mut self.kind {
            solved.forget();
        }
    }

    /// For a limit (in N) and semi-axes, in m.
    fn differentiated(
        &self,
        [xi, eta, spin]: [f64; 3],
        (limit, [a, b]): (f64, [f64; 2]),
    ) -> [Dual<VARIABLES>; 3] {
        if let Kind::Table(table, shape) = &self.kind {
            return self.tabulated((table, **shape), [xi, eta, spin], (limit, [a, b]));
        }
        let variables = Dual::variables([xi, eta, spin, 1.0]);
        let [creepages @ .., growth] = variables;
        let ellipse = self.contact.ellipse([a, b].map(|axis| growth * axis));
        let held = Dual::from(limit);
        let found = match &self.kind {
            Kind::ShenHedrickElkins => shen_hedrick_elkins::saturated(&ellipse, creepages, held),
            Kind::Polach(AreaReduction { area_adhesion, area_slip }) => {
                let reduction = [*area_adhesion, *area_slip].map(Dual::from);
                let [x, y] = polach::limited(&ellipse, creepages, held, reduction);
                [x, y, Dual::from(0.0)]
            }
            Kind::KalkerLinear | Kind::Table(..) | Kind::Solved(..) => {
                ellipse.linear_force(creepages)
            }
        };
        // F = μN f(ξ/(μN), η/(μN), φ/(μN)).
        found.map(|Dual { value, slopes: [by_xi, by_eta, by_spin, by_growth] }| {
            let by_limit = (value - xi * by_xi - eta * by_eta - spin * by_spin) / limit;
            Dual { value, slopes: [by_xi, by_eta, by_spin, by_limit, by_growth / a] }
        })
    }

    /// On patches of one shape F = μN f(G ab ξ/(μN), …).
    fn tabulated(
        &self,
        (table, shape): (&LookUpTable, AtShape),
        [creepage_x, creepage_y, spin]: [f64; 3],
        (limit, [a, b]): (f64, [f64; 2]),
    ) -> [Dual<VARIABLES>; 3] {
        let normal = NormalSummary { semi_axis_x: a, semi_axis_y: b, ..self.contact.normal };
        let contact = self.contact.resized(normal);
        let motion = Kinematics { creepage_x, creepage_y, spin, ..Kinematics::free_rolling(1.0) };
        let found = TableContact::at(table, shape, contact).force(&motion, limit);
        let force = [found.force.x, found.force.y, found.force.moment_z.unwrap_or(0.0)];
        std::array::from_fn(|row| {
            let [by_x, by_y, by_spin] = found.slopes[row];
            let (along, turning) = (creepage_x * by_x + creepage_y * by_y, spin * by_spin);
            let arm = if row == 2 { force[row] } else { 0.0 };
            let by_limit = (force[row] - along - turning) / limit;
            let by_growth = 2.0 * along + 3.0 * turning + arm;
            Dual { value: force[row], slopes: [by_x, by_y, by_spin, by_limit, by_growth / a] }
        })
    }
}
