//! A normal contact under a load other than its own.

use std::sync::Arc;

use super::{NormalContact, PressureSource};
use crate::reporting::{Error, Quantity, Warning, Watch, require_positive};

/// A pressure source with a different own load.
#[derive(Debug, Clone)]
pub struct AtLoad {
    source: Arc<dyn PressureSource>,
    load: f64,
}

impl AtLoad {
    /// The source with the load N, in N; whether the patch grows is up to the source.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use schlupf::normal::{Hertz, Radii, PressureSource, AtLoad};
    ///
    /// let [ball, plane] = [0.5, f64::INFINITY].map(|radius| Radii { x: radius, y: radius });
    /// let source = Arc::new(Hertz::new(ball, plane, 1e11, 10e3)?);
    /// let own = source.normal_contact(None)?.summary;
    /// let contact = AtLoad::new(source, 80e3)?.normal_contact(None)?.summary;
    /// // Hertz 1882: eight times the load, twice the length.
    /// assert!((contact.semi_axis_x / own.semi_axis_x - 2.0).abs() < 1e-12);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn new(source: Arc<dyn PressureSource>, load: f64) -> Result<Self, Error> {
        require_positive(Quantity::Load, load)?;
        Ok(Self { source, load })
    }
}

impl PressureSource for AtLoad {
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
        self.source.normal_contact(load.or(Some(self.load)))
    }

    fn prepare(&self, load: Option<f64>, watch: Watch) -> Result<(), Error> {
        self.source.prepare(load.or(Some(self.load)), watch)
    }

    fn undeformed_distance(&self, x: &[f64], y: &[f64]) -> Option<Vec<f64>> {
        self.source.undeformed_distance(x, y)
    }

    fn distance_bounds(&self) -> [[f64; 2]; 2] {
        self.source.distance_bounds()
    }

    fn cells(&self) -> usize {
        self.source.cells()
    }

    fn load_exponent(&self) -> Option<f64> {
        self.source.load_exponent()
    }

    fn caveat(&self) -> Option<Warning> {
        self.source.caveat()
    }
}

#[cfg(test)]
mod tests {
    use super::super::hertz::{Hertz, Radii};
    use super::*;
    use approx::assert_relative_eq;

    /// Hertz 1882: eight times the load, twice the length.
    #[test]
    fn hertz_1882_grows_with_the_cubic_root() {
        let round = Radii { x: 0.5, y: 0.5 };
        let flat = Radii { x: f64::INFINITY, y: f64::INFINITY };
        let own: Arc<dyn PressureSource> = Arc::new(Hertz::new(round, flat, 1e11, 1e4).unwrap());
        let size =
            |source: &dyn PressureSource| source.normal_contact(None).unwrap().summary.semi_axis_x;
        let heavier = AtLoad::new(Arc::clone(&own), 8e4).unwrap();
        assert_relative_eq!(size(&heavier), 2.0 * size(&*own), max_relative = 1e-12);
        assert_eq!(heavier.normal_contact(Some(1e4)).unwrap().summary.load, 1e4);
        assert!(AtLoad::new(own, 0.0).is_err());
    }
}
