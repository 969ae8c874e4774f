//! What was probably meant by a name that does not exist.

use strsim::{damerau_levenshtein, jaro_winkler};

/// The candidate that a name was probably meant to be, if one is close.
pub fn closest<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
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

/// The dotted path that was probably meant: a field of the same section with a similar name, or a
/// field of the same name in another section.
pub fn closest_path(path: &str) -> Option<&'static str> {
    let (section, name) = path.rsplit_once('.').unwrap_or(("", path));
    let in_section = || super::all().filter(|field| field.section() == section);
    if let Some(neighbour) = closest(name, in_section().map(super::Field::name)) {
        return in_section().find(|field| field.name() == neighbour).map(|field| field.path);
    }
    let namesakes = || super::all().filter(|field| field.name() == name).map(|field| field.path);
    closest(path, namesakes()).or_else(|| namesakes().next())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn misspelt_and_misplaced_fields_are_recognised() {
        assert_eq!(closest_path("kinematics.creepage"), Some("kinematics.creepage_x"));
        assert_eq!(closest_path("kinematics.sped"), Some("kinematics.speed"));
        assert_eq!(closest_path("kinematics.load"), Some("normal.load"));
        assert_eq!(closest_path("load"), Some("normal.load"));
        assert_eq!(closest_path("wheel.youngs_modulus"), Some("wheel.young_modulus"));
        assert_eq!(closest_path("friction.mu"), None);
        assert_eq!(closest_path("grid.cell_x"), Some("grid.cells_x"));
        assert_eq!(closest_path("contactlaw.stiffness"), Some("contact_law.stiffness"));
    }
}
