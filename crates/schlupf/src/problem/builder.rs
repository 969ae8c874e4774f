//! Builder for problems. Defaults are those of a case file.

use std::sync::Arc;

use crate::bodies::{Body, Kinematics, ReferencePoint, contact_modulus};
use crate::elasticity::{CalibratedLayer, Elasticity};
use crate::interface::friction::{Friction, FrictionLaw, TemperatureLinear};
use crate::interface::heat::Heat;
use crate::interface::{ContactLaw, Interface, ThirdBodyLayer};
use crate::normal::{AtLoad, Hertz, PressureSource, Radii};
use crate::problem::{Branch, PrescribedForces, Problem};
use crate::reporting::Error;

/// Default normal load N, in N.
const LOAD: f64 = 80e3;

impl Problem {
    /// A steel wheel in free rolling on a steel rail; every method changes one property.
    ///
    /// ```
    /// use schlupf::{solver, Options, Problem, unwatched};
    ///
    /// let problem = Problem::builder().load(80e3).speed(30.0).creepage_x(0.008).build()?;
    /// let solution = solver::solve(&problem, &Options::default(), &unwatched)?;
    /// assert!(solution.force.x < 0.0, "the wheel brakes");
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn builder() -> ProblemBuilder {
        ProblemBuilder::default()
    }
}

/// A problem under construction; see [`Problem::builder`].
#[derive(Debug, Clone)]
#[must_use]
pub struct ProblemBuilder {
    kinematics: Kinematics,
    prescribed: PrescribedForces,
    reference: ReferencePoint,
    branch: Branch,
    wheel: Body,
    rail: Body,
    radii: [Radii; 2],
    load: Option<f64>,
    normal: Option<Arc<dyn PressureSource>>,
    elasticity: Option<Arc<dyn Elasticity>>,
    layer: Option<ThirdBodyLayer>,
    contact_law: ContactLaw,
    friction: Option<Arc<dyn FrictionLaw>>,
    reference_temperature: Option<f64>,
    heat: Heat,
}

impl Default for ProblemBuilder {
    fn default() -> Self {
        Self {
            kinematics: Kinematics::free_rolling(30.0),
            prescribed: PrescribedForces::default(),
            reference: ReferencePoint::Patch,
            branch: Branch::LowSlip,
            wheel: Body::STEEL,
            rail: Body::STEEL,
            radii: [Radii::along(0.46), Radii::across(0.3)],
            load: None,
            normal: None,
            elasticity: None,
            layer: None,
            contact_law: ContactLaw::default(),
            friction: None,
            reference_temperature: None,
            heat: Heat::default(),
        }
    }
}

impl ProblemBuilder {
    /// Speed v0, in m/s; default 30 m/s.
    pub fn speed(mut self, speed: f64) -> Self {
        self.kinematics.speed = speed;
        self
    }

    /// Longitudinal creepage ξ, dimensionless; positive when braking.
    pub fn creepage_x(mut self, creepage_x: f64) -> Self {
        self.kinematics.creepage_x = creepage_x;
        self
    }

    /// Lateral creepage η, dimensionless.
    pub fn creepage_y(mut self, creepage_y: f64) -> Self {
        self.kinematics.creepage_y = creepage_y;
        self
    }

    /// Spin creepage φ, in 1/m.
    pub fn spin(mut self, spin: f64) -> Self {
        self.kinematics.spin = spin;
        self
    }

    /// Speed, creepages and spin together, for example from [`Kinematics::from_wheel`].
    pub fn kinematics(mut self, kinematics: Kinematics) -> Self {
        self.kinematics = kinematics;
        self
    }

    /// Forces in place of the creepages of the same direction; default: none.
    pub fn prescribed(mut self, prescribed: PrescribedForces) -> Self {
        self.prescribed = prescribed;
        self
    }

    /// Reference point of the creepages and the moment; default: the centre of the patch.
    pub fn reference(mut self, reference: ReferencePoint) -> Self {
        self.reference = reference;
        self
    }

    /// Which of several steady states; default: the one reached from low slip.
    pub fn branch(mut self, branch: Branch) -> Self {
        self.branch = branch;
        self
    }

    /// The wheel; default: steel at 20 degC.
    pub fn wheel(mut self, wheel: Body) -> Self {
        self.wheel = wheel;
        self
    }

    /// The rail; default: steel at 20 degC.
    pub fn rail(mut self, rail: Body) -> Self {
        self.rail = rail;
        self
    }

