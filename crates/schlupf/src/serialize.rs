//! Serialisation by `serde` where it differs from the fields.

use serde::ser::{Serialize, SerializeStruct, Serializer};

use crate::identification::Parameter;
use crate::interface::roughness::load_curve::LoadCurve;
use crate::message::Names;
use crate::method::Method;
use crate::normal::NormalSummary;
use crate::quantity::Quantity;
use crate::warning::Warning;

/// By its name.
impl Serialize for Quantity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// As its points.
impl Serialize for LoadCurve {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.points().serialize(serializer)
    }
}

/// By its name.
impl Serialize for Method {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// As its quantity.
impl Serialize for Parameter {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.quantity().serialize(serializer)
    }
}

/// As a message with the names of the quantities.
impl Serialize for Warning {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.message(&Names).serialize(serializer)
    }
}

/// With the components of its origin as separate fields.
impl Serialize for NormalSummary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("NormalSummary", 8)?;
        fields.serialize_field("load", &self.load)?;
        fields.serialize_field("semi_axis_x", &self.semi_axis_x)?;
        fields.serialize_field("semi_axis_y", &self.semi_axis_y)?;
        fields.serialize_field("peak_pressure", &self.peak_pressure)?;
        fields.serialize_field("approach", &self.approach)?;
        fields.serialize_field("origin_x", &self.origin.map(|[x, _]| x))?;
        fields.serialize_field("origin_y", &self.origin.map(|[_, y]| y))?;
        fields.serialize_field("parts", &self.parts)?;
        fields.end()
    }
}
