//! A rough surface, its contact and its k_c.

use crate::output::roughness::{RoughnessReport, Spots};
use schlupf::interface::roughness::{LoadCurveOptions, MicroModel, MicroModelResult};
use schlupf::normal::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use schlupf::reporting::Message;
use schlupf::surface::HeightMap;
use schlupf::surface::spectrum::{RadialSpectrum, Window};
use schlupf::{Error, Watch};
use schlupf_case::surface::{RoughSurface, SurfaceOrigin};
use schlupf_case::{CaseErrors, InputFile, RoughnessRequest, caveats, field};

use crate::TaskError;
use crate::request::{Kind, Rule, request};
use crate::task::{CaseArgument, Found, Given, Task, Wanted};
use fields::OF_SURFACE;

mod fields;

request! {
    /// Which surface to press; without a file and without `synthetic` that of the case.
    Request {
        /// Surface or profile of one body, or of both together (.csv, .npy, .x3p, .xyz).
        surface: Option<InputFile> = Kind::file_of_case(field!("contact_law.roughness.file")), positional();
        /// Surface of the other body, on the same lattice: their heights are added.
        second: Option<InputFile> = Kind::file_of_case(field!("contact_law.roughness.second_file"));
        /// Make a self-affine surface, such as rms_height="1 um",hurst=0.8,longest="100 um",
        /// shortest="5 um",seed=1; also rms_slope and roll_off.
        synthetic: Option<String> = Kind::list("KEY=VALUE,…");
        /// Form to remove from a measured surface; by default a plane.
        form: Option<String> = Kind::of_case(field!("contact_law.roughness.form"));
        /// Remove waves longer than this from a measured surface, such as "0.8 mm" (λc of the
        /// Gaussian filter, ISO 16610).
        cutoff: Option<String> = Kind::of_case(field!("contact_law.roughness.cutoff_wavelength"));
        /// Unit of the heights of an .npy file, of all lengths of an .xyz file, such as um.
        unit: Option<String> = Kind::of_case(field!("contact_law.roughness.unit"));
        /// Spacing of the points of an .npy file or of heights alone, such as "1 um".
        spacing: Option<String> = Kind::of_case(field!("contact_law.roughness.spacing"));
        /// Fill points without a height smoothly.
        fill_holes: Option<String> = Kind::of_case(field!("contact_law.roughness.fill_holes"));
        /// Resample a surface whose cells are not square.
        square_cells: Option<String> = Kind::of_case(field!("contact_law.roughness.square_cells"));
        /// Cells along x of the resampled or synthetic surface.
        cells: Option<String> = Kind::of_case(field!("contact_law.roughness.cells"));
        /// Seed of a surface generated from a profile.
        seed: Option<String> = Kind::of_case(field!("contact_law.roughness.seed"));
        /// Mean pressures: a range (six pressures) or a list; by default those of the case, of a
        /// surface given here without a case 0.2..1.2 GPa.
        pressure: Option<String> = Kind::of_case(field!("contact_law.roughness.pressures"));
        /// Coefficient of friction; by default that of the case.
        friction: Option<String> = Kind::of_case(field!("friction.coefficient"));
        /// Hardness of the softer body, such as "2.5 GPa"; by default the bodies are elastic.
        hardness: Option<String> = Kind::of_case(field!("contact_law.roughness.hardness"));
        => RULES
    }
}

const RULES: &[Rule] =
    &[Rule::Apart(&["synthetic"], &["surface"]), Rule::With(OF_SURFACE, &["surface", "synthetic"])];

/// `roughness`: the case has the bodies.
pub struct Roughness;

impl Task for Roughness {
    const NAME: &'static str = "roughness";
    const ABOUT: &'static str =
        "Compute k_c from rough surfaces, with statistics, contact area and tangential curves";
    const CASE: CaseArgument =
        CaseArgument::Option("of the bodies; by default steel wheel and rail");
    const HAS_SEVERAL: bool = true;
    type Request = Request;
    type Report = RoughnessReport;

    fn run(
        of: &Given,
        request: Request,
        wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<RoughnessReport>, TaskError> {
        let files = [RoughnessReport::PRESSURES, RoughnessReport::GAPS];
        let with_spots = wanted.figures || files.iter().any(|file| wanted.file(file).is_some());
        let title = of.case.title()?;
        let generated = request.generated();
        let request = request.of_case(of, watch)?;
        let rough = request.load()?;
        let explain = |error: Error| CaseErrors::from(request.explain(&error));
        let result = solve(&request, &rough, watch).map_err(explain)?;
        let spots = with_spots.then(|| spots(&request, &rough.surface, watch));
        let spots = spots.transpose().map_err(explain)?;
        let pressed = Pressed { title, request, generated };
        Ok(pressed.report(rough, result, spots).into())
    }
}

/// What is pressed.
struct Pressed {
    /// Title of the case.
    title: String,
    request: RoughnessRequest,
    /// How a surface is generated, if not by the case.
    generated: Option<String>,
}

impl Pressed {
    /// What was pressed, and what came out.
    fn report(
        &self,
        rough: RoughSurface,
        result: MicroModelResult,
        spots: Option<Spots>,
    ) -> RoughnessReport {
        let request = &self.request;
        let caveats = caveats(&result, rough.surface.lattice().len(), request.key());
        let warnings = rough.notices.into_iter().chain(caveats).map(Message::from).collect();
        RoughnessReport {
            title: self.name(),
            spectrum: RadialSpectrum::of(&rough.surface, Window::of(&rough.surface)),
            surface: rough.surface,
            bodies: *request.bodies(),
            contact_modulus: request.key().contact_modulus,
            hardness: request.key().hardness,
            result,
            spots,
            remarks: rough.remarks,
            warnings,
        }
    }

    /// What the surface is called.
    fn name(&self) -> String {
        match (&self.request.key().source.origin, &self.generated) {
            (SurfaceOrigin::SelfAffine(_), Some(text)) => format!("self-affine surface, {text}"),
            (SurfaceOrigin::SelfAffine(_), None) => format!("{}, self-affine surface", self.title),
            (SurfaceOrigin::Files { files, .. }, _) => {
                let names: Vec<String> =
                    files.iter().map(|file| file.path().display().to_string()).collect();
                names.join(" and ")
            }
        }
    }
}

/// The micro model.
fn solve(
    request: &RoughnessRequest,
    rough: &RoughSurface,
    watch: Watch,
) -> Result<MicroModelResult, Error> {
    let (key, bodies) = (request.key(), request.bodies());
    let model = MicroModel {
        surface: rough.surface.clone(),
        contact_modulus: key.contact_modulus,
        bodies: *bodies,
        hardness: key.hardness,
        mean_pressures: request.mean_pressures().to_vec(),
    };
    model.solve(&LoadCurveOptions::default(), watch)
}

/// The contact at the largest mean pressure.
fn spots(request: &RoughnessRequest, surface: &HeightMap, watch: Watch) -> Result<Spots, Error> {
    let key = request.key();
    let distance = surface.distance_to_plane();
    let contact = RoughContact::new(distance, key.contact_modulus, Boundary::Periodic)?;
    let mut contact = contact.with_hardness(key.hardness)?;
    let solution = contact.press(key.largest_pressure, &RoughContactOptions::default(), watch)?;
    Ok(Spots {
        lattice: *surface.lattice(),
        mean_pressure: key.largest_pressure,
        is_converged: solution.is_converged,
        pressure: solution.pressure,
        gap: solution.gap,
    })
}
