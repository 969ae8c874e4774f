//! Small matrices in single precision, for the preconditioner, which need not be exact: four lanes
//! that a processor works on at once.

use super::resolvent::Matrix;

type Lanes = [f32; 4];

/// A matrix of two rows and two columns: its first column, then its second.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Block(Lanes);

/// A vector (x, y) as (x, x, y, y), to multiply both columns of a block.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Twice(Lanes);

#[inline]
fn each(of: impl Fn(usize) -> f32) -> Lanes {
    [of(0), of(1), of(2), of(3)]
}

impl Block {
    pub const ONE: Self = Self([1.0, 0.0, 0.0, 1.0]);

    pub fn of(&[[xx, xy], [yx, yy]]: &Matrix) -> Self {
        Self([xx as f32, yx as f32, xy as f32, yy as f32])
    }

    #[inline]
    pub fn plus(self, factor: f32, other: Self) -> Self {
        Self(each(|n| self.0[n] + factor * other.0[n]))
    }

    /// With its columns times two factors.
    #[inline]
    pub fn scaled(self, [x, y]: [f32; 2]) -> Self {
        let factors = [x, x, y, y];
        Self(each(|n| factors[n] * self.0[n]))
    }

    #[inline]
    pub fn times(self, Self([xx, yx, xy, yy]): Self) -> Self {
        let Self([a, b, c, d]) = self;
        let (first, second) = ([a, b, a, b], [c, d, c, d]);
        let (upper, lower) = ([xx, xx, xy, xy], [yx, yx, yy, yy]);
        Self(each(|n| first[n] * upper[n] + second[n] * lower[n]))
    }

    #[inline]
    pub fn inverse(self) -> Self {
        let [xx, yx, xy, yy] = self.0;
        let over = (xx * yy - xy * yx).recip();
        Self([over * yy, -over * yx, -over * xy, over * xx])
    }
}

impl Twice {
    #[inline]
    pub fn of([x, y]: [f32; 2]) -> Self {
        Self([x, x, y, y])
    }

    #[inline]
    pub fn once(self) -> [f32; 2] {
        let [x, _, y, _] = self.0;
        [x, y]
    }
}

/// v minus the blocks of a row, each times its vector, of which there are as many.
#[inline]
pub(super) fn reduced_by<const N: usize>(
    v: [f32; 2],
    blocks: &[Block; N],
    vectors: &[Twice],
) -> [f32; 2] {
    let Some(vectors) = vectors.first_chunk::<N>() else { return v };
    let mut sums = [0.0; 4];
    for (block, vector) in blocks.iter().zip(vectors) {
        sums = each(|n| sums[n] + block.0[n] * vector.0[n]);
    }
    [v[0] - (sums[0] + sums[2]), v[1] - (sums[1] + sums[3])]
}

/// A block times a vector.
#[inline]
pub(super) fn image(block: &Block, [x, y]: [f32; 2]) -> [f32; 2] {
    let [xx, yx, xy, yy] = block.0;
    [xx * x + xy * y, yx * x + yy * y]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Products and inverses against those of numbers that single precision holds exactly.
    #[test]
    fn blocks_are_matrices() {
        let a = Block::of(&[[1.0, 2.0], [3.0, 4.0]]);
        let b = Block::of(&[[-1.0, 0.5], [2.0, 8.0]]);
        assert_eq!(a.times(b), Block::of(&[[3.0, 16.5], [5.0, 33.5]]));
        assert_eq!(a.times(a.inverse()), Block::ONE);
        assert_eq!(a.plus(-2.0, b), Block::of(&[[3.0, 1.0], [-1.0, -12.0]]));
        assert_eq!(image(&a, [1.0, -1.0]), [-1.0, -1.0]);
        let both =
            reduced_by([1.0, 1.0], &[a, b], &[Twice::of([1.0, -1.0]), Twice::of([2.0, 4.0])]);
        assert_eq!(both, [2.0, -34.0]);
    }
}
