//! A layer between the surfaces, the third body: oxides, wear debris, leaves, sand.

use crate::reporting::{Error, Quantity, Requirement, require};

/// A thin layer that is sheared by the traction of the point above it.
///
/// Its surfaces move against each other by u = (h/G) t, which adds to the displacement of the
/// bodies; points of the layer do not move each other. Material enters the contact unsheared. Where
/// the traction reaches a limit of elasticity below μ pₙ the layer flows, and there the limit takes
/// the place of μ pₙ.
///
/// Source: Hou, Kalousek and Magel, Rheological model of solid layer in rolling contact (1997), by
/// way of Vollebregt's user guide for CONTACT.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThirdBodyLayer {
    thickness: f64,
    shear_modulus: f64,
    yielding: Option<YieldLimit>,
}

/// The traction at which a layer flows, τ_c = τ_c0 + k_τ w with the accumulated plastic
/// displacement w of its surfaces against each other; at least zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldLimit {
    /// τ_c0, in Pa.
    pub stress: f64,
    /// k_τ, in Pa/m; negative: the layer softens.
    pub hardening: f64,
}

/// Bounds of a thickness, in m.
const THICKNESS: Requirement = Requirement::Between(0.0, 1.0);

/// Bounds of a shear modulus and of a limit of elasticity, in Pa.
const MODULUS: Requirement = Requirement::Between(1.0, 1e14);

/// Largest hardening, in Pa/m.
const STEEPEST: f64 = 1e20;

impl YieldLimit {
    /// τ_c (in Pa) after a plastic displacement w, in m.
    pub fn at(&self, accumulated: f64) -> f64 {
        (self.stress + self.hardening * accumulated).max(0.0)
    }
}

impl ThirdBodyLayer {
    /// An elastic layer of thickness h (in m) and shear modulus G, in Pa. Without thickness it is
    /// rigid until it yields.
    ///
    /// ```
    /// use schlupf::interface::ThirdBodyLayer;
    ///
    /// let layer = ThirdBodyLayer::new(1.25e-3, 8.2e9)?;
    /// assert!((layer.compliance() - 1.524e-13).abs() < 1e-16);
    /// assert!(ThirdBodyLayer::new(1.25e-3, 0.0).is_err());
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// A thickness outside 0 to 1 m, and a shear modulus outside 1 Pa to 100 TPa.
    pub fn new(thickness: f64, shear_modulus: f64) -> Result<Self, Error> {
        require(Quantity::LayerThickness, THICKNESS, thickness)?;
        require(Quantity::LayerShearModulus, MODULUS, shear_modulus)?;
        Ok(Self { thickness, shear_modulus, yielding: None })
    }

    /// The same layer with a limit of elasticity.
    ///
    /// # Errors
    /// A limit τ_c0 outside 1 Pa to 100 TPa, and a softening that is as steep as the layer is
    /// stiff, k_τ ≤ −G/h: the traction would jump.
    pub fn with_yield(self, limit: YieldLimit) -> Result<Self, Error> {
        require(Quantity::LayerYieldStress, MODULUS, limit.stress)?;
        let legal = Requirement::AboveUpTo(-self.compliance().recip(), STEEPEST);
        require(Quantity::LayerHardening, legal, limit.hardening)?;
        Ok(Self { yielding: Some(limit), ..self })
    }

    /// Thickness h, in m.
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// Shear modulus G, in Pa.
    pub fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    /// Its limit of elasticity, if it has one.
    pub fn yield_limit(&self) -> Option<YieldLimit> {
        self.yielding
    }

    /// Displacement over traction h/G, in m/Pa.
    pub fn compliance(&self) -> f64 {
        self.thickness / self.shear_modulus
    }

    /// How fast its limit grows with the plastic displacement, in Pa/m: zero where it does not.
    pub(crate) fn hardening(&self) -> f64 {
        self.yielding.map_or(0.0, |limit| limit.hardening.max(0.0))
    }

    /// Whether its limit changes with the plastic displacement.
    pub(crate) fn hardens(&self) -> bool {
        self.yielding.is_some_and(|limit| limit.hardening != 0.0)
    }

