//! Friction: digits V and L.

use super::control::Control;
use super::given::{Given, Item, angle, real, whole};
use super::reader::{Reader, Reading};

/// A law of friction with its parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Friction {
    /// Digit L, 0 to 6 without 1.
    pub law: Given,
    /// Digit V, 0 to 3.
    pub variation: Given,
    /// The parameters: one set, or one for each place.
    pub sets: Vec<[Given; 5]>,
    /// The places: ALPHA in rad, or SVF in mm; none for rows of the grid.
    pub places: Vec<Given>,
    /// MEMDST and MEM_S0, unless the law is that of Coulomb.
    pub memory: Option<[Given; 2]>,
}

/// Largest number of control points over which friction varies.
const MOST_SETS: i64 = 10_000;

impl Friction {
    /// Reads the parameters of a new law; `rows` is the number of rows of the grid.
    pub fn read(reader: &mut Reader, control: &Control, rows: usize) -> Reading<Self> {
        let (law, variation) = (control.friction_law, control.friction_variation);
        let place = match variation.whole() {
            1 => Some(angle("ALPHA")),
            2 => Some(real("SVF")),
            _ => None,
        };
        let count = if place.is_some() {
            let [count] = reader.numbers([whole("NVF")])?;
            if !(1..=MOST_SETS).contains(&count.whole()) {
                let message = format!("NVF must be 1 to {MOST_SETS}, but is {}", count.whole());
                return Err(reader.error("NVF", count.at, message));
            }
            count.whole() as usize
        } else if variation.is(3) {
            rows
        } else {
            1
        };
        let (mut sets, mut places) = (Vec::new(), Vec::new());
        for _ in 0..count {
            let (at, set) = parameters(reader, law, place)?;
            sets.push(set);
            places.extend(at);
        }
        let memory =
            if law.is(0) { None } else { Some(reader.numbers([real("MEMDST"), real("MEM_S0")])?) };
        Ok(Self { law, variation, sets, places, memory })
    }

    /// The coefficient of friction without slip at low temperatures, of the first set.
    pub fn static_coefficient(&self) -> f64 {
        let [a, b, _, d, _] = self.first().map(|given| given.value);
        match self.law.whole() {
            2..=4 => a + b + d,
            _ => a,
        }
    }

    /// What relative forces refer to over the normal force: the coefficient of friction without
    /// slip, or 1 where it varies across the contact.
    pub fn force_scale(&self) -> f64 {
        if matches!(self.variation.whole(), 1 | 3) { 1.0 } else { self.static_coefficient() }
    }

    /// Each set by itself.
    pub fn each(&self) -> impl Iterator<Item = Self> {
        self.sets.iter().map(|set| Self { sets: vec![*set], ..self.clone() })
    }

    /// The set at a place, linear between ascending ones and constant outside.
    pub fn between(&self, places: &[f64], at: f64) -> Self {
        let mut set = self.first();
        for (k, given) in set.iter_mut().enumerate() {
            let values: Vec<f64> = self.sets.iter().map(|set| set[k].value).collect();
            given.value = interpolated(places, &values, at);
        }
        Self { sets: vec![set], ..self.clone() }
    }

    /// Whether the first set is that of another one with coefficients that are so many times as
    /// large.
    pub fn is(&self, other: &Self, factor: f64) -> bool {
        let coefficients: &[usize] = match self.law.whole() {
            0 => &[0, 1],
            6 => &[0, 2],
            _ => &[0, 1, 3],
        };
        let expected = |k: usize| {
            let value = other.first()[k].value;
            if coefficients.contains(&k) { factor * value } else { value }
        };
        let is_so = |(k, given): (usize, &Given)| {
            (given.value - expected(k)).abs() <= ROUNDING * given.value.abs()
        };
        self.first().iter().enumerate().all(is_so)
    }

    /// The first set; there is one always.
    pub fn first(&self) -> [Given; 5] {
        let none = Given { value: 0.0, ..self.law };
        self.sets.first().copied().unwrap_or([none; 5])
    }
}

/// Rounding of parameters in an input file, relative.
const ROUNDING: f64 = 1e-6;

/// Linear between ascending places, constant outside.
fn interpolated(places: &[f64], values: &[f64], at: f64) -> f64 {
    let next = places.partition_point(|place| *place < at).clamp(1, places.len().max(2) - 1);
    match (places.get(next - 1..=next), values.get(next - 1..=next)) {
        (Some(&[left, right]), Some(&[below, above])) => {
            let part = ((at - left) / (right - left)).clamp(0.0, 1.0);
            below + part * (above - below)
        }
        _ => values.first().copied().unwrap_or_default(),
    }
}

/// A place and its parameters, in the order of the input; those that the law lacks are zero.
fn parameters(
    reader: &mut Reader,
    law: Given,
    place: Option<Item>,
) -> Reading<(Option<Given>, [Given; 5])> {
    let items: &[Item] = match law.whole() {
        0 => &[real("FSTAT"), real("FKIN")],
        2 => &[real("FKIN"), real("FLIN1"), real("SABSH1"), real("FLIN2"), real("SABSH2")],
        3 => &[real("FKIN"), real("FRAT1"), real("SABSH1"), real("FRAT2"), real("SABSH2")],
        4 => &[real("FKIN"), real("FEXP1"), real("SABSH1"), real("FEXP2"), real("SABSH2")],
        6 => &[real("FREF"), real("TREF"), real("DFHEAT"), real("DTHEAT")],
        _ => {
            let message = "L must be 0, 2, 3, 4 or 6 where a law of friction is given, but is 5 (the law of \
                           Polach, whose values the input file has no place for)";
            return Err(reader.error("L", law.at, message.to_owned()));
        }
    };
    let items: Vec<Item> = place.into_iter().chain(items.iter().copied()).collect();
    let given = reader.group_of(&items)?;
    let (at, given) = given.split_at(usize::from(place.is_some()));
    let set = std::array::from_fn(|k| {
        given.get(k).copied().unwrap_or(Given { name: "", value: 0.0, at: law.at })
    });
    Ok((at.first().copied(), set))
}
