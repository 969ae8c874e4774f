//! What may be wrong with a quantity.

use schlupf::reporting::shortened;

/// What to write in place of a number with a comma.
pub fn comma(readings: &[String]) -> String {
    match readings {
        [] => "a comma cannot stand there in a number".to_owned(),
        [one] => format!("a comma is no decimal point: write {}", shortened(one)),
        several => {
            let several: Vec<_> = several.iter().map(|reading| shortened(reading)).collect();
            format!("a comma may separate thousands or decimals: write {}", several.join(" or "))
        }
    }
}

/// Why a text is not the quantity it should be.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum QuantityError {
    /// It does not begin with a number.
    #[error("there is no number in front")]
    NoNumber,
    /// Its number has a comma.
    #[error("{}", comma(readings))]
    Comma {
        /// What it may mean.
        readings: Vec<String>,
    },
    /// The number is beyond the range of double precision.
    #[error("the number is too large")]
    TooLarge,
    /// There is no unit.
    #[error("the unit is missing")]
    NoUnit,
    /// A symbol is not known.
    #[error("unknown unit `{}`", shortened(symbol))]
    UnknownUnit {
        /// The symbol.
        symbol: String,
    },
    /// The unit cannot be read.
    #[error("`{}` is not a product or quotient of units", shortened(text))]
    MalformedUnit {
        /// The unit.
        text: String,
    },
    /// The unit is one of another quantity.
    #[error("`{}` is {kind}", shortened(unit))]
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
