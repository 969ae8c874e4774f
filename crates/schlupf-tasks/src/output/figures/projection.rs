//! A parallel projection of a box, seen from behind its near corner: x to the lower right, y to the
//! upper right, z up. The leading edge of a patch is at the front right, as in the paper.

/// Azimuth of the view, in rad.
const AZIMUTH: f64 = 0.70;
/// Elevation of the view, in rad.
const ELEVATION: f64 = 0.50;
/// Ratio of the height of the box to half its width.
const HEIGHT: f64 = 1.15;

/// Maps a box to the drawing.
#[derive(Debug, Clone)]
pub(crate) struct Projection {
    /// Ranges of x, y and z.
    pub ranges: [[f64; 2]; 3],
    /// Position of the centre of the floor in the drawing.
    pub center: [f64; 2],
    /// Half the width of the box, in drawing units.
    pub scale: f64,
}

impl Projection {
    /// Position of a point in the drawing.
    pub(crate) fn at(&self, point: [f64; 3]) -> [f64; 2] {
        let [u, v] = self.floor([point[0], point[1]]);
        let [low, high] = self.ranges[2];
        let w = (point[2] - low) / (high - low) * HEIGHT;
        let right = u * AZIMUTH.cos() + v * AZIMUTH.sin();
        let up = w * ELEVATION.cos() + Self::away(u, v) * ELEVATION.sin();
        [self.center[0] + self.scale * right, self.center[1] - self.scale * up]
    }

    /// Distance of a point on the floor.
    pub(crate) fn distance(&self, place: [f64; 2]) -> f64 {
        let [u, v] = self.floor(place);
        Self::away(u, v)
    }

    /// The apparent angle of a line on the floor, clockwise, in degrees.
    pub(crate) fn angle(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let low = self.ranges[2][0];
        let [p, q] = [from, to].map(|place| self.at([place[0], place[1], low]));
        (q[1] - p[1]).atan2(q[0] - p[0]).to_degrees()
    }

    fn away(u: f64, v: f64) -> f64 {
        v * AZIMUTH.cos() - u * AZIMUTH.sin()
    }

    /// A position on the floor, from −1 to 1.
    fn floor(&self, place: [f64; 2]) -> [f64; 2] {
        let unit = |value: f64, [low, high]: [f64; 2]| 2.0 * (value - low) / (high - low) - 1.0;
        [unit(place[0], self.ranges[0]), unit(place[1], self.ranges[1])]
    }
}
