//! The pressure of a contact in a plane.

use super::contact_plane::ContactPlane;

/// A solved normal contact.
#[derive(Debug, Clone)]
pub(super) struct Pressed {
    pub plane: ContactPlane,
    /// Positions of the cells along x, relative to the plane's origin, in m.
    pub x: Vec<f64>,
    /// The same along s, in m.
    pub s: Vec<f64>,
    /// In rows along x, in Pa.
    pub pressure: Vec<f64>,
    /// How far tractions have moved the surfaces apart, in rows along x, in m; empty where they
    /// have not.
    pub opening: Vec<f64>,
    /// Force of the pressure, which is normal to the plane, in N.
    pub force: f64,
    /// Integral of the pressure over the surface, in N: on a curved one more than its force.
    pub load: f64,
    /// Curvature of the surface across rolling in 1/m, positive where the rail is convex; zero in a
    /// plane.
    pub curvature: f64,
    /// Approach of the bodies, in m.
    pub approach: f64,
}

impl Pressed {
    /// Centre of the pressure relative to the plane's origin, along x and s, in m.
    pub fn centre(&self) -> [f64; 2] {
        self.means([|x, _| x, |_, s| s])
    }

    /// Means of functions of x and s (in m), weighted with the pressure, in their own units.
    pub fn means<const N: usize>(&self, of: [fn(f64, f64) -> f64; N]) -> [f64; N] {
        let (mut sums, mut total) = ([0.0; N], 0.0);
        for (row, s) in self.pressure.chunks_exact(self.x.len()).zip(&self.s) {
            for (p, x) in row.iter().zip(&self.x) {
                total += p;
                sums.iter_mut().zip(of).for_each(|(sum, of)| *sum += p * of(*x, *s));
            }
        }
        sums.map(|sum| sum / total)
    }
}

/// Centres of so many cells along a side.
pub(super) fn positions(side: [f64; 2], count: usize) -> Vec<f64> {
    let spacing = (side[1] - side[0]) / count as f64;
    (0..count).map(|k| side[0] + (k as f64 + 0.5) * spacing).collect()
}
