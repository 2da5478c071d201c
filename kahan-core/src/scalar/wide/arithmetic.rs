//! The four operations on [`Digits`], comparison and equality.
//!
//! The radius of a result covers the radii of the operands and the digits that were cut off.

use core::cmp::Ordering;
use core::ops::Neg;

use num_traits::{One, Zero};

use super::rows::DigitRow;
use super::{Digits, Size};
use crate::scalar::operators;

fn binary_gcd(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

impl<const D: usize, const M: usize> Digits<D, M> {
    /// Returns the numerators of two numbers over a common denominator, and this denominator.
    /// Returns `None` if the denominator exceeds 64 bits.
    fn over_one_denominator(&self, other: &Self) -> Option<(DigitRow<M>, DigitRow<M>, u64)> {
        if self.denominator == other.denominator {
            return Some((self.row(), other.row(), self.denominator));
        }
        let factor = other.denominator / binary_gcd(self.denominator, other.denominator);
        let all = self.denominator.checked_mul(factor)?;
        let raised = |number: &Self| number.row().times(&integer(all / number.denominator));
        Some((raised(self), raised(other), all))
    }

    #[inline(never)]
    fn combined(&self, other: &Self, sign: i64) -> Self {
        if !(self.is_defined() && other.is_defined()) {
            return Self::UNDEFINED;
        }
        match self.over_one_denominator(other) {
            Some((a, b, denominator)) => Self::of(&a.plus(&b, sign), denominator, self.radius + other.radius),
            None => self.divided_out().combined(&other.divided_out(), sign),
        }
    }

    #[inline(never)]
    pub(super) fn divided_out(&self) -> Self {
        if self.denominator == 1 {
            return *self;
        }
        let quotient: Self = ratio(&self.row(), &integer(self.denominator));
        Self { radius: quotient.radius + self.radius, ..quotient }
    }

    /// Returns the sign, m and e if the numerator is ±m·2^e with an odd m of 64 bits.
    fn short(&self) -> Option<(bool, u64, i64)> {
        let row = self.row();
        let (first, last) = (row.digits().first()?, row.digits().last()?);
        if row.digits().len() > 2 || first.0 - last.0 > 1 {
            return None;
        }
        let (size, place) = row.leading_pair()?;
        let zeros = size.trailing_zeros();
        let odd = u64::try_from(size >> zeros).ok()?;
        Some((row.sign() < 0, odd, 64 * place + i64::from(zeros)))
    }
}

/// Returns a/b for a nonzero divisor. The radius bounds the effect of the remainder.
fn ratio<const D: usize, const M: usize>(a: &DigitRow<M>, b: &DigitRow<M>) -> Digits<D, M> {
    let (quotient, rest) = a.divided(b);
    Digits::of(&quotient, 1, (rest.size() + rest.tail_bound(usize::MAX)) / b.size())
}

fn integer<const M: usize>(n: u64) -> DigitRow<M> {
    DigitRow::of_limbs(false, &[n])
}

impl<const D: usize, const M: usize> Neg for Digits<D, M> {
    type Output = Self;

    fn neg(self) -> Self {
        Self::ZERO - self
    }
}

operators! {
    [const D: usize, const M: usize] Digits<D, M>:
    |a: Self, b: Self| a.combined(&b, 1),
    |a: Self, b: Self| a.combined(&b, -1),
    Self::times,
    Self::over
}

impl<const D: usize, const M: usize> Digits<D, M> {
    /// The error is at most |â|·r_b + |b̂|·r_a + r_a·r_b for factors with the radii r_a and r_b.
    #[inline(never)]
    fn times(self, other: Self) -> Self {
        if !(self.is_defined() && other.is_defined()) {
            return Self::UNDEFINED;
        }
        let Some(denominator) = self.denominator.checked_mul(other.denominator) else {
            return self.divided_out() * other.divided_out();
        };
        let radius = self.size() * other.radius + (other.size() + other.radius) * self.radius;
        Self::of(&self.row().times(&other.row()), denominator, radius)
    }

    /// Divides numbers with radii r_a and r_b. If r_b ≤ |b̂|/64, |a/b − â/b̂| ≤ (r_a +
    /// |â/b̂|·r_b)/(|b̂| − r_b). For a larger r_b the radius is infinite.
    #[inline(never)]
    fn over(self, other: Self) -> Self {
        if !(self.is_defined() && other.is_defined()) || other.is_zero() {
            return Self::UNDEFINED;
        }
        let exact = self.exact_quotient(&other);
        let Some(quotient) = exact.or_else(|| {
            let (above, below, _) = self.over_one_denominator(&other)?;
            Some(ratio(&above, &below))
        }) else {
            return self.divided_out() / other.divided_out();
        };
        let radius = (self.radius + quotient.size() * other.radius) * Size::from(64.0 / 63.0) / other.size();
        let is_known = other.radius * Size::from(64.0) <= other.size();
        let radius = if is_known { radius } else { Size::from(f64::INFINITY) };
        Self { radius: quotient.radius + radius, ..quotient }
    }

    /// Returns the exact quotient by a divisor of few bits, if the denominator fits 64 bits.
    fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        let (is_negative, odd, exponent) = divisor.short()?;
        let denominator = self.denominator.checked_mul(odd)?;
        let factor = DigitRow::of_limbs(is_negative, &[divisor.denominator]);
        let power = DigitRow::of_significand(1, exponent.checked_neg()?);
        Some(Self::of(&self.row().times(&factor).times(&power), denominator, Size::zero()))
    }

    pub(crate) fn compare_magnitudes(&self, other: &Self) -> Option<Ordering> {
        if !(self.is_defined() && other.is_defined()) {
            return None;
        }
        let Some((a, b, _)) = self.over_one_denominator(other) else {
            return self.divided_out().compare_magnitudes(&other.divided_out());
        };
        let sign = if a.sign() * b.sign() < 0 { 1 } else { -1 };
        let difference = a.plus(&b, sign).sign();
        // If self is 0, only the sign of the other number matters.
        Some(if a.sign() == 0 { 0.cmp(&b.sign().abs()) } else { (a.sign() * difference).cmp(&0) })
    }
}

impl<const D: usize, const M: usize> PartialEq for Digits<D, M> {
    fn eq(&self, other: &Self) -> bool {
        let difference = *self - *other;
        difference.is_defined() && difference.is_zero()
    }
}

impl<const D: usize, const M: usize> Zero for Digits<D, M> {
    fn zero() -> Self {
        Self::ZERO
    }

    fn is_zero(&self) -> bool {
        self.count == 0 && self.is_defined()
    }
}

impl<const D: usize, const M: usize> One for Digits<D, M> {
    fn one() -> Self {
        Self::from(1_i64)
    }
}
