//! Arithmetic modulo a prime, usually of 61 bits, in Montgomery form: a residue a is stored as
//! a·2⁶⁴ mod p.
//!
//! Stored residues are below p, so equal residues are equal numbers. Orbits, matrices and
//! interpolations take millions of multiplications, for which 128-bit remainders would be too slow.

use kahan_algebra::prime_field::{PrimeField, Random};
use kahan_algebra::rational::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, Zero};

/// The field of p elements, for an odd prime p below 2⁶². An element a is stored as a·2⁶⁴ mod p.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Modulus {
    plain: PrimeField,
    prime: u64,
    /// The number −1/p modulo 2⁶⁴.
    negated_inverse: u64,
    /// The number 2⁶⁴ modulo p, which is 1 in Montgomery form.
    one: u64,
    /// The number 2¹²⁸ modulo p, which is 2⁶⁴ in Montgomery form.
    square: u64,
}

impl Modulus {
    /// Returns the field of 2⁶¹ − 1 elements.
    #[must_use]
    pub fn mersenne_61() -> Self {
        Self::of(PrimeField::MERSENNE_61)
    }

    /// Returns the field of a random prime of 61 bits.
    pub fn random(random: &mut dyn Random) -> Self {
        Self::of(PrimeField::random(random))
    }

    pub(crate) fn of(plain: PrimeField) -> Self {
        let prime = plain.prime();
        // Newton's iteration for 1/p modulo 2⁶⁴ starts with p, which has three correct bits, and
        // doubles their number five times.
        let mut inverse = prime;
        for _ in 0..5 {
            inverse = inverse.wrapping_mul(2u64.wrapping_sub(prime.wrapping_mul(inverse)));
        }
        let one = ((1u128 << 64) % u128::from(prime)) as u64;
        let square = (u128::from(one) * u128::from(one) % u128::from(prime)) as u64;
        Modulus { plain, prime, negated_inverse: inverse.wrapping_neg(), one, square }
    }

    /// Returns the field with the same prime, with elements as ordinary residues.
    pub(crate) fn field(&self) -> PrimeField {
        self.plain
    }

    /// Returns the number of elements, the prime p.
    #[must_use]
    pub fn prime(&self) -> u64 {
        self.prime
    }

    /// Returns the number 1 in Montgomery form.
    #[must_use]
    pub fn one(&self) -> u64 {
        self.one
    }

    /// Converts an integer to Montgomery form.
    #[must_use]
    pub fn integer(&self, value: u64) -> u64 {
        self.times(value % self.prime, self.square)
    }

    /// Returns a + b.
    #[inline]
    #[must_use]
    pub fn plus(&self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        if sum >= self.prime { sum - self.prime } else { sum }
    }

    /// Returns a − b.
    #[inline]
    #[must_use]
    pub fn minus(&self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + self.prime - b }
    }

    /// Returns a·b.
    #[inline]
    #[must_use]
    pub fn times(&self, a: u64, b: u64) -> u64 {
        let quotient = self.quotient(u128::from(a) * u128::from(b));
        if quotient >= self.prime { quotient - self.prime } else { quotient }
    }

    /// Returns a number below s/2⁶⁴ + p that is s/2⁶⁴ modulo p, for s = `sum` ≤ 2¹²⁸ − 2⁶⁴p.
    #[inline]
    fn quotient(&self, sum: u128) -> u64 {
        let multiple = (sum as u64).wrapping_mul(self.negated_inverse);
        ((sum + u128::from(multiple) * u128::from(self.prime)) >> 64) as u64
    }

    /// The most products that may be added to [`unreduced(a)`](Self::unreduced) for a < p. Since
    /// p < 2⁶², the sum a·2⁶⁴ and eight products are together below 3·2¹²⁶, which fits into 128
    /// bits.
    pub(crate) const MAX_UNREDUCED_PRODUCTS: usize = 8;

    /// Returns a·2⁶⁴, the first summand of a sum of products.
    #[inline]
    pub(crate) fn unreduced(a: u64) -> u128 {
        u128::from(a) << 64
    }

    /// Reduces a sum of products modulo p.
    #[inline]
    pub(crate) fn reduced(&self, sum: u128) -> u64 {
        // The sum is at most p·2⁶⁴ + 8p². Divided by 2⁶⁴ it is below 3p, so `quotient` is below 4p.
        let quotient = self.quotient(sum);
        let quotient = if quotient >= 2 * self.prime { quotient - 2 * self.prime } else { quotient };
        if quotient >= self.prime { quotient - self.prime } else { quotient }
    }

    /// Returns −a.
    #[inline]
    #[must_use]
    pub fn opposite(&self, a: u64) -> u64 {
        if a == 0 { 0 } else { self.prime - a }
    }

    /// Returns 1/a, or `None` for a = 0.
    #[must_use]
    pub fn inverse(&self, a: u64) -> Option<u64> {
        // The stored number is a·2⁶⁴. Its inverse times 2¹²⁸ is a⁻¹·2⁶⁴, the stored number for 1/a.
        let inverse = self.plain.inverse(a)?;
        Some(self.times(self.times(inverse, self.square), self.square))
    }

    /// Inverts all values with a single inversion. Returns `false` if a value is 0.
    pub fn invert_all(&self, values: &mut [u64]) -> bool {
        let mut products = Vec::with_capacity(values.len());
        let mut product = self.one;
        for &value in values.iter() {
            products.push(product);
            product = self.times(product, value);
        }
        let Some(mut inverse) = self.inverse(product) else { return false };
        for (value, before) in values.iter_mut().zip(&products).rev() {
            let own = self.times(inverse, *before);
            inverse = self.times(inverse, *value);
            *value = own;
        }
        true
    }

    /// Returns a^exponent, where 0⁰ is 1.
    #[must_use]
    pub fn power(&self, a: u64, exponent: u32) -> u64 {
        let (mut power, mut base, mut exponent) = (self.one, a, exponent);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = self.times(power, base);
            }
            base = self.times(base, base);
            exponent >>= 1;
        }
        power
    }

    /// Returns Σ aᵢ bᵢ.
    #[must_use]
    pub fn dot(&self, a: &[u64], b: &[u64]) -> u64 {
        a.chunks(Self::MAX_UNREDUCED_PRODUCTS).zip(b.chunks(Self::MAX_UNREDUCED_PRODUCTS)).fold(
            0,
            |sum, (a, b)| {
                let products = a.iter().zip(b).map(|(a, b)| u128::from(*a) * u128::from(*b));
                self.reduced(products.fold(Self::unreduced(sum), |sum, product| sum + product))
            },
        )
    }

    /// Returns ∏ xᵢ^eᵢ for a point x and exponents e.
    #[must_use]
    pub fn monomial(&self, exponents: &[u32], point: &[u64]) -> u64 {
        let powers = exponents.iter().zip(point);
        powers.fold(self.one, |product, (&exponent, &x)| self.times(product, self.power(x, exponent)))
    }

    /// Converts a rational number to Montgomery form. Returns `None` if p divides the denominator.
    #[must_use]
    pub fn rational(&self, value: &Rational) -> Option<u64> {
        self.plain.reduce(value).map(|residue| self.times(residue, self.square))
    }

    /// Returns the ordinary residue of an element, from 0 to p − 1.
    #[must_use]
    pub fn residue(&self, a: u64) -> u64 {
        self.times(a, 1)
    }

    /// Samples an element uniformly.
    pub fn sample(&self, random: &mut dyn Random) -> u64 {
        random.below(self.prime)
    }
}

