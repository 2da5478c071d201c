//! Superscript and subscript digits.

use std::fmt::Display;

/// The superscripts 0 to 9 and minus.
pub(crate) const RAISED: [char; 11] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹', '⁻'];
/// The subscripts 0 to 9 and n.
pub(crate) const LOWERED: [char; 11] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉', 'ₙ'];

pub(crate) fn raised(power: impl Display) -> String {
    set(&power.to_string(), RAISED)
}

pub(crate) fn lowered(index: &str) -> String {
    set(index, LOWERED)
}

fn set(number: &str, signs: [char; 11]) -> String {
    number.chars().map(|c| signs[c.to_digit(10).map_or(10, |digit| digit as usize)]).collect()
}
