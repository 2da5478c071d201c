//! Numbers that are known to lie near others: a middle of limited length and a radius.
//!
//! In: exact numbers. Out: for every sum, product and quotient a ball that contains the exact one.
//! Middles have exponents of their own, so nothing overflows or underflows, and a ball is wide
//! beside its middle only where terms cancelled.

use super::dyadic::Dyadic;

/// significand·2^exponent, rounded up in every operation; significands have 31 bits, and that of 0
/// is 0.
#[derive(Clone, Copy, Debug)]
struct Radius {
    significand: u64,
    exponent: i64,
}

impl Radius {
    const ZERO: Self = Self { significand: 0, exponent: 0 };

    /// The bits that a significand has.
    const BITS: u32 = 31;

    /// At least significand·2^exponent.
    fn new(significand: u64, exponent: i64) -> Self {
        let bits = u64::BITS - significand.leading_zeros();
        if significand == 0 {
            return Self::ZERO;
        }
        if bits <= Self::BITS {
            let missing = Self::BITS - bits;
            return Self { significand: significand << missing, exponent: exponent - i64::from(missing) };
        }
        let excess = bits - Self::BITS;
        // One more is at least what was cut off; it may be 2^31 itself.
        Self { significand: (significand >> excess) + 1, exponent: exponent + i64::from(excess) }
    }

    /// At least |value|.
    fn of(value: &Dyadic) -> Self {
        let (leading, binade) = value.leading();
        if leading == 0.0 {
            return Self::ZERO;
        }
        // 1 ≤ |leading| < 2, cut off.
        Self::new((leading.abs() * 1_073_741_824.0) as u64 + 1, binade - 30)
    }

    fn is_zero(self) -> bool {
        self.significand == 0
    }

    fn plus(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other } else { self };
        }
        let (high, low) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let shift = (high.exponent - low.exponent).min(i64::from(u64::BITS) - 1);
        // The lower one in units of the higher, rounded up.
        Self::new(high.significand + (low.significand >> shift) + 1, high.exponent)
    }

    fn times(self, other: Self) -> Self {
        Self::new(self.significand * other.significand, self.exponent + other.exponent)
    }

    /// At least self/divisor, for a divisor that is not 0.
    fn over(self, divisor: &Dyadic) -> Self {
        if self.is_zero() {
            return self;
        }
        let (leading, binade) = divisor.leading();
        // |divisor| ≥ floor(|leading|·2³⁰)·2^(binade − 30)
        let least = (leading.abs() * 1_073_741_824.0) as u64;
        Self::new((self.significand << 32) / least + 1, self.exponent - 32 - binade + 30)
    }

    fn value(self) -> Dyadic {
        Dyadic::new(self.significand, self.exponent)
    }
}

/// All numbers within the radius of the middle.
#[derive(Clone, Debug)]
pub(crate) struct Ball {
    middle: Dyadic,
    radius: Radius,
}

impl Ball {
    /// The ball of one number.
    pub(crate) fn exactly(middle: Dyadic) -> Self {
        Self { middle, radius: Radius::ZERO }
    }

    /// One with a middle of `bits` bits that contains this one.
    pub(crate) fn rounded(self, bits: u64) -> Self {
        let Self { middle, radius } = self;
        match middle.cut(bits) {
            None => Self { middle, radius },
            Some((middle, unit)) => Self { middle, radius: radius.plus(Radius::new(1, unit)) },
        }
    }

    pub(crate) fn middle(&self) -> &Dyadic {
        &self.middle
    }

    /// Whether it is 0 and nothing else.
    pub(crate) fn is_zero(&self) -> bool {
        self.middle.is_zero() && self.radius.is_zero()
    }

    /// Whether 0 is not in it.
    pub(crate) fn is_not_zero(&self) -> bool {
        !self.middle.is_zero() && !self.least().is_negative() && !self.least().is_zero()
    }

    /// |v| is at least this for every v in it, where that is not negative.
    pub(crate) fn least(&self) -> Dyadic {
        &self.middle.clone().abs() - &self.radius.value()
    }

    /// |v| is at most this for every v in it.
    pub(crate) fn most(&self) -> Dyadic {
        &self.middle.clone().abs() + &self.radius.value()
    }

