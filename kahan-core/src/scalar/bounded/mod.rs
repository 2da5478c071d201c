//! Values with rigorous error bounds, for the precision levels of a stable step.
//!
//! A formula of + − × ÷ is evaluated in rounded arithmetic. Every computed value v̂ has a magnitude
//! m and a count k of roundings. With the rounding unit u, the exact value v satisfies
//!
//! > |v| ≤ m and |v̂ − v| ≤ γₖ·m, γₖ = (1+u)ᵏ − 1.
//!
//! # Rules
//!
//! The magnitude is the value of the formula with every term made positive. The count depends only
//! on the formula, and is therefore known at compile time. Operands a and b have magnitudes mₐ and
//! m_b and counts kₐ and k_b. The rules are:
//!
//! - v = a ± b: m = mₐ + m_b, k = max(kₐ, k_b) + 1, since |a ± b| ≤ mₐ + m_b and one rounding is
//!   added.
//! - v = a·b: m = mₐ·m_b, k = kₐ + k_b + 1, since (1+γ_kₐ)(1+γ_k_b)(1+u) − 1 = γ_k.
//! - v = a/b: m = (mₐ + |v̂|·m_b)/|b̂|, k = max(kₐ, k_b) + 1, because v̂ − v = [(â − a) − v(b̂ −
//!   b)]/b̂ plus a rounding. If γ_k_b·m_b exceeds |b̂|/64, the divisor may be zero, and the result
//!   is `None`. The result is also `None` if |b̂| is not above the smallest allowed divisor. If
//!   1/|â| is known, as in 2/d or 2/d/d′, m is computed as |v̂|·(mₐ/|â| + m_b/|b̂|). The sum in
//!   parentheses is stored for the next quotient.
//!
//! Wide numbers have an error radius, from which m and k follow.
//!
//! # Slack
//! Magnitudes are rounded at most k times, and errors are computed as k·u·m instead of γₖ·m. The
//! factor [`SLACK`] covers both. A computed m satisfies
//!
//! > |v| ≤ M and |v̂ − v| ≤ γₖ·M, where M = m/(1−u)ᵏ.
//!
//! Let t = k·u be at most 1/25. Then γₖ·M ≤ 17/16·k·u·m, because
//!
//! > γₖ/(1−u)ᵏ/t ≤ (eᵗ − 1)·eᵗ/t = 1 + 3t/2 + 7t²/6 + … ≤ 1.0620 at t = 1/25.
//!
//! The excess of 17/16 over 1.0620 covers the last two roundings of an error. Magnitudes of numbers
//! wider than `f64` are rounded to 53 bits, which adds less than 2⁻²⁰ in total.
//!
//! In quotients v̂ replaces v. With q = â/b̂ and an error of b̂ of at most |b̂|/64, |v| ≤
//! 64/63·(|q| + γ_kₐ·Mₐ/|b̂|), and
//!
//! > |q − v| ≤ (γ_kₐ·Mₐ + |v|·γ_k_b·M_b)/|b̂| ≤ 64/63·γ_max(kₐ, k_b)·(Mₐ + |q|·M_b)/|b̂|.
//!
//! Therefore m is multiplied by the slack once more, which exceeds 64/63 and the roundings of m.
//! In a chain c/d/d′/… of n divisors with relative errors ρᵢ ≤ 1/64, |v/q − 1| ≤ Π 1/(1−ρᵢ) − 1 ≤
//! 1.0625·Σ ρᵢ for n ≤ 6. Steps divide by one determinant per block, at most eight in all. The
//! premises under "Underflow" imply t < 10⁻⁴. Then the slack of errors is unused, and n ≤ 14
//! suffices.
//!
//! # Underflow
//! A product, quotient or literal that underflows has an error of at most η. The error of its
//! magnitude m has the same bound. Let w operations of a formula possibly underflow, all inputs be
//! at most 2ᴸ, and all their products at most 2ᴮ. Then these errors grow to at most w·2ᴮ·η. A sum
//! has the larger w of its two terms, and adds 1 to B, which doubles the bound. A product or
//! quotient has the sum of both w, plus 1. Every error includes the [allowance](number::Range). If
//! w ≤ 2¹⁰ and 2¹⁰·2ᴮ·η is at most the allowance, all underflow is covered. A quotient divides an
//! error at most by the square of the smallest allowed divisor. Dividing a constant by ε multiplies
//! it by at most 2 to the power [`bits_of_steps`](number::Range).
//!
//! The caller compares the inputs with the limit [`Bounded::largest_input`], which is known at
//! compile time. The limit allows no input if operations and constants violate a premise, for
//! example k·u ≤ 1/25. The limit allows every input if the format cannot underflow.

