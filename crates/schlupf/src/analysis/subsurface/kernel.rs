//! Stresses in a half-space under uniform pressure or traction on a rectangle, in closed form.
//!
//! With the potentials of Boussinesq and Cerruti (Johnson 1985, §3.2), which are integrals over the
//! loaded rectangle with ρ² = (x − x')² + (y − y')² + z²,
//!
//! V = ∫ dA/ρ,  F = ∫ ln(ρ + z) dA,  Ω = ∫ (z ln(ρ + z) − ρ) dA,  ∂Ω/∂z = F,  ∂F/∂z = V,
//!
//! pressure gives (Love 1929)
//!
//! 2π σxx/p = 2ν V_z − z V_xx − (1 − 2ν) F_xx,  2π σzz/p = V_z − z V_zz,
//! 2π σxy/p = −(1 − 2ν) F_xy − z V_xy,  2π σxz/p = −z V_xz,  and σyy, σyz alike;
//!
//! and traction along x (as in Ahmadi, Keer and Mura 1983)
//!
//! 2π σxx/q = 2(1 + ν) V_x + 2ν Ω_xxx − z F_xxx,  2π σyy/q = 2ν V_x + 2ν Ω_xyy − z F_xyy,
//! 2π σzz/q = −z V_xz,  2π σxy/q = V_y + 2ν Ω_xxy − z F_xxy,
//! 2π σxz/q = V_z − z V_xx,  2π σyz/q = −z V_xy.
//!
//! Here z points into the body, and loads act on it: pressure along z, traction along x. All
//! derivatives are sums over the corners of the rectangle, whose terms are elementary functions of
//! the distance (X, Y) from a corner and of R² = X² + Y² + z². What depends on X or on Y only
//! cancels in the sum and is left out.

use std::f64::consts::TAU;

/// Stresses per load: σxx, σyy, σzz, σxy, σxz, σyz (dimensionless) due to pressure, to traction
/// along x, and to traction along y.
pub(super) type Response = [[f64; 6]; 3];

/// Terms of a corner that change their roles when x and y do.
struct Directional {
    /// V_x.
    first: f64,
    /// z V_xx.
    second: f64,
    /// z V_xz.
    mixed: f64,
    /// F_xx.
    bent: f64,
    /// X/(R + z).
    slope: f64,
}

impl Directional {
    /// Of the direction p at the distance (p, q) and the depth z from the corner.
    fn new([p, q]: [f64; 2], z: f64, distance: f64) -> Self {
        // R + Y loses all digits where Y is negative and long; (R + Y)(R − Y) = X² + z².
        let square = p * p + z * z;
        let sum = if q >= 0.0 { distance + q } else { square / (distance - q) };
        let over = if sum > 0.0 { z / (distance * sum) } else { 0.0 };
        // asinh(Y/√(X² + z²)), with an error of one rounding of 1.
        let stretched = distance + q.abs();
        let first = if square > 0.0 {
            (0.5 * (stretched * stretched / square).ln()).copysign(q)
        } else {
            0.0
        };
        let depth = distance + z;
        Self {
            first,
            second: p * over,
            mixed: z * over,
            bent: -2.0 * p.atan2(sum + z),
            slope: if depth > 0.0 { p / depth } else { 0.0 },
        }
    }
}

/// The terms of a corner at the distance (X, Y) and the depth z below it (in one unit): the
/// response to a uniform load on a rectangle is their sum over its corners with alternating signs.
pub(super) fn corner([x, y]: [f64; 2], z: f64, poisson_ratio: f64) -> Response {
    let nu = poisson_ratio;
    let distance = (x * x + y * y + z * z).sqrt();
    let along = Directional::new([x, y], z, distance);
    let across = Directional::new([y, x], z, distance);
    let down = -(x * y).atan2(z * distance);
    let twist = if distance > 0.0 { z / distance } else { 0.0 };
    let logarithm = if distance + z > 0.0 { (distance + z).ln() } else { 0.0 };
    let third = 1.0 - 2.0 * nu;
    let pressure = [
        2.0 * nu * down - along.second - third * along.bent,
        2.0 * nu * down - across.second - third * across.bent,
        down + along.second + across.second,
        -third * logarithm - twist,
        -along.mixed,
        -across.mixed,
    ];
    let [xx, yy, zz, xy, xz, yz] = traction(&along, &across, [down, twist], nu);
    let by_y = traction(&across, &along, [down, twist], nu);
    let [in_yy, in_xx, in_zz, in_xy, in_yz, in_xz] = by_y;
    [
        pressure.map(|stress| stress / TAU),
        [xx, yy, zz, xy, xz, yz].map(|stress| stress / TAU),
        [in_xx, in_yy, in_zz, in_xy, in_xz, in_yz].map(|stress| stress / TAU),
    ]
}

/// 2π times the stresses due to traction along the first direction; `down` and `twist` are V_z and
/// z V_xy.
fn traction(
    along: &Directional,
    across: &Directional,
    [down, twist]: [f64; 2],
    nu: f64,
) -> [f64; 6] {
    // z F_xyy and z F_xxy, with F_xyy = Y/(R (R + z)); Ω_xyy = −Y/(R + z), Ω_xxy = −X/(R + z).
    let [lateral, shear] = [across.slope, along.slope].map(|slope| twist * slope);
    [
        2.0 * along.first + 2.0 * nu * across.slope + lateral + along.mixed,
        2.0 * nu * (along.first - across.slope) - lateral,
        -along.mixed,
        across.first - 2.0 * nu * along.slope - shear,
        down - along.second,
        -twist,
    ]
}
