//! Numbers typed by a user, with helpful errors.

use std::fmt::Display;

use kahan_algebra::rational::Rational;

/// Reads an exact number such as 3/7, -2, 0.25 or 1e-3, or describes the mistake.
pub fn number(text: &str) -> Result<Rational, String> {
    let text = text.trim();
    Rational::parse(text).ok_or_else(|| {
        let below = text.split_once('/').and_then(|(_, below)| Rational::parse(below));
        if below.is_some_and(|below| below.is_zero()) {
            format!("`{text}` divides by zero")
        } else if has_large_exponent(text) {
            format!("`{text}` is out of reach: decimal exponents go from -4096 to 4096")
        } else {
            format!("`{text}` is not an exact number; write it as 3/7, -2, 0.25 or 1e-3")
        }
    })
}

/// Returns whether the only mistake in `text` is a decimal exponent that is too large.
fn has_large_exponent(text: &str) -> bool {
    let parts = text.split(['e', 'E']).collect::<Vec<_>>();
    let [mantissa, exponent] = parts[..] else { return false };
    let digits = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
    Rational::parse(mantissa).is_some()
        && !digits.is_empty()
        && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// Reads a count from `least` to `most`, such as 1000, 1_000 or 1e3, or describes the mistake.
pub fn whole<T: Copy + Display + TryFrom<i128>>(text: &str, least: T, most: T) -> Result<T, String> {
    let text = text.trim();
    let usual = || format!("write a whole number, {least} or more, such as 1000 or 1e3");
    let too_large = || format!("that is too large: the most is {most}");
    let Some(value) = Rational::parse(text) else {
        return Err(if has_large_exponent(text) && !text.contains("e-") { too_large() } else { usual() });
    };
    if !value.is_integer() || value.is_negative() {
        return Err(usual());
    }
    // A value beyond `i128` is larger than any count.
    let Ok(count) = value.to_string().parse::<i128>() else { return Err(too_large()) };
    let (Ok(lowest), Ok(highest)) = (least.to_string().parse::<i128>(), most.to_string().parse::<i128>())
    else {
        return Err(usual());
    };
    match T::try_from(count) {
        _ if count < lowest => Err(usual()),
        Ok(count_in_type) if count <= highest => Ok(count_in_type),
        _ => Err(too_large()),
    }
}

#[cfg(test)]
mod tests {
    use super::whole;

    #[test]
    fn counts_are_whole() {
        for typed in ["1000", "1e3", "1E3", "1_000", " 1000 ", "10.0e2", "2000/2", "+1000", "1000."] {
            assert_eq!(whole(typed, 0_i64, i64::MAX), Ok(1000), "{typed}");
        }
        for (typed, part) in [
            ("1.5", "whole number, 1 or more"),
            ("-3", "1 or more"),
            ("0", "1 or more"),
            ("1e-3", "whole number"),
            ("many", "whole number"),
            ("1e400", "the most is 9223372036854775807"),
            ("1e99999", "the most is"),
            ("9223372036854775808", "the most is"),
        ] {
            let why = whole(typed, 1_i64, i64::MAX).expect_err(typed);
            assert!(why.contains(part), "{typed}: {why}");
        }
        assert_eq!(whole("18446744073709551615", 0, u64::MAX), Ok(u64::MAX));
        assert!(whole("4294967296", 1, u32::MAX).is_err());
    }
}
