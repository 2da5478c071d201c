//! Bounds the degrees of a gcd of polynomials by the degrees of gcds of images modulo a prime.
//!
//! In an image, all variables except one are set to elements of F_p. The degree of the gcd in the
//! variable v is at most that of the gcd of the images. An unlucky point makes the bound larger,
//! but never wrong.
//!
//! # Proof
//!
//! Let a and b have integer coefficients, let a be primitive, and let g be their primitive gcd. By
//! Gauss's lemma a = g·h with integer coefficients, so lc(a) = lc(g)·lc(h) for leading coefficients
//! in v. Therefore, if lc(a) does not vanish in the image, lc(g) does not vanish either, and g and
//! its image have equal degree in v. The image of g divides both images.

use kahan_syntax::table::Table;

use super::{Budget, Polynomial, Variable, WithinBudget};
use crate::prime_field::{PrimeField, SplitMix64};

const FIELD: PrimeField = PrimeField::MERSENNE_61;

/// A [`Budget`] counts products of two polynomial terms. Such a product costs as much as this many
/// multiplications in F_p.
pub const RESIDUES_PER_TERM: u64 = 32;

type Univariate = Vec<u64>;

/// Bounds the degree of gcd(a, b) in each variable, for primitive a and b. The cost is a few
/// multiplications in F_p for each power in a term, and one univariate gcd for each variable.
///
/// # Errors
/// If the budget runs out.
///
/// # Panics
/// If a polynomial is not primitive and 2^61 − 1 divides a denominator.
pub fn degree_bounds(
    a: &Polynomial,
    b: &Polynomial,
    budget: &mut Budget,
) -> WithinBudget<Table<Variable, u32>> {
    let (degrees_a, degrees_b) = (degrees(a), degrees(b));
    budget.charge((a.len() + b.len()) as u64)?;
    for (variable, &degree_a) in degrees_a.iter() {
        let degree_b = degrees_b.get(variable).copied().unwrap_or(0);
        let steps = (u64::from(degree_a) + 1) * (u64::from(degree_b) + 1);
        budget.charge(steps / RESIDUES_PER_TERM)?;
    }
    let (images_a, images_b) = (images(a, &degrees_a), images(b, &degrees_b));
    let mut bounds = Table::new();
    for (variable, &degree_a) in degrees_a.iter() {
        let Some(&degree_b) = degrees_b.get(variable) else { continue };
        let (image_a, image_b) = (&images_a[variable], &images_b[variable]);
        let kept = image_a.len() > degree_a as usize || image_b.len() > degree_b as usize;
        let bound = if kept { gcd_degree(image_a, image_b) } else { u32::MAX };
        bounds.insert(*variable, bound.min(degree_a).min(degree_b));
    }
    Ok(bounds)
}

fn degrees(polynomial: &Polynomial) -> Table<Variable, u32> {
    let mut degrees = Table::new();
    for (monomial, _) in polynomial.terms() {
        for &(variable, exponent) in monomial.powers() {
            let degree: &mut u32 = degrees.or_insert_with(variable, |_| exponent);
            *degree = exponent.max(*degree);
        }
    }
    degrees
}

fn powers_of_point(variable: Variable, degree: u32) -> Vec<u64> {
    let mut rng = SplitMix64::new(u64::from(variable.0));
    let value = 1 + rng.below(FIELD.prime() - 1);
    let mut powers = vec![1];
    for exponent in 0..degree as usize {
        powers.push(FIELD.mul(powers[exponent], value));
    }
    powers
}

/// Returns for each variable the image of the polynomial in which all other variables have random
/// values in F_p.
fn images(polynomial: &Polynomial, degrees: &Table<Variable, u32>) -> Table<Variable, Univariate> {
    let variables: Vec<Variable> = degrees.iter().map(|(variable, _)| *variable).collect();
    let points: Vec<Vec<u64>> = degrees.iter().map(|(&v, &degree)| powers_of_point(v, degree)).collect();
    let mut images: Vec<Univariate> = points.iter().map(|powers| vec![0; powers.len()]).collect();
    let mut before = vec![0; variables.len()];
    for (monomial, coefficient) in polynomial.terms() {
        let mut value = FIELD.reduce(coefficient).expect("a primitive polynomial has integer coefficients");
        for (index, variable) in variables.iter().enumerate() {
            before[index] = value;
            let exponent = monomial.exponent(*variable);
            if exponent > 0 {
                value = FIELD.mul(value, points[index][exponent as usize]);
            }
        }
        let mut behind = 1;
        for (index, variable) in variables.iter().enumerate().rev() {
            let exponent = monomial.exponent(*variable) as usize;
            let image = &mut images[index][exponent];
            *image = FIELD.add(*image, FIELD.mul(before[index], behind));
            if exponent > 0 {
                behind = FIELD.mul(behind, points[index][exponent]);
            }
        }
    }
    for image in &mut images {
        trim(image);
    }
    Table::from_sorted(variables.into_iter().zip(images).collect())
}

fn trim(polynomial: &mut Univariate) {
    while polynomial.last() == Some(&0) {
        polynomial.pop();
    }
}

/// Returns the degree of the gcd by Euclid's algorithm. Returns `u32::MAX` if both polynomials are
/// 0.
fn gcd_degree(a: &Univariate, b: &Univariate) -> u32 {
    let (mut a, mut b) = (a.clone(), b.clone());
    while let Some(&lead) = b.last() {
        let inverse = FIELD.inverse(lead).expect("a leading coefficient is not zero");
        while a.len() >= b.len() {
            let shift = a.len() - b.len();
            let factor = FIELD.mul(a[a.len() - 1], inverse);
            for (coefficient, other) in a[shift..].iter_mut().zip(&b) {
                *coefficient = FIELD.sub(*coefficient, FIELD.mul(factor, *other));
            }
            trim(&mut a);
        }
        (a, b) = (b, a);
    }
    u32::try_from(a.len()).map_or(u32::MAX, |len| len.wrapping_sub(1))
}
