//! What determines the forces of an element.

/// Creepages and speed, patch and friction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Acting<T> {
    /// ξ, η (dimensionless) and φ, in 1/m.
    pub creepages: [T; 3],
    /// To which they refer, in m/s, above zero.
    pub speed: T,
    /// N, in N.
    pub load: T,
    /// a and b, in m.
    pub semi_axes: [T; 2],
    /// Factor of the coefficient of friction, dimensionless.
    pub friction_factor: T,
    /// Bulk temperatures of wheel and rail, in degC.
    pub temperatures: [T; 2],
    /// Friction limit μN of the contact as a whole, in N.
    pub limit: T,
}
