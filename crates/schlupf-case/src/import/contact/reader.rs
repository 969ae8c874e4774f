//! The text of an input file, group of values by group of values.
//!
//! `%` begins a comment; spaces and commas separate values; a group may go on over several lines;
//! what follows its last value in a line is ignored, so many files name their values there.

use std::sync::Arc;

use crate::{CaseError, Place, Source};
use schlupf::reporting::shortened;

use super::given::{At, Form, Given, GivenText, Item, angle};

/// A line that is more than a comment.
#[derive(Debug)]
struct Line {
    number: usize,
    words: Vec<Word>,
}

/// What stands between spaces and commas.
#[derive(Debug)]
struct Word {
    text: String,
    /// Its first byte in the file.
    start: usize,
    /// With the next word, where both make a number with a decimal comma.
    with_comma: Option<String>,
}

/// A comment.
#[derive(Debug)]
struct Comment {
    line: usize,
    text: String,
    /// Whether it fills its line.
    is_alone: bool,
}

/// Reads one group of values after the other.
#[derive(Debug)]
pub struct Reader {
    source: Arc<Source>,
    lines: Vec<Line>,
    comments: Vec<Comment>,
    /// Place of the next line in `lines`.
    next: usize,
}

/// Values that belong together.
#[derive(Debug, Default)]
struct Group {
    text: Option<GivenText>,
    given: Vec<Given>,
    /// The optional ones.
    more: Vec<Given>,
}

/// Whatever could be told from text that cannot be read on.
pub type Reading<T> = Result<T, CaseError>;

impl Reader {
    /// A reader of a text, before its first line.
    pub fn new(source: Arc<Source>) -> Self {
        let (mut lines, mut comments) = (Vec::new(), Vec::new());
        let mut start = 0;
        for (number, line) in (1..).zip(source.text.split_inclusive('\n')) {
            let (code, comment) = without_comment(line);
            let words = words(code, start);
            start += line.len();
            if let Some(comment) = comment {
                let text = comment.trim().to_owned();
                comments.push(Comment { line: number, text, is_alone: words.is_empty() });
            }
            if !words.is_empty() {
                lines.push(Line { number, words });
            }
        }
        Self { source, lines, comments, next: 0 }
    }

    /// Whether nothing is left.
    pub fn is_at_end(&self) -> bool {
        self.next >= self.lines.len()
    }

    /// The place of what is read next.
    pub fn next(&self) -> At {
        let next = self.lines.get(self.next);
        let at = next.and_then(|line| Some(line.words.first()?.at(line.number)));
        at.unwrap_or_default()
    }

    /// The line of what was read last.
    pub fn line(&self) -> usize {
        let last = self.next.checked_sub(1).and_then(|last| self.lines.get(last));
        last.map_or(1, |line| line.number)
    }

    /// Numbers, all of which must be there.
    pub fn numbers<const N: usize>(&mut self, items: [Item; N]) -> Reading<[Given; N]> {
        Ok(self.numbers_and(items, [])?.0)
    }

    /// Numbers that must be there, and others that may follow in the line of the last of them.
    pub fn numbers_and<const N: usize, const M: usize>(
        &mut self,
        items: [Item; N],
        optional: [Item; M],
    ) -> Reading<([Given; N], [Option<Given>; M])> {
        let group = self.group(None, &items, &optional)?;
        Ok((self.all(group.given, &items)?, in_order(group.more)))
    }

    /// Text in single quotes, and numbers after it.
    pub fn text_and<const N: usize, const M: usize>(
        &mut self,
        name: &'static str,
        items: [Item; N],
        optional: [Item; M],
    ) -> Reading<(GivenText, [Given; N], [Option<Given>; M])> {
        let group = self.group(Some(name), &items, &optional)?;
        let text = group.text.ok_or_else(|| self.at_end(Some(name), &items))?;
        Ok((text, self.all(group.given, &items)?, in_order(group.more)))
    }

    fn all<const N: usize>(&self, given: Vec<Given>, items: &[Item]) -> Reading<[Given; N]> {
        given.try_into().map_err(|_| self.at_end(None, items))
    }

    /// A list of numbers of different names.
    pub fn group_of(&mut self, items: &[Item]) -> Reading<Vec<Given>> {
        Ok(self.group(None, items, &[])?.given)
    }

    /// Any number of numbers.
    pub fn array(&mut self, item: Item, count: usize) -> Reading<Vec<Given>> {
        self.group_of(&vec![item; count])
    }

