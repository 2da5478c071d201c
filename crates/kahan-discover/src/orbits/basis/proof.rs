//! Proves that the terms of a basis have one relation along every orbit.
//!
//! Let the basis have r + 1 terms. The determinant of their values at r + 1 consecutive points must
//! vanish identically, and r of its rows must be independent. The map is birational, so images of
//! generic points are generic, and the relation holds on the whole orbit. The determinant is a
//! rational function with bounds on degree and coefficients, and is evaluated at random points
//! modulo random primes. Points on both sides of the start keep the degrees low.

use kahan_algebra::field::Field;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::{Random, Shake256};
use kahan_algebra::prove::points_needed;
use kahan_algebra::rational::Rational;

use crate::deadline::Deadline;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::SearchField;
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;

use super::{Basis, Term};

const MOST_POINTS: u32 = 64;

const MOST_SAMPLES: usize = 16;

/// Proves the basis with a probability of error below 2⁻¹⁰⁰, and returns the number of random
/// points.
///
/// Returns `None` if a point refutes the basis, degrees are too high for 61-bit primes, or the
/// deadline passes.
pub fn prove(basis: &Basis, searched: &SearchField, field: &Field, deadline: &Deadline<'_>) -> Option<u32> {
    let size = determinant_size(basis, field, searched.eps())?;
    let points = points_needed(size.degree, size.bits).filter(|points| *points <= MOST_POINTS)?;
    let mut random =
        Shake256::new(format!("{field:?} {:?} {:?}", searched.eps(), basis.monomials).as_bytes());
    (0..points).all(|_| !deadline.passed() && holds_somewhere(basis, searched, &mut random)).then_some(points)
}

/// Returns whether the terms have exactly one relation on a random orbit modulo a random prime.
fn holds_somewhere(basis: &Basis, searched: &SearchField, random: &mut dyn Random) -> bool {
    for _ in 0..MOST_SAMPLES {
        let modulus = Modulus::random(random);
        let Some(sample) = searched.sample(modulus, random) else { continue };
        let (before, after) = halves(basis);
        let start = sample.map.point(random);
        let backward =
            sample.map.with_eps(modulus.opposite(sample.map.eps())).orbit(start.clone(), before + 1);
        let forward = sample.map.orbit(start, after + 1);
        if backward.len() <= before || forward.len() <= after {
            continue;
        }
        let orbit = backward[1..].iter().rev().chain(&forward);
        let rows: Vec<Vec<u64>> = orbit.map(|point| basis.values(&modulus, point)).collect();
        let width = basis.terms.len();
        let fewer = Echelon::of(&modulus, rows[1..].to_vec(), width).rank();
        // Too few independent rows allow several relations, so another point is tried.
        if fewer < width - 1 {
            continue;
        }
        return Echelon::of(&modulus, rows, width).rank() == width - 1;
    }
    false
}

fn halves(basis: &Basis) -> (usize, usize) {
    let steps = basis.points();
    (steps / 2, steps - steps / 2)
}

impl Basis {
    pub(super) fn values(&self, modulus: &Modulus, point: &[u64]) -> Vec<u64> {
        let summand = |&(place, factor): &(usize, i64)| {
            let size = modulus.integer(factor.unsigned_abs());
            let value = modulus.times(size, modulus.monomial(&self.monomials[place], point));
            if factor < 0 { modulus.opposite(value) } else { value }
        };
        let value = |term: &Term| term.iter().map(summand).fold(0, |sum, value| modulus.plus(sum, value));
        self.terms.iter().map(value).collect()
    }
}

/// Bounds on the degree of a polynomial, and on log₂ of its 1-norm, the sum of |coefficient|.
#[derive(Clone, Copy)]
struct PolynomialBound {
    degree: u64,
    bits: u64,
}

fn determinant_size(basis: &Basis, field: &Field, eps: Option<&Rational>) -> Option<PolynomialBound> {
    let (before, after) = halves(basis);
    let highest = basis.monomials.iter().map(|exponents| exponents.iter().sum::<u32>()).max()?;
    let size = basis.terms.len() as u64;
    let factors: u64 = basis.terms.iter().flatten().map(|&(_, factor)| factor.unsigned_abs()).sum();
    // Each row of the determinant multiplies the bound by at most `size`·`factors`.
    let bits = u64::from(size.ilog2() + 1) + u64::from(factors.ilog2() + 1);
    let mut total = PolynomialBound { degree: 0, bits: size * bits };
    for steps in [before, after] {
        let mut point = PolynomialBound { degree: 1, bits: 0 };
        for _ in 0..steps {
            point = image(point, field, eps)?;
            total.degree = total.degree.checked_add(point.degree.checked_mul(u64::from(highest))?)?;
            total.bits = total.bits.checked_add(point.bits.checked_mul(u64::from(highest))?)?;
        }
    }
    total.degree = total.degree.checked_add(u64::from(highest))?;
    Some(total)
}

/// Bounds the numerators and the common denominator of the image of a point. The image x̃ solves
/// the linear system A x̃ = b of a step, and Cramer's rule expresses x̃ by determinants.
fn image(point: PolynomialBound, field: &Field, eps: Option<&Rational>) -> Option<PolynomialBound> {
    let n = field.dimension() as u64;
    let symbols = &field.symbols;
    let others = |polynomial: &Polynomial| polynomial.degree_where(|variable| !symbols.is_state(variable));
    let sides = || field.numerators().chain(field.denominators());
    let of_coefficients = sides().map(others).max()?;
    let degree = u64::from(of_coefficients) + u64::from(eps.is_none()) + point.degree;
    // Let pᵢ/qᵢ be component i of the field, and |·| the sum of absolute coefficients. For row i of
    // the matrix A this sum is at most |qᵢ| + 4 |pᵢ|. A fixed ε adds its number of bits.
    let bits = sides().map(norm_bits).max()? + eps.map_or(0, Rational::bits) + 4;
    Some(PolynomialBound {
        degree: degree.checked_mul(n)?,
        bits: point.bits.checked_add(bits)?.checked_mul(n)?.checked_add(n * u64::from(n.ilog2() + 1))?,
    })
}

fn norm_bits(polynomial: &Polynomial) -> u64 {
    let all: u64 = polynomial.terms().map(|(_, coefficient)| coefficient.bits()).sum();
    all + u64::from((polynomial.len() as u64 + 1).ilog2()) + 1
}
