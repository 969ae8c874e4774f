//! Figures of a solution, of creep curves, of a fit, of temperatures below the surface, of a calibration or of a
//! rough contact, each as SVG and as PNG of the same drawing.
//!
//! The surfaces and the cut show the traction on the rail, −t, as Neuhaus and Sextro (2014) do; so do
//! the arrows of the maps. Quantities that are zero throughout have no figure.

mod calibration;
mod color;
mod comparison;
mod contour;
mod creep_curve;
mod cut;
mod fit;
mod fit_panel;
mod font;
mod frame;
mod height_map;
mod history;
mod label;
mod map;
mod marks;
mod mesh;
mod panels;
mod patch;
mod projection;
mod quantity;
mod raster;
mod roughness;
mod sampler;
mod smooth;
mod spectrum;
mod surface;
mod svg;
mod temperature;
mod ticks;
mod units;

use schlupf::Solution;
use schlupf::calibration::side_by_side::SideBySide;

use crate::comparison::Comparison;
use crate::creep_curve::CurveFamily;
use crate::identification::FitReport;
use crate::roughness::RoughnessReport;
use crate::temperature::Temperatures;

pub use svg::MARK;

use map::Arrows;
use patch::Patch;

/// A figure.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Name for its files, without an ending.
    pub name: String,
    /// The drawing, with its fonts embedded.
    pub svg: String,
    /// The same drawing rendered for print.
    pub png: Vec<u8>,
}

/// Why there is no figure.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// The solution has nothing to draw.
    #[error("the solution has no contact patch of finite size to draw")]
    NoPatch,
    /// There is no creep curve with numbers to draw.
    #[error("there is no creep curve of finite numbers to draw")]
    NoCurve,
    /// There are no measured points to draw.
    #[error("there are no measured points over a range of creepages to draw")]
    NoPoints,
    /// There are no curves of a rough contact to draw.
    #[error("there are no tangential curves of finite numbers to draw")]
    NoTangentialCurve,
    /// There are no temperatures to draw.
    #[error("there are no temperatures over a range of places to draw")]
    NoTemperature,
    /// There are no forces and tractions to draw.
    #[error("there are no forces and tractions of half-space and layer to draw")]
    NoSides,
    /// All methods give nothing but zeros.
    #[error("there is nothing to compare: no method gives a force or a temperature rise")]
    NothingToCompare,
    /// The drawing could not be turned into a picture.
    #[error("the figure could not be rendered: {0}")]
    Render(String),
}

/// All figures that the solution has something to show in: `surface_…` over the patch, flat `map_…`,
/// `cut_y0` along y = 0 (through the largest pressure where that line meets no contact), and `history` over the rolled distance.
pub fn all(title: &str, solution: &Solution) -> Result<Vec<Figure>, FigureError> {
    let fonts = font::database();
    drawings(title, solution)?
        .into_iter()
        .map(|(name, svg)| {
            let png = raster::png(&svg, &fonts)?;
            Ok(Figure { name, svg, png })
        })
        .collect()
}

/// Name of the figure of creep curves.
pub const CREEP_CURVE: &str = "creep_curve";

/// The figure of creep curves: force on the rail over load, moment and temperature rise over creepage.
pub fn creep_curve(family: &CurveFamily) -> Result<Figure, FigureError> {
    let svg = creep_curve_drawing(family)?;
    let png = raster::png(&svg, &font::database())?;
    Ok(Figure { name: CREEP_CURVE.to_owned(), svg, png })
}

/// Name of the figure of a comparison.
pub const COMPARISON: &str = "comparison";

/// The figure of a comparison: forces, moment, temperature rise and time of every method that has an answer.
pub fn comparison(comparison: &Comparison) -> Result<Figure, FigureError> {
    let svg = comparison::draw(comparison).ok_or(FigureError::NothingToCompare)?;
    let png = raster::png(&svg, &font::database())?;
    Ok(Figure { name: COMPARISON.to_owned(), svg, png })
}

/// The SVG document of creep curves.
pub fn creep_curve_drawing(family: &CurveFamily) -> Result<String, FigureError> {
    creep_curve::draw(family).ok_or(FigureError::NoCurve)
}

/// Name of the figure of temperatures along lines.
pub const TEMPERATURE: &str = "temperature";

/// The figure of temperatures along a row with its wake, and below a point.
pub fn temperature(temperatures: &Temperatures) -> Result<Figure, FigureError> {
    let svg = temperature_drawing(temperatures)?;
    let png = raster::png(&svg, &font::database())?;
    Ok(Figure { name: TEMPERATURE.to_owned(), svg, png })
}

/// The SVG document of temperatures along lines.
pub fn temperature_drawing(temperatures: &Temperatures) -> Result<String, FigureError> {
    temperature::draw(temperatures).ok_or(FigureError::NoTemperature)
}

/// Name of the figure of layer and half-space.
pub const CALIBRATION: &str = "calibration";

