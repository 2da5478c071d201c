//! Where a numeral ends, and where its parts meet.

/// The numeral at the start of a text, which ends where Rust's lexer ends it: `1..2` and `1.x`
/// begin with `1`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Numeral<'a> {
    /// The digits before the point, and underscores.
    pub(crate) whole: &'a str,
    /// Those behind it.
    pub(crate) fraction: &'a str,
    /// The exponent with its sign.
    pub(crate) exponent: &'a str,
    /// The text behind the numeral.
    pub(crate) rest: &'a str,
}

impl<'a> Numeral<'a> {
    /// The number of bytes of the numeral that begins a text.
    pub(crate) fn length_in(text: &'a str) -> usize {
        text.len() - Self::scan(text).rest.len()
    }

    /// Splits `1_2.5e-3f64` into `1_2`, `5`, `-3`, `f64`. Parts that are not there are empty.
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