/// Returns the only fraction num/den ≡ r modulo m with |num|, den ≤ √(m/2), if it exists (Wang, Guy
/// and Davenport, "P-adic reconstruction of rational numbers", SIGSAM 1982).
#[must_use]
pub fn rational_from_residue(r: &BigInt, m: &BigInt) -> Option<Rational> {
    let bound = (m / 2i32).sqrt();
    let (mut upper, mut lower) = (m.clone(), r.mod_floor(m));
    let (mut upper_factor, mut lower_factor) = (BigInt::zero(), BigInt::from(1));
    while lower > bound {
        let quotient = &upper / &lower;
        let next = &upper - &quotient * &lower;
        upper = std::mem::replace(&mut lower, next);
        let next = &upper_factor - &quotient * &lower_factor;
        upper_factor = std::mem::replace(&mut lower_factor, next);
    }
    if lower_factor.is_zero() || lower_factor.abs() > bound || !lower.gcd(&lower_factor).eq(&BigInt::from(1))
    {
        return None;
    }
    Rational::from(lower).checked_div(&Rational::from(lower_factor))
}

#[cfg(test)]
mod tests {
    use kahan_algebra::prime_field::SplitMix64;

    use super::*;

    #[test]
    fn montgomery_arithmetic_is_that_of_the_prime_field() {
        let mut random = SplitMix64::new(7);
        for modulus in [Modulus::mersenne_61(), Modulus::random(&mut random)] {
            let plain = PrimeField::new(modulus.prime()).unwrap();
            for _ in 0..200 {
                let (a, b) = (plain.sample(&mut random), plain.sample(&mut random));
                let (x, y) = (modulus.integer(a), modulus.integer(b));
                assert_eq!(modulus.residue(modulus.times(x, y)), plain.mul(a, b));
                assert_eq!(modulus.residue(modulus.plus(x, y)), plain.add(a, b));
                assert_eq!(modulus.residue(modulus.minus(x, y)), plain.sub(a, b));
                assert_eq!(modulus.residue(modulus.inverse(x).unwrap()), plain.inverse(a).unwrap());
            }
        }
    }

    #[test]
    fn the_largest_sums_of_products_fit() {
        let plain = PrimeField::new((1 << 62) - 57).unwrap();
        let modulus = Modulus::of(plain);
        for k in 1..100 {
            let (a, b) = (modulus.prime() - 1, modulus.prime() - k);
            let sum = (0..Modulus::MAX_UNREDUCED_PRODUCTS)
                .fold(Modulus::unreduced(a), |sum, _| sum + u128::from(a) * u128::from(b));
            let expected =
                (0..Modulus::MAX_UNREDUCED_PRODUCTS).fold(a, |sum, _| modulus.plus(sum, modulus.times(a, b)));
            assert_eq!(modulus.reduced(sum), expected);
        }
    }

    #[test]
    fn a_fraction_comes_back_from_its_residue() {
        let modulus = Modulus::mersenne_61();
        let m = BigInt::from(modulus.prime());
        for value in [Rational::new(-355, 113), Rational::new(1, 3), Rational::zero(), Rational::from(-4)] {
            let residue = modulus.residue(modulus.rational(&value).unwrap());
            assert_eq!(rational_from_residue(&BigInt::from(residue), &m), Some(value));
        }
    }
}
