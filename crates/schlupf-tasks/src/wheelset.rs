//! The contacts of a wheelset over its lateral position.

use crate::output::wheelset::{Conicity, WheelsetAt, WheelsetReport};
use schlupf::Watch;
use schlupf::analysis::creep_curve::MAX_POINTS;
use schlupf::numerics::parallel;
use schlupf::reporting::{Message, Tallied, Tally};
use schlupf::wheel_rail::{Roll, RollingRadiusDifference, Support, WheelSolution};
use schlupf_case::{
    CaseError, CaseErrors, CaseFile, Cause, FieldNames, FieldPath, Place, Points, field,
};

use crate::notice::{Notice, millimetres};
use crate::request::{Kind, request};
use crate::solve::of_wheel;
use crate::task::{CaseArgument, Found, Given, Task, Wanted};
use crate::{TaskError, messages};

/// Amplitudes of the equivalent conicity: the first, the last unless positions go further, and
/// their number in a metre.
const FIRST_AMPLITUDE: f64 = 1e-3;
const LAST_AMPLITUDE: f64 = 6e-3;
const AMPLITUDES: f64 = 1e4;

/// Number of positions in a range.
const POINTS: usize = 33;

const LATERAL: FieldPath = field!("wheelset.lateral_position");

/// Step of the positions from which it is found, in m.
const RADIUS_STEP: f64 = 2e-5;

request! {
    /// Where to put the wheelset.
    Request {
        /// Lateral positions of the wheelset: the first and the last, or each of them.
        lateral_position: Points = Kind::points(LATERAL), default("-8..8 mm");
        /// Number of positions in a range; by default 33.
        points: Option<usize> = Kind::count(2, MAX_POINTS);
    }
}

/// `wheelset`.
pub struct Wheelset;

impl Task for Wheelset {
    const NAME: &'static str = "wheelset";
    const ABOUT: &'static str =
        "Find the contacts of a wheelset over its lateral position, and its equivalent conicity";
    const CASE: CaseArgument =
        CaseArgument::Positional("with normal.model = \"wheel-rail\" and both profiles");
    type Request = Request;
    type Report = WheelsetReport;

