//! The random fields of `random_systems.rs`, compiled by the macro over ℚ.
//!
//! Only the fields in `IN_FLOATS` are also compiled over floats, because this takes long.
//! `KAHAN_GOLDEN=overwrite cargo test -p kahan-tests back_ends` rewrites `random_systems.rs`.

pub use kahan_judge::random_fields::RandomField;
use kahan_judge::random_fields::{
    DIMENSIONS, Draw, FieldGenerator, Tree, affine, dense, scaled, sparse, spelled,
};
use num_rational::BigRational;

use crate::exact::q;

/// A value p/d for each parameter, as (name, p, d). Floats represent these values exactly.
const PARAMETERS: [(&str, i64, i64); 3] = [("a", 3, 2), ("b", -3, 8), ("k", 9, 4)];

const KINDS: [(&str, FieldGenerator); 5] =
    [("sparse", sparse), ("affine", affine), ("scaled", scaled), ("spelled", spelled), ("dense", dense)];

/// Returns the fields: each kind in every dimension, from fixed seeds.
fn every_field() -> Vec<RandomField> {
    let of = |n: usize| {
        KINDS.into_iter().map(move |(kind, make)| make(n, &mut Draw::seeded(&format!("{kind} {n}"))))
    };
    (1..=DIMENSIONS).flat_map(of).collect()
}

/// Returns the values of a field's parameters.
#[must_use]
pub fn parameter_values(field: &RandomField) -> Vec<BigRational> {
    values(field).map(|(_, p, d)| q(p, d)).collect()
}

fn values(field: &RandomField) -> impl Iterator<Item = (&'static str, i64, i64)> {
    PARAMETERS.into_iter().filter(|(name, ..)| field.parameters.contains(name))
}

/// Evaluates f(x) from the expression trees.
#[must_use]
pub fn value_of(field: &RandomField, x: &[BigRational]) -> Vec<BigRational> {
    let parameters = values(field).map(|(name, p, d)| (name, q(p, d)));
    let names: Vec<(&str, BigRational)> =
        field.states.iter().copied().zip(x.iter().cloned()).chain(parameters).collect();
    field.equations.iter().map(|equation| value(equation, &names)).collect()
}

/// Evaluates an expression tree. Literals are read independently of the front end.
fn value(tree: &Tree, names: &[(&str, BigRational)]) -> BigRational {
    let values = |trees: &[Tree]| trees.iter().map(|tree| value(tree, names)).collect::<Vec<_>>().into_iter();
    match tree {
        Tree::Literal(digits) => decimal(digits),
        Tree::Name(name) => {
            let known = names.iter().find(|(known, _)| known == name);
            known.unwrap_or_else(|| panic!("no value for {name}")).1.clone()
        }
        Tree::Negated(a) => -value(a, names),
        Tree::Sum(terms) => values(terms).sum(),
        Tree::Product(factors) => values(factors).product(),
        Tree::Quotient(a, b) => value(a, names) / value(b, names),
        Tree::Power(base, exponent) => value(base, names).pow(*exponent as i32),
    }
}

fn decimal(text: &str) -> BigRational {
    let digits = text.replace('_', "");
    let (mantissa, exponent) = digits.split_once('e').unwrap_or((&digits, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent: i32 = exponent.parse().expect("an exponent");
    let number = format!("{whole}{fraction}").parse().expect("digits");
    BigRational::from_integer(number) * q(10, 1).pow(exponent - fraction.len() as i32)
}

/// The fields that are also compiled over floats.
const IN_FLOATS: [&str; 13] = [
    "Affine1", "Scaled1", "Sparse2", "Scaled2", "Spelled2", "Dense2", "Sparse3", "Affine3", "Spelled3",
    "Scaled4", "Affine5", "Sparse6", "Dense6",
];

fn in_floats_and_not() -> [Vec<RandomField>; 2] {
    let (floats, not) = every_field().into_iter().partition(|field| IN_FLOATS.contains(&field.name.as_str()));
    [floats, not]
}

/// Returns all fields in the order of [`maps::random`](crate::maps::random).
#[must_use]
pub fn in_order() -> Vec<RandomField> {
    in_floats_and_not().into_iter().flatten().collect()
}

/// Returns the text of `random_systems.rs`.
#[must_use]
pub fn written_file() -> String {
    let mut file = String::from(
        "//! Written by `random_fields::written_file`, not by hand: its fields, compiled by the macro.\n\
         //!\n\
         //! [`with_random_systems`](crate::with_random_systems) hands the list to a macro \
         of one's own.\n\n\
         use kahan_core::prelude::*;\n",
    );
    for field in in_order() {
        let block: String = field.block().lines().map(|line| format!("    {line}\n")).collect();
        file += &format!("\nkahan! {{\n{block}}}\n");
    }
    let [floats, others] = in_floats_and_not().map(|fields| listed(&fields));
    file += &format!(
        "\n/// Calls a macro with every field, `Name: dimension {{ parameter = p / d, … }}`: those that are\n\
         /// compiled over floats, too, and the others.\n\
         #[macro_export]\nmacro_rules! with_random_systems {{\n    ($callback:ident) => {{\n        $callback! {{\n\
         \x20           in_floats {{\n{floats}            }}\n            over_rationals {{\n{others}            }}\n\
         \x20       }}\n    }};\n}}\n"
    );
    file
}

fn listed(fields: &[RandomField]) -> String {
    let line = |field: &RandomField| {
        let values: Vec<String> = values(field).map(|(name, p, d)| format!("{name} = {p} / {d}")).collect();
        let line = format!("{}: {} {{ {} }}", field.name, field.states.len(), values.join(", "));
        format!("                {},\n", line.replace("{  }", "{}"))
    };
    fields.iter().map(line).collect()
}
