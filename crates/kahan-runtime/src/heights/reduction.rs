//! The common factor of each coordinate with W: what a height needs, and what the content is made
//! of.
//!
//! The height of xᵢ is that of Xᵢ/W in lowest terms, so gcd(Xᵢ, W) is needed for every i at every
//! step. They are seldom large, and then one long gcd serves all: gcd(Xᵢ, W) = gcd(Xᵢ, P) with P =
//! gcd(W, ∏Xᵢ mod W), because gcd(Xᵢ, W) divides P and P divides W. Where a coordinate shares much
//! of W, as it does at every step if it does at one, P would be as long as W: it is left out of the
//! product. Its own gcd is quick, as the quotients by it are short. Long numbers are shared out
//! between two threads, where the machine has two.

use dashu_int::ops::{BitTest, Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::integers::{bits, short_gcd};
use crate::threads;

/// From this many bits of W on the gcds of several coordinates are worth a thread: they take
/// milliseconds.
const LONG: usize = 1 << 16;
/// Below so many bits of W nothing is guessed.
const WORTH_GUESSING: usize = 1 << 10;

/// Factors with at least one in so many digits of W are much of it.
const MUCH: usize = 8;

/// gcd(Xᵢ, W) for each i; W ≠ 0. `parts` are numbers whose product is W, or none; `before` are the
/// factors of the last point, or none, from which it is guessed which are long. Cost: one gcd of
/// long numbers where all factors are short, shorter ones where there are several parts; another
/// for each factor that is long.
pub(crate) fn common_factors(x: &[IBig], weight: &UBig, parts: &[IBig], before: &[UBig]) -> Vec<UBig> {
    let shares_much = |factor: &UBig| MUCH * factor.bit_len() >= weight.bit_len();
    if weight.bit_len() >= WORTH_GUESSING && before.iter().any(shares_much) {
        let others: Vec<IBig> =
            x.iter().zip(before).filter(|(_, factor)| !shares_much(factor)).map(|(x, _)| x.clone()).collect();
        let shared = shared_with_product(&others, weight);
        let among = |factor| if shares_much(factor) { weight } else { &shared };
        return x.iter().zip(before).map(|(x, factor)| factor_of(x, weight, among(factor))).collect();
    }
    let is_long = weight.bit_len() >= LONG && threads::available() > 1;
    if parts.len() > 1 && is_long {
        // ∏ gcd(B, ∏Xᵢ) over the parts B divides W, and gcd(Xᵢ, W) divides it.
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

/// What comes of the two halves of a list, at once where the machine has two threads.
pub(super) fn in_halves<T: Sync, R: Send>(items: &[T], work: impl Fn(&[T]) -> R + Sync) -> Vec<R> {
    let (left, right) = items.split_at(items.len() / 2);
    threads::map(2, None, |half| work([left, right][half]))
}

/// gcd(B, ∏Xᵢ) over the i with Xᵢ ≠ 0.
fn shared_with_product(x: &[IBig], part: &UBig) -> UBig {
    let residues = x.iter().filter(|x| !x.is_zero()).map(|x| residue(x, part));
    match residues.reduce(|product, residue| product * residue % part) {
        None => UBig::ONE,
        Some(product) if product.is_zero() => part.clone(),
        Some(product) => part.gcd(&product),
    }
}

/// gcd(Xᵢ, P), which is gcd(Xᵢ, W): `shared` is P.
fn each_with(x: &[IBig], weight: &UBig, shared: &UBig) -> Vec<UBig> {
    x.iter().map(|x| factor_of(x, weight, shared)).collect()
}

/// gcd(Xᵢ, P), P a divisor of W that gcd(Xᵢ, W) divides.
fn factor_of(x: &IBig, weight: &UBig, shared: &UBig) -> UBig {
    match x {
        x if x.is_zero() => weight.clone(),
        _ if shared.is_one() => UBig::ONE,
        x => short_gcd(shared, &x.unsigned_abs()),
    }
}

/// |x| reduced to no more than the size of W, with the same gcd with W.
fn residue(x: &IBig, weight: &UBig) -> UBig {
    if bits(x) > weight.bit_len() { x.unsigned_abs() % weight } else { x.unsigned_abs() }
}
