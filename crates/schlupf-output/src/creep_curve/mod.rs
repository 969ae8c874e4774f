//! Creep curves, one or a family of them: JSON, CSV and a summary. The figure is among the figures.

pub mod csv;
pub mod json;
pub mod summary;

use schlupf::creep_curve::{Abscissa, CreepCurve, Sampling};

/// Creep curves over the same creepages, of cases that differ in one field.
#[derive(Debug, Clone)]
pub struct CurveFamily {
    /// Title of the case.
    pub title: String,
    /// Dotted path of the field in which the members differ; `None` for one curve.
    pub over: Option<String>,
    /// How the points are spaced.
    pub sampling: Sampling,
    /// At least one curve.
    pub members: Vec<Member>,
}

/// One curve of a family.
#[derive(Debug, Clone)]
pub struct Member {
    /// The value of the field, as it was written; `None` for one curve.
    pub value: Option<String>,
    /// What was given without effect.
    pub notices: Vec<String>,
    /// The curve.
    pub curve: CreepCurve,
}

impl CurveFamily {
    /// What all curves are drawn over.
    pub fn abscissa(&self) -> Option<Abscissa> {
        self.members.first().map(|member| member.curve.path.abscissa())
    }

    /// Whether every point of every curve converged.
    pub fn is_converged(&self) -> bool {
        self.members.iter().all(|member| member.curve.is_converged())
    }

    /// What a member is called, such as `normal.load = 60 kN`.
    pub fn name(&self, member: &Member) -> Option<String> {
        Some(format!("{} = {}", self.over.as_ref()?, member.value.as_ref()?))
    }

    /// The warnings of all curves: one that all of them have once, the others with the name of their
    /// curve.
    pub fn warnings(&self) -> Vec<String> {
        let of = |member: &Member| -> Vec<String> {
            member.notices.iter().chain(&member.curve.warnings).cloned().collect()
        };
        let Some((first, others)) = self.members.split_first() else { return Vec::new() };
        let is_common = |text: &String| others.iter().all(|member| of(member).contains(text));
        let (mut warnings, own): (Vec<String>, Vec<String>) =
            of(first).into_iter().partition(is_common);
        let common = warnings.clone();
        let mut add = |member: &Member, texts: Vec<String>| {
            for text in texts.into_iter().filter(|text| !common.contains(text)) {
                warnings.push(match self.name(member) {
                    Some(name) => format!("{name}: {text}"),
                    None => text,
                });
            }
        };
        add(first, own);
        for member in others {
            add(member, of(member));
        }
        warnings
    }
}
