//! Computes gcd(Xᵢ, W) for each coordinate Xᵢ, which heights need at every step.
//!
//! If these are small, one gcd of long numbers is enough: gcd(Xᵢ, W) = gcd(Xᵢ, P) for P = gcd(W,
//! ∏Xᵢ mod W). Coordinates with a large gcd would make P large, so they are left out. A large gcd
//! usually stays large, so the gcds of the previous point predict it.

use dashu_int::ops::{BitTest, Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::integers::{bits, short_gcd};
use crate::threads;

/// The number of bits of W from which gcds of several coordinates use two threads.
const THREADED_GCD_BITS: usize = 1 << 16;
/// The number of bits of W from which large gcds are predicted.
const WORTH_GUESSING: usize = 1 << 10;

/// A common factor is large if it has at least 1/LARGE_FACTOR_FRACTION of the digits of W.
const LARGE_FACTOR_FRACTION: usize = 8;

/// Returns gcd(Xᵢ, W) for each coordinate Xᵢ of a point and its last coordinate W ≠ 0.
///
/// The product of the `parts` is W. The gcds of the previous point are `before`; they predict which
/// gcds are large. An empty slice stands for unknown `parts` or an unknown `before`.
pub(crate) fn common_factors(x: &[IBig], weight: &UBig, parts: &[IBig], before: &[UBig]) -> Vec<UBig> {
    let shares_much = |factor: &UBig| LARGE_FACTOR_FRACTION * factor.bit_len() >= weight.bit_len();
    if weight.bit_len() >= WORTH_GUESSING && before.iter().any(shares_much) {
        let others: Vec<IBig> =
            x.iter().zip(before).filter(|(_, factor)| !shares_much(factor)).map(|(x, _)| x.clone()).collect();
        let shared = shared_with_product(&others, weight);
        let among = |factor| if shares_much(factor) { weight } else { &shared };
        return x.iter().zip(before).map(|(x, factor)| factor_of(x, weight, among(factor))).collect();
    }
    let is_long = weight.bit_len() >= THREADED_GCD_BITS && threads::available() > 1;
    if parts.len() > 1 && is_long {
        // Let W = ∏ B over the factors B in `parts`. Each gcd(Xᵢ, W) divides ∏ gcd(B, ∏Xᵢ), which
        // is shorter than W and therefore replaces it.
        let share = |part: &IBig| shared_with_product(x, &part.unsigned_abs());
        let shares = in_halves(parts, |parts| parts.iter().map(share).collect::<Vec<UBig>>());
        return each_with(x, weight, &shares.iter().flatten().product());
    }
    if x.len() > 1 && is_long {
        let factors = in_halves(x, |x| each_with(x, weight, &shared_with_product(x, weight)));
        return factors.into_iter().flatten().collect();
    }
    each_with(x, weight, &shared_with_product(x, weight))
}

/// Applies `work` to the two halves of a list, on two threads if available.
pub(super) fn in_halves<T: Sync, R: Send>(items: &[T], work: impl Fn(&[T]) -> R + Sync) -> Vec<R> {
    let (left, right) = items.split_at(items.len() / 2);
    threads::map(2, None, |half| work([left, right][half]))
}

fn shared_with_product(x: &[IBig], part: &UBig) -> UBig {
    let residues = x.iter().filter(|x| !x.is_zero()).map(|x| residue(x, part));
    match residues.reduce(|product, residue| product * residue % part) {
        None => UBig::ONE,
        Some(product) if product.is_zero() => part.clone(),
        Some(product) => part.gcd(&product),
    }
}

fn each_with(x: &[IBig], weight: &UBig, shared: &UBig) -> Vec<UBig> {
    x.iter().map(|x| factor_of(x, weight, shared)).collect()
}

/// Returns gcd(Xᵢ, W); `shared` divides W, and gcd(Xᵢ, W) divides `shared`.
fn factor_of(x: &IBig, weight: &UBig, shared: &UBig) -> UBig {
    match x {
        x if x.is_zero() => weight.clone(),
        _ if shared.is_one() => UBig::ONE,
        x => short_gcd(shared, &x.unsigned_abs()),
    }
}

fn residue(x: &IBig, weight: &UBig) -> UBig {
    if bits(x) > weight.bit_len() { x.unsigned_abs() % weight } else { x.unsigned_abs() }
}
