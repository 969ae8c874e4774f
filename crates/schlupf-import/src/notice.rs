//! Notices: what users of an import should know about it.

use schlupf::message::{Message, Names, messages};

messages! {
    /// A notice about an input file.
    Notice of &'static str:

    /// Settings that have no counterpart.
    "settings-left-out" SettingsLeftOut {
        /// Their names.
        names: &'static str,
    } "solver", |subject, words| format!(
        "{names} set CONTACT's own solvers and output and are left out: nothing that is solved depends on them"
    );

    /// The grid of two profiles.
    "grid-left-out" GridLeftOut {
        /// Size of its elements, in mm.
        size: [f64; 2],
    } "grid", |subject, words| format!(
        "elements of {} x {} mm (DX, DS) are left out: grid.cells_x and cells_y are cells across the patch, \
         whatever its size",
        size[0],
        size[1]
    );
}

impl From<Notice> for Message {
    fn from(notice: Notice) -> Self {
        notice.message(&Names)
    }
}
