//! Reads a number at the start of a text.

/// A number at the start of a text, split into its parts. As in Rust, `1..2` and `1.x` begin with
/// the number `1`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Numeral<'a> {
    pub(crate) whole: &'a str,
    pub(crate) fraction: &'a str,
    pub(crate) exponent: &'a str,
    pub(crate) rest: &'a str,
}

impl<'a> Numeral<'a> {
    pub(crate) fn length_in(text: &'a str) -> usize {
        text.len() - Self::scan(text).rest.len()
    }

    /// Splits `1_2.5e-3f64` into `1_2`, `5`, `-3` and `f64`; missing parts are empty.
    pub(crate) fn scan(text: &'a str) -> Self {
        let is_digit = |c: char| c.is_ascii_digit() || c == '_';
        let digits = |text: &'a str| text.split_at(text.find(|c| !is_digit(c)).unwrap_or(text.len()));
        let (whole, mut rest) = digits(text);
        let (mut fraction, mut exponent) = ("", "");
        if let Some(after) = rest.strip_prefix('.')
            && !after.starts_with(|c: char| c == '.' || c == '_' || c.is_alphabetic())
        {
            (fraction, rest) = digits(after);
        }
        if let Some(after) = rest.strip_prefix(['e', 'E']) {
            let (size, beyond) = digits(after.strip_prefix(['+', '-']).unwrap_or(after));
            if size.contains(|c: char| c.is_ascii_digit()) {
                (exponent, rest) = (&after[..after.len() - beyond.len()], beyond);
            }
        }
        Numeral { whole, fraction, exponent, rest }
    }
}
