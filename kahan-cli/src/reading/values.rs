//! Exact numbers, times and coordinates behind options; what is wrong with them becomes a
//! [`Refusal`].

use std::fmt::Display;

use kahan_algebra::rational::Rational;

use crate::printing::Refusal;

/// An exact number; `what` names it in the refusal.
pub(crate) fn number(text: &str, what: &str) -> Result<Rational, Refusal> {
    let text = text.trim();
    exact(text).ok_or_else(|| {
        let below = text.split_once('/').and_then(|(_, below)| decimal(below));
        Refusal::new(if below.is_some_and(|below| below.is_zero()) {
            format!("{what}: `{text}` divides by zero")
        } else if has_large_exponent(text) {
            format!("{what}: `{text}` is out of reach: decimal exponents go from -4096 to 4096")
        } else {
            format!("{what}: `{text}` is not an exact number; write it as 3/7, -2, 0.25 or 1e-3")
        })
    })
}

/// A decimal or a quotient of two, with a sign in front.
fn exact(text: &str) -> Option<Rational> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    let size = match unsigned.split_once('/') {
        Some((above, below)) => decimal(above)?.checked_div(&decimal(below)?)?,
        None => decimal(unsigned)?,
    };
    Some(if text.starts_with('-') { -size } else { size })
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

/// Whether it is a number but for the size of its exponent.
fn has_large_exponent(text: &str) -> bool {
    let parts = text.split(['e', 'E']).collect::<Vec<_>>();
    let [mantissa, exponent] = parts[..] else { return false };
    let digits = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
    exact(mantissa).is_some() && !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// A count from `least` to `most`: 1000, 1_000, 1e3. What is wrong becomes a sentence for clap.
pub(crate) fn whole<T: Copy + Display + TryFrom<i128>>(text: &str, least: T, most: T) -> Result<T, String> {
    let text = text.trim();
    let usual = || format!("write a whole number, {least} or more, such as 1000 or 1e3");
    let too_large = || format!("that is too large: the most is {most}");
    let Some(value) = exact(text) else {
        return Err(if has_large_exponent(text) && !text.contains("e-") { too_large() } else { usual() });
    };
    if !value.is_integer() || value.is_negative() {
        return Err(usual());
    }
    // What is no i128 is larger than any count.
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

/// A time bound in seconds.
pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.trim().parse().ok().filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0);
    seconds.ok_or_else(|| "write a number of seconds above 0, such as 60 or 0.5".to_owned())
}

/// The coordinates behind `--at`, one a state.
pub(crate) fn coordinates(text: &str, states: &[String]) -> Result<Vec<Rational>, Refusal> {
    let parts: Vec<&str> = text.split(',').collect();
    if parts.len() != states.len() {
        let (expected, plural) = (states.len(), if states.len() == 1 { "" } else { "s" });
        let names = states.join(",");
        return Err(Refusal::new(format!(
            "--at: {expected} coordinate{plural} {names} expected, {} given",
            parts.len()
        )));
    }
    parts.iter().zip(states).map(|(part, state)| number(part, &format!("--at, coordinate {state}"))).collect()
}

/// The values behind `--param NAME=V`, in the order of the parameters; `None` for one not given.
pub(super) fn given_values(
    given: &[String],
    names: &[String],
    system: &str,
) -> Result<Vec<Option<Rational>>, Refusal> {
    let mut values: Vec<Option<Rational>> = vec![None; names.len()];
    for text in given {
        let Some((name, value)) = text.split_once('=') else {
            return Err(Refusal::new(format!("--param: `{text}` is not NAME=VALUE, as in --param xi=1/2")));
        };
        let name = name.trim();
        let Some(index) = names.iter().position(|known| known == name) else {
            let known = if names.is_empty() {
                "it has none".to_owned()
            } else {
                format!("it has {}", names.join(", "))
            };
            return Err(Refusal::new(format!("--param: `{name}` is no parameter of {system}: {known}")));
        };
        if values[index].is_some() {
            return Err(Refusal::new(format!("--param: `{name}` is given twice")));
        }
        values[index] = Some(number(value, &format!("--param {name}"))?);
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::{exact, whole};

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
            assert_eq!(exact(typed).map(|value| value.to_string()).as_deref(), Some(meant), "{typed}");
        }
        for wrong in [
            "", ".", "-", "--1", "1/-2", "1e", "1e1.5", "e3", "1__0", "_1", "1_", "0x10", "1/0", "1 2", "inf",
        ] {
            assert!(exact(wrong).is_none(), "{wrong}");
        }
    }

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