mod formats;
mod known_bounds;
mod limit;
mod number;
mod operators;
#[cfg(target_arch = "x86_64")]
mod packed;
mod pair;
mod rules;

#[cfg(feature = "std")]
pub(crate) use known_bounds::KnownBounds;
pub(crate) use known_bounds::backward_error;
pub(crate) use limit::InputLimit;
use number::MOST_UNDERFLOWS;
pub(crate) use number::{Magnitude, Number, Range, power_of_two};
#[cfg(target_arch = "x86_64")]
pub(crate) use packed::{PackedDouble, PackedSingle};
pub(crate) use pair::{BoundedPair, UnpackedPair};

#[cfg(not(target_arch = "x86_64"))]
pub(crate) type PackedDouble = UnpackedPair<f64>;
#[cfg(not(target_arch = "x86_64"))]
pub(crate) type PackedSingle = UnpackedPair<f32>;

/// A factor in error bounds that covers the rounding of magnitudes, and the difference between
/// (1+u)ᵏ − 1 and k·u for k roundings of unit u. Bounds of quotients contain the factor twice.
pub(crate) const SLACK: f64 = 1.0625;

/// A computed value with a bound of its error, as explained at the top of this file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounded<V: Number, P: BoundedPair<V> = UnpackedPair<V>> {
    pair: P,
    /// The number of roundings.
    roundings: u32,
    /// The number of operations that may underflow; see "Underflow" in the module's head.
    underflows: u32,
    /// The largest number of inputs in a product. Its other factors are together at most 2^`bits`.
    inputs: u32,
    bits: u32,
    /// An approximation of 1/|value|, if the value is a quotient with an integer as numerator.
    inverse: Option<V::Magnitude>,
    /// An approximation of magnitude/|value| without the factor `SLACK`.
    ratio: Option<V::Magnitude>,
}

impl<V: Number, P: BoundedPair<V>> Bounded<V, P> {
    #[inline(always)]
    fn of(pair: P) -> Self {
        Self { pair, roundings: 0, underflows: 0, inputs: 0, bits: 0, inverse: None, ratio: None }
    }

    #[inline(always)]
    pub(crate) fn from_input(value: V) -> Self {
        Self { inputs: 1, ..Self::of(BoundedPair::new(value, value.size())) }
    }

    /// Creates a literal that was rounded `roundings` times; each rounding may have underflowed.
    #[inline(always)]
    pub(crate) fn literal(value: V, roundings: u32) -> Self {
        let bits = ((value.approximate().to_bits() >> 52 & 0x7ff) as u32).saturating_sub(1022);
        let pair = BoundedPair::new(value, value.size());
        Self { roundings, underflows: roundings, bits, ..Self::of(pair) }.tightened()
    }

    #[inline(always)]
    pub(crate) fn largest_input(&self) -> InputLimit {
        let Range { allowance, bits_of_products, .. } = V::RANGE;
        if allowance == 0.0 {
            return InputLimit::ANY;
        }
        let most_roundings = const { (0.04 / V::UNIT) as u32 };
        let is_broken = self.roundings > most_roundings
            || self.underflows > MOST_UNDERFLOWS
            || self.bits > bits_of_products;
        if is_broken {
            return InputLimit::NONE;
        }
        InputLimit::below((bits_of_products - self.bits) / self.inputs.max(1))
    }

