//! The file `random_systems.rs`: random fields as the macro compiles them.
//!
//! Every field is interpreted. Compiled are those in [`COMPILED`], as code for each of them in each
//! scalar is what building the tests costs most: every kind in two dimensions at least, and every
//! dimension. The file is written anew by `KAHAN_GOLDEN=overwrite cargo test -p kahan-tests
//! back_ends`.

pub use kahan_measure::random_fields::{RandomField, every_field};

/// The fields that are compiled, by name: of those in six variables, `Sparse6` has a closed form
/// within the budget of terms, and `Dense6` is eliminated in a loop.
const COMPILED: [&str; 13] = [
    "Affine1", "Scaled1", "Sparse2", "Scaled2", "Spelled2", "Dense2", "Sparse3", "Affine3", "Spelled3",
    "Scaled4", "Affine5", "Sparse6", "Dense6",
];

/// The fields that the macro compiles, and those that are interpreted only.
#[must_use]
pub fn compiled_and_not() -> [Vec<RandomField>; 2] {
    let (compiled, not) =
        every_field().into_iter().partition(|field| COMPILED.contains(&field.name.as_str()));
    [compiled, not]
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
    let [fields, _] = compiled_and_not();
    for field in &fields {
        let block: String = field.block().lines().map(|line| format!("    {line}\n")).collect();
        file += &format!("\nkahan! {{\n{block}}}\n");
    }
    file += "\n/// Calls a macro with every field: `Name: dimension { parameter = p / d, … }, …`.\n\
             #[macro_export]\nmacro_rules! with_random_systems {\n    ($callback:ident) => {\n        $callback! {\n";
    for field in &fields {
        let parameters: Vec<String> =
            field.parameters.iter().map(|(name, p, d)| format!("{name} = {p} / {d}")).collect();
        let line = format!("{}: {} {{ {} }}", field.name, field.states.len(), parameters.join(", "));
        file += &format!("            {},\n", line.replace("{  }", "{}"));
    }
    file + "        }\n    };\n}\n"
}
