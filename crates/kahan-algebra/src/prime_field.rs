//! Arithmetic modulo primes below 2^62, and tests for primes.
//!
//! The prover evaluates both sides of an identity at random points of a prime field. The primality
//! test never errs. Equal seeds give equal primes and points on every machine.

mod random;
#[cfg(test)]
mod tests;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

pub use random::{Random, Shake256, SplitMix64};

use kahan_syntax::rational::Rational;

/// The field ℤ/p of a prime p. Elements are `u64` numbers below p.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PrimeField {
    prime: u64,
}

impl PrimeField {
    /// The field with 2^61 − 1 elements, for computations that need no random prime.
    pub const MERSENNE_61: Self = Self { prime: (1 << 61) - 1 };

    /// Returns the field with `prime` elements. Returns `None` unless `prime` is a prime below
    /// 2^62.
    pub fn new(prime: u64) -> Option<Self> {
        (prime < 1 << 62 && is_prime_u64(prime)).then_some(Self { prime })
    }

    /// Returns the field of a random prime of 61 bits, drawn uniformly.
    pub fn random(rng: &mut dyn Random) -> Self {
        Self { prime: random_prime_61(rng) }
    }

    /// Returns the number of elements.
    pub fn prime(self) -> u64 {
        self.prime
    }

    /// Returns a + b.
    pub fn add(self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        if sum >= self.prime { sum - self.prime } else { sum }
    }

    /// Returns a − b.
    pub fn sub(self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + self.prime - b }
    }

    /// Returns a·b.
    pub fn mul(self, a: u64, b: u64) -> u64 {
        mul_mod(a, b, self.prime)
    }

    /// Returns −a.
    pub fn neg(self, a: u64) -> u64 {
        if a == 0 { 0 } else { self.prime - a }
    }

    /// Returns a^exponent, where 0^0 is 1.
    pub fn pow(self, a: u64, exponent: u64) -> u64 {
        pow_mod(a, exponent, self.prime)
    }

    /// Returns 1/a. Returns `None` if a is 0.
    pub fn inverse(self, a: u64) -> Option<u64> {
        if a == 0 {
            return None;
        }
        // Both (r, s) and (next_r, next_s) satisfy r ≡ s·a modulo p, with |s| < p < 2^62.
        let (mut r, mut next_r) = (self.prime as i64, a as i64);
        let (mut s, mut next_s) = (0_i64, 1_i64);
        while next_r != 0 {
            let quotient = r / next_r;
            (r, next_r) = (next_r, r - quotient * next_r);
            (s, next_s) = (next_s, s - quotient * next_s);
        }
        Some(if s < 0 { (s + self.prime as i64) as u64 } else { s as u64 })
    }

    /// Returns the residue of an integer.
    pub fn reduce_i64(self, value: i64) -> u64 {
        let residue = value.unsigned_abs() % self.prime;
        if value < 0 { self.neg(residue) } else { residue }
    }

    /// Returns the residue of a rational. Returns `None` if the prime divides the denominator.
    pub fn reduce(self, value: &Rational) -> Option<u64> {
        let (num, den) = match value.as_small_ratio() {
            Some((num, 1)) => return Some(self.reduce_i64(num)),
            Some((num, den)) => (self.reduce_i64(num), self.reduce_i64(den)),
            None => (self.reduce_big(&value.numerator()), self.reduce_big(&value.denominator())),
        };
        Some(self.mul(num, self.inverse(den)?))
    }

    fn reduce_big(self, value: &BigInt) -> u64 {
        value.mod_floor(&BigInt::from(self.prime)).to_u64().expect("a residue is below p")
    }

    /// Draws an element uniformly.
    pub fn sample(self, rng: &mut dyn Random) -> u64 {
        rng.below(self.prime)
    }
}

fn mul_mod(a: u64, b: u64, modulus: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(modulus)) as u64
}

fn pow_mod(mut base: u64, mut exponent: u64, modulus: u64) -> u64 {
    let mut power = 1 % modulus;
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = mul_mod(power, base, modulus);
        }
        base = mul_mod(base, base, modulus);
        exponent >>= 1;
    }
    power
}

/// The first twelve primes. As bases of the Miller–Rabin test, they decide primality below
/// 3.3·10^24 (Sorenson and Webster, "Strong pseudoprimes to twelve prime bases", Math. Comp. 86,
/// 2017).
const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];

/// The upper limit of trial divisors.
const TRIAL_LIMIT: u64 = 256;

/// Returns whether `n` is prime. The answer is certain.
pub fn is_prime_u64(n: u64) -> bool {
    if n < 4 {
        return n >= 2;
    }
    if n.is_multiple_of(2) {
        return false;
    }
    let mut divisor = 3;
    while divisor < TRIAL_LIMIT {
        if n.is_multiple_of(divisor) {
            return n == divisor;
        }
        divisor += 2;
    }
    if n < TRIAL_LIMIT * TRIAL_LIMIT {
        return true;
    }
    BASES.iter().all(|&base| is_strong_probable_prime(n, base))
}

/// Returns whether base^d = 1, or base^(d·2^r) = −1 for some r < s, modulo n. Here n − 1 = d·2^s
/// with odd d.
fn is_strong_probable_prime(n: u64, base: u64) -> bool {
    let twos = (n - 1).trailing_zeros();
    let mut power = pow_mod(base, (n - 1) >> twos, n);
    if power == 1 || power == n - 1 {
        return true;
    }
    for _ in 1..twos {
        power = mul_mod(power, power, n);
        if power == n - 1 {
            return true;
        }
    }
    false
}

/// Draws a prime between 2^60 and 2^61 uniformly. On average 21 odd numbers are tried.
pub fn random_prime_61(rng: &mut dyn Random) -> u64 {
    loop {
        let candidate = (1 << 60) | (rng.next_u64() >> 4) | 1;
        if is_prime_u64(candidate) {
            return candidate;
        }
    }
}
