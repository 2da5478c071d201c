//! Rational reconstruction that uses scaling symmetries of the map.
//!
//! Each unknown has a weight, with one number for each symmetry. Scaling sets some unknowns with
//! independent weights to 1. The weight of a term determines the powers of these unknowns.

use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

use crate::deadline::Deadline;
use crate::modular::modulus::Modulus;
use crate::modular::reconstruction::{Oracle, confirms, reconstruct};
use crate::modular::weights::{reduce, weight_of};

/// The weights of the unknowns and of the functions in a reconstruction.
#[derive(Clone, Debug)]
pub struct Grading {
    /// The weight of each unknown, with one number for each scaling symmetry.
    pub unknowns: Vec<Vec<Rational>>,
    /// The weight of each function that is reconstructed.
    pub entries: Vec<Vec<Rational>>,
}

impl Grading {
    /// Chooses a largest set of unknowns with independent weights, and prefers later unknowns.
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

    /// Returns integers kⱼ with Σ kⱼ wⱼ = `target`, where wⱼ are the weights of the chosen
    /// unknowns.
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
            weight_of(monomial, self.entries[entry].len(), |variable| {
                let place = variables.iter().position(|known| *known == variable)?;
                Some(&self.unknowns[place])
            })
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

/// Runs [`reconstruct`] with some unknowns scaled to 1, or without scaling if that fails.
pub fn reconstruct_graded(
    oracle: &mut Oracle<'_>,
    variables: &[Variable],
    grading: &Grading,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Vec<RationalFunction>> {
    let chosen = grading.separated();
    if !chosen.is_empty()
        && let Some(found) = reconstruct_scaled(oracle, variables, grading, &chosen, random, deadline)
    {
        return Some(found);
    }
    reconstruct(oracle, variables, random, deadline)
}

fn reconstruct_scaled(
    oracle: &mut Oracle<'_>,
    variables: &[Variable],
    grading: &Grading,
    chosen: &[usize],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Vec<RationalFunction>> {
    let kept: Vec<usize> = (0..variables.len()).filter(|unknown| !chosen.contains(unknown)).collect();
    let mut scaled = |modulus: Modulus, values: &[u64], random: &mut SplitMix64| {
        let mut all = vec![modulus.one(); variables.len()];
        for (&unknown, &value) in kept.iter().zip(values) {
            all[unknown] = value;
        }
        oracle(modulus, &all, random)
    };
    let remaining: Vec<Variable> = kept.iter().map(|&unknown| variables[unknown]).collect();
    let functions = reconstruct(&mut scaled, &remaining, random, deadline)?;
    let restored: Option<Vec<RationalFunction>> = functions
        .iter()
        .enumerate()
        .map(|(entry, function)| grading.homogenised(function, entry, variables, chosen))
        .collect();
    let restored = restored?;
    confirms(oracle, &restored, variables, random, deadline).then_some(restored)
}
