//! First values of new variables in rational numbers.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

use crate::laurent::Laurent;
use crate::numeric::Numeric;
use crate::ring::{Meaning, Ring};

/// The coordinates at a point: exact where they are rational functions of the states, else the
/// floats that [`Numeric`] gives. `None` where a divisor is 0 or a value is not finite.
pub(crate) fn coordinates(
    ring: &Ring,
    states: &[Rational],
    parameters: &[Rational],
) -> Option<Vec<Rational>> {
    let floats = |values: &[Rational]| values.iter().map(Rational::to_f64).collect::<Vec<f64>>();
    let numeric = Numeric::new(ring, &floats(parameters)).coordinates(&floats(states));
    let mut values = states.to_vec();
    for (coordinate, float) in ring.coordinates.iter().zip(numeric).skip(states.len()) {
        values.push(match &coordinate.meaning {
            Meaning::Root(argument, 1) | Meaning::Sum(argument) => value(argument, &values, parameters)?,
            _ => Rational::from_f64(float)?,
        });
    }
    Some(values)
}

/// The value of a polynomial; `None` where it divides by 0.
pub(crate) fn value(
    polynomial: &Laurent,
    coordinates: &[Rational],
    parameters: &[Rational],
) -> Option<Rational> {
    let mut sum = Rational::zero();
    for (monomial, factor) in polynomial.terms() {
        let mut product = coefficient(factor, parameters)?;
        for (coordinate, exponent) in monomial.powers() {
            product = &product * &coordinates[coordinate].pow(i32::from(exponent))?;
        }
        sum = &sum + &product;
    }
    Some(sum)
}

fn coefficient(value: &RationalFunction, parameters: &[Rational]) -> Option<Rational> {
    let polynomial = |polynomial: &Polynomial| {
        polynomial.terms().try_fold(Rational::zero(), |sum, (monomial, number)| {
            let power = |product: Rational, &(parameter, exponent): &(kahan_algebra::poly::Variable, u32)| {
                let value = parameters[usize::from(parameter.0)].pow(i32::try_from(exponent).ok()?)?;
                Some(&product * &value)
            };
            Some(&sum + &monomial.powers().iter().try_fold(number.clone(), power)?)
        })
    };
    polynomial(value.numerator())?.checked_div(&polynomial(value.denominator())?)
}
