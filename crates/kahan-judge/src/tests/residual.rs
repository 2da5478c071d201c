//! Tests results of steps of many variables by the residual of the step's equation A·x̃ = b.
//!
//! Let u be the unit roundoff. A result y is within its error bound if, in every row i,
//!
//!   |A·y − b|ᵢ ≤ (k + 8)·u·(|A|·|y| + |b|)ᵢ
//!
//! For a chain, k is the number of entries in row i of A. For a field, k is that of the widest row.

use std::cmp::Ordering;

use kahan_algebra::prime_field::SplitMix64;

use crate::ball::Ball;
use crate::dyadic::Dyadic;
use crate::elimination::{self, Eliminated, Matrix, precisions};
use crate::equation::{AtPoint, Curvature, Equation};
use crate::float::Format;
use crate::judge::balls::fit;
use crate::judge::{ExactMap, ExactStep, PolePolynomial, Verdict};

/// The row whose number of entries determines the error bound.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rows {
    /// The widest row, for fields of many variables.
    Widest,
    /// For chains: the bound of each row depends on the number of entries in that row.
    Own,
}

#[derive(Debug)]
pub(super) struct ByResidual(pub(super) Equation, pub(super) Rows);

impl ExactMap for ByResidual {
    fn equation(&self) -> &Equation {
        &self.0
    }

    /// Makes the exact step, unless the field divides by zero.
    fn step(&self, point: &[Dyadic]) -> Option<Box<dyn ExactStep>> {
        let equation = self.0.at(point);
        if equation.is_defined() { Some(Box::new(Residual { equation, counted: self.1 })) } else { None }
    }

    fn zeros(
        &self,
        _is_removable: bool,
        point: &[Dyadic],
        random: &mut SplitMix64,
    ) -> Option<PolePolynomial> {
        zeros(&self.0, point, random)
    }
}

struct Residual {
    equation: AtPoint,
    counted: Rows,
}

impl ExactStep for Residual {
    fn judge(&self, format: &Format, result: &[Dyadic]) -> Verdict {
        let Self { equation, counted } = self;
        let rows: Vec<Vec<(usize, Dyadic)>> = (0..equation.x.len()).map(|i| equation.row(i)).collect();
        let widest = rows.iter().map(Vec::len).max().expect("a field has equations");
        let mut verdict = Verdict { error_u: 0.0, keeps_promise: true, is_rough: true };
        for (i, row) in rows.iter().enumerate() {
            let (mut right, mut size, mut left) = (equation.increment(i), Dyadic::zero(), Dyadic::zero());
            for (j, entry) in row {
                left = &left + &(entry * &result[*j]);
                right = &right + &(entry * &equation.x[*j]);
                size = &size + &(entry * &result[*j]).abs();
            }
            let entries = match counted {
                Rows::Widest => widest,
                Rows::Own => row.len(),
            };
            let promise = Dyadic::new(entries as u64 + 8, -format.precision);
            let error = (&left - &right).abs();
            let size = &size + &right.abs();
            if !error.is_zero() {
                verdict.error_u = verdict.error_u.max(error.clone().scaled(format.precision).ratio(&size));
            }
            verdict.keeps_promise &= error.compare(&(&size * &promise)) != Ordering::Greater;
            verdict.is_rough &= (&error * &Dyadic::new(1000, 0)).compare(&size) != Ordering::Greater;
        }
        verdict
    }

    /// Returns whether it is certain that x̃ exists and that the format holds it.
    fn fits(&self, format: &Format) -> bool {
        for bits in precisions() {
            match elimination::next(&self.equation, bits) {
                Eliminated::Singular => return false,
                Eliminated::Unknown => {}
                Eliminated::Solved(next) => {
                    if let Some(fits) = fit(format, &next) {
                        return fits;
                    }
                }
            }
        }
        false
    }
}

/// Expands det A as a polynomial in a state that few rows depend on.
fn zeros(equation: &Equation, point: &[Dyadic], random: &mut SplitMix64) -> Option<PolePolynomial> {
    const MOST_ROWS: usize = 3;
    const MOST_VARIABLES: usize = 64;
    const BITS: u64 = 256;
    let variable = random.below(equation.dimension() as u64) as usize;
    let depends =
        |(i, row): (usize, Vec<Curvature>)| row.iter().any(|entry| entry.second == variable).then_some(i);
    let rows: Vec<usize> = (0..).zip(equation.curvature(point)).filter_map(depends).collect();
    if rows.is_empty() || rows.len() > MOST_ROWS || equation.dimension() > MOST_VARIABLES {
        return None;
    }
    let at = |value: i64| {
        let mut moved = point.to_vec();
        moved[variable] = Dyadic::new(value, 0);
        equation.at(&moved)
    };
    let (zero, one) = (at(0), at(1));
    let slope = |i: usize| {
        let constants = zero.row(i);
        let slope = |(j, value): (usize, Dyadic)| {
            let constant = constants.iter().find(|(k, _)| *k == j).map(|(_, constant)| constant);
            (j, constant.map_or(value.clone(), |constant| &value - constant))
        };
        one.row(i).into_iter().map(slope).collect()
    };
    let slopes: Vec<Vec<(usize, Dyadic)>> = rows.iter().map(|&i| slope(i)).collect();
    let mut coefficients = vec![Dyadic::zero(); rows.len() + 1];
    for chosen in 0_usize..1 << rows.len() {
        let replaced = (0..rows.len()).filter(|k| chosen >> k & 1 == 1);
        let replaced: Vec<(usize, &[(usize, Dyadic)])> =
            replaced.map(|k| (rows[k], slopes[k].as_slice())).collect();
        let place = &mut coefficients[replaced.len()];
        *place = &*place + &determinant(&zero, &replaced, BITS);
    }
    Some(PolePolynomial { variable, coefficients })
}

/// Replaces rows of A by those in `replaced`, and approximates the determinant.
pub(crate) fn determinant(equation: &AtPoint, replaced: &[(usize, &[(usize, Dyadic)])], bits: u64) -> Dyadic {
    let mut matrix = Matrix::of(equation, bits, |_| Vec::new());
    for (i, entries) in replaced {
        matrix.rows[*i].iter_mut().for_each(|entry| *entry = Ball::exactly(Dyadic::zero()));
        for (j, entry) in *entries {
            matrix.rows[*i][*j] = Ball::exactly(entry.clone()).rounded(bits);
        }
    }
    match matrix.solve() {
        Eliminated::Solved((_, determinant)) => determinant.middle().clone(),
        Eliminated::Singular | Eliminated::Unknown => Dyadic::zero(),
    }
}
