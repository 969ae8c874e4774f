//! The JSON schema of a case file, for editors that complete and check TOML.

use serde_json::{Map, Value, json};

use crate::document::Content;
use crate::fields::{ALTERNATIVES, Field, FieldPath, Kind, Requirement, SECTIONS, Section};
use crate::names::FieldNames;

/// The JSON schema (2020-12) of a case file.
pub fn schema() -> Value {
    let mut properties = Map::new();
    for section in SECTIONS {
        if section.name.is_empty() {
            properties.extend(fields(section));
        } else {
            insert(&mut properties, section.name, section_schema(section));
        }
    }
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Case file of schlupf",
        "type": "object",
        "properties": properties,
        "additionalProperties": false,
    })
}

/// Puts the schema of a section in its place: one with a dotted name into the section before it.
fn insert(properties: &mut Map<String, Value>, name: &str, schema: Value) {
    let parent = name.split_once('.').and_then(|(parent, child)| {
        Some((properties.get_mut(parent)?["properties"].as_object_mut()?, child))
    });
    match parent {
        Some((properties, child)) => insert(properties, child, schema),
        None => {
            properties.insert(name.to_owned(), schema);
        }
    }
}

fn fields(section: &Section) -> Map<String, Value> {
    section.fields.iter().map(|field| (field.name().to_owned(), field_schema(field))).collect()
}

fn section_schema(section: &Section) -> Value {
    let mut schema = json!({
        "type": "object",
        "description": section.doc,
        "properties": fields(section),
        "additionalProperties": false,
    });
    let exclusions = exclusions(section);
    if !exclusions.is_empty() {
        schema["allOf"] = Value::Array(exclusions);
    }
    schema
}

/// Fields of a section that exclude each other, pair by pair.
fn exclusions(section: &Section) -> Vec<Value> {
    let name = |path: &FieldPath| (path.section() == section.name).then(|| path.name());
    let mut exclusions = Vec::new();
    for pair in ALTERNATIVES {
        for first in pair.first.iter().filter_map(name) {
            for second in pair.second.iter().filter_map(name) {
                exclusions.push(json!({ "not": { "required": [first, second] } }));
            }
        }
    }
    exclusions
}

fn field_schema(field: &Field) -> Value {
    let mut schema = kind_schema(field.kind, field.requirement);
    let mut description = vec![field.doc.to_owned()];
    let uses: Vec<String> =
        field.uses().map(|(model, names)| format!("{model} {}", names.join(" or "))).collect();
    if !uses.is_empty() {
        description.push(format!("used with {}", uses.join(", or with ")));
    }
    description.extend(field.default.in_words().map(|text| format!("default: {text}")));
    if let Some(value) = field.default_value() {
        schema["default"] = literal(&value.content);
    }
    schema["description"] = description.join("; ").into();
    schema
}

fn literal(content: &Content) -> Value {
    match content {
        Content::Text(text) => text.as_str().into(),
        Content::Integer(number) => (*number).into(),
        Content::Float(number) => (*number).into(),
        Content::Flag(flag) => json!(flag),
        Content::Array(_) | Content::Other(_) => Value::Null,
    }
}

fn kind_schema(kind: Kind, requirement: Requirement) -> Value {
    match kind {
        Kind::Quantity(measure) => json!({
            "type": "string",
            "examples": [format!("1 {}", measure.unit)],
            "$comment": format!("{} in {}; {}", measure.name, measure.examples, requirement.text(measure.unit, &FieldNames::CASE)),
        }),
        Kind::Number => bounded("number", requirement),
        Kind::Count => bounded("integer", requirement),
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Choice(_) => json!({ "oneOf": constants(kind) }),
        Kind::NumberOr(_) => {
            let mut options = constants(kind);
            options.push(bounded("number", requirement));
            json!({ "oneOf": options })
        }
        Kind::Text | Kind::Path => json!({ "type": "string" }),
        Kind::Quantities(_) => json!({ "type": "array", "items": { "type": "string" } }),
        Kind::Numbers => json!({ "type": "array", "items": bounded("number", requirement) }),
    }
}

fn constants(kind: Kind) -> Vec<Value> {
    kind.choices()
        .iter()
        .map(|choice| json!({ "const": choice.name, "description": choice.doc }))
        .collect()
}

fn bounded(kind: &str, requirement: Requirement) -> Value {
    let mut schema = json!({ "type": kind });
    let keywords = [("minimum", "exclusiveMinimum"), ("maximum", "exclusiveMaximum")];
    for (bound, (inclusive, exclusive)) in requirement.bounds().into_iter().zip(keywords) {
        if let Some((bound, belongs)) = bound {
            schema[if belongs { inclusive } else { exclusive }] = bound.into();
        }
    }
    schema
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_has_a_description() {
        let schema = schema();
        for section in SECTIONS.iter().filter(|section| !section.name.is_empty()) {
            for field in section.fields {
                let within =
                    section.name.split('.').fold(&schema, |s, name| &s["properties"][name]);
                let entry = &within["properties"][field.name()];
                assert!(entry["description"].is_string(), "{}", field.path);
            }
        }
        let speed = &schema["properties"]["kinematics"]["properties"]["speed"];
        assert_eq!(speed["type"], "string");
        assert_eq!(speed["default"], "108 km/h");
    }
}
