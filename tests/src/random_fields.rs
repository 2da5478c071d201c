//! The file `random_systems.rs`: the fixed set of random fields, as the macro compiles it.
//!
//! It is written anew by `KAHAN_GOLDEN=overwrite cargo test -p kahan-tests --test back_ends`.

pub use kahan_measure::random_fields::{RandomField, every_field};

/// The text of `random_systems.rs`.
#[must_use]
pub fn written_file() -> String {
    let mut file = String::from(
        "//! Written by `random_fields::written_file`, not by hand: its fields, compiled by the macro.\n\
         //!\n\
         //! [`with_random_systems`](crate::with_random_systems) hands the list to a macro of one's own.\n\n\
         use kahan_core::prelude::*;\n",
    );
    for field in every_field() {
        let block: String = field.block().lines().map(|line| format!("    {line}\n")).collect();
        file += &format!("\nkahan! {{\n{block}}}\n");
    }
    file += "\n/// Calls a macro with every field: `Name: dimension { parameter = p / d, … }, …`.\n\
             #[macro_export]\nmacro_rules! with_random_systems {\n    ($callback:ident) => {\n        $callback! {\n";
    for field in every_field() {
        let parameters: Vec<String> =
            field.parameters.iter().map(|(name, p, d)| format!("{name} = {p} / {d}")).collect();
        let line = format!("{}: {} {{ {} }}", field.name, field.states.len(), parameters.join(", "));
        file += &format!("            {},\n", line.replace("{  }", "{}"));
    }
    file + "        }\n    };\n}\n"
}
