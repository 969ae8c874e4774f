//! k_c of a case as results show it.

use crate::output::contact_law::{ContactLaw, Fit, Origin};
use schlupf_case::{Case, StiffnessOrigin};

/// k_c and where it comes from.
pub fn of(case: &Case) -> ContactLaw {
    let stiffness = case.law_stiffness.stiffness;
    let plain =
        |from| ContactLaw { stiffness, from, rms_height: None, slope_factor: None, fit: None };
    match &case.law_stiffness.origin {
        StiffnessOrigin::Given if stiffness.is_infinite() => plain(Origin::Coulomb),
        StiffnessOrigin::Given => plain(Origin::Given),
        StiffnessOrigin::Default => plain(Origin::Default),
        StiffnessOrigin::ClosedForm { rms_height, slope_factor } => ContactLaw {
            rms_height: Some(*rms_height),
            slope_factor: Some(*slope_factor),
            ..plain(Origin::ClosedForm)
        },
        StiffnessOrigin::MicroModel(micro) => {
            let result = &micro.result;
            let found = &result.stiffness;
            ContactLaw {
                rms_height: Some(result.statistics.root_mean_square_height),
                slope_factor: result.gamma,
                fit: Some(Fit {
                    mean_pressures: found.mean_pressures.clone(),
                    stiffnesses: found.fits.iter().map(|fit| fit.stiffness).collect(),
                    spread: found.spread,
                    root_mean_square_error: found.common.root_mean_square_error,
                    largest_error: found.common.largest_error,
                    closed_form: result.closed_form,
                }),
                ..plain(Origin::MicroModel)
            }
        }
    }
}
