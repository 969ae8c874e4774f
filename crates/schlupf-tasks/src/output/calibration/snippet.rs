//! Stiffnesses as a section of a case file.

use schlupf::elasticity::elastic_layer::LayerStiffness;

use super::CalibrationReport;

/// `[elasticity]` with the stiffnesses to use; missing ones keep their defaults.
pub(super) fn snippet(report: &CalibrationReport) -> String {
    let mut lines = vec!["[elasticity]".to_owned(), "model = \"elastic-layer\"".to_owned()];
    if report.direct.is_none() && report.fitted.is_none() {
        lines.push("# for this patch what calibration = \"half-space\" is for any".to_owned());
    }
    let components = match report.best() {
        // If only displacements along y are known, those along x still need a value.
        [None, Some(y)] => {
            lines.push("# along x as along y, of which alone something is known".to_owned());
            [Some(y), Some(y)]
        }
        other => other,
    };
    for (component, stiffness) in ["x", "y"].into_iter().zip(components) {
        match stiffness {
            Some(stiffness) => lines.extend(assignments(component, &stiffness)),
            None => {
                lines.push("# along y as along x, of which alone something is known".to_owned());
            }
        }
    }
    lines.join("\n") + "\n"
}

fn assignments(component: &str, stiffness: &LayerStiffness) -> [String; 3] {
    let assignment = |field: &str, suffix: &str, value: f64, unit: &str| {
        format!("{field}_{component}{suffix} = \"{value:.4e} {unit}\"")
    };
    [
        assignment("bedding", "", stiffness.bedding, "N/m^3"),
        assignment("coupling", "", stiffness.coupling_along_x, "N/m"),
        assignment("coupling", "_across", stiffness.coupling_along_y, "N/m"),
    ]
}
