//! Finds spaces of polynomials that the map leaves invariant up to a cofactor, modulo a prime.

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::{Sample, SearchField};
use crate::modular::matrix::{Echelon, SPARE_EQUATIONS};
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::Form;

use super::cofactors::Cofactors;

/// Pairs of polynomials with P(x̃) = C(x)·Q(x) for a cofactor C. Each row has the coefficients of
/// P, then those of Q.
type Pairs = Vec<Vec<u64>>;

pub(super) struct Points {
    modulus: Modulus,
    /// For each point x: the monomials at x, the monomials at x̃, and the factors of the Jacobian
    /// determinant at x. The monomials at x̃ are multiplied by a power of the map's denominator.
    values: Vec<(Vec<u64>, Vec<u64>, Vec<u64>)>,
}

impl Points {
    pub(super) fn new(
        searched: &SearchField,
        sample: &Sample,
        cofactors: &Cofactors,
        monomials: &Monomials,
        random: &mut SplitMix64,
    ) -> Option<Self> {
        let map = &sample.map;
        let modulus = *map.modulus();
        let mut values = Vec::new();
        while values.len() < 2 * monomials.len() + SPARE_EQUATIONS {
            let point = map.point(random);
            let next = map.next(&point)?;
            let denominator = searched.evaluate(cofactors.denominator(), sample, &point)?;
            let power = modulus.power(denominator, monomials.degree());
            let there = monomials.values(&modulus, &next);
            let factors = cofactors.factors.iter();
            values.push((
                monomials.values(&modulus, &point),
                there.into_iter().map(|value| modulus.times(value, power)).collect(),
                factors.map(|factor| searched.evaluate(factor, sample, &point)).collect::<Option<_>>()?,
            ));
        }
        Some(Points { modulus, values })
    }

    /// Returns the largest space V such that for each P in V, P(x̃) = C(x)·Q(x) for some Q in V.
    /// The cofactor C is the product of the factors of the Jacobian determinant with these
    /// `exponents`. Each basis element P is paired with its Q.
    pub(super) fn invariant(&self, exponents: &[i32], deadline: &Deadline<'_>) -> Option<Pairs> {
        let modulus = &self.modulus;
        let rows = self.values.iter().map(|(here, there, factors)| {
            let cofactor =
                factors.iter().zip(exponents).fold(modulus.one(), |product, (&base, &exponent)| {
                    modulus.times(product, modulus.power(base, exponent.unsigned_abs()))
                });
            let minus = modulus.opposite(cofactor);
            let right = here.iter().map(|&value| modulus.times(minus, value));
            there.iter().copied().chain(right).collect()
        });
        let count = self.values[0].0.len();
        let mut pairs = Echelon::null_vectors(modulus, rows.collect(), 2 * count, deadline)?;
        loop {
            let kept = with_images_inside(modulus, &pairs, count);
            if kept.len() == pairs.len() {
                return Some(pairs);
            }
            pairs = kept;
        }
    }
}

/// Returns those linear combinations of pairs (P, Q) whose Q lies in the span of all P.
fn with_images_inside(modulus: &Modulus, pairs: &Pairs, count: usize) -> Pairs {
    let space = Echelon::of(modulus, pairs.iter().map(|pair| pair[..count].to_vec()).collect(), count);
    let outside = |pair: &[u64]| space.remainder(modulus, pair[count..].to_vec());
    let rows = pairs.iter().map(|pair| [outside(pair), pair.clone()].concat()).collect();
    let echelon = Echelon::of(modulus, rows, 3 * count);
    let inside = echelon.rank_of_first(count);
    echelon.rows[inside..].iter().map(|row| row[count..].to_vec()).collect()
}

/// A basis P in reduced form, and the matrix M with P(x̃) = C(x)·M·P(x) for a cofactor C.
pub(super) struct InvariantSpace {
    pub(super) rows: Vec<Vec<u64>>,
    pub(super) matrix: Vec<Vec<u64>>,
}

impl InvariantSpace {
    /// Keeps only the coefficients of the monomials of `form`. Returns `None` if the reduced basis
    /// has other leading monomials than `form`.
    pub(super) fn of_form(modulus: &Modulus, form: &Form, pairs: &Pairs) -> Option<Self> {
        let count = pairs.first()?.len() / 2;
        let wide = |pair: &Vec<u64>| {
            let both = form.support.iter().map(|&index| pair[index]);
            both.chain(form.support.iter().map(|&index| pair[count + index])).collect()
        };
        let width = form.support.len();
        let echelon = Echelon::of(modulus, pairs.iter().map(wide).collect(), 2 * width);
        if echelon.pivots != form.pivots {
            return None;
        }
        let coordinates =
            |row: &Vec<u64>| form.pivots.iter().map(|&pivot| row[width + pivot]).collect::<Vec<u64>>();
        Some(InvariantSpace {
            matrix: echelon.rows.iter().map(coordinates).collect(),
            rows: echelon.rows.iter().map(|row| row[..width].to_vec()).collect(),
        })
    }

    /// Returns whether the matrix M is a multiple of the identity. All quotients of elements are
    /// then integrals.
    pub(super) fn is_scalar(&self) -> bool {
        let first = self.matrix[0][0];
        self.matrix
            .iter()
            .enumerate()
            .all(|(i, row)| row.iter().enumerate().all(|(j, &entry)| entry == if i == j { first } else { 0 }))
    }
}
