//! The pressure of a solved contact as a source for the tangential problem.

use std::sync::Arc;

use super::pressed::Pressed;
use super::side::Side;
use crate::bodies::RowMotion;
use crate::normal::{NormalContact, NormalSummary, PressureSource, PressureTable, Tabulated};
use crate::reporting::Error;

/// The pressure in the plane of a contact. Positions are relative to the plane's origin, x along
/// the track and y to the left.
#[derive(Debug, Clone)]
pub struct ContactPatch {
    table: Tabulated,
    load: f64,
    approach: f64,
    /// In the contact frame.
    rows: Option<Arc<RowMotion>>,
}

impl ContactPatch {
    /// That of the left wheel, or its mirror image, with the motion of its rows over s.
    pub(super) fn new(
        pressed: &Pressed,
        rows: Option<&RowMotion>,
        side: Side,
    ) -> Result<Arc<Self>, Error> {
        let columns = pressed.x.len();
        let table = match side {
            Side::Left => {
                PressureTable::where_it_is(&pressed.x, &pressed.s, pressed.pressure.clone())?
            }
            Side::Right => {
                let y: Vec<f64> = pressed.s.iter().rev().map(|s| -s).collect();
                let rows = pressed.pressure.chunks(columns).rev().flatten().copied();
                PressureTable::where_it_is(&pressed.x, &y, rows.collect())?
            }
        };
        let extent = table.extent();
        let middle = |side: [f64; 2]| 0.5 * (side[0] + side[1]);
        let origin = [middle(extent.x), middle(extent.y)];
        let table = table.seen_from(origin);
        let rows = rows.map(|rows| match side {
            Side::Left => rows.seen_from(origin),
            Side::Right => rows.mirrored().seen_from(origin),
        });
        let table = Tabulated::new(table, Some(pressed.load))?;
        let rows = rows.map(Arc::new);
        Ok(Arc::new(Self { table, load: pressed.load, approach: pressed.approach, rows }))
    }
}

impl PressureSource for ContactPatch {
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
        let contact = self.table.normal_contact(load)?;
        let is_own = load.is_none_or(|load| load == self.load);
        let approach = is_own.then_some(self.approach);
        let summary = NormalSummary { approach, ..contact.summary };
        Ok(NormalContact { summary, rows: self.rows.clone(), ..contact })
    }

    fn load_exponent(&self) -> Option<f64> {
        None
    }
}
