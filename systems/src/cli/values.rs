//! Exact numbers, times and coordinates behind options; what is wrong with them becomes a [`Refusal`].

use kahan_algebra::rational::Rational;

use super::output::Refusal;

/// An exact number; `what` names it in the refusal.
pub(crate) fn number(text: &str, what: &str) -> Result<Rational, Refusal> {
    let text = text.trim();
    Rational::parse(text).ok_or_else(|| {
        let zero_divisor = text
            .split_once('/')
            .is_some_and(|(_, below)| Rational::parse(below).is_some_and(|q| q.is_zero()));
        Refusal::new(if zero_divisor {
            format!("{what}: `{text}` divides by zero")
        } else {
            format!("{what}: `{text}` is not an exact number; write it as 3/7, -2, 0.25 or 1e-3")
        })
    })
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
