//! Scaling symmetries, so that fewer unknowns have to be interpolated.
//!
//! Weights of states, parameters and ε under which every equation ε ẋᵢ ~ xᵢ is homogeneous form a lattice; under each of them
//! the coefficients of what the map preserves are homogeneous too. As many unknowns as the weights separate are set to 1,
//! and every term gets its powers of them back from its weight.

use std::time::Instant;

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

use crate::lift::{Oracle, confirms, lift};
use crate::modulus::Modulus;

/// The weights of variables: one entry for each independent scaling symmetry.
#[derive(Clone, Debug, Default)]
pub struct Weights {
    /// By variable: states, parameters, ε.
    by_variable: Vec<Vec<Rational>>,
}

impl Weights {
    /// The scaling symmetries of a field's map; with ε (half the time step) fixed only those that leave ε alone.
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
            let mut divisors = component.denominator.terms().map(|(monomial, _)| exponents(monomial));
            let Some(divisor) = divisors.next() else { continue };
            equations.extend(divisors.map(|other| difference(&other, &divisor)));
            for (monomial, _) in component.numerator.terms() {
                // ε p/q ~ xᵢ
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

    /// The weight of a variable; of one that is none of the map's, nothing.
    #[must_use]
    pub fn of_variable(&self, variable: Variable) -> Vec<Rational> {
        self.by_variable.get(usize::from(variable.0)).cloned().unwrap_or_default()
    }

    /// The weight of a monomial of the map's variables.
    #[must_use]
    pub fn of_monomial(&self, monomial: &Monomial) -> Vec<Rational> {
        let rank = self.by_variable.first().map_or(0, Vec::len);
        let mut sum = vec![Rational::zero(); rank];
        for &(variable, exponent) in monomial.powers() {
            let factor = Rational::from(i64::from(exponent));
            for (entry, own) in sum.iter_mut().zip(self.of_variable(variable)) {
                *entry = &*entry + &(&own * &factor);
            }
        }
        sum
    }
}

/// Reduced echelon form in place; returns the pivot columns among the first `columns`.
fn reduce(rows: &mut [Vec<Rational>], columns: usize) -> Vec<usize> {
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

/// The weights of the unknowns of a lift and of the entries it looks for.
#[derive(Clone, Debug)]
pub struct Grading {
    /// One for each unknown.
    pub unknowns: Vec<Vec<Rational>>,
    /// One for each entry.
    pub entries: Vec<Vec<Rational>>,
}

impl Grading {
    /// Unknowns whose weights are independent, the last ones first: their values can be scaled to 1.
    fn separated(&self) -> Vec<usize> {
        let mut chosen: Vec<usize> = Vec::new();
        for unknown in (0..self.unknowns.len()).rev() {
            let mut rows: Vec<Vec<Rational>> =
                chosen.iter().map(|&other| self.unknowns[other].clone()).collect();
            rows.push(self.unknowns[unknown].clone());
            let wanted = rows.len();
            if reduce(&mut rows, self.unknowns[unknown].len()).len() == wanted {
                chosen.push(unknown);
            }
        }
        chosen
    }

    /// The k with Σ kⱼ wⱼ = target over the chosen unknowns, if it is one of integers.
    fn exponents(&self, chosen: &[usize], target: &[Rational]) -> Option<Vec<i64>> {
        let mut rows: Vec<Vec<Rational>> = (0..target.len())
            .map(|index| {
                let mut row: Vec<Rational> =
                    chosen.iter().map(|&unknown| self.unknowns[unknown][index].clone()).collect();
                row.push(target[index].clone());
                row
            })
            .collect();
        let pivots = reduce(&mut rows, chosen.len() + 1);
        if pivots.len() != chosen.len() || pivots.last() == Some(&chosen.len()) {
            return None;
        }
        rows[..pivots.len()].iter().map(|row| row[chosen.len()].as_i64()).collect()
    }

    /// The function with its powers of the chosen unknowns put back.
    fn homogenised(
        &self,
        function: &RationalFunction,
        entry: usize,
        variables: &[Variable],
        chosen: &[usize],
    ) -> Option<RationalFunction> {
        let Some((first, _)) = function.numerator().leading_term().and(function.denominator().leading_term())
        else {
            return Some(function.clone());
        };
        let weight = |monomial: &Monomial| {
            let mut sum = vec![Rational::zero(); self.entries[entry].len()];
            for &(variable, exponent) in monomial.powers() {
                let place = variables.iter().position(|known| *known == variable)?;
                let factor = Rational::from(i64::from(exponent));
                for (total, own) in sum.iter_mut().zip(&self.unknowns[place]) {
                    *total = &*total + &(own * &factor);
                }
            }
            Some(sum)
        };
        let base = weight(first)?;
        let side = |polynomial: &Polynomial, is_numerator: bool| {
            let terms = polynomial.terms().map(|(monomial, coefficient)| {
                let own = weight(monomial)?;
                let target: Vec<Rational> = (0..base.len())
                    .map(|index| {
                        let wanted = &base[index] - &own[index];
                        if is_numerator { &wanted + &self.entries[entry][index] } else { wanted }
                    })
                    .collect();
                Some((monomial.clone(), coefficient.clone(), self.exponents(chosen, &target)?))
            });
            terms.collect::<Option<Vec<_>>>()
        };
        let (above, below) = (side(function.numerator(), true)?, side(function.denominator(), false)?);
        let mut shift = vec![0i64; chosen.len()];
        for (_, _, exponents) in above.iter().chain(&below) {
            for (least, exponent) in shift.iter_mut().zip(exponents) {
                *least = (*least).min(*exponent);
            }
        }
        let restored = |terms: Vec<(Monomial, Rational, Vec<i64>)>| {
            let terms = terms.into_iter().map(|(monomial, coefficient, exponents)| {
                let powers = chosen.iter().zip(exponents).zip(&shift);
                let powers: Option<Monomial> = powers
                    .map(|((&unknown, exponent), least)| {
                        Some((variables[unknown], u32::try_from(exponent - least).ok()?))
                    })
                    .collect::<Option<Vec<_>>>()
                    .map(|powers| powers.into_iter().collect());
                Some((monomial.mul(&powers?), coefficient))
            });
            terms.collect::<Option<Vec<_>>>().map(Polynomial::from_terms)
        };
        RationalFunction::new(restored(above)?, restored(below)?)
    }
}

/// [`lift`] with some unknowns scaled to 1 where the entries are homogeneous; without, where that comes to nothing.
pub fn lift_graded(
    oracle: &mut dyn Oracle,
    variables: &[Variable],
    grading: &Grading,
    random: &mut SplitMix64,
    deadline: Instant,
) -> Option<Vec<RationalFunction>> {
    let chosen = grading.separated();
    if !chosen.is_empty()
        && let Some(found) = lift_scaled(oracle, variables, grading, &chosen, random, deadline)
    {
        return Some(found);
    }
    lift(oracle, variables, random, deadline)
}

fn lift_scaled(
    oracle: &mut dyn Oracle,
    variables: &[Variable],
    grading: &Grading,
    chosen: &[usize],
    random: &mut SplitMix64,
    deadline: Instant,
) -> Option<Vec<RationalFunction>> {
    let kept: Vec<usize> = (0..variables.len()).filter(|unknown| !chosen.contains(unknown)).collect();
    let mut scaled = |modulus: Modulus, values: &[u64], random: &mut SplitMix64| {
        let mut all = vec![modulus.one(); variables.len()];
        for (&unknown, &value) in kept.iter().zip(values) {
            all[unknown] = value;
        }
        oracle.values(modulus, &all, random)
    };
    let remaining: Vec<Variable> = kept.iter().map(|&unknown| variables[unknown]).collect();
    let functions = lift(&mut scaled, &remaining, random, deadline)?;
    let restored: Option<Vec<RationalFunction>> = functions
        .iter()
        .enumerate()
        .map(|(entry, function)| grading.homogenised(function, entry, variables, chosen))
        .collect();
    let restored = restored?;
    confirms(oracle, &restored, variables, random, deadline).then_some(restored)
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::{lexer, read};

    fn weights(text: &str, eps_is_fixed: bool) -> (Weights, Field) {
        let field = read(&lexer::lex(text).tokens).system.field;
        (Weights::of(&field, eps_is_fixed), field)
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
                for (above, _) in component.numerator.terms() {
                    for (below, _) in component.denominator.terms() {
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
        // Three coordinates and time scale freely; three coefficients follow.
        assert_eq!(rank(&weights("xdot = a1*y*z; ydot = a2*z*x; zdot = a3*x*y;", false).0), 4);
        assert_eq!(rank(&weights("xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z;", false).0), 2);
        assert_eq!(rank(&weights("xdot = x*(1 - y); ydot = y*(x - 1);", false).0), 0);
        assert_eq!(rank(&weights("xdot = y; ydot = 6*x^2 - a;", false).0), 1);
        assert_eq!(rank(&weights("xdot = y; ydot = 6*x^2 - a;", true).0), 0);
    }
}
