//! Blocks of two components.

pub(crate) fn inverse_2x2(matrix: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let [[a, b], [c, d]] = matrix;
    let determinant = a * d - b * c;
    [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
}

#[inline]
pub(crate) fn times(matrix: &[[f64; 2]; 2], v: [f64; 2]) -> [f64; 2] {
    let [[xx, xy], [yx, yy]] = *matrix;
    [xx * v[0] + xy * v[1], yx * v[0] + yy * v[1]]
}
