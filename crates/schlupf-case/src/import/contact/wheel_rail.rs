//! Module 1: a wheel of a wheelset on a rail.

use super::control::Control;
use super::friction::Friction;
use super::given::{Given, GivenText, angle, real, whole};
use super::material::{Elastic, Heat, skip_damping};
use super::reader::{Reader, Reading};
use super::skipped;

/// What a case of module 1 has, and the next one may keep.
#[derive(Debug, Clone, Default)]
pub struct WheelRail {
    /// Friction.
    pub friction: Option<Friction>,
    /// Materials.
    pub elastic: Option<Elastic>,
    /// Heat.
    pub heat: Option<Heat>,
    /// Grid and search.
    pub search: Option<Search>,
    /// Where the rails are.
    pub track: Option<Track>,
    /// Profile of the rail.
    pub rail: Option<Profile>,
    /// DYRAIL, DZRAIL, DROLLR, VYRAIL, VZRAIL and VROLLR, in mm, rad and s.
    pub rail_deviation: Option<[Given; 6]>,
    /// FBDIST, FBPOS and NOMRADW, in mm.
    pub wheelset: Option<[Given; 3]>,
    /// YTAPE, in mm.
    pub tape_circle: Option<Given>,
    /// Profile of the wheel.
    pub wheel: Option<Profile>,
    /// S_WS, Y_WS, Z_WS or FZ, ROLL, YAW and PITCH, in mm, N and rad.
    pub position: Option<[Given; 6]>,
    /// VS, VY, VZ, VROLL, VYAW and VPITCH, in mm/s and rad/s.
    pub velocity: Option<[Given; 6]>,
    /// Deviations of a flexible wheelset from its design, and their rates.
    pub wheel_deviation: Option<[[Given; 6]; 2]>,
}

/// Grid and search for contacts.
#[derive(Debug, Clone, PartialEq)]
pub struct Search {
    /// Digit D.
    pub method: Given,
    /// DX and DS, in mm.
    pub element: [Given; 2],
    /// DQREL: rolled distance in a step over DX, dimensionless.
    pub step: Given,
    /// A_SEP, in rad.
    pub angle: Given,
    /// D_SEP, in mm.
    pub distance: Given,
    /// D_COMB, in mm.
    pub whole_distance: Given,
}

/// Where the rails are.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// GAUGHT, in mm.
    pub gauge_height: Given,
    /// GAUGSQ, or RAILY0 in mm.
    pub face: Given,
    /// GAUGWD, or RAILZ0, in mm.
    pub gauge: Given,
    /// CANT in rad, or NOMRADR in mm.
    pub cant: Given,
    /// CURV, in 1/mm.
    pub curvature: Option<Given>,
}

/// A profile and how it is changed.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// RFNAME or WFNAME.
    pub file: GivenText,
    /// MIRRORY.
    pub mirror_y: Given,
    /// SCALEYZ.
    pub scale: Given,
    /// SMOOTH: L_FILT in mm, or a weight.
    pub smoothing: Given,
    /// MIRRORZ.
    pub mirror_z: Option<Given>,
    /// ISMOOTH.
    pub smoothing_method: Option<Given>,
    /// PRFOPT, where it asks for thresholds of kinks and errors.
    pub thresholds: Option<Given>,
}

impl WheelRail {
    /// Reads what a case gives anew.
    pub fn read(&mut self, reader: &mut Reader, control: &Control) -> Reading<()> {
        skipped::iteration(reader, control)?;
        if !control.friction_law.is(1) {
            self.friction = Some(Friction::read(reader, control, 1)?);
        }
        if control.influence.value >= 2.0 {
            self.elastic = Some(Elastic::read(reader, control, 1)?);
        }
        skip_damping(reader, control)?;
        if control.heat.is(3) {
            self.heat = Some(Heat::read(reader, control)?);
        }
        if control.grid.value >= 2.0 {
            self.search = Some(Search::read(reader, control)?);
        }
        self.read_track(reader, control)?;
        self.read_wheelset(reader, control)?;
        skipped::points_below(reader, control)
    }

