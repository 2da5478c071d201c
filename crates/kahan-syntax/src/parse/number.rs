//! Reads numbers as exact rationals. For example, `0.1` becomes 1/10 and is never rounded to `f64`.

use num_bigint::BigInt;
use num_traits::Num;

use crate::diagnostics::Kind;
use crate::rational::numeral::Numeral;
use crate::rational::{LARGEST_EXPONENT, Rational};
use crate::token::Span;

use super::{Parsed, error};

const MOST_DIGITS: i64 = 2 * LARGEST_EXPONENT;

pub(super) fn parse_number(text: &str, span: Span) -> Parsed<Rational> {
    if !text.starts_with(|c: char| c.is_ascii_digit()) {
        return error(Kind::Number, span, format!("{text} is not a number"), "write a number or a name");
    }
    if let Some(radix) = radix(text) {
        let digits: String = text[2..].chars().filter(|&c| c != '_').collect();
        let help = BigInt::from_str_radix(&digits, radix)
            .map_or_else(|_| "write it in decimal".to_owned(), |value| format!("write `{value}`"));
        return error(Kind::Number, span, format!("`{text}` is not decimal"), help);
    }
    if let Some((number, factor)) = product(text) {
        let help = format!("write `{number}*{factor}`");
        return error(Kind::Syntax, span, format!("`{text}`: a product needs its `*`"), help);
    }
    let Numeral { whole, fraction, rest: suffix, .. } = Numeral::scan(text);
    if !suffix.is_empty() {
        let help = format!("write `{}`", text[..text.len() - suffix.len()].trim_end_matches('_'));
        let message = format!("`{text}` carries a type, but numbers here are exact");
        return error(Kind::Number, span, message, help);
    }
    let digits = [whole, fraction].concat().bytes().filter(u8::is_ascii_digit).count();
    let is_short = digits as i64 <= MOST_DIGITS;
    match is_short.then(|| Rational::parse(&text.replace('_', ""))).flatten() {
        Some(value) => Ok(value),
        None => error(
            Kind::TooLarge,
            span,
            format!(
                "this literal is too large: decimal exponents go to {LARGEST_EXPONENT}, and it has at most {MOST_DIGITS} digits"
            ),
            "rescale the variables or the time",
        ),
    }
}

pub(crate) fn product(text: &str) -> Option<(&str, &str)> {
    let suffix = Numeral::scan(text).rest;
    let is_product = radix(text).is_none() && !suffix.is_empty() && !is_type_suffix(suffix);
    is_product.then(|| text.split_at(text.len() - suffix.len()))
}

fn radix(text: &str) -> Option<u32> {
    match text.get(..2)? {
        "0x" | "0X" => Some(16),
        "0o" => Some(8),
        "0b" => Some(2),
        _ => None,
    }
}

fn is_type_suffix(suffix: &str) -> bool {
    let suffix = suffix.trim_start_matches('_');
    let width = suffix.strip_prefix(['f', 'i', 'u']);
    matches!(width, Some("8" | "16" | "32" | "64" | "128" | "size"))
}