    /// What bounds the traction of material that has flowed by a length (in m) before, where
    /// friction would by μ pₙ (in Pa) and the surfaces slip by `slips` (in m) until they are at a
    /// place, and until they leave it.
    pub(crate) fn pass(&self, friction: f64, flowed: f64, slips: [f64; 2]) -> Flow {
        let by_friction = Flow { bound: friction, here: flowed, left: flowed, yields: [false; 2] };
        let Some(limit) = self.yielding else { return by_friction };
        let before = limit.at(flowed);
        if before >= friction {
            return by_friction;
        }
        // Until the limit has grown to what friction allows.
        let most = match limit.hardening {
            hardening if hardening > 0.0 => (friction - before) / hardening,
            _ => f64::INFINITY,
        };
        let [here, left] = slips.map(|slip| flowed + slip.min(most));
        Flow { bound: limit.at(here), here, left, yields: slips.map(|slip| slip < most) }
    }
}

/// What bounds the traction of material at a place.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Flow {
    /// The bound, in Pa.
    pub bound: f64,
    /// The plastic displacement at the place, in m.
    pub here: f64,
    /// The plastic displacement on leaving the place, in m.
    pub left: f64,
    /// Whether it flows at the place, and until it leaves it.
    pub yields: [bool; 2],
}

/// A point of a layer that is sheared: elastic, and flowing at the limit.
///
/// ```
/// use schlupf::interface::{ShearedPoint, ThirdBodyLayer, YieldLimit};
///
/// let limit = YieldLimit { stress: 200e6, hardening: 0.0 };
/// let layer = ThirdBodyLayer::new(1e-3, 8e9)?.with_yield(limit)?;
/// let mut point = ShearedPoint::default();
/// assert!((point.shear(&layer, [1e-5, 0.0])[0] - 80e6).abs() < 1.0);
/// assert!((point.shear(&layer, [1e-4, 0.0])[0] - 200e6).abs() < 1.0);
/// assert!((point.accumulated - 7.5e-5).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ShearedPoint {
    /// Plastic part of the displacement of the surfaces against each other, in m.
    pub plastic: [f64; 2],
    /// Its accumulated length, in m.
    pub accumulated: f64,
}

