//! Dense polynomials in one variable over a prime field. A polynomial is the vector of its
//! coefficients, ordered by exponent.

use kahan_algebra::prime_field::PrimeField;

/// The coefficients of a polynomial, ordered by exponent from 0 on.
pub type Dense = Vec<u64>;

/// A sum of products is reduced modulo the prime when it reaches this size. Products are below
/// 2^124, so no sum overflows a `u128`.
const REDUCE_AT: u128 = 1 << 127;

/// Removes the zeros at the end of the vector.
#[must_use]
pub fn trimmed(mut a: Dense) -> Dense {
    while a.last() == Some(&0) {
        a.pop();
    }
    a
}

/// Adds the first `sums.len()` coefficients of a·b to `sums`. The sums are right modulo the prime,
/// but may exceed it.
pub(super) fn add_product(field: PrimeField, sums: &mut [u128], a: &[u64], b: &[u64]) {
    for (shift, &left) in a.iter().enumerate().take(sums.len()) {
        for (sum, &right) in sums[shift..].iter_mut().zip(b) {
            *sum += u128::from(left) * u128::from(right);
            if *sum >= REDUCE_AT {
                *sum %= u128::from(field.prime());
            }
        }
    }
}

pub(super) fn reduced(field: PrimeField, sums: &[u128]) -> Dense {
    sums.iter().map(|sum| (sum % u128::from(field.prime())) as u64).collect()
}

/// Returns the first `len` coefficients of a·b. Zeros at the end are kept.
pub(super) fn product_to(field: PrimeField, a: &[u64], b: &[u64], len: usize) -> Dense {
    let mut sums = vec![0; len];
    add_product(field, &mut sums, a, b);
    reduced(field, &sums)
}

pub(super) fn dot(field: PrimeField, a: &[u64], b: &[u64]) -> u64 {
    let mut sum = 0;
    for (&left, &right) in a.iter().zip(b) {
        sum += u128::from(left) * u128::from(right);
        if sum >= REDUCE_AT {
            sum %= u128::from(field.prime());
        }
    }
    (sum % u128::from(field.prime())) as u64
}

pub(super) fn product(field: PrimeField, a: &[u64], b: &[u64]) -> Dense {
    if a.is_empty() || b.is_empty() {
        return Dense::new();
    }
    trimmed(product_to(field, a, b, a.len() + b.len() - 1))
}

pub(super) fn difference(field: PrimeField, a: &[u64], b: &[u64]) -> Dense {
    let at = |side: &[u64], index: usize| side.get(index).copied().unwrap_or(0);
    trimmed((0..a.len().max(b.len())).map(|index| field.sub(at(a, index), at(b, index))).collect())
}

/// Divides a polynomial by its leading coefficient. Maps 0 to 0.
pub(super) fn monic(field: PrimeField, a: &[u64]) -> Dense {
    let inverse = a.last().and_then(|&lead| field.inverse(lead)).unwrap_or(0);
    a.iter().map(|&coefficient| field.mul(coefficient, inverse)).collect()
}

/// Returns the quotient and the remainder of the division of a by b.
///
/// # Panics
/// If b is 0.
#[must_use]
pub fn quotient_and_rest(field: PrimeField, a: &[u64], b: &[u64]) -> (Dense, Dense) {
    let lead = *b.last().expect("a divisor is not zero");
    let inverse = field.inverse(lead).expect("a leading coefficient is not zero");
    let mut rest = a.to_vec();
    let mut quotient = vec![0; (a.len() + 1).saturating_sub(b.len())];
    for shift in (0..quotient.len()).rev() {
        let factor = field.mul(rest[shift + b.len() - 1], inverse);
        quotient[shift] = factor;
        if factor != 0 {
            for (own, &other) in rest[shift..].iter_mut().zip(b) {
                *own = field.sub(*own, field.mul(factor, other));
            }
        }
    }
    rest.truncate(b.len() - 1);
    (trimmed(quotient), trimmed(rest))
}

pub(super) fn remainder(field: PrimeField, a: &[u64], b: &[u64]) -> Dense {
    quotient_and_rest(field, a, b).1
}

/// Returns the monic greatest common divisor of a and b.
#[must_use]
pub fn gcd(field: PrimeField, a: &[u64], b: &[u64]) -> Dense {
    let (mut a, mut b) = (a.to_vec(), b.to_vec());
    while !b.is_empty() {
        (a, b) = (b.clone(), remainder(field, &a, &b));
    }
    monic(field, &a)
}

/// Returns the inverse of a modulo `modulus`, or `None` if a and `modulus` have a common divisor.
pub(super) fn inverse(field: PrimeField, a: &[u64], modulus: &[u64]) -> Option<Dense> {
    // Both `upper` and `lower` are pairs (r, s) with r = s·a modulo `modulus`.
    let (mut upper, mut lower) = ((modulus.to_vec(), vec![]), (remainder(field, a, modulus), vec![1]));
    while lower.0.len() > 1 {
        let (quotient, rest) = quotient_and_rest(field, &upper.0, &lower.0);
        let next = difference(field, &upper.1, &product(field, &quotient, &lower.1));
        (upper, lower) = (lower, (rest, next));
    }
    let unit = field.inverse(*lower.0.first()?)?;
    Some(remainder(field, &product(field, &lower.1, &[unit]), modulus))
}

pub(super) fn power(field: PrimeField, a: &[u64], mut exponent: u64, modulus: &[u64]) -> Dense {
    let (mut power, mut base) = (remainder(field, &[1], modulus), remainder(field, a, modulus));
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = remainder(field, &product(field, &power, &base), modulus);
        }
        base = remainder(field, &product(field, &base, &base), modulus);
        exponent >>= 1;
    }
    power
}

/// Returns the derivative of the polynomial.
#[must_use]
pub fn derivative(field: PrimeField, a: &[u64]) -> Dense {
    let terms = a.iter().enumerate().skip(1);
    trimmed(terms.map(|(index, &value)| field.mul(index as u64 % field.prime(), value)).collect())
}

/// Returns polynomials sᵢ with 1/∏fᵢ = Σ sᵢ/fᵢ and deg sᵢ < deg fᵢ for given factors fᵢ. Returns
/// `None` if two factors have a common divisor.
pub(super) fn partial_fractions(field: PrimeField, factors: &[Dense]) -> Option<Vec<Dense>> {
    let cofactor = |skipped: usize, modulus: &Dense| {
        let others = factors.iter().enumerate().filter(|(index, _)| *index != skipped);
        others.fold(vec![1], |so_far, (_, other)| remainder(field, &product(field, &so_far, other), modulus))
    };
    factors.iter().enumerate().map(|(index, f)| inverse(field, &cofactor(index, f), f)).collect()
}
