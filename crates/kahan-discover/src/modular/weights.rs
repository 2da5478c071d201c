//! Scaling symmetries, which reduce the number of unknowns in a reconstruction.
//!
//! States, parameters and ε get weights, so that all terms of ε ẋᵢ have the weight of xᵢ. Then the
//! coefficients of invariants are homogeneous. All valid choices of weights form a vector space.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Monomial, Variable};
use kahan_algebra::rational::Rational;

/// The weights of variables, each with one entry for each independent scaling symmetry.
#[derive(Clone, Debug, Default)]
pub struct Weights {
    by_variable: Vec<Vec<Rational>>,
}

impl Weights {
    /// Returns the scaling symmetries of a field's map. If ε is fixed, the symmetries do not scale
    /// ε.
    #[must_use]
    pub fn of(field: &Field, eps_is_fixed: bool) -> Self {
        let count = usize::from(field.symbols.epsilon().0) + 1;
        let exponents = |monomial: &Monomial| {
            let mut row = vec![Rational::zero(); count];
            for &(variable, exponent) in monomial.powers() {
                row[usize::from(variable.0)] = Rational::from(i64::from(exponent));
            }
            row
        };
        let difference = |a: &[Rational], b: &[Rational]| -> Vec<Rational> {
            a.iter().zip(b).map(|(a, b)| a - b).collect()
        };
        let mut equations: Vec<Vec<Rational>> = Vec::new();
        for (i, component) in field.components.iter().enumerate() {
            let mut divisors = component.denominator().terms().map(|(monomial, _)| exponents(monomial));
            let Some(divisor) = divisors.next() else { continue };
            equations.extend(divisors.map(|other| difference(&other, &divisor)));
            for (monomial, _) in component.numerator().terms() {
                // The term ε·monomial/divisor of ε ẋᵢ must have the weight of xᵢ.
                let mut row = difference(&exponents(monomial), &divisor);
                row[count - 1] = &row[count - 1] + &Rational::one();
                row[i] = &row[i] - &Rational::one();
                equations.push(row);
            }
        }
        if eps_is_fixed {
            let mut row = vec![Rational::zero(); count];
            row[count - 1] = Rational::one();
            equations.push(row);
        }
        let pivots = reduce(&mut equations, count);
        let free: Vec<usize> = (0..count).filter(|column| !pivots.contains(column)).collect();
        let weight = |variable: usize| {
            free.iter()
                .map(|&column| match pivots.iter().position(|&pivot| pivot == variable) {
                    Some(row) => -&equations[row][column],
                    None if column == variable => Rational::one(),
                    None => Rational::zero(),
                })
                .collect()
        };
        Weights { by_variable: (0..count).map(weight).collect() }
    }

    /// Returns the weight of a variable of the map, or an empty list for other variables.
    #[must_use]
    pub fn of_variable(&self, variable: Variable) -> Vec<Rational> {
        self.by_variable.get(usize::from(variable.0)).cloned().unwrap_or_default()
    }

    /// Returns the weight of a monomial of the map's variables.
    #[must_use]
    pub fn of_monomial(&self, monomial: &Monomial) -> Vec<Rational> {
        let rank = self.by_variable.first().map_or(0, Vec::len);
        let own = |variable: Variable| self.by_variable.get(usize::from(variable.0));
        weight_of(monomial, rank, own).unwrap_or_default()
    }
}

/// Returns the weight of a monomial, with an entry for each of `rank` independent symmetries.
pub(crate) fn weight_of<'a>(
    monomial: &Monomial,
    rank: usize,
    of_variable: impl Fn(Variable) -> Option<&'a Vec<Rational>>,
) -> Option<Vec<Rational>> {
    let mut sum = vec![Rational::zero(); rank];
    for &(variable, exponent) in monomial.powers() {
        let factor = Rational::from(i64::from(exponent));
        for (entry, own) in sum.iter_mut().zip(of_variable(variable)?) {
            *entry = &*entry + &(own * &factor);
        }
    }
    Some(sum)
}

/// Computes the reduced echelon form in place, with pivots only in the first `columns` columns.
/// Returns the pivot columns.
pub(crate) fn reduce(rows: &mut [Vec<Rational>], columns: usize) -> Vec<usize> {
    let mut pivots = Vec::new();
    for column in 0..columns {
        let rank = pivots.len();
        let Some(found) = (rank..rows.len()).find(|&row| !rows[row][column].is_zero()) else { continue };
        rows.swap(rank, found);
        let Some(inverse) = rows[rank][column].recip() else { continue };
        let pivot: Vec<Rational> = rows[rank].iter().map(|entry| entry * &inverse).collect();
        for (index, row) in rows.iter_mut().enumerate() {
            let factor = row[column].clone();
            if index == rank {
                row.clone_from(&pivot);
            } else if !factor.is_zero() {
                for (entry, own) in row.iter_mut().zip(&pivot) {
                    *entry = &*entry - &(&factor * own);
                }
            }
        }
        pivots.push(column);
    }
    pivots
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::{lexer, read};

    fn weights(text: &str, eps_is_fixed: bool) -> (Weights, Field) {
        let field = read(&lexer::lex(text).tokens).system().expect("a system").field;
        (Weights::of(&field, eps_is_fixed), field.as_ref().clone())
    }

    fn rank(weights: &Weights) -> usize {
        weights.by_variable[0].len()
    }

    #[test]
    fn every_equation_is_homogeneous_in_the_weights() {
        for text in [
            "xdot = a1*y*z; ydot = a2*z*x; zdot = a3*x*y;",
            "xdot = y; ydot = 6*x^2 - a;",
            "xdot = y/a + b*x; ydot = x^2/(a + b);",
        ] {
            let (weights, field) = weights(text, false);
            assert!(rank(&weights) > 0, "{text}");
            let eps = Monomial::variable(field.symbols.epsilon());
            for (i, component) in field.components.iter().enumerate() {
                let state = weights.of_variable(field.symbols.state(i));
                for (above, _) in component.numerator().terms() {
                    for (below, _) in component.denominator().terms() {
                        let above = weights.of_monomial(&above.mul(&eps));
                        let below = weights.of_monomial(below);
                        let quotient: Vec<Rational> = above.iter().zip(&below).map(|(a, b)| a - b).collect();
                        assert_eq!(quotient, state, "{text}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_number_of_symmetries_is_known() {
        assert_eq!(rank(&weights("xdot = a1*y*z; ydot = a2*z*x; zdot = a3*x*y;", false).0), 4);
        assert_eq!(rank(&weights("xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z;", false).0), 2);
        assert_eq!(rank(&weights("xdot = x*(1 - y); ydot = y*(x - 1);", false).0), 0);
        assert_eq!(rank(&weights("xdot = y; ydot = 6*x^2 - a;", false).0), 1);
        assert_eq!(rank(&weights("xdot = y; ydot = 6*x^2 - a;", true).0), 0);
    }
}