/// The figure of forces and tractions of the calibrated layer and of uncoupled springs against the half-space.
pub fn calibration(title: &str, sides: &SideBySide) -> Result<Figure, FigureError> {
    let svg = calibration_drawing(title, sides)?;
    let png = raster::png(&svg, &font::database())?;
    Ok(Figure { name: CALIBRATION.to_owned(), svg, png })
}

/// The SVG document of layer and half-space.
pub fn calibration_drawing(title: &str, sides: &SideBySide) -> Result<String, FigureError> {
    calibration::draw(title, sides).ok_or(FigureError::NoSides)
}

/// Name of the figure of a fit.
pub const FIT: &str = "fit";

/// The figure of a fit: measured forces with the fitted curves, and the residuals.
pub fn fit(report: &FitReport) -> Result<Figure, FigureError> {
    let svg = fit_drawing(report)?;
    let png = raster::png(&svg, &font::database())?;
    Ok(Figure { name: FIT.to_owned(), svg, png })
}

/// The SVG document of a fit.
pub fn fit_drawing(report: &FitReport) -> Result<String, FigureError> {
    fit::draw(report).ok_or(FigureError::NoPoints)
}

/// Names of the figures of a rough surface.
pub const ROUGHNESS: [&str; 4] =
    ["roughness_curves", "roughness_surface", "roughness_spots", "roughness_spectrum"];

/// The figures of a rough surface: tangential curves, heights, and contact spots and spectrum where there
/// are some.
pub fn roughness(report: &RoughnessReport) -> Result<Vec<Figure>, FigureError> {
    let fonts = font::database();
    let render = |(name, svg): (&str, String)| {
        let png = raster::png(&svg, &fonts)?;
        Ok(Figure { name: name.to_owned(), svg, png })
    };
    roughness_drawings(report)?.into_iter().map(render).collect()
}

/// Names and SVG documents of the figures of a rough surface.
pub fn roughness_drawings(
    report: &RoughnessReport,
) -> Result<Vec<(&'static str, String)>, FigureError> {
    let [curves, surface, spots, spectrum] = ROUGHNESS;
    let mut drawings = vec![
        (curves, roughness::draw(report).ok_or(FigureError::NoTangentialCurve)?),
        (surface, height_map::surface(report)),
    ];
    drawings.extend(report.spots.as_ref().map(|found| (spots, height_map::spots(report, found))));
    drawings.extend(spectrum::draw(report).map(|svg| (spectrum, svg)));
    Ok(drawings)
}

/// Names of all figures of a solution that there can be.
pub fn names() -> Vec<String> {
    const SURFACES: [&str; 6] =
        ["pressure", "force_x", "force_y", "slip", "friction_power", "temperature"];
    const MAPS: [&str; 5] = ["pressure", "traction", "slip", "friction_power", "temperature"];
    let surfaces = SURFACES.iter().map(|name| format!("surface_{name}"));
    let maps = MAPS.iter().map(|name| format!("map_{name}"));
    surfaces.chain(maps).chain(["cut_y0", "history"].map(str::to_owned)).collect()
}

/// Names and SVG documents of all figures, without the pictures, which take most of the time.
pub fn drawings(title: &str, solution: &Solution) -> Result<Vec<(String, String)>, FigureError> {
    /// What is left out, over the largest that the normalised quantities of the paper can be.
    const INVISIBLE: f64 = 1e-3;
    let patch = Patch::new(title, solution).ok_or(FigureError::NoPatch)?;
    let mut drawings = Vec::new();
    for quantity in quantity::of_the_paper(&patch) {
        if quantity.is_visible(if quantity.normalised { INVISIBLE } else { 0.0 }) {
            drawings.push((format!("surface_{}", quantity.name), surface::draw(&patch, &quantity)));
        }
    }
    for quantity in quantity::physical(&patch) {
        if quantity.is_visible(0.0) {
            let arrows = arrows(&patch, quantity.name);
            let svg = map::draw(&patch, &quantity, arrows.as_ref());
            drawings.push((format!("map_{}", quantity.name), svg));
        }
    }
    drawings.push(("cut_y0".to_owned(), cut::draw(&patch)));
    if solution.history.len() > 1 {
        drawings.push(("history".to_owned(), history::draw(&patch)));
    }
    Ok(drawings)
}

/// The arrows that belong to a map.
fn arrows(patch: &Patch, name: &str) -> Option<Arrows> {
    let fields = patch.fields();
    let opposite = |field: &[f64]| field.iter().map(|value| -value).collect();
    match name {
        "traction" => Some(Arrows {
            x: opposite(&fields.traction_x),
            y: opposite(&fields.traction_y),
            vanish_at_rim: true,
            text: "traction on the rail",
        }),
        "slip" => Some(Arrows {
            x: fields.slip_x.clone(),
            y: fields.slip_y.clone(),
            vanish_at_rim: false,
            text: "slip of the wheel over the rail",
        }),
        _ => None,
    }
}
