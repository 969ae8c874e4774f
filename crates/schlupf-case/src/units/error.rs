//! What may be wrong with a quantity.

/// Why a text is not the quantity it should be.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum QuantityError {
    /// It does not begin with a number.
    #[error("there is no number in front{}", if *decimal_comma { "; write a point for the decimal comma" } else { "" })]
    NoNumber {
        /// Whether it looks like a number with a decimal comma.
        decimal_comma: bool,
    },
    /// The number is beyond the range of double precision.
    #[error("the number is too large")]
    TooLarge,
    /// There is no unit.
    #[error("the unit is missing")]
    NoUnit,
    /// A symbol is not known.
    #[error("unknown unit `{symbol}`")]
    UnknownUnit {
        /// The symbol.
        symbol: String,
    },
    /// The unit cannot be read.
    #[error("`{text}` is not a product or quotient of units")]
    MalformedUnit {
        /// The unit.
        text: String,
    },
    /// The unit is one of another quantity.
    #[error("`{unit}` is {kind}")]
    WrongDimension {
        /// The unit.
        unit: String,
        /// What it is, such as `the unit of a force`.
        kind: String,
    },
    /// A temperature was given in place of a temperature difference.
    #[error("`{unit}` is for temperatures counted from its own zero; a difference is given in K")]
    TemperatureForDifference {
        /// The unit.
        unit: String,
    },
}