    /// Radii of the wheel for Hertz's contact; default: 0.46 m along rolling and straight across.
    pub fn wheel_radii(mut self, radii: Radii) -> Self {
        self.radii[0] = radii;
        self
    }

    /// Radii of the rail for Hertz's contact; default: straight along rolling and 0.3 m across.
    pub fn rail_radii(mut self, radii: Radii) -> Self {
        self.radii[1] = radii;
        self
    }

    /// Normal load N, in N; default: 80 kN, or the load of the pressure source itself.
    pub fn load(mut self, load: f64) -> Self {
        self.load = Some(load);
        self
    }

    /// Source of the pressure, replacing Hertz's contact of the radii.
    pub fn normal(mut self, source: impl PressureSource + 'static) -> Self {
        self.normal = Some(Arc::new(source));
        self
    }

    /// Tangential elasticity, replacing the [`CalibratedLayer`] of the materials.
    pub fn elasticity(mut self, model: impl Elasticity + 'static) -> Self {
        self.elasticity = Some(Arc::new(model));
        self
    }

    /// A layer between the surfaces; default: none.
    pub fn layer(mut self, layer: ThirdBodyLayer) -> Self {
        self.layer = Some(layer);
        self
    }

    /// Contact law, replacing [`ContactLaw::default`].
    pub fn contact_law(mut self, law: impl Into<ContactLaw>) -> Self {
        self.contact_law = law.into();
        self
    }

    /// Friction law, replacing [`TemperatureLinear::default`].
    pub fn friction(mut self, law: impl FrictionLaw + 'static) -> Self {
        self.friction = Some(Arc::new(law));
        self
    }

    /// Reference temperature of the friction law, in degC; default: that of the rail.
    pub fn reference_temperature(mut self, temperature: f64) -> Self {
        self.reference_temperature = Some(temperature);
        self
    }

    /// Frictional heating, replacing [`Heat::default`].
    pub fn heat(mut self, heat: Heat) -> Self {
        self.heat = heat;
        self
    }

    /// The problem.
    ///
    /// # Errors
    /// A contact outside Hertz's theory, materials for which the layer is not calibrated, and
    /// everything [`Problem::check`] rejects.
    pub fn build(self) -> Result<Problem, Error> {
        let [wheel, rail] = [&self.wheel.material, &self.rail.material];
        let normal = match (self.normal, self.load) {
            (Some(source), None) => source,
            (Some(source), Some(load)) => Arc::new(AtLoad::new(source, load)?),
            (None, load) => {
                let [wheel_radii, rail_radii] = self.radii;
                let modulus = contact_modulus(wheel, rail);
                Arc::new(Hertz::new(wheel_radii, rail_radii, modulus, load.unwrap_or(LOAD))?)
            }
        };
        let elasticity = match self.elasticity {
            Some(model) => model,
            None => Arc::new(CalibratedLayer::new(wheel, rail, None)?),
        };
        let friction = self.friction.unwrap_or_else(|| Arc::new(TemperatureLinear::default()));
        let reference_temperature =
            self.reference_temperature.unwrap_or(self.rail.bulk_temperature);
        let problem = Problem {
            kinematics: self.kinematics,
            prescribed: self.prescribed,
            reference: self.reference,
            branch: self.branch,
            normal,
            interface: Interface {
                wheel: self.wheel,
                rail: self.rail,
                elasticity,
                layer: self.layer,
                contact_law: self.contact_law,
                friction: Friction::new(friction, reference_temperature),
                heat: self.heat,
            },
        };
        problem.check()?;
        Ok(problem)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::Ellipse;

    #[test]
    fn a_source_of_pressure_has_its_own_load_unless_another_is_given() {
        let builder = Problem::builder().normal(Ellipse::from_load(6e-3, 5e-3, 7e4).unwrap());
        let load = |builder: ProblemBuilder| {
            builder.build().unwrap().normal.normal_contact(None).unwrap().summary.load
        };
        assert_eq!(load(builder.clone()), 7e4);
        assert_eq!(load(builder.load(9e4)), 9e4);
    }

    #[test]
    fn friction_counts_from_the_temperature_of_the_rail() {
        let rail = Body { bulk_temperature: -10.0, ..Body::STEEL };
        let problem = Problem::builder().rail(rail).build().unwrap();
        assert_eq!(problem.interface.friction.reference_temperature, -10.0);
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let error = Problem::builder().load(-1.0).build().unwrap_err();
        assert!(error.to_string().starts_with("load"), "{error}");
        let error = Problem::builder().creepage_x(1.5).build().unwrap_err();
        assert!(error.to_string().contains("a reversed wheel"), "{error}");
    }
}
