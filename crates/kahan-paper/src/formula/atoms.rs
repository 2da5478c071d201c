//! Replaces transcendental functions in formulas by independent variables.
//!
//! If v, w, … are independent, only the polynomial 0 over ℚ vanishes at exp v, log v, v^w,
//! tan(v/2), …. Then an identity that is rational in these functions holds if and only if it holds
//! with new variables in their place. If exp of another expression occurs, only the “if” is
//! certain.

use std::collections::BTreeMap;

use kahan_algebra::rational::Rational;

use super::Formula;

/// Replaces functions by expressions in new variables; `None` if a function remains.
pub(crate) fn rationalise(formula: &Formula) -> Option<Formula> {
    match formula {
        Formula::Name(name) if name == "pi" => None,
        Formula::Power(base, exponent) => power(base, exponent),
        Formula::Call(name, arguments) => call(name, arguments),
        _ => formula.of_parts(&|part| rationalise(part).ok_or(())).ok(),
    }
}

fn call(name: &str, arguments: &[Formula]) -> Option<Formula> {
    let one = || Formula::integer(1);
    let half = |a: Formula, negative: bool, b: Formula| {
        Formula::Sum(vec![(false, a), (negative, b)]).over(Formula::integer(2))
    };
    match (name, arguments) {
        ("exp", [u]) => exponential(u),
        ("sinh", [u]) => Some(half(exponential(u)?, true, one().over(exponential(u)?))),
        ("cosh", [u]) => Some(half(exponential(u)?, false, one().over(exponential(u)?))),
        ("tanh", [u]) => {
            Some(call("sinh", std::slice::from_ref(u))?.over(call("cosh", std::slice::from_ref(u))?))
        }
        ("coth", [u]) => Some(one().over(call("tanh", std::slice::from_ref(u))?)),
        ("sech", [u]) => Some(one().over(call("cosh", std::slice::from_ref(u))?)),
        ("log", [Formula::Name(v)]) => Some(Formula::Name(format!("log {v}"))),
        ("tan", [Formula::Name(_)]) => Some(call("sin", arguments)?.over(call("cos", arguments)?)),
        ("cos" | "sin", [Formula::Name(v)]) => {
            let t = Formula::Name(format!("tan {v}/2"));
            let below = Formula::Sum(vec![(false, one()), (false, t.clone().raised_to(2))]);
            let above = if name == "sin" {
                Formula::integer(2).times(t)
            } else {
                Formula::Sum(vec![(false, one()), (true, t.raised_to(2))])
            };
            Some(above.over(below))
        }
        // Both calls move `inner` to a point where functions have other values.
        ("next" | "back", [.., inner]) => {
            (!has_functions(inner)).then(|| Formula::call(name, arguments.to_vec()))
        }
        ("on" | "at", [inner, rest @ ..]) if !has_functions(inner) => {
            let rest: Option<Vec<Formula>> = rest.iter().map(rationalise).collect();
            Some(Formula::call(name, std::iter::once(inner.clone()).chain(rest?).collect()))
        }
        ("f" | "A" | "b" | "J", _) => Some(Formula::call(name, arguments.to_vec())),
        _ => None,
    }
}

pub(crate) fn has_functions(formula: &Formula) -> bool {
    rationalise(formula).is_none_or(|rational| rational != *formula)
}

/// Rewrites base^exponent, as a monomial in new variables if the exponent contains names.
fn power(base: &Formula, exponent: &Formula) -> Option<Formula> {
    let rational_base = rationalise(base)?;
    if exponent.as_number().is_some() {
        return Some(Formula::Power(Box::new(rational_base), Box::new(exponent.clone())));
    }
    let form = expand(exponent)?;
    let integers =
        form.into_iter().map(|(names, k)| Some((names, k.as_i64()?))).collect::<Option<Vec<_>>>()?;
    let mut factors = Vec::new();
    for (names, k) in integers {
        let atom = if names.is_empty() {
            rational_base.clone()
        } else {
            let Formula::Name(v) = base else { return None };
            Formula::Name(format!("{v}^{}", names.join("*")))
        };
        factors.push((false, atom.raised_to(k)));
    }
    Some(if factors.is_empty() { Formula::integer(1) } else { Formula::Product(factors) })
}

/// Rewrites exp(u) as a monomial in new variables if u is an integer combination of monomials,
/// otherwise as one new variable.
fn exponential(u: &Formula) -> Option<Formula> {
    let Some(form) = expand(u) else { return Some(whole_exponential(u)) };
    let mut factors = Vec::new();
    for (names, k) in form {
        if names.is_empty() {
            return None;
        }
        factors.push((false, Formula::Name(format!("exp {}", names.join("*"))).raised_to(k.as_i64()?)));
    }
    Some(if factors.is_empty() { Formula::integer(1) } else { Formula::Product(factors) })
}

fn whole_exponential(u: &Formula) -> Formula {
    let inverse = |u: Formula| Formula::integer(1).over(whole_exponential(&u));
    match u {
        Formula::Negation(inner) => inverse((**inner).clone()),
        Formula::Product(factors) if matches!(factors.first(), Some((false, Formula::Negation(_)))) => {
            let mut factors = factors.clone();
            if let (false, Formula::Negation(inner)) = factors[0].clone() {
                factors[0] = (false, *inner);
            }
            inverse(Formula::Product(factors))
        }
        _ => Formula::Name(format!("exp {u:?}")),
    }
}

/// A polynomial in names: sorted lists of names with their coefficients.
type Expanded = BTreeMap<Vec<String>, Rational>;

fn expand(formula: &Formula) -> Option<Expanded> {
    let constant = |value: Rational| Expanded::from([(Vec::new(), value)]);
    let expanded = match formula {
        Formula::Number(value) => constant(value.clone()),
        Formula::Name(name) => Expanded::from([(vec![name.clone()], Rational::one())]),
        Formula::Negation(inner) => product(&expand(inner)?, &constant(Rational::from(-1))),
        Formula::Sum(terms) => {
            let mut sum = Expanded::new();
            for (negative, term) in terms {
                for (names, value) in expand(term)? {
                    let entry = sum.entry(names).or_insert(Rational::ZERO);
                    *entry = if *negative { &*entry - &value } else { &*entry + &value };
                }
            }
            sum
        }
        Formula::Product(factors) => {
            let mut result = constant(Rational::one());
            for (divides, factor) in factors {
                let factor = if *divides { constant(factor.as_number()?.recip()?) } else { expand(factor)? };
                result = product(&result, &factor);
            }
            result
        }
        Formula::Power(..) | Formula::Call(..) => constant(formula.as_number()?),
    };
    Some(expanded.into_iter().filter(|(_, value)| !value.is_zero()).collect())
}

fn product(a: &Expanded, b: &Expanded) -> Expanded {
    let mut result = Expanded::new();
    for (left, p) in a {
        for (right, q) in b {
            let mut names = [left.as_slice(), right.as_slice()].concat();
            names.sort();
            let entry = result.entry(names).or_insert(Rational::ZERO);
            *entry = &*entry + &(p * q);
        }
    }
    result
}
