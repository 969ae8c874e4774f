//! Creep curves over a field as a map: over the creepage and the field, or their largest forces
//! over two fields.

use schlupf::Status;
use schlupf::analysis::creep_curve::{CreepCurve, Creepages};
use schlupf::reporting::{Column, Record, columns};
use schlupf::solution::Resultant;
use serde::ser::{Serialize, SerializeMap, SerializeStruct, Serializer};

use super::{CurveFamily, Member};

/// Values over two axes, of numbers in SI units (temperatures in degC, rises in K).
#[derive(Debug, Clone, PartialEq)]
pub struct CreepMap {
    /// The creepage or force along the curves, or the first field.
    pub x: Axis,
    /// The field in which the curves differ, or the second field.
    pub y: Axis,
    /// Quantities over both.
    pub columns: Vec<MapColumn>,
}

/// An axis of a map.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Axis {
    /// That of the quantity along the curves, such as `creepage_x`, or the dotted path of a field.
    pub name: String,
    /// SI unit of its values; empty if they are dimensionless.
    pub unit: &'static str,
    /// Its values in increasing order, in that unit.
    pub values: Vec<f64>,
}

/// A quantity of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct MapColumn {
    /// Name, as in the table of the curves.
    pub name: &'static str,
    /// SI unit; empty if it is dimensionless.
    pub unit: &'static str,
    /// A row for each value of y, with a value for each of x, in that unit; `None` where it is not
    /// known, or the solution has not converged.
    pub rows: Vec<Vec<Option<f64>>>,
}

impl CreepMap {
    /// A quantity by its name.
    pub fn column(&self, name: &str) -> Option<&MapColumn> {
        self.columns.iter().find(|column| column.name == name)
    }
}

/// Fewest values of a single field that make a map: two curves are seen better as curves.
const FEWEST: usize = 3;

impl CurveFamily {
    /// The curves as a map, if they differ in numbers: over the creepage and one field that has at
    /// least three values, or the largest force of each curve over two fields.
    pub fn map(&self) -> Option<CreepMap> {
        match self.over.len() {
            1 => self.map_of_points(),
            2 => self.map_of_peaks(),
            _ => None,
        }
    }

    fn map_of_points(&self) -> Option<CreepMap> {
        let first = &self.members.first()?.curve;
        let x = |curve: &CreepCurve| -> Vec<f64> {
            curve.points.iter().map(|point| point.abscissa).collect()
        };
        let (abscissae, quantity) = (x(first), first.path.quantity());
        let [columns_of_x, places] =
            [&abscissae, &self.numbers(0)?].map(|numbers| ascending(numbers));
        let is_like = |member: &Member| x(&member.curve) == abscissae;
        if !self.members.iter().all(is_like) || places.len() < FEWEST {
            return None;
        }
        let axis = Axis {
            name: quantity.name().to_owned(),
            unit: quantity.unit(),
            values: columns_of_x.iter().map(|k| abscissae[*k]).collect(),
        };
        let column = |column: &Column<CreepCurve>| {
            let value = |member: usize, point: usize| {
                let curve = &self.members[member].curve;
                let is_converged = curve.points[point].status == Status::Converged;
                known((column.value)(curve, point).number()).filter(|_| is_converged)
            };
            let row = |member: &usize| columns_of_x.iter().map(|k| value(*member, *k)).collect();
            map_column(column, places.iter().map(row).collect())
        };
        let columns = CreepCurve::COLUMNS.iter().map(column).collect();
        Some(CreepMap { x: axis, y: self.axis(0)?, columns: with_values(columns) })
    }

    fn map_of_peaks(&self) -> Option<CreepMap> {
        let [x, y] = [self.axis(0)?, self.axis(1)?];
        let [of_x, of_y] = [self.numbers(0)?, self.numbers(1)?];
        let peaks: Vec<Option<Peak>> =
            self.members.iter().map(|member| Peak::of(&member.curve)).collect();
        let place = |x: f64, y: f64| {
            let mut pairs = of_x.iter().zip(&of_y);
            pairs.position(|(of_x, of_y)| *of_x == x && *of_y == y)
        };
        let column = |column: &Column<Peak>| {
            let value = |x: f64, y: f64| {
                let peak = peaks.get(place(x, y)?)?.as_ref()?;
                known((column.value)(peak, 0).number())
            };
            let row = |y: &f64| x.values.iter().map(|x| value(*x, *y)).collect();
            map_column(column, y.values.iter().map(row).collect())
        };
        let columns = Peak::COLUMNS.iter().map(column).collect();
        Some(CreepMap { columns: with_values(columns), x, y })
    }

