//! Texts of inputs, outputs and states that end with a null byte, and never move.

use std::ffi::{CStr, CString};
use std::sync::OnceLock;

use schlupf::Quantity;
use schlupf::element::{CONTACTS, Signal};

/// What an input, output or state is called.
pub struct Texts {
    /// Name, as fields of a case and columns of results have it.
    pub name: CString,
    /// Unit of SI, `degC` for temperatures; empty where dimensionless.
    pub unit: CString,
    /// A short description.
    pub description: CString,
}

impl Texts {
    /// Those of a quantity, of the whole or of one of the contacts of a wheel.
    pub fn of(signal: &Signal) -> &'static Self {
        static ALL: OnceLock<Vec<Texts>> = OnceLock::new();
        let all = ALL.get_or_init(|| {
            let contacts = std::iter::once(None).chain((1..=CONTACTS).map(Some));
            let of = |contact| Quantity::ALL.iter().map(move |of| Signal::new(*of, contact));
            contacts.flat_map(of).map(|signal| Self::new(&signal)).collect()
        });
        let contact = signal.contact.unwrap_or(0);
        &all[contact * Quantity::ALL.len() + signal.quantity as usize]
    }

    fn new(signal: &Signal) -> Self {
        // None of them has a null byte.
        let text = |text: &str| CString::new(text).unwrap_or_default();
        Self {
            name: text(signal.name()),
            unit: text(signal.unit()),
            description: text(&signal.description()),
        }
    }

    /// The version of the library.
    pub fn version() -> &'static CStr {
        const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");
        CStr::from_bytes_with_nul(VERSION.as_bytes()).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_those_of_their_signal() {
        for contact in [None, Some(1), Some(CONTACTS)] {
            for quantity in Quantity::ALL {
                let signal = Signal::new(*quantity, contact);
                let texts = Texts::of(&signal);
                assert_eq!(texts.name.to_str(), Ok(signal.name()));
                assert_eq!(texts.unit.to_str(), Ok(quantity.unit()));
                assert_eq!(texts.description.to_str(), Ok(&*signal.description()));
            }
        }
        assert_eq!(Texts::version().to_str(), Ok(env!("CARGO_PKG_VERSION")));
    }
}
