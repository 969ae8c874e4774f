//! The shakedown map of a rolling and sliding line contact.

use crate::solver::reference::SlidingLineContact;

/// What happens to a material under repeated passages of a sliding line contact (Johnson 1985,
/// §9.2), in plane strain, elastic and perfectly plastic with the yield stress in pure shear k by
/// Tresca's criterion, as the largest pressure over k up to which it holds. All of the contact
/// slides with the coefficient of friction μ.
///
/// Up to the [elastic limit](Self::elastic) nothing yields. Up to the [shakedown
/// limit](Self::shakedown) residual stresses form so that nothing yields any more: by Melan's
/// theorem the largest p0/k for which residual stresses can be found that keep the material from
/// yielding. In a line contact they are σxx and σyy that depend on the depth only (Johnson and
/// Jefferis 1963); σxx is chosen, and σyy keeps the stress across between the two others. Beyond,
/// every passage deforms the material. From μ = 0.37 on it does so on the surface, where the
/// shakedown limit is 1/μ, and where the surface-fatigue index is positive.
///
/// Limits: no hardening; a patch that is round carries some 17 % more without traction, 4.7 k
/// instead of 4.0 k (Ponter, Hearle and Johnson 1985), and on the surface the same. By von Mises's
/// criterion with the same k the limit of the surface is up to 9 % lower, because the stress across
/// counts there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShakedownLimits {
    /// p0/k up to which nothing yields, dimensionless.
    pub elastic: f64,
    /// p0/k up to which nothing yields in the end, dimensionless.
    pub shakedown: f64,
}

/// Depths, of the half-length of the contact, in a geometric series from the first to the last;
/// places along the contact, evenly spaced up to the farthest on both sides.
const DEPTHS: u32 = 80;
const SHALLOWEST: f64 = 5e-3;
const DEEPEST: f64 = 2.0;
const PLACES: i32 = 200;
const FARTHEST: f64 = 1.6;

/// Steps of the search for the residual stress.
const STEPS: usize = 36;

impl ShakedownLimits {
    /// The limits for a coefficient of friction and Poisson's ratio (both dimensionless).
    ///
    /// ```
    /// use schlupf::analysis::damage::ShakedownLimits;
    ///
    /// // Johnson 1985: shakedown of a line contact without traction up to 4.00 k.
    /// let limits = ShakedownLimits::of(0.0, 0.3);
    /// assert!((limits.shakedown - 4.0).abs() < 0.01);
    /// ```
    pub fn of(friction: f64, poisson_ratio: f64) -> Self {
        let line =
            SlidingLineContact { half_length: 1.0, peak_pressure: 1.0, traction_ratio: friction };
        // On the surface, σxx − σzz and σxz make one shear stress all over the contact, μ p0.
        let mut largest = [friction.abs(); 2];
        let ratio = DEEPEST / SHALLOWEST;
        let below = |k: u32| SHALLOWEST * ratio.powf(f64::from(k) / f64::from(DEPTHS));
        for depth in (0..=DEPTHS).map(below).chain([0.0]) {
            let stresses: Vec<[f64; 3]> = (-PLACES..=PLACES)
                .map(|i| line.stress(FARTHEST * f64::from(i) / f64::from(PLACES), depth))
                .collect();
            let elastic = stresses.iter().map(|stress| largest_shear(stress, poisson_ratio));
            largest[0] = elastic.fold(largest[0], f64::max);
            largest[1] = largest[1].max(with_residual_stress(&stresses));
        }
        // What does not yield at all shakes down, too.
        let [elastic, shakedown] = [largest[0], largest[1].min(largest[0])].map(f64::recip);
        Self { elastic, shakedown }
    }
}

/// The largest shear stress over all planes, in plane strain.
fn largest_shear([xx, zz, xz]: &[f64; 3], poisson_ratio: f64) -> f64 {
    let (mean, radius) = (0.5 * (xx + zz), (0.5 * (xx - zz)).hypot(*xz));
    let yy = poisson_ratio * (xx + zz);
    radius.max(0.5 * (radius + (yy - mean).abs()))
}

/// The largest shear stress in the plane along a depth with the residual stress σxx that makes it
/// smallest: by golden sections of a convex function.
fn with_residual_stress(stresses: &[[f64; 3]]) -> f64 {
    let largest = |residual: f64| {
        let shear = |[xx, zz, xz]: &[f64; 3]| (0.5 * (xx + residual - zz)).hypot(*xz);
        stresses.iter().map(shear).fold(0.0, f64::max)
    };
    let part = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (-4.0, 4.0);
    let [mut left, mut right] =
        [high - part * (high - low), low + part * (high - low)].map(|at| (at, largest(at)));
    for _ in 0..STEPS {
        if left.1 < right.1 {
            (high, right) = (right.0, left);
            let at = high - part * (high - low);
            left = (at, largest(at));
        } else {
            (low, left) = (left.0, right);
            let at = low + part * (high - low);
            right = (at, largest(at));
        }
    }
    left.1.min(right.1)
}
