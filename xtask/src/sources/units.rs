//! Every public number of the core names its unit.

use syn::visit::{self, Visit};
use syn::{
    Attribute, Expr, Field, Fields, GenericArgument, Ident, ImplItem, Item, ItemEnum, ItemStruct,
    ItemTrait, Lit, Meta, PathArguments, ReturnType, Signature, TraitItem, Type, TypeParamBound,
    Visibility,
};

use super::syntax::{is_test_impl_item, is_test_item};
use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule = Rule {
    name: "units",
    demand: "the doc comment of a public number of the core says `in <unit>`, `in the unit of …` or `dimensionless`",
    check,
};

const CORE: &str = "crates/schlupf/src/";

/// Possible beginnings of a unit, apart from `1/`.
const UNITS: [&str; 14] =
    ["m", "mm", "s", "kg", "N", "Pa", "MPa", "GPa", "K", "degC", "rad", "W", "J", "Hz"];

fn check(sources: &[Source]) -> Vec<Finding> {
    let core = sources.iter().filter(|source| source.path.starts_with(CORE) && !source.for_tests);
    core.flat_map(check_file).collect()
}

fn check_file(source: &Source) -> Vec<Finding> {
    let mut numbers = Numbers { without_unit: Vec::new() };
    numbers.visit_file(&source.file);
    let findings = numbers.without_unit.into_iter().map(|(line, name)| {
        source.finding(line, format!("`{name}` has no unit in its doc comment"))
    });
    findings.collect()
}

/// Whether a type is f64 or a container of it.
fn is_number(ty: &Type) -> bool {
    match ty {
        Type::Array(array) => is_number(&array.elem),
        Type::Group(group) => is_number(&group.elem),
        Type::Paren(paren) => is_number(&paren.elem),
        Type::Reference(reference) => is_number(&reference.elem),
        Type::Slice(slice) => is_number(&slice.elem),
        Type::Tuple(tuple) => tuple.elems.iter().any(is_number),
        Type::ImplTrait(implementor) => implementor.bounds.iter().any(|bound| match bound {
            TypeParamBound::Trait(bound) => path_is_number(&bound.path),
            _ => false,
        }),
        Type::Path(path) => path_is_number(&path.path),
        _ => false,
    }
}

fn path_is_number(path: &syn::Path) -> bool {
    let Some(last) = path.segments.last() else { return false };
    match &last.arguments {
        PathArguments::None => last.ident == "f64",
        PathArguments::AngleBracketed(arguments) => {
            arguments.args.iter().any(|argument| match argument {
                GenericArgument::Type(ty) => is_number(ty),
                GenericArgument::AssocType(item) => is_number(&item.ty),
                _ => false,
            })
        }
        // A function of numbers is not a number.
        PathArguments::Parenthesized(_) => false,
    }
}

/// The doc comment, with line breaks as spaces.
fn doc(attributes: &[Attribute]) -> String {
    let lines = attributes.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Str(text) => Some(text.value()),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    });
    let text: Vec<String> = lines.collect();
    text.join(" ").split_whitespace().collect::<Vec<_>>().join(" ")
}

fn names_unit(doc: &str) -> bool {
    let words: Vec<&str> =
        doc.split([' ', ',', ';', '(']).filter(|word| !word.is_empty()).collect();
    doc.to_lowercase().contains("dimensionless")
        || doc.contains("in the unit of ")
        || words.windows(2).any(|pair| pair[0] == "in" && is_unit(pair[1]))
}

/// Whether a word is a unit or the beginning of one: `N/m³.`, `1/m`, `W/`.
fn is_unit(word: &str) -> bool {
    let symbol = word.strip_prefix("1/").unwrap_or(word);
    let end = symbol.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(symbol.len());
    let (symbol, rest) = symbol.split_at(end);
    UNITS.contains(&symbol) && !rest.starts_with(['-', '_', '\'', '’'])
}

/// Collects the public numbers whose doc comments name no unit.
struct Numbers {
    /// Line and name.
    without_unit: Vec<(usize, String)>,
}

impl Numbers {
    fn demand(&mut self, ident: &Ident, attributes: &[Attribute]) {
        if !names_unit(&doc(attributes)) {
            self.without_unit.push((ident.span().start().line, ident.to_string()));
        }
    }

    fn function(&mut self, signature: &Signature, attributes: &[Attribute]) {
        if matches!(&signature.output, ReturnType::Type(_, ty) if is_number(ty)) {
            self.demand(&signature.ident, attributes);
        }
    }

