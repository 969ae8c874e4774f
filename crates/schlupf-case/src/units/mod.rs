//! Quantities with units as text, such as `"50 W/(m K)"`.

mod dimension;
mod expression;
mod measure;
mod quantity;
mod symbol;

pub use dimension::Dimension;
pub use measure::{Measure, Scale};
pub use quantity::{Conversion, QuantityError, parse_quantity, parse_unit};