    /// The value of a field for each member, if all are numbers.
    fn numbers(&self, field: usize) -> Option<Vec<f64>> {
        self.members.iter().map(|member| Some(member.values.get(field)?.number?.0)).collect()
    }

    /// The axis of a field.
    fn axis(&self, field: usize) -> Option<Axis> {
        let mut values = self.numbers(field)?;
        values.sort_unstable_by(f64::total_cmp);
        values.dedup();
        let (_, unit) = self.members.first()?.values.get(field)?.number?;
        Some(Axis { name: self.over.get(field)?.clone(), unit, values })
    }
}

/// The largest force of a curve: its maximum, or where that is at an end of the range, the force
/// there.
#[derive(Debug, Clone, PartialEq)]
struct Peak {
    creepages: Creepages,
    /// Total creepage ν, dimensionless.
    creepage: f64,
    force: Resultant,
    normalised: Resultant,
    /// |F|/N, dimensionless.
    traction_coefficient: f64,
}

impl Peak {
    /// `None` if a point has not converged: the largest force may have been there.
    fn of(curve: &CreepCurve) -> Option<Self> {
        if !curve.is_converged() {
            return None;
        }
        let peak = |abscissa, force, normalised, traction_coefficient| {
            let creepages = curve.path.at(abscissa);
            let creepage = creepages.x.hypot(creepages.y);
            Self { creepages, creepage, force, normalised, traction_coefficient }
        };
        if let Some(top) = curve.maximum() {
            return Some(peak(top.abscissa, top.force, top.normalised, top.traction_coefficient));
        }
        let larger = |one: &&schlupf::analysis::creep_curve::Point,
                      other: &&schlupf::analysis::creep_curve::Point| {
            one.traction_coefficient.total_cmp(&other.traction_coefficient)
        };
        let end = curve.points.iter().max_by(larger)?;
        Some(peak(end.abscissa, end.force, end.normalised, end.traction_coefficient))
    }
}

/// A peak, one row; forces on the wheel.
impl Record for Peak {
    fn rows(&self) -> usize {
        1
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Peak:
        CreepageX => |peak, _| peak.creepages.x,
        CreepageY => |peak, _| peak.creepages.y,
        Spin => |peak, _| peak.creepages.spin,
        Creepage => |peak, _| peak.creepage,
        ForceX => |peak, _| peak.force.x,
        ForceY => |peak, _| peak.force.y,
        MomentZ => |peak, _| peak.force.moment_z,
        NormalisedX => |peak, _| peak.normalised.x,
        NormalisedY => |peak, _| peak.normalised.y,
        NormalisedMomentZ => |peak, _| peak.normalised.moment_z,
        TractionCoefficient => |peak, _| peak.traction_coefficient,
    };
}

/// The places of numbers in increasing order.
fn ascending(numbers: &[f64]) -> Vec<usize> {
    let mut places: Vec<usize> = (0..numbers.len()).collect();
    places.sort_unstable_by(|one, other| numbers[*one].total_cmp(&numbers[*other]));
    places
}

fn known(number: Option<f64>) -> Option<f64> {
    number.filter(|number| number.is_finite())
}

fn map_column<R: ?Sized>(column: &Column<R>, rows: Vec<Vec<Option<f64>>>) -> MapColumn {
    MapColumn { name: column.name, unit: column.quantity.unit(), rows }
}

/// Without the quantities that are known nowhere.
fn with_values(columns: Vec<MapColumn>) -> Vec<MapColumn> {
    let is_known = |column: &MapColumn| column.rows.iter().flatten().any(Option::is_some);
    columns.into_iter().filter(is_known).collect()
}

impl Serialize for CreepMap {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(3))?;
        map.serialize_entry("x", &self.x)?;
        map.serialize_entry("y", &self.y)?;
        map.serialize_entry("columns", &Columns(&self.columns))?;
        map.end()
    }
}

/// Quantities by their names.
struct Columns<'a>(&'a [MapColumn]);

impl Serialize for Columns<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|column| (column.name, column)))
    }
}

impl Serialize for MapColumn {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut column = serializer.serialize_struct("MapColumn", 2)?;
        column.serialize_field("unit", self.unit)?;
        column.serialize_field("values", &self.rows)?;
        column.end()
    }
}
