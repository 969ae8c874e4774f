//! Where in the input something stands.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use schlupf::reporting::shortened;

/// A text that was read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Name of the file.
    pub name: String,
    /// All of its text.
    pub text: String,
}

impl Source {
    /// Line and column of a byte, both from 1; the column counts characters.
    pub fn position(&self, byte: usize) -> (usize, usize) {
        let before = self.text.get(..byte).unwrap_or(&self.text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = 1 + before.matches('\n').count();
        (line, 1 + before[line_start..].chars().count())
    }

    /// Bytes of a line, numbered from 1, without its end.
    pub fn line(&self, number: usize) -> Range<usize> {
        let mut start = 0;
        for line in self.text.split_inclusive('\n').take(number.saturating_sub(1)) {
            start += line.len();
        }
        let length = self.text[start..].lines().next().map_or(0, str::len);
        start..start + length
    }
}

/// A column, the first of a table, of what its rows are called.
pub const INDEX: &str = "index";

/// Where in the input something stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// In a text.
    Text {
        /// The text.
        source: Arc<Source>,
        /// Bytes of it.
        span: Range<usize>,
    },
    /// In a file that is no text, or in all of a file.
    File {
        /// Name of the file.
        name: String,
    },
    /// In what overrides the file, such as an option of the command line.
    Override {
        /// The option, such as `--set`.
        option: Arc<str>,
        /// The text after it.
        text: String,
    },
    /// Nowhere: the default value of the field.
    Default,
}

impl Place {
    /// Sorts places in the order of the input: first the text, then what overrides it.
    pub fn order(&self) -> usize {
        match self {
            Self::Text { span, .. } => span.start,
            Self::File { .. } | Self::Override { .. } | Self::Default => usize::MAX,
        }
    }

    /// A line of a text, numbered from 1. A row of a table is told by what stands in its first
    /// column, if that is [`INDEX`].
    pub fn line(source: &Arc<Source>, number: usize) -> Self {
        let span = source.line(number);
        let is_labelled = |text: &str| text.split(',').next() == Some(INDEX);
        let row = source.text[span.clone()].split(',').next();
        match row.filter(|_| source.text.lines().next().is_some_and(is_labelled)) {
            Some(INDEX) => Self::File { name: source.name.clone() },
            Some(row) => Self::File { name: format!("{}, row {row}", source.name) },
            None => Self::Text { source: Arc::clone(source), span },
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text { source, span } => {
                let (line, column) = source.position(span.start);
                write!(f, "{}:{line}:{column}", source.name)
            }
            Self::File { name } => f.write_str(name),
            // The data of a program are its text and have the name of the option: once is enough.
            Self::Override { option, text } if text.is_empty() || **option == **text => {
                f.write_str(option)
            }
            Self::Override { option, text } => write!(f, "{option} {}", shortened(text)),
            Self::Default => f.write_str("default value"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_are_counted_from_one() {
        let source =
            Source { name: "case.toml".to_owned(), text: "a = 1\nφ = \"x\"\n".to_owned() };
        assert_eq!(source.position(0), (1, 1));
        let quote = source.text.find('"').unwrap();
        assert_eq!(source.position(quote), (2, 5));
        assert_eq!(&source.text[source.line(2)], "φ = \"x\"");
        assert_eq!(source.line(99), source.text.len()..source.text.len());
    }
}
