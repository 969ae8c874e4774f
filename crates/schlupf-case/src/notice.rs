//! Notices: what users of results should know about a case.

use schlupf::reporting::{Message, messages, with_unit};

use crate::fields::{self, Field, FieldPath, Requirement, creepage_in_per_cent, readable};
use crate::names::FieldNames;
use crate::place::Place;

const ROUGHNESS: &str = "contact_law.roughness";

messages! {
    /// A notice about a field or a section of a case.
    Notice of &'static str:

    /// The case gives no fields: all have their defaults.
    "nothing-given" NothingGiven {} field!("title").as_str(), |subject, words| {
        "the case gives no fields: all have their defaults, free rolling of a steel wheel on a steel rail; \
         `schlupf init` writes a case to start from"
            .to_owned()
    };

    /// A field was given that the chosen models do not use.
    "no-effect" NoEffect {
        /// Where it was given.
        place: Place,
        /// Its path.
        field: FieldPath,
        /// What it would need, or what excludes it, such as `with heat.model = "none"`.
        because: String,
    } field.as_str(), |subject, words| format!("{place}: {field} has no effect {because}");

    /// A number is unusual: wrong unit, or a percentage?
    "unusual-value" UnusualValue {
        /// Where it was given.
        place: Place,
        /// Its path.
        field: FieldPath,
        /// What it is, in the unit of the field.
        value: f64,
        /// What it is in almost all cases.
        usual: Requirement,
        /// Its unit; empty if it is dimensionless.
        unit: &'static str,
    } field.as_str(), |subject, words| {
        let is = with_unit(*value, unit);
        let usual = usual.text(unit, &FieldNames::CASE);
        let advice = if unit.is_empty() {
            creepage_in_per_cent(field, *value).map_or(String::new(), |help| format!(": {help}"))
        } else {
            ": is its unit right?".to_owned()
        };
        format!("{place}: {field} is {is}, but is usually {usual}{advice}")
    }, severity usual.remoteness(*value);

    /// A roughness height is outside of 1 nm to 100 µm: wrong unit?
    "unusual-height" UnusualHeight {
        /// h_rms of both surfaces together, in m.
        rms_height: f64,
    } ROUGHNESS, |subject, words| format!(
        "h_rms is {} m, outside of 1 nm to 100 µm: is its unit right?",
        readable(*rms_height)
    ), severity (rms_height / 1e-6).ln().abs();

    /// The contact spots carry more than steel can bear.
    "yielding-spots" YieldingSpots {
        /// Mean pressure in the spots, in Pa.
        in_spots: f64,
        /// Mean pressure on the surface, in Pa.
        mean_pressure: f64,
    } ROUGHNESS, |subject, words| format!(
        "the spots carry {:.1} GPa in the mean at {:.0} MPa, above the hardness of steel (2.5 to \
         3 GPa on rails): give a hardness",
        1e-9 * in_spots,
        1e-6 * mean_pressure
    );

    /// Too few cells are in contact to resolve the shape of the spots.
    "few-cells-in-contact" FewCellsInContact {
        /// Cells in contact in the mean, dimensionless.
        cells: f64,
        /// At which pressure: `largest` or `smallest`.
        at: &'static str,
    } ROUGHNESS, |subject, words| format!(
        "only {cells:.0} cells are in contact at the {at} pressure: k_c is doubtful; more cells or a \
         larger surface make it better"
    );

    /// Eq. (8) with one k_c does not fit the tangential curves.
    "not-exponential" NotExponential {
        /// What Eq. (8) with one k_c misses of μp, root mean square, dimensionless.
        root_mean_square_error: f64,
        /// The largest of it, dimensionless.
        largest_error: f64,
    } ROUGHNESS, |subject, words| format!(
        "Eq. (8) with one k_c misses {:.0} % of μp (root mean square), at most {:.0} %: the surface does \
         not load exponentially at these pressures",
        1e2 * root_mean_square_error,
        1e2 * largest_error
    );

    /// k_c depends on the pressure.
    "stiffness-varies" StiffnessVaries {
        /// Smallest and largest k_c, in 1/m.
        stiffness: [f64; 2],
        /// Smallest and largest mean pressure, in Pa.
        mean_pressure: [f64; 2],
    } ROUGHNESS, |subject, words| format!(
        "k_c depends on the pressure: from {:.3e} to {:.3e} 1/m between {:.0} and {:.0} MPa",
        stiffness[0],
        stiffness[1],
        1e-6 * mean_pressure[0],
        1e-6 * mean_pressure[1]
    );

    /// The normal contact of the micro model did not converge.
    "micro-model-not-converged" MicroModelNotConverged {} ROUGHNESS, |subject, words| {
        "the normal contact of the micro model did not converge at every pressure: do not trust its k_c"
            .to_owned()
    };

    /// Too few pressures for the closed form of k_c.
    "no-closed-form" NoClosedForm {} ROUGHNESS, |subject, words| {
        "fewer than three of the solved pressures bring 1 to 20 % of the surface into contact: the \
         closed form does not apply"
            .to_owned()
    };

    /// Gradients so large that the small-slope assumption is doubtful.
    "steep-surface" SteepSurface {
        /// Root mean square gradient, dimensionless.
        gradient: f64,
    } ROUGHNESS, |subject, words| format!(
        "the root mean square gradient is {}: the model takes slopes for small, its k_c is doubtful",
        readable(*gradient)
    );

    /// The measured piece is too small to be representative.
    "small-piece" SmallPiece {
        /// Part of the variance in waves longer than a fifth of it, dimensionless.
        share: f64,
    } ROUGHNESS, |subject, words| format!(
        "{:.0} % of the variance of the heights lies in waves longer than a fifth of the piece: its k_c \
         is that of this piece, another one may differ by tens of per cent; measure a larger one, or \
         remove waviness",
        1e2 * share
    );

    /// Much of the roughness lies in waves longer than the contact.
    "long-waves" LongWaves {
        /// Part of the variance in them, dimensionless.
        share: f64,
        /// Length of the contact in the direction of rolling, in m.
        length: f64,
    } ROUGHNESS, |subject, words| format!(
        "{:.0} % of the variance of the heights lies in waves longer than the contact, {:.3} mm: this \
         is waviness, to which the contact conforms; without it k_c would be larger: remove it with \
         form or cutoff_wavelength",
        1e2 * share,
        1e3 * length
    );

    /// Waves of a profile or a spectrum shorter than two cells are omitted.
    "waves-left-out" WavesLeftOut {
        /// The longest of them, in m.
        wavelength: f64,
    } ROUGHNESS, |subject, words| format!(
        "waves shorter than {:.3} µm, two cells, are left out; more cells would keep them",
        1e6 * wavelength
    );

    /// Waves of a profile or a spectrum longer than the surface are omitted.
    "long-waves-left-out" LongWavesLeftOut {
        /// The longest of them, in m.
        longest: f64,
        /// Side of the surface, in m.
        side: f64,
    } ROUGHNESS, |subject, words| format!(
        "waves longer than the surface, {:.3} mm, are left out; the longest are {:.3} mm",
        1e3 * side,
        1e3 * longest
    );

    /// The shape of a profile does not show its axes, or contradicts its format or the case.
    "profile-axes" ProfileAxes {
        /// Its path.
        field: FieldPath,
        /// What was taken and why.
        text: String,
    } field.as_str(), |subject, words| format!("{subject}: {text}");

    /// A profile has not the size of a wheel or rail, or numbers without a unit were taken for
    /// metres.
    "profile-units" ProfileUnits {
        /// Its path.
        field: FieldPath,
        /// What was read, and what it would be in other units.
        text: String,
    } field.as_str(), |subject, words| format!("{subject}: {text}");

    /// Points of a profile were repeated or out of order, and were sorted.
    "profile-order" ProfileOrder {
        /// Its path.
        field: FieldPath,
        /// Where.
        text: String,
    } field.as_str(), |subject, words| format!("{subject}: {text}");

    /// Two passes cover the same part of a profile; the later one is left out there.
    "profile-overlap" ProfileOverlap {
        /// Its path.
        field: FieldPath,
        /// Where, and how far apart.
        text: String,
    } field.as_str(), |subject, words| format!("{subject}: {text}");

    /// A setting in the file of a profile is not applied.
    "profile-setting" ProfileSetting {
        /// Its path.
        field: FieldPath,
        /// The setting, and what to do.
        setting: String,
    } field.as_str(), |subject, words| format!("{subject}: the file's setting is not applied: {setting}");

    /// The flange of a profile does not belong to the usual position of its back.
    "flange-back" FlangeBack {
        /// Its path.
        field: FieldPath,
        /// What was taken and why.
        text: String,
    } field.as_str(), |subject, words| format!("{subject}: {text}");

    /// The inner side of the rail profile ends above the gauge depth; the rail is placed by that
    /// end.
    "gauge-depth-not-reached" GaugeDepthNotReached {
        /// Depth of the inner end of the profile below its top, in m.
        reached: f64,
        /// Depth down to which the gauge is measured, in m.
        wanted: f64,
    } field!("track.gauge_depth").as_str(), |subject, words| format!(
        "{subject} is {:.2} mm, but on its inner side the rail's profile ends {:.2} mm below its top: \
         the gauge is taken at that end, so the rail is too far inwards by what is missing; give a \
         longer profile, or the depth at which the gauge was measured",
        1e3 * wanted,
        1e3 * reached
    ), severity wanted - reached;

    /// Many of the points had no height and were filled.
    "filled-points" FilledPoints {
        /// The file and how many points of it were filled, as a sentence.
        filling: String,
    } ROUGHNESS, |subject, words| format!(
        "{filling}: they are smooth, and Sa, Sq, Ssk, Sku, Sz, the gradients and k_c count them"
    );
}

impl Notice {
    /// Code of a number that is far from what it is in almost all cases.
    pub const UNUSUAL: &str = "unusual-value";

    /// A warning of the most unusual of some values (in the unit of the field), if there is one.
    pub fn of_unusual(field: &'static Field, values: &[f64], place: &Place) -> Option<Self> {
        let (worst, _) = fields::unusual(field, values)?;
        let (value, usual, place) = (values[worst], field.usual?, place.clone());
        let unit = field.kind.unit();
        Some(Self::UnusualValue { place, field: field.path, value, usual, unit })
    }
}

impl From<Notice> for Message {
    fn from(notice: Notice) -> Self {
        notice.message(&FieldNames::CASE)
    }
}
