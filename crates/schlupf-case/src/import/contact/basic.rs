//! Module 3: a contact between two bodies of given curvatures or of a given distance.

use super::control::Control;
use super::friction::Friction;
use super::given::{Given, angle, real, whole};
use super::material::{Elastic, Heat, skip_damping};
use super::reader::{Reader, Reading};
use super::skipped;

/// What a case of module 3 has, and the next one may keep.
#[derive(Debug, Clone, Default)]
pub struct Basic {
    /// MAXOUT: iterations between normal and tangential problem.
    pub outer_iterations: Option<Given>,
    /// Loads and creepages.
    pub motion: Option<Motion>,
    /// Friction.
    pub friction: Option<Friction>,
    /// Speed, direction and step of rolling.
    pub rolling: Option<Rolling>,
    /// Materials.
    pub elastic: Option<Elastic>,
    /// Heat.
    pub heat: Option<Heat>,
    /// Potential contact area.
    pub area: Option<Area>,
    /// Undeformed distance, where the area is not that of Hertz.
    pub distance: Option<Distance>,
    /// Digit E of the case that gave the extra slip.
    pub extra_slip: Option<Given>,
}

/// Normal force or approach, and creepages or forces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// FN in N, or PEN in mm.
    pub normal: Given,
    /// CKSI or FXREL, and CETA or FYREL: creepages, shifts in mm, or forces over μ0 FN.
    pub tangential: [Given; 2],
    /// CPHI, in rad/mm, or in rad in a shift.
    pub spin: Given,
    /// SPINXO and SPINYO, in mm.
    pub spin_centre: Option<[Given; 2]>,
}

/// How the bodies roll.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling {
    /// CHI, in rad.
    pub direction: Given,
    /// DQ, in mm.
    pub step: Given,
    /// VELOC, in mm/s.
    pub speed: Given,
}

/// The potential contact area.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    /// IPOTCN: how it is given.
    pub kind: Given,
    /// MX and MY.
    pub cells: [Given; 2],
    /// What follows them in the line, in mm, 1/mm, or dimensionless.
    pub values: Vec<Given>,
}

/// The undeformed distance.
#[derive(Debug, Clone, PartialEq)]
pub struct Distance {
    /// IBASE: how it is given.
    pub base: Given,
    /// IPLAN: where contact is possible.
    pub plan: Given,
    /// Coefficients or values.
    pub values: Vec<Given>,
}

/// Most elements of a grid.
const MOST_ELEMENTS: i64 = 4_000_000;

impl Basic {
    /// Reads what a case gives anew.
    pub fn read(&mut self, reader: &mut Reader, control: &Control) -> Reading<()> {
        self.outer_iterations = skipped::iteration(reader, control)?.or(self.outer_iterations);
        self.motion = Some(Motion::read(reader, control)?);
        let is_by_row = control.friction_variation.is(3);
        let has_new_friction = !control.friction_law.is(1);
        if has_new_friction && !is_by_row {
            self.friction = Some(Friction::read(reader, control, 1)?);
        }
        if control.influence.value >= 2.0 {
            if control.is_rolling() {
                self.rolling = Some(Rolling::read(reader)?);
            }
            self.elastic = Some(Elastic::read(reader, control, 3)?);
        }
        skip_damping(reader, control)?;
        if control.heat.is(3) {
            self.heat = Some(Heat::read(reader, control)?);
        }
        if control.grid.is(2) {
            self.area = Some(Area::read(reader)?);
        }
        if control.distance.value >= 2.0 {
            let area = self.area.as_ref();
            self.distance = match area.filter(|area| !area.is_hertzian()) {
                Some(area) => Some(Distance::read(reader, area)?),
                None => None,
            };
        }
        if has_new_friction && is_by_row {
            let rows = self.area.as_ref().map_or(1, |area| area.cells[1].whole() as usize);
            self.friction = Some(Friction::read(reader, control, rows)?);
        }
        if control.extra.is(9) {
            let elements = self.area.as_ref().map_or(0, Area::elements);
            reader.array(real("EXRHS"), 2 * elements)?;
        }
        if !control.extra.is(1) {
            self.extra_slip = Some(control.extra);
        }
        skipped::points_below(reader, control)
    }
}

impl Motion {
    fn read(reader: &mut Reader, control: &Control) -> Reading<Self> {
        let normal = if control.normal.is(0) { "PEN" } else { "FN" };
        let [x, y] = match control.force.whole() {
            0 => ["CKSI", "CETA"],
            1 => ["FXREL", "CETA"],
            _ => ["FXREL", "FYREL"],
        };
        let ([normal, x, y, spin], centre) = reader.numbers_and(
            [real(normal), real(x), real(y), real("CPHI")],
            [real("SPINXO"), real("SPINYO")],
        )?;
        let spin_centre = match centre {
            [Some(x), Some(y)] => Some([x, y]),
            _ => None,
        };
        Ok(Self { normal, tangential: [x, y], spin, spin_centre })
    }
}

impl Rolling {
    fn read(reader: &mut Reader) -> Reading<Self> {
        let ([direction, step, speed], _) =
            reader.numbers_and([angle("CHI"), real("DQ"), real("VELOC")], [real("FACPHI")])?;
        Ok(Self { direction, step, speed })
    }
}

