//! Represents the exact step x̃ as quotients x̃ᵢ = Nᵢ/d with one denominator d.
//!
//! A result y has the error |yᵢd − Nᵢ|/|d| in component i. All errors and the norm max |Nᵢ|/|d|
//! have the denominator |d|, so they are compared without division.

use std::cmp::Ordering;

use kahan_algebra::arithmetic::{self, solve};
use kahan_algebra::rational::Rational;
use num_bigint::BigInt;

use super::{ExactStep, Verdict};
use crate::dyadic::Dyadic;
use crate::elimination::largest;
use crate::equation::AtPoint;
use crate::float::Format;

/// The factor in the error bound of `try_step`: ‖error‖∞ ≤ 64 u ‖exact‖∞, where u = 2^−precision.
pub(crate) const ERROR_BOUND_FACTOR: i64 = 64;

/// The numerators Nᵢ and the denominator d ≠ 0 of the step x̃ᵢ = Nᵢ/d.
pub(crate) struct Fraction {
    pub(crate) numerators: Vec<Dyadic>,
    pub(crate) denominator: Dyadic,
    pub(crate) size: Dyadic,
}

impl Fraction {
    pub(crate) fn of(numerators: Vec<Dyadic>, denominator: Dyadic) -> Self {
        let size = largest(numerators.iter().cloned().map(Dyadic::abs));
        Self { numerators, denominator, size }
    }

    /// Solves the equation for x̃ over the rational numbers, unless det A = 0.
    pub(crate) fn of_equation(equation: &AtPoint) -> Option<Self> {
        let n = equation.x.len();
        let row = |i: usize| {
            let mut row = vec![Rational::zero(); n];
            equation.row(i).iter().for_each(|(j, entry)| row[*j] = entry.rational());
            row
        };
        let matrix: Vec<_> = (0..n).map(row).collect();
        let right: Vec<_> = (0..n).map(|i| vec![equation.increment(i).rational()]).collect();
        let solved = solve(&arithmetic::Exact, &matrix, &right)?;
        // By Cramer's rule, the numerators are determinants with dyadic entries, hence dyadic.
        let numerator = |(x, moved): (&Dyadic, &Vec<Rational>)| {
            Dyadic::of_rational(&(&(&x.rational() + &moved[0]) * &solved.determinant))
        };
        let numerators = equation.x.iter().zip(&solved.solution).map(numerator).collect();
        Some(Self::of(numerators, Dyadic::of_rational(&solved.determinant)))
    }
}

impl ExactStep for Fraction {
    fn judge(&self, format: &Format, result: &[Dyadic]) -> Verdict {
        let errors = result.iter().zip(&self.numerators).map(|(y, n)| (&(y * &self.denominator) - n).abs());
        let error = largest(errors);
        let within = |bound: &Dyadic| error.compare(bound) != Ordering::Greater;
        Verdict {
            error_u: if error.is_zero() {
                0.0
            } else {
                error.clone().scaled(format.precision).ratio(&self.size)
            },
            keeps_promise: within(&(&self.size * &Dyadic::new(ERROR_BOUND_FACTOR, -format.precision))),
            is_rough: (&error * &Dyadic::new(1000, 0)).compare(&self.size) != Ordering::Greater,
        }
    }

    fn fits(&self, format: &Format) -> bool {
        let d = self.denominator.clone().abs();
        let (least, greatest) = (d.clone().scaled(format.least_binade), &d * &greatest(format));
        self.numerators.iter().all(|n| {
            let n = n.clone().abs();
            n.is_zero() || (n.compare(&least) != Ordering::Less && n.compare(&greatest) != Ordering::Greater)
        })
    }
}

pub(crate) fn greatest(format: &Format) -> Dyadic {
    let Format { precision, greatest_binade, .. } = format;
    Dyadic::new((BigInt::from(1) << precision) - 1, greatest_binade + 1 - precision)
}