    fn group(
        &mut self,
        text: Option<&'static str>,
        items: &[Item],
        optional: &[Item],
    ) -> Reading<Group> {
        let mut group = Group::default();
        while group.text.is_some() != text.is_some() || group.given.len() < items.len() {
            let Some(line) = self.lines.get(self.next) else {
                return Err(self.at_end(text, items));
            };
            self.next += 1;
            let number = line.number;
            let mut words = line.words.iter();
            if let Some(name) = text.filter(|_| group.text.is_none()) {
                let Some(word) = words.next() else { continue };
                let Some(inner) = unquoted(&word.text) else {
                    let message = {
                        let word = shortened(&word.text);
                        format!("{name} must be text in single quotes, but is `{word}`")
                    };
                    return Err(self.error(name, word.at(number), message));
                };
                let at = word.at(number);
                group.text = Some(GivenText { text: inner.to_owned(), at });
            }
            let left = &items[group.given.len()..];
            self.refuse_comma([left, optional], words.as_slice(), number)?;
            for (item, word) in left.iter().zip(words.by_ref()) {
                let Some(value) = item.number(&word.text) else {
                    let (name, form) = (item.name, item.form_name());
                    let expected = expected(text, items);
                    let message = format!(
                        "{name} must be {form}, but is `{}` (expected here: {expected})",
                        shortened(&word.text)
                    );
                    return Err(self.error(name, word.at(number), message));
                };
                group.given.push(Given { name: item.name, value, at: word.at(number) });
            }
            for (item, word) in optional.iter().zip(words) {
                let Some(value) = item.number(&word.text) else { break };
                group.more.push(Given { name: item.name, value, at: word.at(number) });
            }
        }
        Ok(group)
    }

    /// Refuses a decimal comma, which would make two values of one. A comma between two whole
    /// numbers may be one where the line has all values that must be there without it, too.
    fn refuse_comma(
        &self,
        [required, optional]: [&[Item]; 2],
        words: &[Word],
        line: usize,
    ) -> Reading<()> {
        let is_number = |word: &&Word| angle("").number(&word.text).is_some();
        let numbers = &words[..words.iter().take_while(is_number).count()];
        let items = required.iter().chain(optional).zip(numbers);
        let commas = items.filter(|(item, _)| item.form != Form::Whole);
        let commas =
            commas.filter_map(|(item, word)| Some((item, word, word.with_comma.as_ref()?)));
        let commas: Vec<_> = commas.collect();
        let Some(&(item, word, whole)) =
            commas.first().filter(|_| numbers.len() >= required.len() + commas.len())
        else {
            return Ok(());
        };
        let message = format!(
            "{} must be {}, but is `{whole}`: a comma separates values",
            item.name,
            item.form_name()
        );
        let at = At { line, bytes: [word.start, word.start + whole.len()] };
        let help = format!("a decimal comma must be a point: {}", whole.replace(',', "."));
        Err(self.error(item.name, at, message).help(Some(help)))
    }

    fn at_end(&self, text: Option<&str>, items: &[Item]) -> CaseError {
        let message = format!("the file must go on with {}, but ends", expected(text, items));
        let place = Place::line(&self.source, self.source.text.lines().count());
        CaseError::new("", message, place)
    }

    /// An error at a place.
    pub fn error(&self, field: &str, at: At, message: String) -> CaseError {
        CaseError::new(field, message, at.place(&self.source))
    }

    /// What the comments say of a case that begins in a line: the first line of the nearest block
    /// above it that follows the line `after`, or else what stands behind its first value.
    pub fn title(&self, after: usize, line: usize) -> Option<String> {
        let above = self
            .comments
            .iter()
            .filter(|comment| comment.is_alone && comment.line > after && comment.line < line);
        let mut block: Option<(&str, usize)> = None;
        for comment in above {
            let text = plain(&comment.text);
            if text.is_empty() {
                continue;
            }
            let goes_on = block.is_some_and(|(_, last)| last + 1 == comment.line);
            block = match block {
                Some((first, _)) if goes_on => Some((first, comment.line)),
                _ => Some((text, comment.line)),
            };
        }
        let beside = || {
            let beside = self.comments.iter().find(|comment| comment.line == line);
            beside.map(|comment| plain(&comment.text)).filter(|text| !text.is_empty())
        };
        block.map(|(text, _)| text).or_else(beside).map(str::to_owned)
    }
}

/// The values that there are, then none.
fn in_order<const M: usize>(given: Vec<Given>) -> [Option<Given>; M] {
    let mut given = given.into_iter();
    std::array::from_fn(|_| given.next())
}

/// A comment without what frames it.
fn plain(comment: &str) -> &str {
    comment.trim_matches(|c: char| c.is_whitespace() || "%-=*#!".contains(c))
}

