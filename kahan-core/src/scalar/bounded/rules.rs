//! Arithmetic of bounded values: each result gets a value, a magnitude and a count of roundings.

use num_traits::Zero;

use super::{Bounded, BoundedPair, Magnitude, Number, SLACK};

impl<V: Number, P: BoundedPair<V>> Bounded<V, P> {
    #[inline(always)]
    pub(crate) fn sum(self, other: Self) -> Self {
        self.added(other, self.pair.plus(other.pair))
    }

    #[inline(always)]
    pub(crate) fn difference(self, other: Self) -> Self {
        self.added(other, self.pair.minus(other.pair))
    }

    #[inline(always)]
    pub(crate) fn product(self, other: Self) -> Self {
        self.multiplied(other, self.pair.times(other.pair))
    }

    #[inline(always)]
    pub(crate) fn product_plus(self, other: Self, addend: Self) -> Self {
        let pair = self.pair.multiply_add(other.pair, addend.pair);
        self.multiplied(other, pair).added(addend, pair)
    }

    #[inline(always)]
    fn added(self, other: Self, pair: P) -> Self {
        Self {
            roundings: self.roundings.max(other.roundings).saturating_add(1),
            underflows: self.underflows.max(other.underflows),
            inputs: self.inputs.max(other.inputs),
            bits: self.bits.max(other.bits).saturating_add(1),
            ..Self::of(pair)
        }
        .tightened()
    }

    #[inline(always)]
    fn multiplied(self, other: Self, pair: P) -> Self {
        Self {
            roundings: self.roundings.saturating_add(other.roundings).saturating_add(1),
            underflows: self.underflows.saturating_add(other.underflows).saturating_add(1),
            inputs: self.inputs.saturating_add(other.inputs),
            bits: self.bits.saturating_add(other.bits),
            ..Self::of(pair)
        }
        .tightened()
    }

    /// Tightens the bound of a value v̂ with an error radius r. With the rounding unit u, the new
    /// magnitude is |v̂| + r/u. If r = 0, the value is exact.
    #[inline(always)]
    pub(super) fn tightened(self) -> Self {
        let value = self.value();
        match value.radius() {
            None => self,
            Some(radius) => {
                let magnitude = value.size() + radius / V::Magnitude::of(V::UNIT);
                let roundings = u32::from(!radius.is_zero());
                Self {
                    pair: BoundedPair::new(value, magnitude),
                    roundings,
                    inverse: None,
                    ratio: None,
                    ..self
                }
            }
        }
    }

    /// Returns self/divisor, or `None` unless the divisor is certainly nonzero.
    #[inline(always)]
    pub(crate) fn quotient(self, divisor: Self) -> Option<Self> {
        let value = self.value().quotient(divisor.value())?;
        let size = divisor.value().size();
        let doubt = V::Magnitude::of(64.0) * divisor.gamma() * divisor.magnitude();
        let least = V::Magnitude::of(V::RANGE.least_divisor());
        let is_certain = size > doubt + least;
        if !is_certain {
            return None;
        }
        // If 1/|a| is known, v̂ = a/b̂ gives 1/|b̂| as |v̂|·(1/|a|) without a second division.
        let (magnitude, inverse, ratio) = match self.inverse() {
            Some(inverse) => {
                let ratio = self.ratio.unwrap_or_else(|| V::Magnitude::of(1.0));
                let ratio = ratio + divisor.magnitude() * (value.size() * inverse);
                let magnitude = value.size() * ratio * V::Magnitude::of(SLACK);
                (magnitude, Some(size * inverse), Some(ratio))
            }
            None => {
                let numerator = self.magnitude() + value.size() * divisor.magnitude();
                (numerator * V::Magnitude::of(SLACK) / size, None, None)
            }
        };
        let quotient = Self {
            pair: BoundedPair::new(value, magnitude),
            roundings: self.roundings.max(divisor.roundings).saturating_add(1),
            underflows: self.underflows.saturating_add(divisor.underflows).saturating_add(1),
            inputs: self.inputs.saturating_add(divisor.inputs),
            bits: self.bits.saturating_add(divisor.bits).saturating_add(2 * V::RANGE.bits_of_divisors),
            inverse,
            ratio,
        };
        Some(quotient.tightened())
    }

    /// Returns c/ε for a literal c and an [ordinary input](Self::is_ordinary_input) ε.
    #[inline(always)]
    pub(crate) fn over_input(self, eps: Self) -> Self {
        let value = self.value() / eps.value();
        Self {
            roundings: self.roundings.saturating_add(eps.roundings).saturating_add(1),
            underflows: self.underflows.saturating_add(1),
            inputs: self.inputs,
            bits: self.bits.saturating_add(V::RANGE.bits_of_steps),
            ..Self::of(BoundedPair::new(value, value.size()))
        }
    }

    /// Returns an approximation of 1/|value| if one is known without a division at run time.
    #[inline(always)]
    fn inverse(&self) -> Option<V::Magnitude> {
        let is_whole_constant = self.inputs == 0 && self.roundings == 0;
        if is_whole_constant { Some(V::Magnitude::of(1.0) / self.magnitude()) } else { self.inverse }
    }
}