    /// Creates a value whose error is unknown. With the maximal `bits`, `largest_input` allows no
    /// input.
    #[inline(always)]
    pub(crate) fn unknown(value: V) -> Self {
        let pair = BoundedPair::new(value, V::Magnitude::of(f64::INFINITY));
        Self { roundings: 1, bits: u32::MAX, ..Self::of(pair) }
    }

    #[inline(always)]
    pub(crate) fn negated(self) -> Self {
        Self { pair: self.pair.negated(), ..self }
    }

    /// Replaces the magnitude by `change(magnitude)`, which must be an equal number.
    #[inline(always)]
    pub(crate) fn with_magnitude(self, change: impl FnOnce(V::Magnitude) -> V::Magnitude) -> Self {
        Self { pair: BoundedPair::new(self.value(), change(self.magnitude())), ..self }
    }

    #[inline(always)]
    pub(crate) fn is_literal(&self) -> bool {
        self.inputs == 0
    }

    /// Returns whether this is an input, not a computed result, and steps may divide by it.
    #[inline(always)]
    pub(crate) fn is_ordinary_input(&self) -> bool {
        let is_input = self.inputs == 1 && self.roundings == 0 && self.bits == 0;
        let (most, size) = (power_of_two(V::RANGE.bits_of_steps as i32), self.value().approximate().abs());
        is_input && V::RANGE.bits_of_steps > 0 && (1.0 / most..=most).contains(&size)
    }

    #[inline(always)]
    pub(crate) fn value(&self) -> V {
        self.pair.value()
    }

    #[inline(always)]
    pub(crate) fn magnitude(&self) -> V::Magnitude {
        self.pair.magnitude()
    }

    #[inline(always)]
    fn gamma(&self) -> V::Magnitude {
        V::Magnitude::of(SLACK * V::UNIT * f64::from(self.roundings))
    }

    #[inline(always)]
    fn gamma_in_units(&self) -> V::Magnitude {
        V::Magnitude::of(SLACK * f64::from(self.roundings))
    }

    /// Returns a bound of the value's error, including the allowance for underflow.
    #[inline(always)]
    pub(crate) fn error(&self) -> V::Magnitude {
        self.magnitude() * self.gamma() + V::Magnitude::of(V::RANGE.allowance)
    }

    /// Returns the weight of this reciprocal r̂, for products with numbers n̂ that have been
    /// rounded `roundings` times. The error of a product n̂·r̂ is at most u times the weight times
    /// the magnitude of n̂, where u is the rounding unit.
    ///
    /// Let n and r be the exact values of n̂ and r̂. The error is (n̂ − n)·r̂ + n·(r̂ − r), plus
    /// one rounding. The weight exceeds |r̂|. Hence no product overflows without its bound.
    #[inline(always)]
    pub(crate) fn weight(&self, roundings: u32) -> V::Magnitude {
        let gamma = Self { roundings: roundings.saturating_add(1), ..*self }.gamma_in_units();
        let own = self.gamma_in_units();
        let allowance = V::Magnitude::of(V::RANGE.allowance / V::UNIT);
        match self.ratio {
            Some(ratio) => {
                self.value().size() * (gamma + ratio * (V::Magnitude::of(SLACK) * own)) + allowance
            }
            None => self.value().size() * gamma + self.magnitude() * own + allowance,
        }
    }

    #[inline(always)]
    pub(crate) fn roundings(&self) -> u32 {
        self.roundings
    }
}

/// Returns the term for underflow in the magnitude of a numerator that has been rounded `roundings`
/// times. This term times the [weight](Bounded::weight) of a reciprocal r̂ is at least |r̂| times
/// the allowance.
#[inline(always)]
pub(crate) fn underflow<V: Number>(roundings: u32) -> f64 {
    V::RANGE.allowance / (V::UNIT * f64::from(roundings.saturating_add(1)))
}
