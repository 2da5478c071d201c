//! Polynomials with integer coefficients, and their values at exact points.
//!
//! Polynomials are evaluated term by term, independently of the tested code.

use kahan_algebra::poly::{Polynomial, Variable};
use num_bigint::BigInt;
use num_integer::Integer;

use super::dyadic::Dyadic;

#[derive(Clone, Debug)]
pub(crate) struct Terms(Vec<(BigInt, Vec<(usize, usize)>)>);

pub(crate) struct Powers(Vec<Vec<Dyadic>>);

impl Powers {
    pub(crate) fn of(point: &[Dyadic], degree: usize) -> Self {
        let powers = |x: &Dyadic| {
            let mut powers = vec![Dyadic::new(1, 0)];
            for k in 0..degree {
                powers.push(&powers[k] * x);
            }
            powers
        };
        Self(point.iter().map(powers).collect())
    }

    pub(crate) fn coordinate(&self, variable: usize) -> &Dyadic {
        &self.0[variable][1]
    }
}

impl Terms {
    /// Converts `scale` times the polynomial to integer coefficients. The integer `scale` must be a
    /// multiple of the [`common_denominator`].
    pub(crate) fn of(polynomial: &Polynomial, scale: &BigInt) -> Self {
        let terms = polynomial.terms().map(|(monomial, coefficient)| {
            let powers = monomial.powers().iter().map(|&(v, power)| (usize::from(v.0), power as usize));
            (scale / coefficient.denominator() * coefficient.numerator(), powers.collect())
        });
        Self(terms.collect())
    }

    pub(crate) fn at(&self, point: &Powers) -> Dyadic {
        self.0.iter().fold(Dyadic::zero(), |sum, (coefficient, powers)| {
            let term = powers.iter().fold(Dyadic::new(coefficient.clone(), 0), |product, &(v, power)| {
                &product * &point.0[v][power]
            });
            &sum + &term
        })
    }
}

pub(crate) fn common_denominator<'a>(polynomials: impl IntoIterator<Item = &'a Polynomial>) -> BigInt {
    let coefficients = polynomials.into_iter().flat_map(|p| p.terms().map(|(_, c)| c.denominator()));
    coefficients.fold(BigInt::from(1), |common, denominator| common.lcm(&denominator))
}

pub(crate) fn greatest_power<'a>(polynomials: impl IntoIterator<Item = &'a Polynomial>) -> usize {
    let powers = polynomials.into_iter().flat_map(|p| p.terms().flat_map(|(m, _)| m.powers().to_vec()));
    powers.map(|(_, power)| power as usize).max().unwrap_or(0).max(1)
}

/// A polynomial in one variable, whose coefficients depend on the other variables.
#[derive(Clone, Debug)]
pub(crate) struct Univariate {
    pub(crate) variable: usize,
    coefficients: Vec<Terms>,
}

impl Univariate {
    /// For each variable, returns the polynomial as a polynomial in this variable alone.
    pub(crate) fn all(polynomial: &Polynomial, scale: &BigInt) -> Vec<Self> {
        let of = |variable: Variable| {
            let parts = polynomial.coefficients_in(variable);
            let degree = polynomial.degree_in(variable);
            let coefficient = |k| parts.get(&k).map_or(Terms(Vec::new()), |part| Terms::of(part, scale));
            Self { variable: usize::from(variable.0), coefficients: (0..=degree).map(coefficient).collect() }
        };
        polynomial.variables().into_iter().map(of).collect()
    }

    /// Evaluates the coefficients at a point. The point's own value of the variable is not used.
    pub(crate) fn at(&self, point: &Powers) -> Vec<Dyadic> {
        self.coefficients.iter().map(|terms| terms.at(point)).collect()
    }
}
