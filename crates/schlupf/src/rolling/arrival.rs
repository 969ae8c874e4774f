//! What the elements bring into their new cells when the material moves on by one cell.

use crate::heat::HeatStep;
use crate::interface::contact_law::Slide;
use crate::patch::Patch;
use crate::state::Element;

use super::contact::DiscreteContact;

/// What an element brings into its new cell.
#[derive(Debug, Clone, Default)]
pub(super) struct Arrival {
    /// Its history; the increment and the turn are still to come.
    pub slide: Slide,
    /// A p of the new cell a step ago, in m.
    pub before: [f64; 2],
    /// Elastic part of its sliding on the last way, over that way, dimensionless; if it has come
    /// from a cell.
    pub stretch: Option<[f64; 2]>,
    /// What A p of its new cell is compared with, in m: A p where it was, and for a cell that lies
    /// partly behind another piece of the leading edge, the difference between the two places of
    /// entry.
    pub displacement: [f64; 2],
    /// Heat that it has received.
    pub heat: Vec<HeatStep>,
    /// Its coefficient of friction (dimensionless), if it remembers one.
    pub friction: Option<f64>,
    /// Whether the element comes into contact only now, in the middle of a strip: a step ago the
    /// patch had not reached it. It starts without traction.
    pub joins: bool,
}

impl Arrival {
    /// At the leading edge nothing has happened yet.
    fn at_leading_edge(displacement: [f64; 2]) -> Self {
        Self { displacement, ..Self::default() }
    }

    /// From the upstream neighbour, if that was in contact.
    fn from_upstream(element: Option<&Element>, displacement: [f64; 2]) -> Self {
        let Some(element) = element else {
            return Self { displacement, joins: true, ..Self::default() };
        };
        Self {
            slide: Slide {
                traction: element.saturation,
                distance: element.sliding,
                ..Slide::default()
            },
            stretch: Some(element.stretch),
            displacement,
            heat: element.heat.clone(),
            friction: element.friction_on_leaving,
            ..Self::default()
        }
    }
}

/// Moves all elements on by one cell. The contact has its new patch already, and its displacement
/// field is still that of the last step.
pub(super) fn carry_over(contact: &DiscreteContact, elements: &[Element]) -> Vec<Arrival> {
    let patch = &contact.patch;
    let at = positions(patch, elements);
    let mut displacement = vec![0.0; 2 * patch.len()];
    let mut at_entry = displacement.clone();
    contact.displacement_at_cells(&mut displacement);
    contact.displacement_at_entries(&mut at_entry);
    let pair = |values: &[f64], k: usize| [values[2 * k], values[2 * k + 1]];
    let mut arrivals = Vec::with_capacity(patch.len());
    for strip in &patch.strips {
        arrivals.push(Arrival::at_leading_edge(pair(&at_entry, strip.cells.start)));
        for upstream in strip.cells.start..strip.cells.end - 1 {
            let element = at[patch.cells[upstream].index].map(|e| &elements[e]);
            let (there, entries) = (pair(&displacement, upstream), pair(&at_entry, upstream));
            let entry = pair(&at_entry, upstream + 1);
            let compared = [0, 1].map(|c| entry[c] + there[c] - entries[c]);
            arrivals.push(Arrival::from_upstream(element, compared));
        }
    }
    for (k, arrival) in arrivals.iter_mut().enumerate() {
        arrival.before = pair(&displacement, k);
    }
    arrivals
}

/// Which element stands in which cell of the grid.
pub(super) fn positions(patch: &Patch, elements: &[Element]) -> Vec<Option<usize>> {
    let mut at = vec![None; patch.grid.len()];
    for (e, element) in elements.iter().enumerate() {
        at[element.index] = Some(e);
    }
    at
}
