//! Numbers that are worked on one at a time, or four side by side by the same formulas.

use std::f64::consts::LOG2_E;
use std::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

use wide::{CmpLe, f64x4, u64x4};

/// Number of lanes of [`f64x4`].
pub(crate) const FOUR: usize = 4;

/// ln 2, and what is missing of it (Cody and Waite 1980).
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// Added to a number, it leaves the nearest integer in the last bits, plus the bias of exponents.
const SHIFT: f64 = 6_755_399_441_055_744.0 + 1023.0;

/// 1/0!, … 1/12!
const INVERSE_FACTORIALS: [f64; 13] = {
    let mut values = [1.0; 13];
    let (mut k, mut factorial) = (1, 1.0);
    while k < 13 {
        factorial *= k as f64;
        values[k] = 1.0 / factorial;
        k += 1;
    }
    values
};

/// A number, or several of them.
pub(crate) trait Lanes:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Whether something holds, in each lane.
    type Mask: Copy + BitAnd<Output = Self::Mask>;

    fn sqrt(self) -> Self;
    /// e^x for x ≤ 0.
    fn decay(self) -> Self;
    fn min(self, other: Self) -> Self;
    fn max(self, other: Self) -> Self;
    /// Whether it is not above another one.
    fn at_most(self, other: Self) -> Self::Mask;
    /// Whether something holds in any lane.
    fn any(mask: Self::Mask) -> bool;
    /// One of two where something holds, and the other one elsewhere.
    fn choose(mask: Self::Mask, here: Self, elsewhere: Self) -> Self;
}

impl Lanes for f64 {
    type Mask = bool;

    #[inline]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }

    #[inline]
    fn decay(self) -> Self {
        self.exp()
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        Self::min(self, other)
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        Self::max(self, other)
    }

    #[inline]
    fn at_most(self, other: Self) -> bool {
        self <= other
    }

    #[inline]
    fn any(mask: bool) -> bool {
        mask
    }

    #[inline]
    fn choose(mask: bool, here: Self, elsewhere: Self) -> Self {
        if mask { here } else { elsewhere }
    }
}

impl Lanes for f64x4 {
    type Mask = Self;

    #[inline]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }

    /// 2ⁿ e^r with |r| ≤ ½ ln 2, where the series of e^r ends after twelve terms.
    #[inline]
    fn decay(self) -> Self {
        // Below that e^x would be less than the smallest normal number.
        let x = self.fast_max(Self::from(-708.0));
        // Its last bits are the integer nearest to x/ln 2, with the bias of the exponents.
        let shifted = x * Self::from(LOG2_E) + Self::from(SHIFT);
        let nearest = shifted - Self::from(SHIFT);
        // ln 2 in two parts, of which the first one times an integer is exact.
        let r = x - nearest * Self::from(LN_2[0]) - nearest * Self::from(LN_2[1]);
        // Pairs of terms, and pairs of those, do not wait for each other.
        let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12] =
            INVERSE_FACTORIALS.map(Self::from);
        let square = r * r;
        let fourth = square * square;
        let first = (c0 + c1 * r) + (c2 + c3 * r) * square;
        let second = (c4 + c5 * r) + (c6 + c7 * r) * square;
        let third = (c8 + c9 * r) + (c10 + c11 * r) * square + c12 * fourth;
        let power: Self = bytemuck::cast(bytemuck::cast::<Self, u64x4>(shifted) << 52);
        (first + (second + third * fourth) * fourth) * power
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        self.fast_min(other)
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        self.fast_max(other)
    }

    #[inline]
    fn at_most(self, other: Self) -> Self {
        self.cmp_le(other)
    }

    #[inline]
    fn any(mask: Self) -> bool {
        Self::any(mask)
    }

    #[inline]
    fn choose(mask: Self, here: Self, elsewhere: Self) -> Self {
        mask.blend(here, elsewhere)
    }
}

/// x · y of vectors in the plane.
#[inline]
pub(crate) fn dot<T: Lanes>(x: [T; 2], y: [T; 2]) -> T {
    x[0] * y[0] + x[1] * y[1]
}

/// Each component of a vector in the plane, times a factor.
#[inline]
pub(crate) fn scaled<T: Lanes>(factor: T, x: [T; 2]) -> [T; 2] {
    [factor * x[0], factor * x[1]]
}

/// x + y of vectors in the plane.
#[inline]
pub(crate) fn sum<T: Lanes>(x: [T; 2], y: [T; 2]) -> [T; 2] {
    [x[0] + y[0], x[1] + y[1]]
}

/// x − y of vectors in the plane.
#[inline]
pub(crate) fn difference<T: Lanes>(x: [T; 2], y: [T; 2]) -> [T; 2] {
    [x[0] - y[0], x[1] - y[1]]
}

/// One of two vectors in the plane, see [`Lanes::choose`].
#[inline]
pub(crate) fn choose<T: Lanes>(mask: T::Mask, here: [T; 2], elsewhere: [T; 2]) -> [T; 2] {
    [T::choose(mask, here[0], elsewhere[0]), T::choose(mask, here[1], elsewhere[1])]
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Four lanes give what one gives four times.
    #[test]
    fn lanes_are_numbers_side_by_side() {
        let (x, y) = ([0.3, -1.0, 700.0, -800.0], [0.3, 2.0, -1.0, 0.0]);
        let (many_x, many_y) = (f64x4::from(x), f64x4::from(y));
        let decay = Lanes::decay(-many_x.abs()).to_array();
        let chosen = Lanes::choose(many_x.at_most(many_y), many_x, many_y).to_array();
        let root = Lanes::sqrt(Lanes::max(many_x, many_y)).to_array();
        for n in 0..FOUR {
            assert_relative_eq!(
                decay[n],
                (-x[n].abs()).exp(),
                max_relative = 1e-15,
                epsilon = 1e-300
            );
            assert_eq!(chosen[n], if x[n] <= y[n] { x[n] } else { y[n] });
            assert_eq!(root[n], x[n].max(y[n]).sqrt());
        }
    }
}