impl ShearedPoint {
    /// The traction (in Pa) after the surfaces have moved on, in a straight line, to a displacement
    /// u against each other (in m). Exact if the traction keeps its direction: elastic up to τ_c,
    /// then dτ/du = k_τ G/h/(k_τ + G/h), and elastic again where u goes back.
    pub fn shear(&mut self, layer: &ThirdBodyLayer, displacement: [f64; 2]) -> [f64; 2] {
        let compliance = layer.compliance();
        let moved = [0, 1].map(|c| displacement[c] - self.plastic[c]);
        let size = moved[0].hypot(moved[1]);
        let elastic = moved.map(|u| if u == 0.0 { 0.0 } else { u / compliance });
        let Some(limit) = layer.yield_limit() else { return elastic };
        let yielding = compliance * limit.at(self.accumulated);
        if size <= yielding {
            return elastic;
        }
        let direction = moved.map(|u| u / size);
        // Until nothing is left of a limit that falls.
        let flow = ((size - yielding) / (1.0 + compliance * limit.hardening)).min(size);
        self.accumulated += flow;
        for (plastic, along) in self.plastic.iter_mut().zip(direction) {
            *plastic += flow * along;
        }
        direction.map(|along| limit.at(self.accumulated) * along)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Clay of Hou et al. 1997: elastic to 40 µm, 200 MPa, then 400 MPa/mm.
    fn clay() -> ThirdBodyLayer {
        let stiffness = 200e6 / 40e-6;
        let slope = 400e6 / 1e-3;
        let hardening = slope * stiffness / (stiffness - slope);
        let layer = ThirdBodyLayer::new(1e-3, 1e-3 * stiffness).unwrap();
        layer.with_yield(YieldLimit { stress: 200e6, hardening }).unwrap()
    }

    /// Hou, Kalousek and Magel 1997: loading along both slopes, unloading with the first, reversing
    /// until the limit of the displacement so far.
    #[test]
    fn hou_1997_loading_unloading_reversing() {
        let (layer, mut point) = (clay(), ShearedPoint::default());
        let along = |point: &mut ShearedPoint, u: f64| point.shear(&layer, [u, 0.0])[0];
        for (u, stress) in [(20e-6, 100e6), (40e-6, 200e6), (90e-6, 220e6), (140e-6, 240e6)] {
            assert_relative_eq!(along(&mut point, u), stress, max_relative = 1e-12);
        }
        // Back by 240 MPa at 5 MPa/µm: free of traction 48 µm before.
        assert_relative_eq!(along(&mut point, 92e-6), 0.0, epsilon = 1.0);
        assert_relative_eq!(along(&mut point, 46e-6), -230e6, max_relative = 1e-12);
        // It flows at 240 MPa again, 96 µm before where it turned, and hardens on.
        assert_relative_eq!(along(&mut point, 44e-6), -240e6, max_relative = 1e-12);
        assert_relative_eq!(along(&mut point, -56e-6), -280e6, max_relative = 1e-12);
        // In one step or in many.
        let (mut once, mut often) = (ShearedPoint::default(), ShearedPoint::default());
        for n in 1..=140 {
            along(&mut often, 1e-6 * f64::from(n));
        }
        along(&mut once, 140e-6);
        assert_relative_eq!(often.accumulated, once.accumulated, max_relative = 1e-12);
    }

    /// Without thickness nothing moves up to the limit, and all movement is plastic beyond.
    #[test]
    fn without_thickness_it_is_rigid_until_it_yields() {
        let limit = YieldLimit { stress: 35e6, hardening: 1e12 };
        let layer = ThirdBodyLayer::new(0.0, 82e9).unwrap().with_yield(limit).unwrap();
        let mut point = ShearedPoint::default();
        assert_eq!(point.shear(&layer, [0.0; 2]), [0.0; 2]);
        assert_relative_eq!(point.shear(&layer, [3e-6, 4e-6])[1], 32e6, max_relative = 1e-12);
        assert_relative_eq!(point.accumulated, 5e-6, max_relative = 1e-12);
    }

    /// Sand softens from 400 MPa by 200 MPa/mm, and never below nothing.
    #[test]
    fn hou_1997_softening() {
        let (stiffness, slope): (f64, f64) = (8e12, -2e11);
        let hardening = slope * stiffness / (stiffness - slope);
        let layer = ThirdBodyLayer::new(1e-3, 8e9).unwrap();
        let limit = YieldLimit { stress: 400e6, hardening };
        let layer = layer.with_yield(limit).unwrap();
        let mut point = ShearedPoint::default();
        let stress = point.shear(&layer, [0.0, -1.05e-3])[1];
        assert_relative_eq!(stress, -200e6, max_relative = 1e-12);
        assert_relative_eq!(point.shear(&layer, [0.0, -5e-3])[1], 0.0, epsilon = 1.0);
        let steep = YieldLimit { hardening: -8e12, ..limit };
        assert!(layer.with_yield(steep).unwrap_err().to_string().starts_with("layer_hardening"));
    }

    /// The bound of a place is continuous where friction takes over.
    #[test]
    fn friction_takes_over_where_the_layer_has_hardened() {
        let layer = clay();
        let (friction, flowed) = (230e6, 10e-6);
        let at = |slip: f64| layer.pass(friction, flowed, [slip, 2.0 * slip]);
        let hardening = layer.yield_limit().unwrap().hardening;
        let until = (230e6 - layer.yield_limit().unwrap().at(flowed)) / hardening;
        let [before, after] = [0.999 * until, 1.001 * until].map(at);
        assert!(before.yields == [true, false] && after.yields == [false; 2]);
        assert_relative_eq!(before.bound, after.bound, max_relative = 1e-3);
        assert_relative_eq!(after.bound, friction, max_relative = 1e-12);
        assert_relative_eq!(before.left, flowed + until, max_relative = 1e-12);
        assert_eq!(layer.pass(150e6, flowed, [1e-5; 2]).left, flowed);
    }
}
