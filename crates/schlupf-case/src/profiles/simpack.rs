//! Simpack's profiles, `.prr` and `.prw`.
//!
//! Sections `header` and `spline`, in the latter a list of points between `point.begin` and
//! `point.end`: y, z and a weight. What changes the points is done in Simpack's order: shift,
//! bounds, mirrors, inversion of the order; a length in the file over `units.len.f` is in metres.

use super::points::File;
use crate::error::CaseError;

/// Where a file may be recognised.
const BEGIN: &str = "spline.begin";

/// Whether a file is one of Simpack's.
pub fn is_one(file: &File) -> bool {
    file.lines(&['!']).any(|(_, line)| line.eq_ignore_ascii_case(BEGIN))
}

/// What is done with the points.
struct Changes {
    shift: [f64; 2],
    /// Lower and upper bounds of y and z; without effect unless the lower one is below the upper.
    bounds: [[f64; 2]; 2],
    is_mirrored: [bool; 2],
    is_inverted: bool,
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
            is_inverted: false,
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
            "inversion" => self.is_inverted = number()? != 0.0,
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

    fn apply(&self, points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        let [across, up] = self.bounds;
        let is_bound = |[low, high]: [f64; 2]| low < high;
        let mut points: Vec<[f64; 2]> = points
            .into_iter()
            .map(|[y, z]| [y + self.shift[0], z + self.shift[1]])
            .filter(|[y, _]| !is_bound(across) || (across[0]..=across[1]).contains(y))
            .map(|[y, z]| [y, if is_bound(up) { z.clamp(up[0], up[1]) } else { z }])
            .map(|point| {
                [0, 1].map(|k| if self.is_mirrored[k] { -point[k] } else { point[k] } / self.unit)
            })
            .collect();
        if self.is_inverted {
            points.reverse();
        }
        points
    }
}

/// The points of a file, in m.
pub fn read(file: &File) -> Result<Vec<[f64; 2]>, CaseError> {
    let mut changes = Changes::default();
    let mut points = Vec::new();
    let (mut is_spline, mut is_point) = (false, false);
    for (number, line) in file.lines(&['!']).filter(|(_, line)| !line.is_empty()) {
        match line.to_ascii_lowercase().as_str() {
            BEGIN => is_spline = true,
            "spline.end" => is_spline = false,
            "point.begin" if is_spline => is_point = true,
            "point.end" => is_point = false,
            _ if is_point => match file.numbers(number, line)?[..] {
                [y, z] | [y, z, _] => points.push([y, z]),
                ref numbers => {
                    let message = format!(
                        "a point must have y, z and at most a weight, but has {} numbers",
                        numbers.len()
                    );
                    return Err(file.error(number, message));
                }
            },
            _ if is_spline => {
                if let Some((key, value)) = line.split_once('=') {
                    changes.set(file, number, &key.trim().to_ascii_lowercase(), value.trim())?;
                }
            }
            _ => {}
        }
    }
    if points.is_empty() {
        let message = "a Simpack profile must have points between point.begin and point.end in \
                       spline.begin, but has none";
        return Err(file.error_of_all(message));
    }
    Ok(changes.apply(points))
}
