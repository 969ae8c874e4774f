//! `[history]`.

use schlupf::problem::History;

use crate::error::CaseError;
use crate::notice::Notice;
use crate::settings::Settings;
use crate::{FieldPath, tables};

const SERIES: [FieldPath; 8] = fields![
    "history.speed",
    "history.creepage_x",
    "history.creepage_y",
    "history.spin",
    "history.load",
    "history.force_x",
    "history.force_y",
    "history.moment_z",
];

/// Values over time and the shift before them, where the case has them.
pub fn history(settings: &Settings) -> Result<Option<History>, CaseError> {
    let [x, y] =
        fields!["history.shift_x", "history.shift_y"].map(|path| settings.optional_number(path));
    let (x, y) = (x?, y?);
    let shift = x.or(y).map(|_| [x.unwrap_or(0.0), y.unwrap_or(0.0)]);
    let over_time = over_time(settings)?;
    if over_time.is_none() && shift.is_none() {
        return Ok(None);
    }
    Ok(Some(History { shift, ..over_time.unwrap_or_default() }))
}

/// Values of a history's file that are far from what they are in almost all cases.
pub fn unusual(settings: &Settings, history: &History) -> Vec<Notice> {
    if !settings.is_given(field!("history.file")) {
        return Vec::new();
    }
    let place = settings.place(field!("history.file"));
    let History { speed, creepage_x, creepage_y, spin, load, force_x, force_y, moment_z, .. } =
        history;
    let series = [speed, creepage_x, creepage_y, spin, load, force_x, force_y, moment_z];
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
    let Some(time) = settings.series(field!("history.time")) else {
        return if settings.any_given(&SERIES) {
            settings.setting(field!("history.time")).map(|_| None)
        } else {
            Ok(None)
        };
    };
    inline(settings, time).map(Some)
}

fn inline(settings: &Settings, time: &[f64]) -> Result<History, CaseError> {
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
    let [speed, creepage_x, creepage_y, spin, load, force_x, force_y, moment_z] =
        SERIES.map(|path| settings.series(path).map(<[f64]>::to_vec));
    let (shift, time) = (None, time.to_vec());
    let motion = History { shift, time, speed, creepage_x, creepage_y, spin, ..History::default() };
    let history = History { load, force_x, force_y, moment_z, ..motion };
    match tables::check_history(&history) {
        Ok(()) => Ok(history),
        Err((_, message)) => {
            Err(settings.error(field!("history.time"), format!("history.time: {message}")))
        }
    }
}