    /// The fields of a struct or variant. An unnamed field is documented at its owner.
    fn fields<'a>(
        &mut self,
        fields: impl Iterator<Item = &'a Field>,
        owner: &Ident,
        owners_attributes: &[Attribute],
    ) {
        for field in fields.filter(|field| is_number(&field.ty)) {
            match &field.ident {
                Some(name) => self.demand(name, &field.attrs),
                None if names_unit(&doc(&field.attrs)) => {}
                None => self.demand(owner, owners_attributes),
            }
        }
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

impl<'ast> Visit<'ast> for Numbers {
    fn visit_item(&mut self, item: &'ast Item) {
        if is_test_item(item) {
            return;
        }
        match item {
            Item::Const(item) if is_public(&item.vis) && is_number(&item.ty) => {
                self.demand(&item.ident, &item.attrs);
            }
            Item::Static(item) if is_public(&item.vis) && is_number(&item.ty) => {
                self.demand(&item.ident, &item.attrs);
            }
            Item::Fn(item) if is_public(&item.vis) => self.function(&item.sig, &item.attrs),
            _ => {}
        }
        visit::visit_item(self, item);
    }

    fn visit_item_struct(&mut self, item: &'ast ItemStruct) {
        let public = item.fields.iter().filter(|field| is_public(&field.vis));
        self.fields(public, &item.ident, &item.attrs);
    }

    fn visit_item_enum(&mut self, item: &'ast ItemEnum) {
        if !is_public(&item.vis) {
            return;
        }
        for variant in &item.variants {
            if !matches!(variant.fields, Fields::Unit) {
                self.fields(variant.fields.iter(), &variant.ident, &variant.attrs);
            }
        }
    }

    fn visit_item_trait(&mut self, item: &'ast ItemTrait) {
        if !is_public(&item.vis) {
            return;
        }
        for item in &item.items {
            match item {
                TraitItem::Fn(item) => self.function(&item.sig, &item.attrs),
                TraitItem::Const(item) if is_number(&item.ty) => {
                    self.demand(&item.ident, &item.attrs);
                }
                _ => {}
            }
        }
    }

    // The items of a trait have their doc comments, and no visibility of their own, at the trait.
    fn visit_impl_item(&mut self, item: &'ast ImplItem) {
        if is_test_impl_item(item) {
            return;
        }
        match item {
            ImplItem::Const(item) if is_public(&item.vis) && is_number(&item.ty) => {
                self.demand(&item.ident, &item.attrs);
            }
            ImplItem::Fn(item) if is_public(&item.vis) => self.function(&item.sig, &item.attrs),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, lines};
    use super::*;

    const FILE: &str = "crates/schlupf/src/interface/heat.rs";

    #[test]
    fn every_public_number_of_the_core_names_its_unit() {
        assert_holds(&RULE);
    }

    #[test]
    fn units_are_recognised() {
        for doc in [
            "Pressure, in Pa.",
            "Stiffness (in N/m³).",
            "Spin, in 1/m.",
            "Conductivity, in W/(m K)",
            "Force, in N (or normalised).",
            "Share; dimensionless.",
            "Dimensionless.",
            "Bounds, in the unit of the quantity.",
        ] {
            assert!(names_unit(doc), "{doc}");
        }
        for doc in ["", "Pressure.", "Pressure in the patch.", "Slip in m-direction.", "begin m"] {
            assert!(!names_unit(doc), "{doc}");
        }
    }

    #[test]
    fn numbers_without_a_unit_are_found_wherever_they_are_public() {
        let text = "
            pub const A: f64 = 1.0;
            pub struct B { pub b: Option<f64>, c: f64, /// In all, in\n /// Pa.\n pub d: [f64; 2] }
            pub enum E { F(f64) }
            pub trait T { fn t(&self) -> Vec<f64>; }
            impl B { pub fn b(&self) -> Result<(f64, f64), ()> { Err(()) } fn c(&self) -> f64 { 1.0 } }
            pub fn g(f: f64) -> Box<dyn Fn(f64) -> f64> { h() }
            #[cfg(test)] mod tests { pub const K: f64 = 1.0; }";
        // The doc comment in B takes two lines more.
        assert_eq!(lines(&RULE, FILE, text), [2, 3, 6, 7, 8]);
    }

    #[test]
    fn other_crates_are_free() {
        assert_eq!(lines(&RULE, "crates/schlupf-tasks/src/a.rs", "pub const A: f64 = 1.0;"), []);
    }
}
