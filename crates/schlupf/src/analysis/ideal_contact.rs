//! The contact on which others are calibrated and tables are built: an ellipse between equal bodies
//! that are half-spaces, with constant friction and without heat.

use crate::bodies::{Body, Kinematics, Material};
use crate::elasticity::HalfSpace;
use crate::interface::ContactLaw;
use crate::interface::friction::Constant;
use crate::interface::heat::Heat;
use crate::normal::Ellipse;
use crate::problem::Problem;
use crate::reporting::Error;

pub(super) struct IdealContact {
    /// √(ab), in m.
    pub size: f64,
    /// p0, in Pa.
    pub peak_pressure: f64,
    /// μ, dimensionless.
    pub friction: f64,
}

impl IdealContact {
    /// Semi-axes along and across rolling (in m) for a/b.
    pub fn semi_axes(&self, axis_ratio: f64) -> [f64; 2] {
        [self.size * axis_ratio.sqrt(), self.size / axis_ratio.sqrt()]
    }

    /// Rolling without creepage at 1 m/s, for a/b and ν, and the bodies.
    pub fn problem(
        &self,
        axis_ratio: f64,
        poisson_ratio: f64,
        law: impl Into<ContactLaw>,
    ) -> Result<(Problem, HalfSpace), Error> {
        let [a, b] = self.semi_axes(axis_ratio);
        let material = Material { poisson_ratio, ..Material::STEEL };
        let bodies = HalfSpace::new(&material, &material)?;
        let body = Body { material, ..Body::STEEL };
        let problem = Problem::builder()
            .kinematics(Kinematics::free_rolling(1.0))
            .wheel(body)
            .rail(body)
            .normal(Ellipse::from_peak_pressure(a, b, self.peak_pressure)?)
            .elasticity(bodies)
            .contact_law(law)
            .friction(Constant::new(self.friction)?)
            .heat(Heat::none())
            .build()?;
        Ok((problem, bodies))
    }
}
