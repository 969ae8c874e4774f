//! Transfer of the elements into their new cells when the material moves on by one cell, and time
//! and place of entry of new elements.
//!
//! A material point that enters within a step is compared with the displacement where and when it
//! entered, not with that of the previous instant. With λ the fraction of the step that the
//! material of a cell has spent in contact, m its upstream neighbour, u = A p and e the
//! displacement where the material entered, it slides by
//!
//! Δs_k = D_k − u_k(t) + (u_m − e_m)(t − Δt) + λ e_k(t − Δt) + (1 − λ) e_k(t),
//!
//! where D_k is the rigid slip along its path; (u_m − e_m) is zero where nothing comes from
//! upstream.
//!
//! Where the load changes, the edges of the patch move: [`super::moving_edge`].

use crate::bodies::Kinematics;
use crate::normal::patch::{Cell, Patch, Strip};
use crate::normal::{Grid, VectorField};
use crate::numerics::vector::dot;
use crate::problem::{Element, HeatRecord, Places, TrackPoint};
use crate::solver::rolling::shared::contact::DiscreteContact;
use crate::solver::rolling::shared::passage::pair;
use crate::solver::settings;

use super::moving_edge::{Motion, motions};
use super::past::{Departure, Past};

/// State that an element brings into its new cell.
#[derive(Debug, Clone, Default)]
pub(super) struct Arrival {
    /// Sliding since entry before the step, in m.
    pub sliding: [f64; 2],
    /// Traction on the rail over μ pₙ before the step, dimensionless.
    pub saturation: [f64; 2],
    /// Places that it has passed, with their distances from the cell, the latest first.
    pub places: Places,
    /// The known part of the displacement with which A p of its new cell is compared, in m.
    pub displacement: [f64; 2],
    /// Length of its path in contact within the step, in m; in a shift the part of one metre, over
    /// which it is given.
    pub path: f64,
    /// λ: fraction of the step that it has spent in contact, dimensionless.
    pub in_contact: f64,
    /// Whether it came into contact in place, not over the leading edge.
    pub in_place: bool,
    /// Heat that it has received.
    pub heat: HeatRecord,
    /// Its coefficient of friction (dimensionless), with friction memory.
    pub friction: Option<f64>,
    /// Plastic displacement of the layer between the surfaces, in m.
    pub plastic_displacement: f64,
}

/// Keeps all elements in place in a shift, with the displacement at the cells before it (in m). If
/// the load changes (`moves`), the patch is already the new one.
pub(super) fn keep_in_place(
    patch: &Patch,
    displacement: &[f64],
    past: &Past,
    moves: bool,
    elements: &[Element],
) -> Vec<Arrival> {
    let motions = if moves { motions(patch, past, 0.0) } else { Vec::new() };
    let mut arrivals = Vec::with_capacity(patch.len());
    for (n, strip) in patch.strips.iter().enumerate() {
        for k in strip.cells.clone() {
            let (cell, here) = (&patch.cells[k], pair(displacement, k));
            arrivals.push(if let Some((element, _)) = &past.cells[cell.index] {
                Arrival::stays(&elements[*element], here)
            } else {
                let met = motions.get(n).map(|m| m.part_at_rest(cell.x, cell.entry_x()));
                Arrival::meets(met.unwrap_or(1.0), here)
            });
        }
    }
    arrivals
}

impl Arrival {
    /// Material that stays where it is in a shift.
    fn stays(element: &Element, displacement: [f64; 2]) -> Self {
        Self {
            sliding: element.sliding,
            saturation: element.saturation,
            displacement,
            path: 1.0,
            in_contact: 1.0,
            heat: element.heat.clone(),
            friction: element.friction_on_leaving,
            plastic_displacement: element.plastic_displacement,
            ..Self::default()
        }
    }

    /// Material that meets the other body within a shift, in contact for a part of it; `here` is
    /// A p of the previous instant, in m.
    fn meets(in_contact: f64, here: [f64; 2]) -> Self {
        let displacement = here.map(|u| in_contact * u);
        Self { displacement, path: in_contact, in_contact, in_place: true, ..Self::default() }
    }
}

/// Moves all elements on by one cell. If the load changes (`moves`), the contact already has its
/// new patch; the displacement is that of the previous instant.
pub(super) fn carry_over(
    contact: &DiscreteContact,
    displacement: &VectorField,
    past: &Past,
    moves: bool,
    elements: &[Element],
) -> Vec<Arrival> {
    let patch = &contact.patch;
    let mut at_cells = vec![0.0; 2 * patch.len()];
    contact.interpolation.gather(displacement, &mut at_cells);
    let spacing = patch.grid.spacing_x;
    let motions = if moves { motions(patch, past, spacing) } else { Vec::new() };
    let mut arrivals = Vec::with_capacity(patch.len());
    for (n, strip) in patch.strips.iter().enumerate() {
        let nearest = strip.cells.clone().find_map(|k| past.at(patch.cells[k].index));
        for k in strip.cells.clone() {
            let cell = &patch.cells[k];
            let entered = past.at(cell.index).or(nearest).map(|before| before.at_entry);
            let upstream = upstream_index(patch, strip, k).and_then(|i| past.cells[i].as_ref());
            let place = Place { cell, motion: motions.get(n), grid: &patch.grid, entered };
            arrivals.push(match upstream {
                Some((element, departure)) => place.carry_on(&elements[*element], departure),
                None => place.enter(pair(&at_cells, k)),
            });
        }
    }
    arrivals
}

