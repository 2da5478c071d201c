//! Formats numbers, links to claims, and marks of outcomes for the text of the page.

use maud::{Markup, html};

use super::found::CheckedClaim;
use kahan_paper::{Id, Outcome};

/// Formats a small or large number with a power of ten, for example 1.2·10⁻¹⁶.
pub(super) fn scientific(value: f64) -> Markup {
    let text = format!("{value:.1e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    html! { (mantissa.replace('-', "−")) "·10" sup { (exponent.replace('-', "−")) } }
}

/// Groups the digits of a whole number by threes, with narrow spaces at which no line breaks.
pub(super) fn grouped(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

pub(super) fn anchor(id: &Id) -> String {
    format!("claim-{id}")
}

pub(super) fn link(checked: &CheckedClaim<'_>) -> Markup {
    let id = &checked.claim.id;
    html! { a href=(format!("#{}", anchor(id))) { code { (id) } } }
}

pub(super) fn badge(outcome: Outcome) -> Markup {
    let (class, sign) = match outcome {
        Outcome::Failed => ("failed", "✗"),
        Outcome::Misprint => ("misprint", "✎"),
        Outcome::Numerical(_) => ("numerical", "≈"),
        Outcome::Exact(_) => ("exact", "="),
        Outcome::Proved | Outcome::ProvedModP => ("proved", "✓"),
    };
    let words = match outcome {
        Outcome::Numerical(decimals) => html! { "numerical, 10" sup { "−" (decimals) } },
        Outcome::Misprint => html! { "misprint, corrected" },
        _ => html! { (outcome.words()) },
    };
    html! { span.badge.(class) { span aria-hidden="true" { (sign) " " } (words) } }
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn digits_are_grouped() {
        assert_eq!(grouped(95_282).replace('\u{202f}', " "), "95 282");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_000_000).replace('\u{202f}', " "), "1 000 000");
    }
}
