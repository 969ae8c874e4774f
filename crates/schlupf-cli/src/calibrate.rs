//! `schlupf calibrate`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use schlupf::calibration::displacements::{DisplacementFit, Sample, fit};
use schlupf::calibration::side_by_side::side_by_side;
use schlupf::calibration::{Calibration, CalibrationOptions, calibrate, deviation_of_table};
use schlupf::elasticity::Elasticity;
use schlupf::elasticity::calibrated_layer::{
    CalibratedLayer, RelativeStiffness, tabulated_stiffness,
};
use schlupf::elasticity::elastic_layer::LayerStiffness;
use schlupf::elasticity::half_space::HalfSpace;
use schlupf::history::History;
use schlupf::normal::{NormalContact, Pressure};
use schlupf::{Error, Status, Watch};
use schlupf_case::{Case, CaseErrors, Displacements, read_displacements};
use schlupf_output::calibration::{Anew, Fitted, FittedComponent, Layer, Report, json, summary};
use schlupf_output::figures::{self, Figure};

use crate::arguments::CalibrateArguments;
use crate::commands::read_case;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::outputs::{self, Input};
use crate::progress::Progress;
use crate::report;
use crate::solve::figure_files;

const DISPLACEMENTS: &str = "--displacements";

/// Finds stiffnesses for the patch of a case and writes them.
pub fn run(arguments: &CalibrateArguments) -> Result<ExitCode, Failure> {
    let case = read_case(&arguments.case)?;
    check_outputs(arguments, &case)?;
    let displacements = arguments
        .displacements
        .iter()
        .map(|path| read_displacements(DISPLACEMENTS, path).map_err(CaseErrors::from))
        .collect::<Result<Vec<_>, _>>()?;
    let progress = Progress::start();
    progress.stage("calibrating");
    let explain = |error: Error| Failure::Case(case.explain(&error).into());
    let patch = Patch::of(&case).map_err(explain)?;
    let found = patch.report(arguments, &displacements, &case, &progress.watch());
    let (report, figure) = found.map_err(explain)?;
    let figure = figure.transpose()?;
    drop(progress);
    write(arguments, &report, figure)?;
    match report.status {
        Status::Converged => Ok(ExitCode::SUCCESS),
        Status::NotConverged => {
            report::warn("not converged: the stiffnesses are those of the last step");
            Ok(ExitCode::from(NOT_CONVERGED))
        }
    }
}

/// What the stiffnesses are for.
struct Patch {
    normal: NormalContact,
    bodies: HalfSpace,
    axis_ratio: f64,
    /// √(ab), in m.
    size: f64,
}

type Figured = Option<Result<Figure, figures::FigureError>>;

impl Patch {
    /// That of the case; of a history that with the largest load.
    fn of(case: &Case) -> Result<Self, Error> {
        let problem = &case.problem;
        let load = case.history.as_ref().and_then(History::largest_load);
        let normal = problem.normal.normal_contact(load)?;
        let bodies = HalfSpace::new(&problem.wheel.material, &problem.rail.material)?;
        let [a, b] = [normal.summary.semi_axis_x, normal.summary.semi_axis_y];
        Ok(Self { normal, bodies, axis_ratio: a / b, size: (a * b).sqrt() })
    }

    fn report(
        &self,
        arguments: &CalibrateArguments,
        displacements: &[Displacements],
        case: &Case,
        watch: Watch,
    ) -> Result<(Report, Figured), Error> {
        let options = CalibrationOptions {
            cells: arguments.cells,
            max_iterations: case.options.max_iterations,
        };
        let ratios = (self.axis_ratio, self.bodies.poisson_ratio());
        let [wheel, rail] = [&case.problem.wheel, &case.problem.rail].map(|body| &body.material);
        let mut warnings = self.warnings(case, &CalibratedLayer::new(wheel, rail, None)?);
        let needs_no_table = arguments.anew || !displacements.is_empty();
        let tabulated = match tabulated_stiffness(ratios.0, ratios.1) {
            Ok(stiffness) => Some(stiffness),
            Err(error) if needs_no_table => {
                warnings.push(error.to_string());
                None
            }
            Err(error) => return Err(error),
        };
        let deviation = tabulated
            .filter(|_| displacements.is_empty())
            .map(|_| deviation_of_table(ratios.0, ratios.1, &options, watch))
            .transpose()?;
        let anew = arguments.anew.then(|| calibrate(ratios.0, ratios.1, &options, watch));
        let anew = anew.transpose()?;
        let fitted = fitted(displacements)?;
        let exact = tabulated.map(|stiffness| self.layer(stiffness, None).stiffness);
        warnings.extend(fitted.iter().flat_map(|fitted| doubts(fitted, exact)));
        let mut converged = anew.is_none_or(|anew| anew.converged)
            && fitted.iter().flat_map(components).all(|component| component.fit.converged);
        let mut figure = None;
        if arguments.figures.is_some() {
            let stiffness = anew.map(|anew| anew.stiffness).or(tabulated);
            if let Some(stiffness) = stiffness {
                let sides = side_by_side(ratios.0, ratios.1, stiffness, watch)?;
                converged &= sides.is_converged();
                figure = Some(figures::calibration(&case.title, &sides));
            }
        }
        let report = Report {
            title: case.title.clone(),
            normal: self.normal.summary,
            shear_modulus: self.bodies.shear_modulus(),
            poisson_ratio: ratios.1,
            tabulated: tabulated.map(|stiffness| self.layer(stiffness, deviation)),
            anew: anew.map(|anew| self.anew(&anew)),
            fitted,
            warnings,
            status: if converged { Status::Converged } else { Status::NotConverged },
        };
        Ok((report, figure))
    }