    pub(crate) fn plus(&self, other: &Self, bits: u64) -> Self {
        let radius = self.radius.plus(other.radius);
        let (high, low) =
            if self.middle.binade() >= other.middle.binade() { (self, other) } else { (other, self) };
        match (high.middle.binade(), low.middle.binade()) {
            // What is far below the last bit is no more than a part of the radius.
            (Some(above), Some(below)) if above - below > bits as i64 + 8 => {
                let radius = radius.plus(Radius::of(&low.middle));
                Self { middle: high.middle.clone(), radius }.rounded(bits)
            }
            _ => Self { middle: &self.middle + &other.middle, radius }.rounded(bits),
        }
    }

    pub(crate) fn minus(&self, other: &Self, bits: u64) -> Self {
        self.plus(&Self { middle: &Dyadic::zero() - &other.middle, radius: other.radius }, bits)
    }

    pub(crate) fn times(&self, other: &Self, bits: u64) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::exactly(Dyadic::zero());
        }
        let one = Radius::of(&self.middle).times(other.radius);
        let two = self.radius.times(Radius::of(&other.middle).plus(other.radius));
        Self { middle: &self.middle * &other.middle, radius: one.plus(two) }.rounded(bits)
    }

    /// self/divisor, for a divisor that [is not zero](Self::is_not_zero).
    pub(crate) fn over(&self, divisor: &Self, bits: u64) -> Self {
        if self.is_zero() {
            return self.clone();
        }
        // a/b − â/b̂ = [(a − â) − (â/b̂)(b − b̂)]/b
        let (middle, unit) = self.middle.quotient(&divisor.middle, bits);
        let by_divisor = Radius::of(&middle).plus(Radius::new(1, unit)).times(divisor.radius);
        let radius = self.radius.plus(by_divisor).over(&divisor.least());
        Self { middle, radius: radius.plus(Radius::new(1, unit)) }
    }

    pub(crate) fn absolute(self) -> Self {
        // 0 may be inside: then the magnitudes lie between −radius and the most.
        Self { middle: self.middle.abs(), radius: self.radius }
    }
}

#[cfg(test)]
mod tests {
    use kahan_algebra::prime_field::SplitMix64;
    use kahan_core::num_rational::BigRational;

    use super::*;

    /// A ball around numbers near n, with one of them.
    fn drawn(random: &mut SplitMix64) -> (Ball, BigRational) {
        let integer = random.next_u64() as i64 >> random.below(60);
        let middle = Dyadic::new(integer, random.below(40) as i64 - 20);
        let radius = Radius::new(random.next_u64() >> random.below(64), random.below(30) as i64 - 70);
        let share = Dyadic::new(random.below(257) as i64 - 128, -7);
        let inside = (&middle + &(&share * &radius.value())).rational().to_big();
        (Ball { middle, radius }, inside)
    }

    fn contains(ball: &Ball, value: &BigRational) -> bool {
        let [middle, radius] = [&ball.middle, &ball.radius.value()].map(|of| of.rational().to_big());
        let difference = middle - value;
        -radius.clone() <= difference && difference <= radius
    }

    #[test]
    fn every_operation_keeps_what_is_inside() {
        let mut random = SplitMix64::new(3);
        let (mut wide, mut quotients) = (0, 0);
        for turn in 0..20_000 {
            let ((a, x), (b, y)) = (drawn(&mut random), drawn(&mut random));
            let bits = 8 + random.below(60);
            assert!(contains(&a.plus(&b, bits), &(&x + &y)), "{turn}");
            assert!(contains(&a.minus(&b, bits), &(&x - &y)), "{turn}");
            assert!(contains(&a.times(&b, bits), &(&x * &y)), "{turn}");
            assert!(contains(&a.clone().rounded(bits), &x), "{turn}");
            if b.is_not_zero() {
                assert!(contains(&a.over(&b, bits), &(&x / &y)), "{turn}");
                quotients += 1;
            } else {
                wide += 1;
            }
        }
        assert!(wide > 100 && quotients > 10_000, "{wide} {quotients}");
    }

    #[test]
    fn long_middles_make_small_radii() {
        let (one, three) = (Ball::exactly(Dyadic::new(1, 0)), Ball::exactly(Dyadic::new(3, 900)));
        let third = one.over(&three, 200);
        assert!(third.radius.value().ratio(&third.middle) < 2_f64.powi(-198));
        let rest = third.times(&three, 200).minus(&one, 200);
        assert!(!rest.is_not_zero() && rest.most().near_f64() < 2_f64.powi(-195));
    }
}
