//! Ball arithmetic: a ball is the set of all numbers within a radius of a middle.
//!
//! Every sum, product and quotient is a ball that contains the exact result. Exponents are 64-bit
//! integers, so nothing overflows or underflows.

use super::dyadic::Dyadic;

#[derive(Clone, Debug)]
pub(crate) struct Ball {
    middle: Dyadic,
    /// The radius. Every operation rounds it up to at most [`RADIUS_BITS`] bits.
    radius: Dyadic,
}

const RADIUS_BITS: u64 = 31;

/// Returns an upper bound of |value| with about `RADIUS_BITS` bits.
fn upper_bound(value: &Dyadic) -> Dyadic {
    let size = value.clone().abs();
    match size.truncated(RADIUS_BITS) {
        None => size,
        Some((cut, unit)) => &cut + &Dyadic::new(1, unit),
    }
}

impl Ball {
    pub(crate) fn exactly(middle: Dyadic) -> Self {
        Self { middle, radius: Dyadic::zero() }
    }

    /// Rounds the middle to `bits` bits, and enlarges the radius by the rounding error.
    pub(crate) fn rounded(self, bits: u64) -> Self {
        let Self { middle, radius } = self;
        match middle.truncated(bits) {
            None => Self { middle, radius },
            Some((middle, unit)) => Self { middle, radius: upper_bound(&(&radius + &Dyadic::new(1, unit))) },
        }
    }

    pub(crate) fn middle(&self) -> &Dyadic {
        &self.middle
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.middle.is_zero() && self.radius.is_zero()
    }

    pub(crate) fn is_not_zero(&self) -> bool {
        !self.middle.is_zero() && !self.least().is_negative() && !self.least().is_zero()
    }

    /// Returns |middle| − radius, a lower bound of |v| for all v in the ball. It may be negative.
    pub(crate) fn least(&self) -> Dyadic {
        &self.middle.clone().abs() - &self.radius
    }

    pub(crate) fn most(&self) -> Dyadic {
        &self.middle.clone().abs() + &self.radius
    }

    pub(crate) fn plus(&self, other: &Self, bits: u64) -> Self {
        let radius = upper_bound(&(&self.radius + &other.radius));
        let (high, low) =
            if self.middle.binade() >= other.middle.binade() { (self, other) } else { (other, self) };
        match (high.middle.binade(), low.middle.binade()) {
            // A middle that is smaller by more than `bits` + 8 binades only enlarges the radius.
            (Some(above), Some(below)) if above - below > bits as i64 + 8 => {
                let radius = upper_bound(&(&radius + &upper_bound(&low.middle)));
                Self { middle: high.middle.clone(), radius }.rounded(bits)
            }
            _ => Self { middle: &self.middle + &other.middle, radius }.rounded(bits),
        }
    }

    pub(crate) fn minus(&self, other: &Self, bits: u64) -> Self {
        self.plus(&Self { middle: &Dyadic::zero() - &other.middle, radius: other.radius.clone() }, bits)
    }

    pub(crate) fn times(&self, other: &Self, bits: u64) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::exactly(Dyadic::zero());
        }
        let one = &upper_bound(&self.middle) * &other.radius;
        let two = &self.radius * &(&upper_bound(&other.middle) + &other.radius);
        Self { middle: &self.middle * &other.middle, radius: upper_bound(&(&one + &two)) }.rounded(bits)
    }

    /// Divides by a ball that [excludes 0](Self::is_not_zero).
    pub(crate) fn over(&self, divisor: &Self, bits: u64) -> Self {
        if self.is_zero() {
            return self.clone();
        }
        // For a and b in the balls with middles â and b̂, the radius bounds the absolute value of
        // a/b − â/b̂ = [(a − â) − (â/b̂)(b − b̂)]/b.
        let (middle, unit) = self.middle.quotient(&divisor.middle, bits);
        let unit = Dyadic::new(1, unit);
        let by_divisor = &(&upper_bound(&middle) + &unit) * &divisor.radius;
        let mut radius = upper_bound(&(&self.radius + &by_divisor));
        if !radius.is_zero() {
            let (quotient, beyond) = radius.quotient(&divisor.least(), RADIUS_BITS);
            radius = &quotient + &Dyadic::new(1, beyond);
        }
        Self { middle, radius: upper_bound(&(&radius + &unit)) }
    }

    pub(crate) fn absolute(self) -> Self {
        // By the triangle inequality, |v| differs from |middle| by at most the radius.
        Self { middle: self.middle.abs(), radius: self.radius }
    }
}

#[cfg(test)]
mod tests {
    use kahan_algebra::prime_field::SplitMix64;
    use kahan_core::num_rational::BigRational;

    use super::*;

    fn drawn(random: &mut SplitMix64) -> (Ball, BigRational) {
        let integer = random.next_u64() as i64 >> random.below(60);
        let middle = Dyadic::new(integer, random.below(40) as i64 - 20);
        let radius =
            upper_bound(&Dyadic::new(random.next_u64() >> random.below(64), random.below(30) as i64 - 70));
        let share = Dyadic::new(random.below(257) as i64 - 128, -7);
        let inside = (&middle + &(&share * &radius)).rational().to_big();
        (Ball { middle, radius }, inside)
    }

    fn contains(ball: &Ball, value: &BigRational) -> bool {
        let [middle, radius] = [&ball.middle, &ball.radius].map(|of| of.rational().to_big());
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
        assert!(third.radius.ratio(&third.middle) < 2_f64.powi(-198));
        let rest = third.times(&three, 200).minus(&one, 200);
        assert!(!rest.is_not_zero() && rest.most().near_f64() < 2_f64.powi(-195));
    }
}
