//! Stiffnesses of the elastic layer for the patch of a case.

use crate::output::calibration::{CalibrationReport, Direct, Fitted, FittedComponent, Layer};
use schlupf::analysis::calibration::displacements::{DisplacementFit, Sample, fit};
use schlupf::analysis::calibration::side_by_side::side_by_side;
use schlupf::analysis::calibration::{
    Calibration, CalibrationOptions, Deviation, calibrate, deviation_of_table,
};
use schlupf::bodies::Material;
use schlupf::elasticity::elastic_layer::LayerStiffness;
use schlupf::elasticity::{
    CalibratedLayer, Elasticity, HalfSpace, RelativeStiffness, tabulated_stiffness,
};
use schlupf::normal::{NormalContact, Pressure};
use schlupf::reporting::{CalibrationError, Message};
use schlupf::{Error, Quantity, Status, Warning, Watch};
use schlupf_case::{
    CaseErrors, CaseFile, DISPLACEMENT_COLUMNS, Displacements, InputFile, read_displacements,
};

use crate::request::{Kind, Rule, request};
use crate::task::{Found, Given, Task, Wanted};
use crate::{Notice, TaskError, messages};

request! {
    /// What to calibrate the layer to.
    Request {
        /// Calibrate for this very patch instead of interpolating the table, and compare both.
        direct: bool = Kind::flag();
        /// Displacements of a finite-element model to fit to (CSV with columns x, y, traction_x,
        /// displacement_x, …); several files count together.
        displacements: Vec<InputFile> = Kind::table(&DISPLACEMENT_COLUMNS);
        /// Cells across the patch on which layer and half-space are compared.
        cells: usize = Kind::count(10, 80), default(CalibrationOptions::default().cells);
        => &[Rule::Apart(&["displacements"], &["direct"])]
    }
}

/// `calibrate`: for the patch of the case; of a history that with the largest load.
pub struct Calibrate;

impl Task for Calibrate {
    const NAME: &'static str = "calibrate";
    const ABOUT: &'static str = "Determine the stiffnesses of the elastic layer: tabulated, \
                                 recalibrated, or fitted to displacements";
    type Request = Request;
    type Report = CalibrationReport;

    fn run(
        of: &Given,
        request: Request,
        wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<CalibrationReport>, TaskError> {
        let name = request.asked.name("displacements");
        let files = request.displacements.iter();
        let displacements = files.map(|file| read_displacements(&name, file));
        let displacements = displacements.collect::<Result<Vec<_>, _>>()?;
        let patch = Patch::of(of.case, watch)?;
        let report = patch.report(&request, &displacements, wanted.figures, watch);
        let report = report.map_err(|error| {
            let names: Vec<&str> = displacements.iter().map(|file| file.name.as_str()).collect();
            let sources = matches!(
                error,
                Error::Calibration { error: CalibrationError::UnlikeALayer { .. } }
            )
            .then(|| format!("the displacements are those of {}", names.join(", ")));
            of.case.explain(&error).help(sources)
        })?;
        Ok(report.into())
    }
}

/// What the stiffnesses are for.
#[derive(Debug)]
struct Patch {
    title: String,
    normal: NormalContact,
    /// Of wheel and rail.
    materials: [Material; 2],
    bodies: HalfSpace,
    axis_ratio: f64,
    /// √(ab), in m.
    size: f64,
    max_iterations: usize,
    /// Whatever there is to know about the case.
    notices: Vec<Message>,
}

impl Patch {
    /// That of the case; of a history that with the largest load.
    fn of(case: &CaseFile, watch: Watch) -> Result<Self, CaseErrors> {
        let normal = case.normal_contact(watch)?;
        let materials = case.materials();
        let bodies = HalfSpace::new(&materials[0], &materials[1]);
        let bodies = bodies.map_err(|error| case.explain(&error))?;
        let [a, b] = normal.summary.semi_axes();
        Ok(Self {
            title: case.title()?,
            normal,
            materials,
            bodies,
            axis_ratio: a / b,
            size: (a * b).sqrt(),
            max_iterations: case.options()?.max_iterations,
            notices: case.notices(),
        })
    }

