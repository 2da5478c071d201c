//! Finds points with rational coordinates at which a polynomial vanishes.

use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbols;

/// Returns (a, b) if the polynomial is a + b·`free` at these values; `None` if it is not linear.
fn line(polynomial: &Polynomial, values: &[Rational], free: Variable) -> Option<(Rational, Rational)> {
    let mut line = (Rational::zero(), Rational::zero());
    for (monomial, coefficient) in polynomial.terms() {
        let (mut value, mut power) = (coefficient.clone(), 0);
        for &(variable, exponent) in monomial.powers() {
            if variable == free {
                power = exponent;
            } else {
                value = &value * &values[usize::from(variable.0)].pow(exponent as i32)?;
            }
        }
        match power {
            0 => line.0 = &line.0 + &value,
            1 => line.1 = &line.1 + &value,
            _ => return None,
        }
    }
    Some(line)
}

/// Changes one state so that the polynomial vanishes. Returns `None` if the polynomial is linear in
/// no state.
#[must_use]
pub fn moved_onto(
    polynomial: &Polynomial,
    symbols: &Symbols,
    mut values: Vec<Rational>,
) -> Option<Vec<Rational>> {
    let states = (0..symbols.dimension()).map(|i| symbols.state(i));
    let mut free = states.filter(|state| polynomial.variables().contains(state));
    let (free, value) = free.find_map(|free| {
        let (constant, slope) = line(polynomial, &values, free)?;
        Some((free, -constant.checked_div(&slope)?))
    })?;
    values[usize::from(free.0)] = value;
    Some(values)
}
