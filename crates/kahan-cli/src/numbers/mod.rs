//! The scalars that commands compute with, and how their values are written.

mod double_double;
mod scalar;

pub(crate) use double_double::DoubleDouble;
pub(crate) use scalar::{Printable, Rounded, ScalarKind};

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
