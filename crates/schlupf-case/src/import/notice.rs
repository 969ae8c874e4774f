//! Notices: what users of an import should know about it.

use schlupf::reporting::{Message, Names, messages};

use crate::FieldPath;

messages! {
    /// A notice about an input file.
    Notice of &'static str:

    /// Settings of CONTACT's solvers and output have no counterpart.
    "settings-left-out" SettingsLeftOut {
        /// Their names.
        names: &'static str,
    } "solver", |subject, words| format!(
        "{names} set CONTACT's own solvers and output and are left out: nothing that is solved depends on them"
    );

    /// The given size of elements has no counterpart.
    "grid-left-out" GridLeftOut {
        /// Size of its elements, in mm.
        size: [f64; 2],
    } "grid", |subject, words| format!(
        "elements of {} x {} mm (DX, DS) are left out: grid.cells_x and cells_y are cells across the patch, \
         whatever its size",
        size[0],
        size[1]
    );

    /// CONTACT's FASTSIM has other flexibilities and takes cells as a whole.
    "other-fastsim" OtherFastsim {} field!("solver.method").as_str(), |subject, words| "CONTACT's FASTSIM shifts its \
        three flexibilities towards one and takes cells as a whole: forces differ by 1 to 4 % of the \
        friction limit".to_owned();

    /// FaStrip is replaced by what it approximates.
    "no-strips" NoStrips {} field!("solver.method").as_str(), |subject, words| "FaStrip (M = 5 to 7) is \
        an approximation of elastic half-spaces, whose equations are solved here: its own force in \
        CONTACT's example differs by 3 % of the friction limit".to_owned();

    /// Influences on a curved surface follow its turn.
    "bent-half-spaces" BentHalfSpaces {} field!("normal.method").as_str(), |subject, words| "D = 4: the \
        half-spaces are bent along the surface, as with C3 = 4; with C3 = 2 the largest pressure is \
        up to 5 % higher".to_owned();

    /// The ellipse correction of KPEC is another one.
    "other-shares" OtherShares {} field!("normal.method").as_str(), |subject, words| "KPEC: the share \
        of the approach that bounds the contact follows from Hertz's theory, not from CONTACT's \
        formula; pressures of contacts that are no ellipses differ".to_owned();

    /// Modified FASTSIM with lateral creepage or spin differs from CONTACT's.
    "other-slope-reduction" OtherSlopeReduction {} field!("fastsim.reduction_decay").as_str(), |subject, words| "with \
        lateral creepage or spin modified FASTSIM differs more: the ratio of slip to adhesion that \
        reduces the slope has C11 √(ξ² + (η + φ a)²) in CONTACT, √((C11 ξ)² + (C22 η)²) here"
        .to_owned();

    /// Creepages and moment refer to the middle of the contact.
    "moment-at-middle" MomentAtMiddle {
        /// Middle of the contact in the coordinates of the file, in mm.
        centre: [f64; 2],
    } field!("kinematics.reference").as_str(), |subject, words| format!(
        "creepages are converted to the middle of the contact, ({}, {}) mm in the input, and the moment \
         is taken about it",
        crate::import::document::number(centre[0]),
        crate::import::document::number(centre[1])
    );

    /// Points of stresses below the surface are another command's.
    "points-left-out" PointsLeftOut {} "subsurface", |subject, words| "the points of stresses below \
        the surface (S) are left out: `schlupf subsurface` computes them".to_owned();

    /// Close contacts are one; CONTACT attenuates their influence on each other.
    "whole-contacts" WholeContacts {} field!("normal.join_distance").as_str(), |subject, words| "contacts closer than \
        D_SEP are one contact: CONTACT attenuates their influence on each other down to D_COMB, and \
        turns their planes up to D_TURN; others move each other's surfaces apart, which CONTACT \
        leaves out".to_owned();

    /// Friction follows the inclination of every row.
    "friction-by-row" FrictionByRow {} field!("friction.variation_inclination").as_str(), |subject, words| "V = 1: \
        friction is that at the inclination of every row of cells; a contact in a plane of CONTACT \
        has that at the inclination of the plane".to_owned();

    /// Thresholds for kinks and errors of a profile have no counterpart.
    "thresholds-left-out" ThresholdsLeftOut {
        /// The field of the profile.
        profile: FieldPath,
    } profile.as_str(), |subject, words| "thresholds for kinks and \
        errors of a profile (PRFOPT) are left out: it is taken as it is".to_owned();
}

impl From<Notice> for Message {
    fn from(notice: Notice) -> Self {
        notice.message(&Names)
    }
}
