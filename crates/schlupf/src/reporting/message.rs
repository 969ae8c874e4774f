//! Errors and warnings as messages: each kind is declared once with its code, its values and its
//! sentence, which every face renders in its own words.

use std::borrow::Cow;

use crate::reporting::Quantity;

/// What a face calls quantities: paths in a case file, options of a command, keywords of a
/// function.
pub trait Words: Send + Sync {
    /// Its word for a quantity.
    fn word(&self, quantity: Quantity) -> Cow<'static, str>;

    /// How it says that a quantity has a name as its value.
    fn choice(&self, quantity: Quantity, name: &str) -> String {
        format!("{} = {name:?}", self.word(quantity))
    }
}

/// What a message may be about: a quantity, or something that all faces call the same.
pub trait Subject: Send + Sync {
    /// The word of a face for it.
    fn word(&self, words: &dyn Words) -> Cow<'static, str>;
}

impl Subject for Quantity {
    fn word(&self, words: &dyn Words) -> Cow<'static, str> {
        words.word(*self)
    }
}

impl Subject for &'static str {
    fn word(&self, _words: &dyn Words) -> Cow<'static, str> {
        (*self).into()
    }
}

/// The names of the registry itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Names;

impl Words for Names {
    fn word(&self, quantity: Quantity) -> Cow<'static, str> {
        quantity.name().into()
    }
}

/// An error or a warning in the words of a face.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Message {
    /// Which kind; a word that stays the same in every version.
    pub code: &'static str,
    /// The quantity that it is about, in the words of the face.
    pub quantity: String,
    /// A sentence.
    pub text: String,
    /// How severe it is among those of its kind, dimensionless: the larger, the worse.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub severity: f64,
}

impl Message {
    /// Code of whatever says why results did not converge.
    pub const NOT_CONVERGED: &'static str = "not-converged";

    /// A message.
    pub fn new(code: &'static str, quantity: impl Into<String>, text: impl Into<String>) -> Self {
        Self { code, quantity: quantity.into(), text: text.into(), severity: 0.0 }
    }

    /// The same with its severity, dimensionless.
    #[must_use]
    pub fn graded(self, severity: f64) -> Self {
        Self { severity, ..self }
    }

    /// Whether it says why results did not converge.
    pub fn is_of_convergence(&self) -> bool {
        self.code == Self::NOT_CONVERGED
    }

    /// The same with something in front of its sentence.
    #[must_use]
    pub fn about(self, subject: &str) -> Self {
        Self { text: format!("{subject}: {}", self.text), ..self }
    }
}

/// Quotes a text that somebody gave: in quotation marks, and only as much of it as fits on a line.
pub fn quoted(text: &str) -> String {
    format!("{:?}", shortened(text))
}

/// As much of a text that somebody gave as fits on a line.
pub fn shortened(text: &str) -> Cow<'_, str> {
    cut(text, 60)
}

/// A text of which no more than so many characters are kept.
pub fn cut(text: &str, most: usize) -> Cow<'_, str> {
    text.char_indices()
        .nth(most)
        .map_or(text.into(), |(end, _)| format!("{}…", &text[..end]).into())
}

/// Quotes a path: all of it but where no system takes one so long.
pub fn quoted_path(path: &str) -> String {
    const MOST: usize = 4096;
    if path.len() > MOST { quoted(path) } else { format!("{path:?}") }
}

/// Declares an enum of messages: for each kind its code, its values, the quantity that it is about
/// and its sentence in given [`Words`]. The code of a kind that holds another message is that of
/// the other: `"code" [field: its type]`, without the type where it is of the same enum. Messages
/// may be about another [`Subject`] than quantities. A kind of which one may be worse than another
/// says by which number: `severity …`, the larger the worse.
#[doc(hidden)]
#[macro_export]
macro_rules! messages {
    (@codes $code:literal $meaning:expr;) => { vec![($code, $meaning.trim())] };
    (@codes $code:literal $meaning:expr; $inner:ident) => { Vec::new() };
    (@codes $code:literal $meaning:expr; $inner:ident: $of:ty) => { <$of>::codes() };
    (
        $(#[$about:meta])*
        $name:ident of $about_what:ty: $(
            $(#[doc = $doc:literal])*
            $code:literal $([$inner:ident $(: $of:ty)?])? $kind:ident { $($(#[$field_doc:meta])* $field:ident: $type:ty),* $(,)? }
            $quantity:expr, |$subject:ident, $words:ident| $text:expr $(, severity $severity:expr)?;
        )*
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[doc = $doc])* $kind { $($(#[$field_doc])* $field: $type),* }),*
        }

        #[allow(
            unused_variables,
            unreachable_code,
            clippy::use_self,
            reason = "what a message says need not use every field"
        )]
        impl $name {
            /// The codes of all kinds with what each of them means, in Markdown, in the order of
            /// their declaration; those within in the place of a kind that holds them.
            pub fn codes() -> Vec<(&'static str, &'static str)> {
                [$($crate::reporting::messages!(
                    @codes $code concat!($($doc),*); $($inner $(: $of)?)?
                )),*].concat()
            }

            /// Which kind it is, as a word that stays the same in every version.
            pub fn code(&self) -> &'static str {
                match self {
                    $(Self::$kind { $($field),* } => { $(return $inner.code();)? $code })*
                }
            }

            /// The quantity that it is about.
            pub fn quantity(&self) -> $about_what {
                match self { $(Self::$kind { $($field),* } => $quantity),* }
            }

            /// How severe it is among those of its kind, dimensionless: the larger, the worse.
            pub fn severity(&self) -> f64 {
                match self { $(Self::$kind { $($field),* } => { $(return $severity;)? 0.0 }),* }
            }

            /// It as a sentence in the words of a face.
            pub fn text(&self, words: &dyn $crate::reporting::Words) -> String {
                match self {
                    $(Self::$kind { $($field),* } => {
                        let $subject = $crate::reporting::Subject::word(&$quantity, words);
                        let $words = words;
                        $text
                    })*
                }
            }

            /// It in the words of a face.
            pub fn message(&self, words: &dyn $crate::reporting::Words) -> $crate::reporting::Message {
                let quantity = $crate::reporting::Subject::word(&self.quantity(), words);
                $crate::reporting::Message::new(self.code(), quantity, self.text(words))
                    .graded(self.severity())
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(&self.text(&$crate::reporting::Names))
            }
        }
    };
    ($(#[$about:meta])* $name:ident: $($kinds:tt)*) => {
        $crate::reporting::messages! { $(#[$about])* $name of $crate::reporting::Quantity: $($kinds)* }
    };
}

#[doc(hidden)]
pub use messages;
