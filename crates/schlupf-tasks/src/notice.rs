//! Notices: what users of results should know about what a task did.

use schlupf::Error;
use schlupf::reporting::{Message, messages};
use schlupf_case::{Case, FieldNames, field};

const CALIBRATION: &str = field!("elasticity.calibration").as_str();

messages! {
    /// A notice about a field of a case.
    Notice of &'static str:

    /// A method of `schlupf compare` cannot answer for this case.
    "not-available" NotAvailable {
        /// Why.
        reason: String,
    } field!("solver.method").as_str(), |subject, words| format!("not available: {reason}");

    /// A file has no rows, because the method gives no fields.
    "empty-output" EmptyOutput {
        /// Which one.
        output: String,
        /// What is missing.
        what: &'static str,
        /// Name of the method.
        method: &'static str,
    } field!("solver.method").as_str(), |subject, words| {
        format!("{output}: {what}, because solver.method = {method:?} gives no fields")
    };

    /// Loads of the data differ much from that of the case: wrong units?
    "other-loads" OtherLoads {
        /// The one that is farthest, in N.
        of_data: f64,
        /// Load of the case, in N.
        of_case: f64,
    } field!("normal.load").as_str(), |subject, words| format!(
        "the data have a load of {of_data:.4e} N, the case one of {of_case:.4e} N: are the units right?"
    );

    /// The method has no fields: wear and melting per wheel passage are unknown.
    "no-wear" NoWear {
        /// Its name.
        method: &'static str,
    } field!("solver.method").as_str(), |subject, words| format!(
        "the method {method} gives no fields: wear and melting are unknown"
    );

    /// Wear coefficients of dry steel with low friction or a layer.
    "wear-of-dry-steel" WearOfDrySteel {
        /// μ0, dimensionless.
        friction: f64,
    } field!("damage.wear_map").as_str(), |subject, words| format!(
        "the coefficients of wear are those of dry steel on steel, but μ0 is {friction} or there is a \
         layer: what lowers friction lowers wear by more"
    );

    /// A part of the contact is hotter than the melting temperature.
    "molten" Molten {
        /// Part of the area of contact, dimensionless.
        share: f64,
        /// The largest temperature, in °C.
        temperature: f64,
        /// That of melting, in °C.
        limit: f64,
    } field!("damage.melting_temperature").as_str(), |subject, words| format!(
        "{:.1} % of the contact is hotter than {limit} °C, up to {temperature:.0} °C: a surface \
         melts, and friction, wear and heat are no longer those of the laws", 100.0 * share
    );

    /// States of a run have no solution: the damage is that of the others.
    "left-out" LeftOut {
        /// How many.
        rows: usize,
        /// The first of them, from 0.
        first: usize,
        /// Over which distance they hold, in m.
        distance: f64,
    } "status", |subject, words| format!(
        "{rows} of the states have not converged or have failed, the first in row {first}: the \
         {distance:.4e} m over which they hold are left out"
    );

    /// A wheel has more contacts than a table has columns for: the smallest are not counted.
    "more-contacts" MoreContacts {
        /// How many.
        rows: usize,
        /// The first of them, from 0.
        first: usize,
    } field!("normal.model").as_str(), |subject, words| format!(
        "in {rows} of the states the wheel has more contacts than the table has columns for, in row \
         {first} for the first time: those with the smallest forces are not counted"
    );

    /// The contacts of a wheelset were not found at a lateral position.
    "position-failed" PositionFailed {
        /// Where, in m.
        lateral: f64,
        /// Why.
        reason: String,
    } field!("wheelset.lateral_position").as_str(), |subject, words| {
        format!("at a lateral position of {} mm: {reason}", millimetres(*lateral))
    };

    /// Beyond an amplitude the wheels leave the rails or profiles end: conicity is given up to it.
    "conicity-ends" ConicityEnds {
        /// The largest amplitude, in m.
        largest: f64,
        /// Why.
        reason: String,
    } field!("wheelset.lateral_position").as_str(), |subject, words| format!(
        "the equivalent conicity ends at an amplitude of {} mm: beyond, {reason}",
        millimetres(*largest)
    );

    /// The rolling radius difference drives the wheelset outwards: the equivalent conicity by EN
    /// 15302 is unknown.
    "no-periodic-motion" NoPeriodicMotion {
        /// Smallest and largest of them, in m.
        amplitudes: [f64; 2],
    } field!("wheelset.lateral_position").as_str(), |subject, words| format!(
        "the equivalent conicity by EN 15302 is unknown for amplitudes from {} to {} mm: there the \
         rolling radius difference drives the wheelset away from the middle, and no motion has such \
         an amplitude",
        millimetres(amplitudes[0]),
        millimetres(amplitudes[1])
    );

    /// States of a run have no friction power (Polach's method with spin): the damage is that of
    /// the others.
    "no-friction-power" NoFrictionPower {
        /// How many.
        rows: usize,
        /// The first of them, from 0.
        first: usize,
        /// Over which distance they hold, in m.
        distance: f64,
    } field!("solver.method").as_str(), |subject, words| format!(
        "{rows} of the states have no friction power, because the method gives no moment and they \
         have spin, the first in row {first}: the {distance:.4e} m over which they hold are left out"
    );

    /// The patch is outside the table of calibrated stiffnesses.
    "no-table" NoTable {
        /// Why.
        error: Error,
    } CALIBRATION, |subject, words| error.text(words);

    /// Fitted stiffnesses are far from those of the case's bodies: wrong units?
    "unlikely-bedding" UnlikelyBedding {
        /// `x` or `y`.
        component: &'static str,
        /// Bedding over that of half-spaces, dimensionless.
        ratio: f64,
    } CALIBRATION, |subject, words| format!(
        "the bedding for displacement_{component} is {ratio:.1e} times that of half-spaces of the case's \
         bodies: are units and bodies right?"
    );

    /// An elastic layer fits the displacements poorly.
    "poor-layer-fit" PoorLayerFit {
        /// `x` or `y`.
        component: &'static str,
        /// Part of them that it misses, dimensionless.
        deviation: f64,
    } CALIBRATION, |subject, words| format!(
        "the layer misses {:.0} % of displacement_{component}, which is not that of an elastic layer",
        100.0 * deviation
    );

    /// The displacements do not determine the decay length of the coupling.
    "undetermined-decay-length" UndeterminedDecayLength {
        /// `x` or `y`.
        component: &'static str,
        /// `along` or `across` rolling.
        direction: &'static str,
    } CALIBRATION, |subject, words| format!(
        "displacement_{component} does not determine the coupling {direction} rolling: its decay \
         length reached its search bound"
    );
}

/// A length in mm with six digits after the point at most.
pub(crate) fn millimetres(length: f64) -> f64 {
    (1e9 * length).round() / 1e6
}

impl Notice {
    /// What to know about a result that is about the first contact of a case only, besides the
    /// warnings of its solution.
    pub fn of_first_contact(case: &Case) -> Vec<Message> {
        let others = case.wheel.as_ref().and_then(|wheel| wheel.other_contacts());
        let of_wheel = others.map(|warning| warning.message(&FieldNames::CASE));
        case.notices.iter().cloned().chain(of_wheel).collect()
    }
}

impl From<Notice> for Message {
    fn from(notice: Notice) -> Self {
        notice.message(&FieldNames::CASE)
    }
}
