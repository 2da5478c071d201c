//! Exact numbers as people type them.

use super::Rational;

impl Rational {
    /// A decimal or a quotient of two, with a sign in front: `3/7`, `-2`, `0.25`, `1e-3`, `1_000`,
    /// `.5`, `5.`.
    ///
    /// `None` for what is no such number, divides by zero, or has an exponent beyond ±4096.
    #[must_use]
    pub fn typed(text: &str) -> Option<Self> {
        let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
        let size = match unsigned.split_once('/') {
            Some((above, below)) => decimal(above)?.checked_div(&decimal(below)?)?,
            None => decimal(unsigned)?,
        };
        Some(if text.starts_with('-') { -size } else { size })
    }
}

/// A decimal without a sign. Beyond what the language reads, as people type it: `.5`, `5.`,
/// `1_000`.
fn decimal(text: &str) -> Option<Rational> {
    let text = without_separators(text);
    let (mantissa, exponent) = text.split_at(text.find(['e', 'E']).unwrap_or(text.len()));
    if !mantissa.bytes().any(|byte| byte.is_ascii_digit()) || mantissa.contains(['+', '-', '/']) {
        return None;
    }
    let whole = if mantissa.starts_with('.') { "0" } else { "" };
    Rational::parse(&format!("{whole}{}{exponent}", mantissa.strip_suffix('.').unwrap_or(mantissa)))
}

/// The text without each `_` that stands between two digits.
fn without_separators(text: &str) -> String {
    let is_digit =
        |at: Option<usize>| at.and_then(|at| text.as_bytes().get(at)).is_some_and(u8::is_ascii_digit);
    let kept = text.char_indices();
    let kept = kept.filter(|&(at, c)| c != '_' || !is_digit(at.checked_sub(1)) || !is_digit(Some(at + 1)));
    kept.map(|(_, c)| c).collect()
}

#[cfg(test)]
mod tests {
    use super::Rational;

    #[test]
    fn numbers_are_read_as_people_type_them() {
        for (typed, meant) in [
            (".1", "1/10"),
            ("-.25", "-1/4"),
            ("5.", "5"),
            ("+3/7", "3/7"),
            (".1/.3", "1/3"),
            ("1_000.5", "2001/2"),
            ("1.5E3", "1500"),
            (".5e-1", "1/20"),
        ] {
            assert_eq!(
                Rational::typed(typed).map(|value| value.to_string()).as_deref(),
                Some(meant),
                "{typed}"
            );
        }
        for wrong in [
            "", ".", "-", "--1", "1/-2", "1e", "1e1.5", "e3", "1__0", "_1", "1_", "0x10", "1/0", "1 2", "inf",
        ] {
            assert!(Rational::typed(wrong).is_none(), "{wrong}");
        }
    }
}
