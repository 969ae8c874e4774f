//! The profiles of a wheel and a rail in their places, before anything is solved.

use schlupf::Status;
use schlupf::wheel_rail::{ProfileCurve, Surface, WheelOnRail};

use crate::output::figures::color::{BLUE, VERMILION};
use crate::output::figures::frame::Frame;
use crate::output::figures::marks::{HEADING, Heading, short};
use crate::output::figures::panels::WIDTH;
use crate::output::figures::svg::Drawing;
use crate::output::figures::{self, Figure, FigureError};

/// Name of the figure.
pub const NAME: &str = "profiles";

/// Space around the profiles, in mm.
const MARGIN: f64 = 6.0;

/// Points along a curve.
const POINTS: usize = 800;

/// Radius of the mark of a point.
const DOT: f64 = 1.6;

/// Both profiles as they are in the track with the wheelset at a height (in m) above the nominal
/// one, as seen along the track, and the points that their curves run through.
///
/// # Errors
/// A drawing that cannot be rendered.
pub fn figure(title: &str, wheel: &WheelOnRail, height: f64) -> Result<Vec<Figure>, FigureError> {
    figures::render(vec![(NAME.to_owned(), drawing(title, wheel, height))])
}

/// A curve and what places its points in the drawing's plane, in mm.
type Placed<'a> = (&'a Surface, &'a dyn Fn([f64; 2]) -> [f64; 2], &'static str);

/// Points of the rail and of the wheel as they are in the track at the lateral position of the
/// wheelset, with the axle at its nominal height: y and z of each, in m.
pub fn outlines(wheel: &WheelOnRail) -> [Vec<[f64; 2]>; 2] {
    let (pair, outwards) = (wheel.pair(), wheel.side.outwards());
    let shift = pair.wheel_offset() + outwards * wheel.position.lateral;
    let in_track = |surface, shift| {
        let placed = |[y, z]: [f64; 2]| [outwards * (y + shift), z];
        places(surface).map(placed).collect()
    };
    [in_track(pair.rail(), 0.0), in_track(pair.wheel(), shift)]
}

fn drawing(title: &str, wheel: &WheelOnRail, height: f64) -> String {
    let pair = wheel.pair();
    let outwards = -wheel.side.outwards();
    // The axis points to the right, so it is that of −y.
    let shift = pair.wheel_offset() - outwards * wheel.position.lateral;
    let on_rail = |[y, z]: [f64; 2]| [1e3 * outwards * y, 1e3 * z];
    let on_wheel = |[y, z]: [f64; 2]| [1e3 * outwards * (y + shift), 1e3 * (z + height)];
    let curves: [Placed; 2] = [(pair.rail(), &on_rail, VERMILION), (pair.wheel(), &on_wheel, BLUE)];
    let frame = frame(&curves);
    let top = frame.corner[1];
    let mut drawing = Drawing::new(WIDTH, top + frame.size[1] + 66.0);
    let place = format!(
        "{} wheel, lateral position {} mm, axle {} mm above the nominal height; not rolled or yawed",
        wheel.side.name(),
        short(1e3 * wheel.position.lateral),
        short(1e3 * height)
    );
    Heading::new("Profiles in place", title, place, Status::Converged).draw(&mut drawing);
    frame.draw_grid(&mut drawing);
    drawing.begin_clip(&frame.area());
    for (curve, placed, color) in &curves {
        let line: Vec<[f64; 2]> = places(curve).map(|place| frame.at(placed(place))).collect();
        let stroke = format!(r#"stroke="{color}" stroke-width="1.4" stroke-linejoin="round""#);
        drawing.polyline(&line, &stroke);
        for point in curve.uniform().map_or(&[][..], ProfileCurve::points) {
            let [x, y] = frame.at(placed(*point));
            let dot = format!(r#"<circle cx="{x:.2}" cy="{y:.2}" r="{DOT}" fill="{color}"/>"#);
            drawing.shape(&dot);
        }
    }
    drawing.end_group();
    frame.draw_vertical(&mut drawing, "$z$ (mm)");
    frame.draw_horizontal(&mut drawing, "to the right, −$y$ (mm)");
    drawing.finish()
}

/// Places along the profile of a surface at the wheelset, in m.
pub(crate) fn places(surface: &Surface) -> impl Iterator<Item = [f64; 2]> {
    let step = surface.length() / (POINTS - 1) as f64;
    (0..POINTS).filter_map(move |k| Some(surface.point(0.0, k as f64 * step)?.place))
}

/// The axes around both curves, with equal scales.
fn frame(curves: &[Placed; 2]) -> Frame {
    let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for (curve, placed, _) in curves {
        let points = curve.uniform().map(|curve| curve.points().to_vec());
        for point in points.unwrap_or_else(|| places(curve).collect()) {
            for (axis, value) in placed(point).into_iter().enumerate() {
                range[axis] = [range[axis][0].min(value), range[axis][1].max(value)];
            }
        }
    }
    let [x, y] = range.map(|[low, high]| [low - MARGIN, high + MARGIN]);
    let width = WIDTH - 90.0;
    let size = [width, width * (y[1] - y[0]) / (x[1] - x[0])];
    Frame { corner: [60.0, HEADING + 20.0], size, x, y, powers: false }
}
