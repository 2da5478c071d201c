//! Names the values of a plan in the generated code.

use kahan_algebra::derived::{ValueName, ValueNames};
use kahan_algebra::plan::{Node, Operation};
use proc_macro2::{Ident, Span};

/// Returns the name of a value, such as `__c_3` for the constant 3. A value without a descriptive
/// name gets a kind and a number, such as `__sum_1`.
pub(super) fn binding(names: &mut ValueNames, node: Node, operation: &Operation) -> Ident {
    let ratio = match operation {
        Operation::Constant(value) => value.as_small_ratio(),
        _ => None,
    };
    let signed = |numerator: i64| {
        let sign = if numerator < 0 { "minus_" } else { "" };
        format!("__c_{sign}{}", numerator.unsigned_abs())
    };
    let name = match ratio {
        Some((numerator, 1)) => signed(numerator),
        Some((numerator, denominator)) => format!("{}_{denominator}", signed(numerator)),
        None => match names.name(node) {
            ValueName::Described(text) => format!("__t_{text}"),
            ValueName::Numbered(what, number) => format!("__{what}_{number}"),
        },
    };
    Ident::new(&name, Span::call_site())
}

#[cfg(test)]
mod tests {
    use quote::quote;

    use crate::expand;

    #[test]
    fn a_negative_constant_has_a_name() {
        let block = "xdot = 1e1500*x; ydot = 1e-1500*y;".parse().expect("tokens");
        let rust = expand(&quote! { ::kahan_core }, block).tokens.to_string();
        assert!(rust.contains("let __c_minus_2 ="), "{rust}");
    }
}