impl Area {
    fn read(reader: &mut Reader) -> Reading<Self> {
        let [kind] = reader.numbers([whole("IPOTCN")])?;
        let names: &[&str] = match kind.whole() {
            -1 => &["A1", "B1", "SCALE"],
            -2 => &["A1", "AOB", "SCALE"],
            -4 => &["A1", "BB", "SCALE"],
            -3 | -5 => &["AA", "BB", "SCALE"],
            -6 => &["AA", "BNEG", "BPOS", "SCALE"],
            1 => &["XL", "YL", "DX", "DY"],
            2 => &["XL", "YL", "XH", "YH"],
            3 => &["XC1", "YC1", "DX", "DY"],
            4 => &["XC1", "YC1", "XCM", "YCM"],
            other => {
                let message = format!("IPOTCN must be -6 to -1 or 1 to 4, but is {other}");
                return Err(reader.error("IPOTCN", kind.at, message));
            }
        };
        let items: Vec<_> = [whole("MX"), whole("MY")]
            .into_iter()
            .chain(names.iter().map(|name| real(name)))
            .collect();
        let given = reader.group_of(&items)?;
        let [x, y, ref values @ ..] = given[..] else {
            return Err(reader.error("MX", kind.at, "MX and MY must be given".to_owned()));
        };
        let elements = x.whole().saturating_mul(y.whole());
        if x.whole() < 1 || y.whole() < 1 || elements > MOST_ELEMENTS {
            let message = format!(
                "MX and MY must be positive and have a product of {MOST_ELEMENTS} at most, but are {} and {}",
                x.whole(),
                y.whole()
            );
            return Err(reader.error("MX", x.at, message));
        }
        Ok(Self { kind, cells: [x, y], values: values.to_vec() })
    }

    /// Whether it follows from a solution of Hertz, or of one like it.
    pub fn is_hertzian(&self) -> bool {
        self.kind.value < 0.0
    }

    fn elements(&self) -> usize {
        self.cells.map(|count| count.whole() as usize).into_iter().product()
    }

    /// Centre of the first element and sides of an element, in mm, of an area that is given as
    /// such.
    pub fn lattice(&self) -> ([f64; 2], [f64; 2]) {
        let values = |k: usize| self.values.get(k).map_or(0.0, |given| given.value);
        let cells = self.cells.map(|count| count.value);
        let (from, to) = ([values(0), values(1)], [values(2), values(3)]);
        let pairs = |of: &dyn Fn(usize) -> f64| [of(0), of(1)];
        match self.kind.whole() {
            1 => (pairs(&|k| from[k] + 0.5 * to[k]), to),
            2 => {
                let side = pairs(&|k| (to[k] - from[k]) / cells[k]);
                (pairs(&|k| from[k] + 0.5 * side[k]), side)
            }
            3 => (from, to),
            _ => (from, pairs(&|k| (to[k] - from[k]) / (cells[k] - 1.0))),
        }
    }
}

impl Distance {
    /// The undeformed distance (in mm) at a point (in mm), the centre of an element.
    pub fn at(&self, [x, y]: [f64; 2], element: usize) -> f64 {
        let b = |k: usize| self.values.get(k).map_or(0.0, |given| given.value);
        match self.base.whole() {
            1 => b(0) * x * x + b(1) * x * y + b(2) * y * y + b(3) * x + b(4) * y + b(5),
            2 => {
                let [middle, radius, start, step] = [b(1), b(2), b(3), b(4)];
                let heights = self.values.len().saturating_sub(5).max(2);
                let place = (y - start) / step;
                // Linear, beyond the ends, too.
                let k = (place.floor().max(0.0) as usize).min(heights - 2);
                let part = place - k as f64;
                let height = (1.0 - part) * b(5 + k) + part * b(6 + k);
                height + (x - middle).powi(2) / (2.0 * radius)
            }
            3 => {
                b(0) * (b(1) * (x - b(2))).sin() - b(3) * (b(4) * (x - b(5))).sin()
                    + x * x / b(6)
                    + y * y / b(7)
            }
            _ => b(element),
        }
    }

    fn read(reader: &mut Reader, area: &Area) -> Reading<Self> {
        let [base, plan] = reader.numbers([whole("IBASE"), whole("IPLAN")])?;
        let values = match base.whole() {
            1 => reader
                .numbers([real("B1"), real("B2"), real("B3"), real("B4"), real("B5"), real("B6")])?
                .to_vec(),
            2 => {
                let mut head = reader
                    .numbers([whole("NN"), real("XM"), real("RM"), real("Y1"), real("DY1")])?
                    .to_vec();
                let count = head.first().map_or(0, |count| count.whole());
                if !(2..=MOST_ELEMENTS).contains(&count) {
                    let message = format!("NN must be 2 to {MOST_ELEMENTS}, but is {count}");
                    return Err(reader.error("NN", base.at, message));
                }
                head.extend(reader.array(real("B"), count as usize)?);
                head
            }
            3 => reader.array(real("B"), 8)?,
            9 => reader.array(real("H"), area.elements())?,
            other => {
                let message = format!("IBASE must be 1, 2, 3 or 9, but is {other}");
                return Err(reader.error("IBASE", base.at, message));
            }
        };
        match plan.whole() {
            1 => {}
            2 => drop(reader.array(real("PL"), 6)?),
            3 => drop(reader.array(real("XL1 … YH2"), 8)?),
            4 => {
                let [patches] = reader.numbers([whole("NPATCH")])?;
                let patches = patches.whole().clamp(1, 100) as usize;
                reader.array(real("XL, XH, YL, YH"), 4 * patches)?;
                if patches > 1 {
                    reader.array(real("FAC"), patches * (patches - 1) / 2)?;
                }
            }
            other => {
                let message = format!("IPLAN must be 1 to 4, but is {other}");
                return Err(reader.error("IPLAN", plan.at, message));
            }
        }
        Ok(Self { base, plan, values })
    }
}
