//! Numbers on the command line and on pages.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
pub(crate) use kahan_study::numbers::ScalarKind;

/// Reads the name of a scalar.
pub(crate) fn scalar() -> impl TypedValueParser<Value = ScalarKind> {
    let names = ScalarKind::ALL.map(|kind| PossibleValue::new(kind.name()).help(kind.meaning()));
    PossibleValuesParser::new(names).map(|name| {
        let kind = ScalarKind::ALL.into_iter().find(|kind| kind.name() == name);
        kind.expect("clap takes no other names")
    })
}

/// A number with this many decimals and a typographic minus sign, for pages and pictures.
pub(crate) fn decimal(value: f64, decimals: usize) -> String {
    format!("{value:.decimals$}").replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::decimal;

    #[test]
    fn numbers_are_rounded_with_a_minus_sign() {
        assert_eq!(decimal(-1.005, 1), "−1.0");
    }
}