    /// A position at which the contacts are not found is one without wheels.
    fn run(
        of: &Given,
        request: Request,
        _wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<WheelsetReport>, TaskError> {
        if let Points::Each(_) = request.lateral_position {
            request.asked.check_range("lateral_position", &["points"])?;
        }
        let Support::Force(load) = of.case.wheel()?.support else {
            return Err(TaskError::Request(
                "wheelset.height must be left out for the contacts of a wheelset that rests on both \
                 rails: give normal.load"
                    .to_owned(),
            ));
        };
        if of.case.has_history() {
            return Err(TaskError::Request(
                "history.time must be left out for the contacts of a wheelset, which are those of \
                 steady rolling"
                    .to_owned(),
            ));
        }
        Ok(report(of.case, &request, load, watch)?.into())
    }
}

/// All contacts of a wheelset whose wheels carry a load (in N) each.
fn report(
    file: &CaseFile,
    request: &Request,
    load: f64,
    watch: Watch,
) -> Result<WheelsetReport, TaskError> {
    let [from, to] = request.lateral_position.ends();
    let (radii, conicity, mut notices) = rigid(file, from.abs().max(to.abs()), watch)?;
    let lateral = request.lateral_position.evenly(request.points.unwrap_or(POINTS));
    let found = parallel::try_map(lateral, |lateral| match wheels(file, lateral, watch) {
        Err(error) if is_stopped(&error) => Err(error),
        wheels => Ok((lateral, wheels)),
    })?;
    let is_empty = radii.is_none() && found.iter().all(|(_, wheels)| wheels.is_err());
    if let Some((lateral, Err(error))) = found.first().filter(|_| is_empty) {
        return Err(at_position(file, error.clone(), *lateral).into());
    }
    let mut positions = Vec::new();
    for (lateral, wheels) in found {
        let wheels = wheels.map_err(|errors| errors.first.message);
        if let Err(reason) = &wheels {
            let reason = reason.clone();
            notices.push(Notice::PositionFailed { lateral, reason }.into());
        }
        let rigid = radii.as_ref().and_then(|radii| radii.at(lateral));
        positions.push(WheelsetAt { lateral, rigid, wheels });
    }
    let warnings =
        file.notices().into_iter().chain(of_positions(&positions)).chain(notices).collect();
    let (title, pairs) = (file.title()?, file.wheel()?.pairs.clone());
    Ok(WheelsetReport { title, pairs, load, positions, radii, conicity, warnings })
}

/// Both wheels at a lateral position (in m).
fn wheels(file: &CaseFile, lateral: f64, watch: Watch) -> Result<[WheelSolution; 2], CaseErrors> {
    let wheels = file.wheels_at(lateral, watch)?;
    let two = <[WheelSolution; 2]>::try_from(wheels);
    two.map_err(|_| {
        let place = Place::File { name: file.name().to_owned() };
        CaseError::new("wheelset", "the wheelset must have two wheels", place).into()
    })
}

/// An error with the lateral position (in m) at which it arose; that of the case is not used.
fn at_position(file: &CaseFile, mut errors: CaseErrors, lateral: f64) -> CaseErrors {
    let CaseError { field, message, place, .. } = &mut *errors.first;
    *message = format!("at a lateral position of {} mm: {message}", millimetres(lateral));
    if *field == *LATERAL {
        *place = Place::File { name: file.name().to_owned() };
    }
    errors
}

fn is_stopped(errors: &CaseErrors) -> bool {
    errors.first.cause == Cause::Stopped
}

/// Δr of rigid bodies as in EN 15302, without roll, up to a lateral position (in m) at least, the
/// equivalent conicity that follows, and what to know about both.
fn rigid(
    file: &CaseFile,
    largest: f64,
    watch: Watch,
) -> Result<(Option<RollingRadiusDifference>, Conicity, Vec<Message>), TaskError> {
    let pairs = &file.wheel()?.pairs;
    let last = largest.max(LAST_AMPLITUDE);
    // The motion of unequal wheels is not about the middle of the track.
    let wanted = if pairs.are_one() { last } else { 2.0 * last };
    let intervals = (wanted / RADIUS_STEP).ceil() as usize;
    let ends = |largest: f64, error: &schlupf::Error| {
        let reason = error.text(&FieldNames::CASE);
        Message::from(Notice::ConicityEnds { largest, reason })
    };
    let explain = |error: &schlupf::Error| CaseErrors::from(file.explain(error));
    let radii = RollingRadiusDifference::new(pairs, (wanted, intervals), Roll::Neglected, watch);
    let radii = match radii {
        Ok(radii) => radii,
        Err(error) if is_stopped(&explain(&error)) => return Err(explain(&error).into()),
        Err(error) => return Ok((None, Conicity::default(), vec![ends(0.0, &error)])),
    };
    let reach = radii.reach().min(last);
    let conicity = conicity(&radii, reach).map_err(|error| explain(&error))?;
    let mut notices = Vec::new();
    if let Some(error) = radii.end.as_ref().filter(|_| reach < last) {
        notices.push(ends(conicity.amplitude.last().copied().unwrap_or(0.0), error));
    }
    let unknown = conicity.amplitude.iter().zip(&conicity.nonlinear);
    let unknown: Vec<f64> = unknown
        .filter(|(_, conicity)| conicity.is_none())
        .map(|(amplitude, _)| *amplitude)
        .collect();
    if let (Some(first), Some(last)) = (unknown.first(), unknown.last()) {
        notices.push(Notice::NoPeriodicMotion { amplitudes: [*first, *last] }.into());
    }
    Ok((Some(radii), conicity, notices))
}

/// Both equivalent conicities at amplitudes up to the largest (in m).
fn conicity(radii: &RollingRadiusDifference, largest: f64) -> Result<Conicity, schlupf::Error> {
    let first = (FIRST_AMPLITUDE * AMPLITUDES).round() as usize;
    let last = (largest * AMPLITUDES + 1e-6).floor() as usize;
    let amplitude: Vec<f64> = (first..=last).map(|k| k as f64 / AMPLITUDES).collect();
    // Rounding must not take the last one beyond the positions.
    let within = || amplitude.iter().map(|amplitude| amplitude.min(largest));
    let nonlinear = within().map(|a| radii.equivalent_conicity(a)).collect::<Result<_, _>>()?;
    let harmonic = within().map(|a| radii.harmonic_conicity(a)).collect::<Result<_, _>>()?;
    Ok(Conicity { amplitude, nonlinear, harmonic })
}

/// What to know about the contacts: of each kind of message the worst one with its place, and how
/// many there are.
fn of_positions(positions: &[WheelsetAt]) -> impl Iterator<Item = Message> {
    let mut found = Tally::default();
    for at in positions {
        for wheel in at.wheels.iter().flatten() {
            let first = wheel.contacts.first().into_iter();
            let first = first.flat_map(|contact| messages(&contact.solution.warnings));
            for message in first.chain(of_wheel(wheel)) {
                found.note(message, (at.lateral, wheel.side.name()));
            }
        }
    }
    let message = |kind: Tallied<Message, (f64, &str)>| {
        let (lateral, side) = kind.place;
        kind.message(&format!("{side} wheel at {} mm", millimetres(lateral)), "place")
    };
    found.into_iter().map(message)
}
