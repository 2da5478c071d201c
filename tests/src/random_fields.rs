//! The file `random_systems.rs`: random fields as the macro compiles them.
//!
//! All of them are compiled over ℚ. Code over floats costs most of what building the tests takes,
//! so there are such steps of those in `IN_FLOATS` only: every kind in two dimensions at least, and
//! every dimension. The file is written anew by `KAHAN_GOLDEN=overwrite cargo test -p kahan-tests
//! back_ends`.

pub use kahan_study::random_fields::{RandomField, every_field};

/// The fields that are compiled over floats, too, by name: of those in six variables, `Sparse6` has
/// a closed form within the budget of terms, and `Dense6` is eliminated in a loop.
const IN_FLOATS: [&str; 13] = [
    "Affine1", "Scaled1", "Sparse2", "Scaled2", "Spelled2", "Dense2", "Sparse3", "Affine3", "Spelled3",
    "Scaled4", "Affine5", "Sparse6", "Dense6",
];

/// The fields that are compiled over floats, too, and then those over ℚ only.
fn in_floats_and_not() -> [Vec<RandomField>; 2] {
    let (floats, not) = every_field().into_iter().partition(|field| IN_FLOATS.contains(&field.name.as_str()));
    [floats, not]
}

/// Every field, in the order of [`maps::random`](crate::maps::random): those over floats, too,
/// first.
#[must_use]
pub fn in_order() -> Vec<RandomField> {
    in_floats_and_not().into_iter().flatten().collect()
}

/// The text of `random_systems.rs`.
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

/// A line for each field.
fn listed(fields: &[RandomField]) -> String {
    let line = |field: &RandomField| {
        let values = field.parameters.iter().map(|(name, p, d)| format!("{name} = {p} / {d}"));
        let values: Vec<String> = values.collect();
        let line = format!("{}: {} {{ {} }}", field.name, field.states.len(), values.join(", "));
        format!("                {},\n", line.replace("{  }", "{}"))
    };
    fields.iter().map(line).collect()
}
