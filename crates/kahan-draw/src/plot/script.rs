//! Superscript and subscript digits.

use std::fmt::Display;

/// The superscripts 0 to 9 and minus.
pub(crate) const SUPERSCRIPTS: [char; 11] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹', '⁻'];
/// The subscripts 0 to 9 and n.
pub(crate) const SUBSCRIPTS: [char; 11] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉', 'ₙ'];

pub(crate) fn superscript(power: impl Display) -> String {
    with_digits(&power.to_string(), SUPERSCRIPTS)
}

pub(crate) fn subscript(index: &str) -> String {
    with_digits(index, SUBSCRIPTS)
}

fn with_digits(number: &str, signs: [char; 11]) -> String {
    number.chars().map(|c| signs[c.to_digit(10).map_or(10, |digit| digit as usize)]).collect()
}
