//! Figures of a solution, of creep curves, of a fit, of temperatures below the surface, of a
//! calibration or of a rough contact, each as SVG and, with the feature `png`, as PNG of the same
//! drawing.
//!
//! The surfaces and the section show the traction on the rail, −t, as in Neuhaus and Sextro (2014);
//! so do the arrows of the maps. Quantities that are zero everywhere have no figure.

pub(crate) mod cells;
mod chain;
pub(crate) mod color;
mod contour;
mod cut;
mod font;
pub(crate) mod frame;
mod history;
pub(crate) mod label;
pub(crate) mod lattice;
pub(crate) mod map;
pub(crate) mod marks;
mod mesh;
mod panel;
pub(crate) mod panels;
pub(crate) mod patch;
mod projection;
pub(crate) mod quantity;
#[cfg(feature = "png")]
mod raster;
pub(crate) mod relief;
mod run;
mod sampler;
pub(crate) mod smooth;
mod surface;
pub(crate) mod svg;
pub(crate) mod ticks;
pub(crate) mod units;

use schlupf::Solution;

pub use svg::MARK;

use map::Arrows;
use patch::Patch;

/// What figures are drawn as.
pub const FORMATS: &str =
    if cfg!(feature = "png") { "PNG and SVG" } else { "SVG, without the feature png" };

/// A figure.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Name for its files, without extension.
    pub name: String,
    /// The drawing, with its fonts embedded.
    pub svg: String,
    /// The same drawing rendered for print.
    #[cfg(feature = "png")]
    pub png: Vec<u8>,
}

impl Figure {
    /// Its files: names and contents.
    pub fn files(self) -> Vec<(String, Vec<u8>)> {
        vec![
            (format!("{}.svg", self.name), self.svg.into_bytes()),
            #[cfg(feature = "png")]
            (format!("{}.png", self.name), self.png),
        ]
    }
}

/// Reason why there is no figure.
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
    /// There are no stresses to draw.
    #[error("there are no stresses over a range of depths to draw")]
    NoStress,
    /// There are no temperatures to draw.
    #[error("there are no temperatures over a range of places to draw")]
    NoTemperature,
    /// There are no forces and tractions to draw.
    #[error("there are no forces and tractions of half-space and layer to draw")]
    NoSides,
    /// There are no contacts over a range of positions to draw.
    #[error("there are no contacts over a range of lateral positions to draw")]
    NoContacts,
    /// All methods give only zeros.
    #[error("there is nothing to compare: no method gives a force or a temperature rise")]
    NothingToCompare,
    /// The drawing could not be rendered.
    #[error("the figure could not be rendered: {0}")]
    Render(String),
}

/// A drawing: its name, and the SVG document.
pub type Drawing = (String, String);

/// Renders drawings to figures with their pictures, which takes most of the time.
pub fn render(drawings: Vec<Drawing>) -> Result<Vec<Figure>, FigureError> {
    #[cfg(feature = "png")]
    let fonts = raster::fonts();
    let figure = |(name, svg): Drawing| {
        Ok(Figure {
            name,
            #[cfg(feature = "png")]
            png: raster::png(&svg, &fonts)?,
            svg,
        })
    };
    drawings.into_iter().map(figure).collect()
}

/// Names of all possible figures of a solution.
pub fn names() -> Vec<String> {
    const SURFACES: [&str; 6] =
        ["pressure", "force_x", "force_y", "slip", "friction_power", "temperature"];
    const MAPS: [&str; 5] = ["pressure", "traction", "slip", "friction_power", "temperature"];
    let surfaces = SURFACES.iter().map(|name| format!("surface_{name}"));
    let maps = MAPS.iter().map(|name| format!("map_{name}"));
    surfaces.chain(maps).chain(["cut_y0", HISTORY].map(str::to_owned)).collect()
}

/// Name of the figure that only solutions with a history have.
pub const HISTORY: &str = "history";

/// All drawings for which the solution has something to show: `surface_…` over the patch and flat
/// `map_…`, unless it is a single row of cells, `cut_y0` along y = 0 (through the largest pressure
/// if that line has no contact), and `history` over the distance rolled, or over time where the
/// speed varies.
pub fn drawings(title: &str, solution: &Solution) -> Result<Vec<Drawing>, FigureError> {
    /// Threshold below which a quantity is omitted, relative to the largest possible value of the
    /// paper's normalised quantities.
    const INVISIBLE: f64 = 1e-3;
    let patch = Patch::new(title, solution).ok_or(FigureError::NoPatch)?;
    let mut drawings = Vec::new();
    let mut rows = solution.fields.cell.iter().map(|[_, row]| row);
    let first = rows.next();
    let has_rows = rows.any(|row| Some(row) != first);
    for quantity in quantity::of_the_paper(&patch) {
        if has_rows && quantity.is_visible(if quantity.normalised { INVISIBLE } else { 0.0 }) {
            drawings.push((format!("surface_{}", quantity.name), surface::draw(&patch, &quantity)));
        }
    }
    for quantity in quantity::physical(&patch) {
        if has_rows && quantity.is_visible(0.0) {
            let arrows = arrows(&patch, quantity.name);
            let svg = map::draw(&patch, &quantity, arrows.as_ref());
            drawings.push((format!("map_{}", quantity.name), svg));
        }
    }
    drawings.push(("cut_y0".to_owned(), cut::draw(&patch)));
    if solution.history.len() > 1 {
        drawings.push((HISTORY.to_owned(), history::draw(&patch)));
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
