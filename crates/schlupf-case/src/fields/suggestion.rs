//! What was probably meant by a name that does not exist.

use strsim::{damerau_levenshtein, jaro_winkler};

/// The candidate that a name was probably meant to be, if one is close.
pub fn closest<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    /// Longer than any name, even a misspelt one.
    const LONGEST: usize = 200;
    let name = if name.len() > LONGEST { "" } else { name };
    let likeness = |candidate: &str| {
        // One or two wrong letters in a short name are alike; so is a long name cut short.
        let near = damerau_levenshtein(name, candidate) <= 1 + candidate.len() / 8;
        let likeness = jaro_winkler(name, candidate);
        if near { likeness.max(0.9) } else { likeness }
    };
    candidates
        .map(|candidate| (likeness(candidate), candidate))
        .filter(|(likeness, _)| *likeness > 0.85)
        .fold(None, |best: Option<(f64, &str)>, next| match best {
            Some(best) if best.0 >= next.0 => Some(best),
            _ => Some(next),
        })
        .map(|(_, candidate)| candidate)
}

/// What to write in place of per cent.
pub const NOT_PER_CENT: &str = "give a fraction, not a percentage: 1 % is 0.01";

/// Whether a unit or the end of a text stands for per cent.
pub fn is_per_cent(text: &str) -> bool {
    ["%", "per cent", "percent", "pct"].iter().any(|unit| text.trim().ends_with(unit))
}

/// Advice for a creepage (a field or a column) that is too large to be a part of one.
pub fn creepage_in_per_cent(name: &str, value: f64) -> Option<String> {
    let is_creepage = name.ends_with("creepage_x") || name.ends_with("creepage_y");
    let is_large = value.abs() >= 1.0 && value.is_finite();
    (is_creepage && is_large).then(|| NOT_PER_CENT.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn creepages_from_one_on_may_be_in_per_cent() {
        let advised = |name, value| creepage_in_per_cent(name, value).is_some();
        assert!(advised("kinematics.creepage_x", 1.539) && advised("creepage_y", -2.0));
        assert!(![0.99, f64::INFINITY].into_iter().any(|value| advised("creepage_x", value)));
        assert!(!advised("kinematics.spin", 1.539));
        assert!(is_per_cent("%") && is_per_cent("1.5 %") && !is_per_cent("1/m"));
    }
}
