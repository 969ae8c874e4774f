//! A fit to measured creep curves: JSON, CSV and a summary. The figure is among the figures.

mod figure;
mod json;
mod summary;

use schlupf::Status;
use schlupf::analysis::identification::{Component, Fit, FittedCurves, FittedPoint, Parameter};
use schlupf::reporting::{Column, Message, Record, Value, columns};

use crate::output::figures::{Drawing, FigureError};
use crate::output::number::significant;
use crate::output::report::{OwnFile, Report};
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues};

/// Name of the figure.
const FIGURE: &str = "fit";

/// A fit with its input.
#[derive(Debug, Clone)]
pub struct FitReport {
    /// Title of the case.
    pub title: String,
    /// Source of the data.
    pub data: String,
    /// Load of the case, in N: used for points without their own.
    pub load: f64,
    /// The fit.
    pub fit: Fit,
    /// The model between the points.
    pub curves: FittedCurves,
    /// γ and the resulting k_c (in 1/m), if the roughness was fitted.
    pub roughness: Option<FittedRoughness>,
    /// Names of the parameters, in the order of the estimates.
    pub names: Vec<String>,
    /// The case with the fitted values, if requested.
    pub case: Option<String>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// Results of a fitted roughness height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedRoughness {
    /// γ, dimensionless.
    pub gamma: f64,
    /// k_c, in 1/m.
    pub contact_stiffness: f64,
}

/// Measured and fitted forces, on the rail.
impl Record for FitReport {
    fn rows(&self) -> usize {
        self.fit.points.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { FitReport:
        CreepageX => |report, k| report.point(k).data.condition.kinematics.creepage_x,
        CreepageY => |report, k| report.point(k).data.condition.kinematics.creepage_y,
        Spin => |report, k| report.point(k).data.condition.kinematics.spin,
        Speed => |report, k| report.point(k).data.condition.kinematics.speed,
        Load => |report, k| report.load_of(report.point(k)),
        Component => |report, k| Value::Name(component(report.point(k).data.component)),
        ForceRatio => |report, k| report.point(k).data.force_ratio,
        FittedRatio "fitted" => |report, k| report.point(k).fitted,
        RatioResidual "residual" => |report, k| report.point(k).residual(),
        StandardDeviation => |report, k| report.point(k).data.standard_deviation,
    };
}

impl Report for FitReport {
    fn status(&self) -> Status {
        self.fit.status
    }

    fn warnings(&self) -> &[Message] {
        &self.warnings
    }

    fn json(&self) -> String {
        json::document(self)
    }

    fn summary(&self) -> Summary {
        summary::text(self)
    }

    fn csv(&self) -> Option<String> {
        let note = "forces on the rail over the load, residual = measured - fitted";
        Some(table::csv(self, note))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        vec![("points", table::columns(self))]
    }

    fn figure_names() -> Vec<String> {
        vec![FIGURE.to_owned()]
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        let svg = figure::draw(self).ok_or(FigureError::NoPoints)?;
        Ok(vec![(FIGURE.to_owned(), svg)])
    }

    fn own_files() -> &'static [OwnFile] {
        const {
            &[OwnFile::new(
                Self::CASE,
                "write-case",
                "Write the case with the fitted values, keeping comments and layout",
            )
            .part()]
        }
    }

    fn own_file(&self, format: &str) -> Option<Vec<u8>> {
        (format == Self::CASE).then(|| self.case.clone().map(String::into_bytes)).flatten()
    }
}

impl FitReport {
    /// Format of the case with the fitted values.
    pub const CASE: &str = "case";

    fn point(&self, k: usize) -> &FittedPoint {
        &self.fit.points[k]
    }

    /// Load of a point, in N.
    fn load_of(&self, point: &FittedPoint) -> f64 {
        point.data.condition.load.unwrap_or(self.load)
    }
}

/// Name of a component in results.
pub(crate) fn component(component: Component) -> &'static str {
    match component {
        Component::Longitudinal => "x",
        Component::Lateral => "y",
    }
}

/// A value and the half-width of its interval in the customary unit of the parameter.
pub(crate) fn in_usual_unit(parameter: Parameter, number: f64) -> (f64, &'static str) {
    match parameter {
        Parameter::Roughness => (number / 1e-6, "µm"),
        _ => (number, parameter.quantity().unit()),
    }
}

/// A value with the digits that its uncertainty justifies, and the uncertainty with two; the value
/// with six digits if its uncertainty is negligible.
pub(crate) fn with_uncertainty(value: f64, half_width: Option<f64>) -> [String; 2] {
    let is_large = |width: &f64| *width > 1e-5 * value.abs() && value != 0.0;
    let Some(half_width) = half_width.filter(is_large) else {
        return [six_digits(value), significant(half_width)];
    };
    // Decimal places of the second digit of the uncertainty.
    let last = half_width.abs().log10().floor() as i32 - 1;
    if value.abs() >= 1e5 {
        let exponent = value.abs().log10().floor() as i32;
        let scale = 10.0_f64.powi(exponent);
        let places = (exponent - last).clamp(0, 6) as usize;
        return [value, half_width].map(|number| format!("{:.places$}e{exponent}", number / scale));
    }
    let places = (-last).clamp(0, 12) as usize;
    let step = 10.0_f64.powi(last);
    [value, half_width].map(|number| format!("{:.places$}", (number / step).round() * step))
}

fn six_digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if (1e-4..1e6).contains(&rounded.abs()) || rounded == 0.0 {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::with_uncertainty;

    #[test]
    fn digits_follow_the_uncertainty() {
        let rows = [
            (0.330_236, 0.000_684, ["0.33024", "0.00068"]),
            (1853.087, 54.29, ["1853", "54"]),
            (1853.087, 5.429, ["1853.1", "5.4"]),
            (15_853.087, 542.9, ["15850", "540"]),
            (4.871_23e6, 1.234e5, ["4.87e6", "0.12e6"]),
            (0.33, 1e-9, ["0.33", "1e-9"]),
        ];
        for (value, half_width, expected) in rows {
            assert_eq!(with_uncertainty(value, Some(half_width)), expected);
        }
        assert_eq!(with_uncertainty(0.45, None), ["0.45", "n/a"]);
    }
}
