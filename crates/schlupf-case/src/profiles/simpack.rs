//! Simpack's profiles, `.prr` and `.prw`.
//!
//! Sections `header` and `spline`, in the latter a list of points between `point.begin` and
//! `point.end`: y, z and a weight. What changes the points is done in Simpack's order: least
//! distance, shift, bounds, mirrors; a length in the file over `units.len.f` is in metres. The
//! inversion of the order changes nothing here. y then points outwards and z down. Comments begin
//! with `!` or `%`.

use super::points::{Axes, Content, File, Row, Separator};
use crate::error::CaseError;

/// Where a file may be recognised.
const BEGIN: &str = "spline.begin";

const COMMENTS: &[char] = &['!', '%'];

/// Whether a file is one of Simpack's.
pub fn is_one(file: &File) -> bool {
    file.lines(COMMENTS).any(|(_, line)| line.eq_ignore_ascii_case(BEGIN))
}

/// What is done with the points.
struct Changes {
    shift: [f64; 2],
    /// Lower and upper bounds of y and z; without effect unless the lower one is below the upper.
    bounds: [[f64; 2]; 2],
    is_mirrored: [bool; 2],
    /// Points that are closer to the one before are left out.
    least_distance: f64,
    /// Simpack smooths with it.
    smoothing: f64,
    /// User's length over the metre.
    unit: f64,
}

impl Default for Changes {
    /// Millimetres.
    fn default() -> Self {
        Self {
            shift: [0.0; 2],
            bounds: [[1.0, 0.0]; 2],
            is_mirrored: [false; 2],
            least_distance: 0.0,
            smoothing: 0.0,
            unit: 1e3,
        }
    }
}

impl Changes {
    fn set(&mut self, file: &File, line: usize, key: &str, value: &str) -> Result<(), CaseError> {
        let number = || file.number(line, value);
        match key {
            "shift.y" => self.shift[0] = number()?,
            "shift.z" => self.shift[1] = number()?,
            "bound.y.min" => self.bounds[0][0] = number()?,
            "bound.y.max" => self.bounds[0][1] = number()?,
            "bound.z.min" => self.bounds[1][0] = number()?,
            "bound.z.max" => self.bounds[1][1] = number()?,
            "mirror.y" => self.is_mirrored[0] = number()? != 0.0,
            "mirror.z" => self.is_mirrored[1] = number()? != 0.0,
            "point.dist.min" => self.least_distance = number()?,
            "approx.smooth" => self.smoothing = number()?,
            "units.len.f" => {
                self.unit = number()?;
                if self.unit <= 0.0 {
                    return Err(file.error(line, format!("{key} must be positive, but is {value}")));
                }
            }
            "rotate" if number()? != 0.0 => {
                return Err(file.error(line, format!("{key} must be 0, but is {value}")));
            }
            _ => {}
        }
        Ok(())
    }

    fn apply(&self, rows: Vec<Row>) -> Vec<Row> {
        let [across, up] = self.bounds;
        let is_bound = |[low, high]: [f64; 2]| low < high;
        let mut kept: Vec<Row> = Vec::with_capacity(rows.len());
        for row in rows {
            let is_apart = |last: &Row| {
                let [y, z] = [0, 1].map(|k| row.place[k] - last.place[k]);
                y.hypot(z) >= self.least_distance
            };
            if kept.last().is_none_or(is_apart) {
                kept.push(row);
            }
        }
        kept.into_iter()
            .map(|row| Row { place: [0, 1].map(|k| row.place[k] + self.shift[k]), ..row })
            .filter(|row| !is_bound(across) || (across[0]..=across[1]).contains(&row.place[0]))
            .map(|row| {
                let [y, z] = row.place;
                let place = [y, if is_bound(up) { z.clamp(up[0], up[1]) } else { z }];
                let mirrored = |k: usize| if self.is_mirrored[k] { -place[k] } else { place[k] };
                Row { place: [0, 1].map(|k| mirrored(k) / self.unit), ..row }
            })
            .collect()
    }

    /// What is not applied.
    fn left_out(&self) -> Vec<String> {
        let smooths = self.smoothing > 0.0;
        let smoothing = format!(
            "approx.smooth = {}: Simpack smooths with it, here profile_smoothing does",
            self.smoothing
        );
        smooths.then_some(smoothing).into_iter().collect()
    }
}

/// The points of a file.
pub fn read(file: &File, is_wheel: bool) -> Result<Content, CaseError> {
    let mut changes = Changes::default();
    let mut rows: Vec<(usize, &str)> = Vec::new();
    let (mut is_header, mut is_spline, mut is_point) = (false, false, false);
    for (number, line) in file.lines(COMMENTS).filter(|(_, line)| !line.is_empty()) {
        match line.to_ascii_lowercase().as_str() {
            "header.begin" => is_header = true,
            "header.end" => is_header = false,
            BEGIN => {
                if !rows.is_empty() {
                    let message = "a file must have one profile, but another one begins here";
                    return Err(file.error(number, message));
                }
                is_spline = true;
            }
            "spline.end" => is_spline = false,
            "point.begin" if is_spline => is_point = true,
            "point.end" => is_point = false,
            _ if is_point => rows.push((number, line)),
            _ => {
                let Some((key, value)) = line.split_once('=') else { continue };
                let (key, value) = (key.trim().to_ascii_lowercase(), value.trim());
                if is_spline {
                    changes.set(file, number, &key, value)?;
                } else if is_header && key == "type" {
                    let is = file.number(number, value)? != 0.0;
                    file.check_body([is, is_wheel], number, &format!("type is {value}"))?;
                }
            }
        }
    }
    if rows.is_empty() {
        let message = "a Simpack profile must have points between point.begin and point.end in \
                       spline.begin, but has none";
        return Err(file.error_of_all(message));
    }
    let texts = rows.iter().map(|(_, text)| *text);
    let separator = Separator::of(&texts);
    let points: Result<Vec<Row>, CaseError> =
        rows.iter().map(|(line, text)| point(file, *line, &separator.cells(text, 2))).collect();
    Ok(Content {
        axes: Axes { is_inwards: Some(false), is_down: Some(true) },
        left_out: changes.left_out(),
        ..Content::of(format!("Simpack{}", separator.remark(texts)), changes.apply(points?))
    })
}

/// The point of a row, in the unit of the file.
fn point(file: &File, line: usize, cells: &[&str]) -> Result<Row, CaseError> {
    let numbers: Result<Vec<f64>, CaseError> =
        cells.iter().map(|cell| file.number(line, cell)).collect();
    let ([y, z] | [y, z, _]) = numbers?[..] else {
        let count = cells.len();
        let message =
            format!("a point must have y, z and at most a weight, but has {count} numbers");
        return Err(file.error(line, message));
    };
    Ok(Row { place: [y, z], line })
}
