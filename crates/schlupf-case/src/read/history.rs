//! `[history]`.

use schlupf::problem::History;

use crate::error::CaseError;
use crate::fields::choice::StartChoice;
use crate::notice::Notice;
use crate::settings::Settings;
use crate::{FieldPath, tables};

const SERIES: [FieldPath; 11] = fields![
    "history.shifts_x",
    "history.shifts_y",
    "history.turns",
    "history.speed",
    "history.creepage_x",
    "history.creepage_y",
    "history.spin",
    "history.load",
    "history.force_x",
    "history.force_y",
    "history.moment_z",
];

const SHIFT: [FieldPath; 3] = fields!["history.shift_x", "history.shift_y", "history.turn"];

/// Whether a history starts with steady rolling.
pub fn starts_rolling(settings: &Settings) -> Result<bool, CaseError> {
    Ok(settings.chosen::<StartChoice>(field!("history.start"))? == StartChoice::Steady)
}

/// Values over time and shifts, where the case has them.
pub fn history(settings: &Settings) -> Result<Option<History>, CaseError> {
    let Some(mut history) = over_time(settings)? else { return Ok(None) };
    history.starts_rolling = starts_rolling(settings)?;
    let count = history.time.len();
    let tables = [&mut history.shift_x, &mut history.shift_y, &mut history.turn];
    for (table, path) in tables.into_iter().zip(SHIFT) {
        let at_start = |shift| {
            let mut shifts = vec![0.0; count];
            shifts[0] = shift;
            shifts
        };
        *table = settings.optional_number(path)?.map(at_start).or(table.take());
    }
    match tables::check_history(&history) {
        Ok(()) => Ok(Some(history)),
        Err((_, message)) => {
            Err(settings.error(field!("history.time"), format!("history.time: {message}")))
        }
    }
}

/// Values of a history's file that are far from what they are in almost all cases.
pub fn unusual(settings: &Settings, history: &History) -> Vec<Notice> {
    if !settings.is_given(field!("history.file")) {
        return Vec::new();
    }
    let place = settings.place(field!("history.file"));
    let History { shift_x, shift_y, turn, speed, creepage_x, creepage_y, spin, .. } = history;
    let History { load, force_x, force_y, moment_z, .. } = history;
    let series = [
        shift_x, shift_y, turn, speed, creepage_x, creepage_y, spin, load, force_x, force_y,
        moment_z,
    ];
    let unusual = |(path, values): (FieldPath, &Option<Vec<f64>>)| {
        Notice::of_unusual(path.field(), values.as_deref()?, &place)
    };
    SERIES.into_iter().zip(series).filter_map(unusual).collect()
}

fn over_time(settings: &Settings) -> Result<Option<History>, CaseError> {
    if settings.is_given(field!("history.file")) {
        let (name, bytes) = settings.read_file(field!("history.file"))?;
        return tables::history_from_csv(name, bytes).map(Some);
    }
    let is_shifted = settings.any_given(&SHIFT) || settings.any_given(&SERIES[..3]);
    let time = match settings.series(field!("history.time")) {
        Some(time) => time.to_vec(),
        // Shifts alone.
        None if is_shifted => {
            let rows =
                SERIES.iter().find_map(|path| settings.series(*path)).map_or(1, <[f64]>::len);
            vec![0.0; rows.max(1)]
        }
        None if settings.any_given(&SERIES) || starts_rolling(settings)? => {
            return settings.setting(field!("history.time")).map(|_| None);
        }
        None => return Ok(None),
    };
    inline(settings, time).map(Some)
}

fn inline(settings: &Settings, time: Vec<f64>) -> Result<History, CaseError> {
    for path in SERIES {
        let Some(series) = settings.series(path) else { continue };
        if series.len() != time.len() {
            let message = format!(
                "{path} must have as many entries as history.time, {}, but has {}",
                time.len(),
                series.len()
            );
            return Err(settings.error(path, message));
        }
    }
    let of = |path: FieldPath| settings.series(path).map(<[f64]>::to_vec);
    let [shift_x, shift_y, turn, speed, creepage_x, creepage_y, spin, load, x, y, z] =
        SERIES.map(of);
    let motion = History {
        time,
        shift_x,
        shift_y,
        turn,
        speed,
        creepage_x,
        creepage_y,
        spin,
        ..History::default()
    };
    Ok(History { load, force_x: x, force_y: y, moment_z: z, ..motion })
}