/// A cell that receives an element.
struct Place<'a> {
    cell: &'a Cell,
    /// Motion of the edges of its strip, if they move.
    motion: Option<&'a Motion>,
    grid: &'a Grid,
    /// A p of the previous instant where the material of the cell entered at that time, in m; if
    /// the strip was in contact.
    entered: Option<[f64; 2]>,
}

impl Place<'_> {
    /// An element that came into contact within the step; `here` is A p of the previous instant, in
    /// m.
    fn enter(&self, here: [f64; 2]) -> Arrival {
        let cell = self.cell;
        let path = self.motion.map_or(cell.since_entry.distance, |motion| {
            motion.path_until_end(cell.x, cell.entry_x()).clamp(0.0, self.grid.spacing_x)
        });
        let leads = self.motion.is_none_or(|motion| motion.is_from_leading_edge(cell.x, path));
        let in_contact = self.part_of_step(path);
        let over_edge = self.entered.filter(|_| leads);
        Arrival {
            displacement: over_edge.unwrap_or(here).map(|u| in_contact * u),
            places: std::iter::once(TrackPoint { distance: path, ..TrackPoint::default() })
                .collect(),
            path,
            in_contact,
            in_place: over_edge.is_none(),
            ..Arrival::default()
        }
    }

    /// An element that was in contact at the previous instant.
    fn carry_on(&self, element: &Element, departure: &Departure) -> Arrival {
        let cell = self.cell;
        let path = self.motion.map_or(cell.path_in.distance, |motion| {
            let before = motion.path_until_start(departure.x, departure.entry_x);
            let path = motion.path_until_end(cell.x, cell.entry_x()) - before;
            path.clamp(0.0, settings::longest_path() * self.grid.spacing_x)
        });
        let in_contact = self.part_of_step(path);
        let entered = self.entered.unwrap_or(departure.at_entry);
        let compared =
            |c: usize| in_contact * entered[c] + departure.displacement[c] - departure.at_entry[c];
        Arrival {
            sliding: element.sliding,
            saturation: element.saturation,
            places: passed(element, path),
            displacement: [compared(0), compared(1)],
            path,
            in_contact,
            in_place: false,
            heat: element.heat.clone(),
            friction: element.friction_on_leaving,
            plastic_displacement: element.plastic_displacement,
        }
    }

    /// λ for a path (in m) within the step.
    fn part_of_step(&self, path: f64) -> f64 {
        (path / self.grid.spacing_x).clamp(0.0, 1.0)
    }
}

/// The places that an element has passed when it has moved on by a path, in m. Without a track it
/// has passed at least the place where it is.
fn passed(element: &Element, path: f64) -> Places {
    if element.track.is_empty() {
        let Element { sliding, saturation, .. } = *element;
        return std::iter::once(TrackPoint { distance: path, sliding, saturation }).collect();
    }
    let on = |place: &TrackPoint| TrackPoint { distance: place.distance + path, ..*place };
    element.track.iter().map(on).collect()
}

/// The cell of the grid from which the material of a cell comes, unless another strip ends there.
fn upstream_index(patch: &Patch, strip: &Strip, k: usize) -> Option<usize> {
    let upstream = patch.cells[k].index + 1;
    let is_of_other = k == strip.cells.start && k > 0 && patch.cells[k - 1].index == upstream;
    (!is_of_other).then_some(upstream)
}

/// The index of the element in each cell of the grid.
pub(super) fn positions(patch: &Patch, elements: &[Element]) -> Vec<Option<usize>> {
    let mut at = vec![None; patch.grid.len()];
    for (e, element) in elements.iter().enumerate() {
        at[element.index] = Some(e);
    }
    at
}

/// The places that the elements have passed and from which their sliding follows, with the mean
/// motions of the step before and of this one: only the last place where the rigid slip has just
/// fallen below half of what it was, or turned. What sticks from then on would otherwise slide on
/// for half a step.
pub(super) fn places_passed(
    patch: &Patch,
    arrivals: &[Arrival],
    motions: [&Kinematics; 2],
) -> Vec<Places> {
    let of = |(cell, arrival): (&Cell, &Arrival)| {
        let [before, now] = motions.map(|motion| rigid_slip(cell, arrival.path, motion));
        let along = dot(&before, &now);
        let kept = if along < 0.5 * dot(&before, &before) { 1 } else { usize::MAX };
        arrival.places.iter().take(kept).copied().collect()
    };
    patch.cells.iter().zip(arrivals).map(of).collect()
}

/// Rigid slip (in m) along a path in contact (in m) into a cell, which is the whole path from its
/// upstream neighbour or from the leading edge unless the edge moves.
pub(super) fn rigid_slip(cell: &Cell, path: f64, kinematics: &Kinematics) -> [f64; 2] {
    let part = path / cell.path_in.distance;
    cell.rigid_slip_in(kinematics).map(|slip| part * slip)
}
