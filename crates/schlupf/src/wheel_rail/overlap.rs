//! Points at which a wheel is close to a rail, and regions in which both would overlap.

/// A point of the gap.
#[derive(Debug, Clone, Copy)]
pub(super) struct GapPoint {
    /// Lateral position in the track, in m.
    pub y: f64,
    /// The rail's height there, in m, and arc length, in m.
    pub rail: [f64; 2],
    /// Inclination of the rail, in rad.
    pub inclination: f64,
    /// x of the wheel's candidate in the track, in m, and its arc length, in m.
    pub wheel: [f64; 2],
    /// Vertical gap (in m) with the wheelset at its nominal height.
    pub gap: f64,
}

/// A region in which wheel and rail would overlap.
#[derive(Debug, Clone, Copy)]
pub(super) struct Region {
    /// Sum of the depths to the power of 2.5, in m to that power.
    pub weight: f64,
    /// Weighted mean, in m.
    pub x: f64,
    /// Weighted mean, in m.
    pub y: f64,
    /// Weighted mean of the rail's inclination, in rad.
    pub inclination: f64,
    /// Weighted mean of the angle by which the rail rises forwards, in rad.
    pub rise: f64,
    /// Ends on the rail, y and z in m.
    pub ends: [[f64; 2]; 2],
    /// Extent along x, in m.
    pub along: [f64; 2],
    /// The nearest gap point to the middle.
    pub nearest: GapPoint,
}
