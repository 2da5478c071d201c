//! Digits above and below the line.

use std::fmt::Display;

/// 0 to 9 and a minus sign as exponents.
pub(crate) const RAISED: [char; 11] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹', '⁻'];
/// 0 to 9 and n as indices.
pub(crate) const LOWERED: [char; 11] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉', 'ₙ'];

/// A whole number as an exponent.
pub(crate) fn raised(power: impl Display) -> String {
    set(&power.to_string(), RAISED)
}

/// Digits as an index.
pub(crate) fn lowered(index: &str) -> String {
    set(index, LOWERED)
}

fn set(number: &str, signs: [char; 11]) -> String {
    number.chars().map(|c| signs[c.to_digit(10).map_or(10, |digit| digit as usize)]).collect()
}