    /// The stiffnesses; with the forces and tractions of all models, which the figure shows, if
    /// they are wanted.
    fn report(
        &self,
        request: &Request,
        displacements: &[Displacements],
        with_sides: bool,
        watch: Watch,
    ) -> Result<CalibrationReport, Error> {
        let options =
            CalibrationOptions { cells: request.cells, max_iterations: self.max_iterations };
        let ratios = (self.axis_ratio, self.bodies.poisson_ratio());
        let [wheel, rail] = &self.materials;
        let mut warnings = self.warnings(&CalibratedLayer::new(wheel, rail, None)?);
        let needs_no_table = request.direct || !displacements.is_empty();
        let tabulated = match tabulated_stiffness(ratios.0, ratios.1) {
            Ok(stiffness) => Some(stiffness),
            Err(error) if needs_no_table => {
                warnings.push(Notice::NoTable { error }.into());
                None
            }
            Err(error) => return Err(error),
        };
        let deviation = tabulated
            .filter(|_| displacements.is_empty())
            .map(|_| deviation_of_table(ratios.0, ratios.1, &options, watch))
            .transpose()?;
        let direct = request.direct.then(|| calibrate(ratios.0, ratios.1, &options, watch));
        let direct = direct.transpose()?;
        let fitted = fitted(displacements)?;
        let exact = tabulated.map(|stiffness| self.layer(stiffness, None).stiffness);
        let doubts = fitted.iter().flat_map(|fitted| doubts(fitted, exact));
        warnings.extend(doubts.map(Message::from));
        let mut converged = direct.is_none_or(|direct| direct.converged)
            && fitted.iter().flat_map(components).all(|component| component.fit.converged);
        let mut sides = None;
        if with_sides && displacements.is_empty() {
            let stiffness = direct.map(|direct| direct.stiffness).or(tabulated);
            if let Some(stiffness) = stiffness {
                let found = side_by_side(ratios.0, ratios.1, stiffness, watch)?;
                converged &= found.is_converged();
                sides = Some(found);
            }
        }
        Ok(CalibrationReport {
            title: self.title.clone(),
            normal: self.normal.summary,
            shear_modulus: self.bodies.shear_modulus(),
            poisson_ratio: ratios.1,
            tabulated: tabulated.map(|stiffness| self.layer(stiffness, deviation)),
            direct: direct.map(|direct| self.direct(&direct)),
            fitted,
            warnings,
            sides,
            status: if converged { Status::Converged } else { Status::NotConverged },
        })
    }

    fn warnings(&self, layer: &CalibratedLayer) -> Vec<Message> {
        let of_parts = layer.caveat_of_parts(self.normal.summary.parts);
        let is_elliptic = matches!(self.normal.pressure, Pressure::Elliptic);
        let of_shape =
            (!is_elliptic && of_parts.is_none()).then_some(Warning::EquivalentEllipse {});
        let warnings: Vec<Warning> =
            of_parts.into_iter().chain(of_shape).chain(self.bodies.caveat()).collect();
        self.notices.iter().cloned().chain(messages(&warnings)).collect()
    }

    fn layer(&self, stiffness: [RelativeStiffness; 2], deviation: Option<Deviation>) -> Layer {
        let absolute =
            |relative: RelativeStiffness| relative.absolute(self.bodies.shear_modulus(), self.size);
        Layer { stiffness: stiffness.map(absolute), deviation }
    }

    fn direct(&self, found: &Calibration) -> Direct {
        let bed = found.winkler_bedding.map(|bedding| RelativeStiffness {
            bedding,
            reach_along_x: 0.0,
            reach_along_y: 0.0,
        });
        Direct {
            layer: self.layer(found.stiffness, Some(found.layer)),
            uncoupled: self.layer(bed, Some(found.winkler)),
        }
    }
}

/// Each component is fitted to all files that load it.
fn fitted(displacements: &[Displacements]) -> Result<Option<Fitted>, Error> {
    if displacements.is_empty() {
        return Ok(None);
    }
    let component = |k: usize| {
        let loaded =
            displacements.iter().filter_map(|file| Some((file, file.samples[k].as_ref()?)));
        let (files, samples): (Vec<&Displacements>, Vec<&Sample>) = loaded.unzip();
        if samples.is_empty() {
            return Ok(None);
        }
        let samples: Vec<Sample> = samples.into_iter().cloned().collect();
        let files: Vec<String> = files.into_iter().map(|file| file.name.clone()).collect();
        let fit = fit(&samples)?;
        if fit.largest_deviation() > UNLIKE {
            return Err(unlike(&fit, k));
        }
        Ok(Some(FittedComponent { fit, files }))
    };
    Ok(Some(Fitted { components: [component(0)?, component(1)?] }))
}

/// Part of given displacements that a layer may miss before a warning, and before they are refused.
const FAR: f64 = 0.15;
const UNLIKE: f64 = 0.5;

/// Bedding over that of the bodies' half-spaces, or the inverse, from which on there is a warning.
const FOREIGN: f64 = 30.0;

/// An error that no layer has such displacements.
fn unlike(fit: &DisplacementFit, component: usize) -> Error {
    let quantity = [Quantity::DisplacementX, Quantity::DisplacementY][component];
    CalibrationError::UnlikeALayer { quantity, deviation: fit.largest_deviation() }.into()
}

/// What to know about fits to displacements; `exact` is the layer that is like the half-space.
fn doubts(fitted: &Fitted, exact: Option<[LayerStiffness; 2]>) -> Vec<Notice> {
    let mut doubts = Vec::new();
    let components = ["x", "y"].into_iter().zip(&fitted.components).enumerate();
    for (k, (component, fitted)) in components {
        let Some(FittedComponent { fit, .. }) = fitted else { continue };
        if let Some(ratio) = exact.map(|exact| fit.bedding / exact[k].bedding)
            && !(FOREIGN.recip()..FOREIGN).contains(&ratio)
        {
            doubts.push(Notice::UnlikelyBedding { component, ratio });
        }
        let deviation = fit.largest_deviation();
        if deviation > FAR {
            doubts.push(Notice::PoorLayerFit { component, deviation });
        }
        let directions = ["along", "across"].into_iter().zip(fit.is_open);
        let open = directions.filter(|(_, is_open)| *is_open);
        doubts.extend(
            open.map(|(direction, _)| Notice::UndeterminedDecayLength { component, direction }),
        );
    }
    doubts
}

fn components(fitted: &Fitted) -> impl Iterator<Item = &FittedComponent> {
    fitted.components.iter().flatten()
}