    fn read_track(&mut self, reader: &mut Reader, control: &Control) -> Reading<()> {
        let kind = control.distance.whole();
        if matches!(kind, 1 | 3) {
            let cant = if control.config.value >= 4.0 { real("NOMRADR") } else { angle("CANT") };
            let ([gauge_height, face, gauge, cant], [curvature]) = reader.numbers_and(
                [real("GAUGHT"), real("GAUGSQ"), real("GAUGWD"), cant],
                [real("CURV")],
            )?;
            self.track = Some(Track { gauge_height, face, gauge, cant, curvature });
        }
        if kind == 3 {
            self.rail = Some(Profile::read(reader, "RFNAME")?);
        }
        if matches!(kind, 2 | 3) {
            self.rail_deviation = Some(reader.numbers([
                real("DYRAIL"),
                real("DZRAIL"),
                angle("DROLLR"),
                real("VYRAIL"),
                real("VZRAIL"),
                angle("VROLLR"),
            ])?);
            if control.force.is(3) {
                let stiffness = [real("KYRAIL"), real("FYRAIL"), real("KZRAIL"), real("FZRAIL")];
                reader.numbers_and(stiffness, [real("DYSTEP0")])?;
            }
        }
        Ok(())
    }

    fn read_wheelset(&mut self, reader: &mut Reader, control: &Control) -> Reading<()> {
        let kind = control.extra.whole();
        if matches!(kind, 3 | 5) {
            let size = [real("FBDIST"), real("FBPOS"), real("NOMRADW")];
            let (size, [tape_circle]) = reader.numbers_and(size, [real("YTAPE")])?;
            (self.wheelset, self.tape_circle) = (Some(size), tape_circle);
            self.wheel = Some(Profile::read(reader, "WFNAME")?);
        }
        if matches!(kind, 1..=5) {
            let height = if control.normal.is(0) { "Z_WS" } else { "FZ" };
            self.position = Some(reader.numbers([
                real("S_WS"),
                real("Y_WS"),
                real(height),
                angle("ROLL"),
                angle("YAW"),
                angle("PITCH"),
            ])?);
        }
        if matches!(kind, 2..=5) {
            let pitch = match control.force.whole() {
                1 => real("FX_WS"),
                2 => real("MY_WS"),
                _ => angle("VPITCH"),
            };
            let forward = if control.config.value >= 4.0 { angle("RPITCH") } else { real("VS_WS") };
            self.velocity = Some(reader.numbers([
                forward,
                real("VY_WS"),
                real("VZ_WS"),
                angle("VROLL"),
                angle("VYAW"),
                pitch,
            ])?);
        }
        if matches!(kind, 4 | 5) {
            let deviation = reader.numbers([
                real("DXWHL"),
                real("DYWHL"),
                real("DZWHL"),
                angle("DROLLW"),
                angle("DYAWW"),
                angle("DPITCHW"),
            ])?;
            let rates = reader.numbers([
                real("VXWHL"),
                real("VYWHL"),
                real("VZWHL"),
                angle("VROLLW"),
                angle("VYAWW"),
                angle("VPITCHW"),
            ])?;
            self.wheel_deviation = Some([deviation, rates]);
        }
        Ok(())
    }
}

impl Search {
    fn read(reader: &mut Reader, control: &Control) -> Reading<Self> {
        let ([x, s, step, angle, distance, whole_distance], _) = reader.numbers_and(
            [real("DX"), real("DS"), real("DQREL"), angle("A_SEP"), real("D_SEP"), real("D_COMB")],
            [real("D_TURN"), real("G_MISS")],
        )?;
        let (method, element) = (control.grid, [x, s]);
        Ok(Self { method, element, step, angle, distance, whole_distance })
    }
}

impl Profile {
    fn read(reader: &mut Reader, name: &'static str) -> Reading<Self> {
        let (file, [mirror_y, scale, smoothing], [mirror_z, options]) = reader.text_and(
            name,
            [whole("MIRRORY"), real("SCALEYZ"), real("SMOOTH")],
            [whole("MIRRORZ"), whole("PRFOPT")],
        )?;
        let thresholds = options.filter(|options| options.value >= 1.0);
        let options = options.map_or(0, Given::whole);
        let mut smoothing_method = None;
        if options >= 1 {
            let [method, ..] = reader.numbers([
                whole("ISMOOTH"),
                angle("ZIGTHRS"),
                angle("KINKHIGH"),
                angle("KINKLOW"),
                real("KINKWID"),
            ])?;
            smoothing_method = Some(method);
        }
        if options >= 2 {
            reader.numbers([whole("ERRHND"), real("MAXOMIT")])?;
        }
        Ok(Self { file, mirror_y, scale, smoothing, mirror_z, smoothing_method, thresholds })
    }
}
