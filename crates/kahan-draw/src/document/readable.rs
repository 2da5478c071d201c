//! Rewrites plain text with typographic signs.

use crate::plot::{subscript, superscript};

const GREEK: [(&str, char); 13] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("eps", 'ε'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("phi", 'φ'),
    ("psi", 'ψ'),
    ("tau", 'τ'),
    ("xi", 'ξ'),
    ("zeta", 'ζ'),
];

/// Writes names, indices, powers and signs in Unicode, for example α₁ for `alpha1`.
pub fn readable(text: &str) -> String {
    let mut readable = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = rest.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(rest.len());
        let taken = match first {
            '^' => power(&rest[1..]).map(|(power, taken)| (power, taken + 1)),
            '_' => index(&rest[1..]).map(|(index, taken)| (index, taken + 1)),
            '-' => sign(readable.chars().next_back(), &rest[1..]).map(|sign| (sign.to_owned(), 1)),
            '~' => Some(("\u{303}".to_owned(), 1)),
            _ if length == 0 => None,
            _ => number(rest).or_else(|| Some((word(&rest[..length]), length))),
        };
        let (written, taken) = taken.unwrap_or_else(|| (first.to_string(), first.len_utf8()));
        readable.push_str(&written);
        rest = &rest[taken..];
    }
    readable.replace("->", "→")
}

fn digits(text: &str) -> &str {
    &text[..text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len())]
}

/// Reads the power after `^`. Returns the power and its length in bytes.
fn power(text: &str) -> Option<(String, usize)> {
    let after = text.strip_prefix('-').unwrap_or(text);
    let length = text.len() - after.len() + digits(after).len();
    (!digits(after).is_empty()).then(|| (superscript(&text[..length]), length))
}

/// Reads the index after `_`. Returns the index and its length in bytes.
fn index(text: &str) -> Option<(String, usize)> {
    match digits(text) {
        "" => (text.starts_with('n') && !text[1..].starts_with(char::is_alphanumeric))
            .then(|| ("ₙ".to_owned(), 1)),
        index => Some((subscript(index), index.len())),
    }
}

/// Returns a minus sign if the hyphen begins a word or stands between spaces.
fn sign(before: Option<char>, after: &str) -> Option<&'static str> {
    let opens = before.is_none_or(|c| matches!(c, ' ' | '(' | ',' | '='));
    let alone = before == Some(' ') && after.starts_with(' ');
    (alone || opens && after.starts_with(char::is_alphanumeric)).then_some("−")
}

/// Returns a number's new text and old length: `1e-3` becomes 10⁻³, and `1.50` becomes 1.5.
fn number(text: &str) -> Option<(String, usize)> {
    if let Some(after) = text.strip_prefix("1e-") {
        let exponent = digits(after);
        return (!exponent.is_empty()).then(|| (format!("10⁻{}", superscript(exponent)), 3 + exponent.len()));
    }
    let whole = digits(text);
    let decimals = digits(text[whole.len()..].strip_prefix('.')?);
    // A number with one decimal, such as 4.1, may be the number of a section, and stays unchanged.
    if whole.is_empty() || decimals.len() < 2 {
        return None;
    }
    let kept = decimals.trim_end_matches('0');
    let point = if kept.is_empty() { "" } else { "." };
    Some((format!("{whole}{point}{kept}"), whole.len() + 1 + decimals.len()))
}

/// Writes Greek names and the Latin `a` as letters with an index: `alpha1` as α₁, `a12` as a₁₂.
fn word(word: &str) -> String {
    let stem = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let letter = match stem {
        "a" => 'a',
        _ => match GREEK.iter().find(|(name, _)| *name == stem) {
            Some((_, letter)) => *letter,
            // Names of systems, such as E1, keep their digits.
            None => return word.to_owned(),
        },
    };
    format!("{letter}{}", subscript(&word[stem.len()..]))
}

#[cfg(test)]
mod tests {
    use super::readable;

    #[test]
    fn names_become_letters_and_other_words_stay() {
        assert_eq!(readable("Table 4, i = 3, at eps = 0"), "Table 4, i = 3, at ε = 0");
        assert_eq!(readable("alpha1 a12 epsilon x~ maxi e1 theta"), "α₁ a₁₂ epsilon x\u{303} maxi e1 theta");
        assert_eq!(readable("Poincaré’s (tau,xi)"), "Poincaré’s (τ,ξ)");
        assert_eq!(readable("K_9, x_n, H_eps, x_no, (x,y) -> (y,x)"), "K₉, xₙ, H_ε, x_no, (x,y) → (y,x)");
    }

    #[test]
    fn signs_powers_and_decimals_are_set() {
        assert_eq!(readable("Lenard-Magri at xi = -1, 1 - P, n-2"), "Lenard-Magri at ξ = −1, 1 − P, n-2");
        assert_eq!(readable("u = s^2, error < 2^-100, x^n"), "u = s², error < 2⁻¹⁰⁰, x^n");
        assert_eq!(
            readable("numerical to 1e-70, 2.5000000, 1.000, 0.6066"),
            "numerical to 10⁻⁷⁰, 2.5, 1, 0.6066"
        );
        assert_eq!(readable("Section 6.3, 10 points, 1/200"), "Section 6.3, 10 points, 1/200");
    }
}