    fn warnings(&self, case: &Case, layer: &CalibratedLayer) -> Vec<String> {
        let mut warnings = case.notices.clone();
        let of_parts = layer.caveat_of_parts(self.normal.summary.parts);
        let is_table = matches!(self.normal.pressure, Pressure::Tabulated(..));
        let of_shape = (is_table && of_parts.is_none())
            .then(|| "the patch is treated like the ellipse with the same extent".to_owned());
        warnings.extend(of_parts);
        warnings.extend(of_shape);
        warnings.extend(self.bodies.caveat());
        warnings
    }

    fn layer(
        &self,
        stiffness: [RelativeStiffness; 2],
        deviation: Option<schlupf::calibration::Deviation>,
    ) -> Layer {
        let absolute =
            |relative: RelativeStiffness| relative.absolute(self.bodies.shear_modulus(), self.size);
        Layer { stiffness: stiffness.map(absolute), deviation }
    }

    fn anew(&self, found: &Calibration) -> Anew {
        let bed = found.winkler_bedding.map(|bedding| RelativeStiffness {
            bedding,
            reach_along_x: 0.0,
            reach_along_y: 0.0,
        });
        Anew {
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
            return Err(unlike(&fit, k, &files));
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
fn unlike(fit: &DisplacementFit, component: usize, files: &[String]) -> Error {
    Error::Contradiction {
        quantity: ["displacement_x", "displacement_y"][component],
        reason: format!(
            "no elastic layer has the displacements of {}: the nearest is {:.0} % of them away; check that \
             tractions and displacements belong together, and their units",
            files.join(", "),
            100.0 * fit.largest_deviation()
        ),
    }
}

/// What to know about fits to displacements; `exact` is the layer that is like the half-space.
fn doubts(fitted: &Fitted, exact: Option<[LayerStiffness; 2]>) -> Vec<String> {
    let mut doubts = Vec::new();
    for (k, (name, component)) in ["x", "y"].into_iter().zip(&fitted.components).enumerate() {
        let Some(FittedComponent { fit, .. }) = component else { continue };
        if let Some(ratio) = exact.map(|exact| fit.bedding / exact[k].bedding)
            && !(FOREIGN.recip()..FOREIGN).contains(&ratio)
        {
            doubts.push(format!(
                "the bedding for displacement_{name} is {ratio:.1e} times that of half-spaces of the case's \
                 bodies: are units and bodies right?"
            ));
        }
        if fit.largest_deviation() > FAR {
            doubts.push(format!(
                "the layer misses {:.0} % of displacement_{name}: it is hardly an elastic layer's",
                100.0 * fit.largest_deviation()
            ));
        }
        for (direction, is_open) in ["along", "across"].into_iter().zip(fit.is_open) {
            if is_open {
                doubts.push(format!(
                    "displacement_{name} leaves open how far the coupling reaches {direction} rolling: its \
                     decay length is at the end of the range that is looked at"
                ));
            }
        }
    }
    doubts
}

fn components(fitted: &Fitted) -> impl Iterator<Item = &FittedComponent> {
    fitted.components.iter().flatten()
}

fn check_outputs(arguments: &CalibrateArguments, case: &Case) -> Result<(), Failure> {
    let json = arguments.report.json_file();
    let outputs: Vec<(&str, &Path)> = json.map(|path| ("--json", path)).into_iter().collect();
    let mut inputs = Input::of_case(&arguments.case, case);
    inputs.extend(arguments.displacements.iter().map(|path| Input {
        what: DISPLACEMENTS.to_owned(),
        path: path.clone(),
        except: None,
    }));
    match &arguments.figures {
        None => outputs::check(&outputs, &inputs),
        Some(directory) => {
            let names = figure_files(figures::CALIBRATION);
            outputs::check_with_directory(&outputs, &inputs, ("--figures", directory), &names)
        }
    }
}

fn write(
    arguments: &CalibrateArguments,
    report: &Report,
    figure: Option<Figure>,
) -> Result<(), Failure> {
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    if let Some(path) = arguments.report.json_file() {
        files.push((path.to_owned(), json::document(report).into_bytes()));
    }
    if let (Some(directory), Some(figure)) = (&arguments.figures, figure) {
        let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
        files.push((svg, figure.svg.into_bytes()));
        files.push((png, figure.png));
    }
    outputs::write(&files, arguments.figures.as_deref())?;
    arguments.report.print(|| json::document(report), || summary::text(report))
}
