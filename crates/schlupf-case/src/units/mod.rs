//! Quantities with units as text, such as `"50 W/(m K)"`.

mod dimension;
mod error;
mod expression;
mod measure;
mod quantity;
mod symbol;

pub use dimension::Dimension;
pub use error::{QuantityError, comma};
pub use measure::{Measure, Scale};
pub use quantity::{Conversion, comma_readings, dimension, parse_quantity, parse_unit};