/// Code and comment of a line; a percent sign between quotes begins none.
fn without_comment(line: &str) -> (&str, Option<&str>) {
    let mut is_quoted = false;
    for (place, character) in line.char_indices() {
        match character {
            '\'' => is_quoted = !is_quoted,
            '%' if !is_quoted => return (&line[..place], Some(&line[place + 1..])),
            _ => {}
        }
    }
    (line, None)
}

impl Word {
    fn at(&self, line: usize) -> At {
        At { line, bytes: [self.start, self.start + self.text.len()] }
    }
}

/// The words of a line that begins with a byte of the file.
fn words(code: &str, start: usize) -> Vec<Word> {
    let (mut words, mut is_quoted): (Vec<Word>, bool) = (Vec::new(), false);
    let mut is_inside = false;
    for (place, character) in code.char_indices() {
        if character == '\'' {
            is_quoted = !is_quoted;
        }
        let separates = !is_quoted && (character.is_whitespace() || character == ',');
        match words.last_mut().filter(|_| is_inside && !separates) {
            Some(word) => word.text.push(character),
            None if separates => {}
            None => {
                let text = character.to_string();
                words.push(Word { text, start: start + place, with_comma: None });
            }
        }
        is_inside = !separates;
    }
    for place in 1..words.len() {
        let (whole, fraction) = (&words[place - 1], &words[place]);
        let from = whole.start - start;
        if !code[..from].chars().next_back().is_none_or(char::is_whitespace) {
            continue;
        }
        // Two words with nothing but a comma between and around them.
        let together = code[from..].split_whitespace().next().unwrap_or_default();
        let is_whole = whole.text.trim_start_matches(['+', '-']).bytes();
        let is_number = is_whole.len() > 0
            && is_whole.into_iter().all(|byte| byte.is_ascii_digit())
            && fraction.text.starts_with(|c: char| c.is_ascii_digit())
            && !fraction.text.contains('.');
        if is_number && together == format!("{},{}", whole.text, fraction.text) {
            words[place - 1].with_comma = Some(together.to_owned());
        }
    }
    words
}

fn unquoted(word: &str) -> Option<&str> {
    word.strip_prefix('\'')?.strip_suffix('\'')
}

/// Names of a group; those of an array once.
fn expected(text: Option<&str>, items: &[Item]) -> String {
    let mut names: Vec<&str> = text.into_iter().chain(items.iter().map(|item| item.name)).collect();
    names.dedup();
    names.join(", ")
}

#[cfg(test)]
mod tests {
    use super::super::given::{real, whole};
    use super::*;

    fn reader(text: &str) -> Reader {
        Reader::new(Arc::new(Source { name: "a.inp".to_owned(), text: text.to_owned() }))
    }

    /// A group over two lines, commas, text behind it, values that may be left out, and a percent
    /// sign in a name.
    #[test]
    fn groups_end_where_their_values_do() {
        let mut reader =
            reader("% head\n1.0, 2d0 % first\n\n 3 4 5  A, B\n6 'a % b' 7\n 'a % b' 7d x\n");
        let (given, more) =
            reader.numbers_and([real("A"), real("B"), real("C")], [real("D"), whole("E")]).unwrap();
        assert_eq!(given.map(|given| given.value), [1.0, 2.0, 3.0]);
        assert_eq!(given.map(|given| given.at.line), [2, 2, 4]);
        assert_eq!(more.map(|given| given.map(|given| given.value)), [Some(4.0), Some(5.0)]);
        let ([six], [none]) = reader.numbers_and([real("F")], [real("G")]).unwrap();
        assert!(six.is(6) && none.is_none());
        let (text, [degrees], []) = reader.text_and("N", [angle("H")], []).unwrap();
        assert_eq!(text.text, "a % b");
        assert_eq!(degrees.value, 7f64.to_radians());
        assert!(reader.is_at_end());
    }

    #[test]
    fn what_is_missing_is_named() {
        let message = |text: &str| {
            let mut reader = reader(text);
            reader.numbers([real("FN"), whole("MX")]).unwrap_err().to_string()
        };
        assert_eq!(message("1"), "a.inp:1:1: the file must go on with FN, MX, but ends");
        let wrong = message("1\n2.5\n");
        assert!(wrong.contains("a.inp:2:1: MX must be a whole number, but is `2.5`"), "{wrong}");
    }

    #[test]
    fn titles_are_the_nearest_comments() {
        let reader = reader(
            "% Example\n%\n% Two balls\n% of steel\n\n 3 MODULE\n 1\n 3 % second\n 2\n% ----\n 3\n",
        );
        assert_eq!(reader.title(0, 6).as_deref(), Some("Two balls"));
        assert_eq!(reader.title(6, 8).as_deref(), Some("second"));
        assert_eq!(reader.title(8, 11), None);
    }
}
