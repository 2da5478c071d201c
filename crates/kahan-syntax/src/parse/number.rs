//! Literal text to an exact rational: `0.1` is 1/10, with as many digits as are written, never
//! through `f64`.

use num_bigint::BigInt;
use num_traits::Num;

use crate::diagnostics::Kind;
use crate::rational::{LARGEST_EXPONENT, Rational};
use crate::token::Span;

use super::{Parsed, error};

/// The most digits of a literal.
const MOST_DIGITS: i64 = 2 * LARGEST_EXPONENT;

/// A literal split where its parts meet.
struct Literal<'a> {
    whole: &'a str,
    fraction: &'a str,
    exponent: &'a str,
    suffix: &'a str,
}

/// The exact value of the literal `text`.
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
    let parts = split(text);
    if !parts.suffix.is_empty() {
        let number = &text[..text.len() - parts.suffix.len()];
        return if is_type_suffix(parts.suffix) {
            let help = format!("write `{}`", number.trim_end_matches('_'));
            error(Kind::Number, span, format!("`{text}` carries a type, but numbers here are exact"), help)
        } else {
            let help = format!("write `{number}*{}`", parts.suffix);
            error(Kind::Syntax, span, format!("`{text}`: a product needs its `*`"), help)
        };
    }
    let exponent = parts.exponent.replace('_', "").parse::<i64>().unwrap_or(i64::MAX);
    let digits = [parts.whole, parts.fraction].concat().bytes().filter(u8::is_ascii_digit).count();
    if !(-LARGEST_EXPONENT..=LARGEST_EXPONENT).contains(&exponent) || digits as i64 > MOST_DIGITS {
        return error(
            Kind::TooLarge,
            span,
            format!(
                "this literal is too large: decimal exponents go to {LARGEST_EXPONENT}, and it has at most {MOST_DIGITS} digits"
            ),
            "rescale the variables or the time",
        );
    }
    Ok(Rational::typed(&text.replace('_', "")).expect("a number of this size is read"))
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

/// Splits `1_2.5e-3f64` into `1_2`, `5`, `-3`, `f64`.
fn split(text: &str) -> Literal<'_> {
    let digits =
        |from: usize| from + text[from..].bytes().take_while(|b| b.is_ascii_digit() || *b == b'_').count();
    let byte = |at: usize| text.as_bytes().get(at).copied();
    let whole_end = digits(0);
    let mut end = whole_end;
    let mut fraction = "";
    if byte(end) == Some(b'.') {
        let fraction_end = digits(end + 1);
        fraction = &text[end + 1..fraction_end];
        end = fraction_end;
    }
    let mut exponent = "0";
    if matches!(byte(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(byte(end + 1), Some(b'+' | b'-')));
        let exponent_end = digits(end + 1 + sign);
        if text[end + 1 + sign..exponent_end].bytes().any(|b| b.is_ascii_digit()) {
            exponent = text[end + 1..exponent_end].trim_matches('_');
            end = exponent_end;
        }
    }
    Literal { whole: &text[..whole_end], fraction, exponent, suffix: &text[end..] }
}
