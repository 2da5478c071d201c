//! Finds the polynomial relations on one orbit.
//!
//! The values of monomials along an orbit form a matrix. Its null vectors are the polynomials that
//! vanish on the orbit and on its Zariski closure. In reduced form each relation expresses one
//! monomial by lower ones. Then the coefficients of the relation are integrals, as functions of the
//! orbit's start (Petrera, Pfadler, Suris, "On integrability of Hirota–Kimura type
//! discretizations", 2011).

use crate::deadline::Deadline;
use crate::maps::modular_step::ModularStep;
use crate::modular::matrix::{Echelon, NullVector};
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;

/// The number of points beyond the number of monomials, which excludes accidental relations.
const SPARE_POINTS: usize = 6;

/// The relations on one orbit.
#[derive(Clone, Debug)]
pub struct Relations {
    /// The first point of the orbit.
    pub start: Vec<u64>,
    /// The number of monomials of degree ≤ 0, ≤ 1, … that are linearly independent on the orbit.
    pub ranks: Vec<usize>,
    /// The relations in reduced form, ordered by their leading monomials.
    pub vectors: Vec<NullVector>,
    /// The number of points used.
    pub points: usize,
    /// The period, if the orbit returned to its start.
    pub period: Option<usize>,
}

impl Relations {
    /// Returns the relations among `monomials` on the orbit of `start`. Returns `None` if the orbit
    /// meets a pole, or if the deadline passes. With N monomials and rank r, the cost is N + 6
    /// steps and N² r multiplications.
    #[must_use]
    pub fn on_orbit(
        map: &impl ModularStep,
        start: Vec<u64>,
        monomials: &Monomials,
        deadline: &Deadline<'_>,
    ) -> Option<Self> {
        let wanted = monomials.len() + SPARE_POINTS;
        let orbit = map.orbit(start, wanted);
        let period = orbit.iter().skip(1).position(|point| *point == orbit[0]).map(|before| before + 1);
        if orbit.len() < wanted {
            return None;
        }
        let distinct = period.unwrap_or(wanted).min(wanted);
        let modulus = map.modulus();
        let rows = orbit[..distinct].iter().map(|point| monomials.values(modulus, point)).collect();
        let echelon = Echelon::within(modulus, rows, monomials.len(), deadline)?;
        let ranks = (0..=monomials.degree()).map(|d| echelon.rank_of_first(monomials.up_to(d))).collect();
        let vectors = echelon.null_space(modulus);
        Some(Relations { start: orbit[0].clone(), ranks, vectors, points: distinct, period })
    }

    /// Returns the rank of the gradients of all relations at the first point of the orbit. This is
    /// the codimension there of the variety that the relations define.
    #[must_use]
    pub fn codimension(&self, modulus: &Modulus, monomials: &Monomials) -> usize {
        self.normals(modulus, monomials).len()
    }

    /// Returns a basis of the span of the gradients of all relations at the start.
    #[must_use]
    pub fn normals(&self, modulus: &Modulus, monomials: &Monomials) -> Vec<Vec<u64>> {
        let gradients = monomial_gradients(modulus, monomials, &self.start);
        let rows = self.vectors.iter().map(|vector| gradient(modulus, &gradients, &vector.entries)).collect();
        Echelon::of(modulus, rows, monomials.variables()).rows
    }
}

pub(crate) fn monomial_gradient(modulus: &Modulus, exponents: &[u32], point: &[u64]) -> Vec<u64> {
    let slope = |variable: usize| {
        let mut lowered = exponents.to_vec();
        match lowered[variable].checked_sub(1) {
            Some(exponent) => lowered[variable] = exponent,
            None => return 0,
        }
        let factor = modulus.integer(u64::from(exponents[variable]));
        modulus.times(factor, modulus.monomial(&lowered, point))
    };
    (0..exponents.len()).map(slope).collect()
}

/// Returns the gradients of all monomials at a point.
#[must_use]
pub fn monomial_gradients(modulus: &Modulus, monomials: &Monomials, point: &[u64]) -> Vec<Vec<u64>> {
    (0..monomials.len()).map(|index| monomial_gradient(modulus, monomials.exponents(index), point)).collect()
}

/// Returns the gradient of Σ cₘ m, given the gradients of the monomials m and the coefficients cₘ.
#[must_use]
pub fn gradient(modulus: &Modulus, gradients: &[Vec<u64>], coefficients: &[u64]) -> Vec<u64> {
    let mut sum = vec![0; gradients.first().map_or(0, Vec::len)];
    for (&coefficient, slopes) in
        coefficients.iter().zip(gradients).filter(|(coefficient, _)| **coefficient != 0)
    {
        for (entry, slope) in sum.iter_mut().zip(slopes) {
            *entry = modulus.plus(*entry, modulus.times(coefficient, *slope));
        }
    }
    sum
}
