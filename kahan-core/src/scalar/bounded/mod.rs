//! A value with a bound on its error: what the rungs of a step that promises compute with.
//!
//! In: numbers that are exact. Out: for every value v̂ that a formula of + − × ÷ gives in rounded
//! arithmetic, a magnitude m and a count k such that the exact v satisfies |v| ≤ m and |v̂ − v| ≤
//! γₖ·m, γₖ = (1+u)ᵏ − 1.
//!
//! m is the formula with every term made positive: as many operations again, which share registers
//! with those of the values; k depends on the formula alone, so compilers compute it. Each rule
//! below keeps both inequalities:
//!
//! - v = a ± b: m = mₐ + m_b, k = max(kₐ, k_b) + 1, since |a ± b| ≤ mₐ + m_b and one rounding is
//!   added.
//! - v = a·b: m = mₐ·m_b, k = kₐ + k_b + 1, since (1+γ_kₐ)(1+γ_k_b)(1+u) − 1 = γ_k.
//! - v = a/b: m = (mₐ + |v̂|·m_b)/|b̂|, k = max(kₐ, k_b) + 1, because v̂ − v = [(â − a) − v(b̂ −
//!   b)]/b̂ plus a rounding. Where γ_k_b·m_b exceeds |b̂|/64, the divisor may be zero, and there is
//!   no quotient. Where 1/|â| is at hand, as for a reciprocal 2/d or 2/d/d′, the same m is
//!   |v̂|·(mₐ/|â| + m_b/|b̂|), and what is in parentheses is kept as a sum.
//!
//! Magnitudes are rounded themselves, v̂ stands for v where they are made, and γₖ is taken as k·u;
//! [`SLACK`] pays for all three as long as k·u is at most 1/10. A number of the last rungs knows
//! how far it may be off, and m and k follow from that.
//!
//! # Underflow
//! An operation that underflows is off by η at most, and m with it. With all inputs at most 2ᴸ in
//! size and all products of them at most 2ᴮ, such errors grow to no more than w·2ᴮ·η: a sum takes
//! the larger w of its terms, its bit of B pays for the other, and a product adds 1 to those of its
//! factors, so that 2¹⁰ is generous. As long as that is below the [allowance](number::Range), which
//! every error contains, none is overlooked: [`Bounded::largest_input`] is the L that this leaves,
//! and whoever makes the values compares. Quotients count as if every divisor were the least, which
//! is checked, and errors are divided by it twice. What a step divides by ε is a constant that is
//! at most 2 to the power [`bits_of_steps`](number::Range) times as large.

mod formats;
mod number;
mod operators;
#[cfg(target_arch = "x86_64")]
mod packed;
mod pair;
mod rules;
mod working;

#[cfg(all(test, feature = "exact"))]
pub(crate) use number::Range;
pub(crate) use number::{Magnitude, Number, power_of_two};
#[cfg(target_arch = "x86_64")]
pub(crate) use packed::{PackedDouble, PackedSingle};
pub(crate) use pair::{Both, Pair};
pub(crate) use working::{Working, operations};

/// A double and its magnitude, where no register holds the two.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) type PackedDouble = Both<f64>;
/// A float and its magnitude, where no register holds the two.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) type PackedSingle = Both<f32>;

/// What magnitudes are multiplied by before they are believed: they are rounded, quotients are made
/// of rounded values, and (1+u)ᵏ − 1 is more than k·u. Quotients have it twice, which is once more
/// than they need.
pub(crate) const SLACK: f64 = 1.0625;

/// A value v̂ with |v̂ − v| ≤ γₖ·m, and how both are held.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounded<V: Working, P: Pair<V> = Both<V>> {
    /// v̂ and m
    pair: P,
    /// k
    roundings: u32,
    /// How many inputs are multiplied in a term, and how many bits all else adds to its size.
    inputs: u32,
    bits: u32,
    /// About 1/|v̂| of a quotient of such values, the first of which is a whole constant; compilers
    /// know whether it is there.
    inverse: Option<V::Magnitude>,
    /// And about m/|v̂|, without the slack. Both apart, so that compilers do not fetch them from
    /// memory as one vector.
    ratio: Option<V::Magnitude>,
}

impl<V: Working, P: Pair<V>> Bounded<V, P> {
    /// An input: a number that is what it says.
    #[inline(always)]
    pub(crate) fn given(value: V) -> Self {
        Self {
            pair: Pair::new(value, value.size()),
            roundings: 0,
            inputs: 1,
            bits: 0,
            inverse: None,
            ratio: None,
        }
    }

    /// A literal, known while compiling.
    #[inline(always)]
    pub(crate) fn literal(value: V, roundings: u32) -> Self {
        // The exponent of the next power of two.
        let bits = ((value.approximate().to_bits() >> 52 & 0x7ff) as u32).saturating_sub(1022);
        Self { pair: Pair::new(value, value.size()), roundings, inputs: 0, bits, inverse: None, ratio: None }
            .settled()
    }

    /// The binary exponent that no input may exceed, so that underflow is allowed for.
    #[inline(always)]
    pub(crate) fn largest_input(&self) -> u32 {
        V::RANGE.bits_of_products.saturating_sub(self.bits) / self.inputs.max(1)
    }

    /// A value of which nothing is known.
    #[inline(always)]
    pub(crate) fn unknown(value: V) -> Self {
        let pair = Pair::new(value, V::Magnitude::of(f64::INFINITY));
        Self { pair, roundings: 1, inputs: 0, bits: 0, inverse: None, ratio: None }
    }

    /// −v̂
    #[inline(always)]
    pub(crate) fn negated(self) -> Self {
        Self { pair: self.pair.negated(), ..self }
    }

    /// The same, m changed by what changes no number.
    #[inline(always)]
    pub(crate) fn with_magnitude(self, change: impl FnOnce(V::Magnitude) -> V::Magnitude) -> Self {
        Self { pair: Pair::new(self.value(), change(self.magnitude())), ..self }
    }

    /// Whether this is a constant of the formula.
    #[inline(always)]
    pub(crate) fn is_literal(&self) -> bool {
        self.inputs == 0
    }

    /// Whether this is an input as it was given, and of a size that steps may be divided by.
    #[inline(always)]
    pub(crate) fn is_ordinary_input(&self) -> bool {
        let is_input = self.inputs == 1 && self.roundings == 0 && self.bits == 0;
        let (most, size) = (power_of_two(V::RANGE.bits_of_steps as i32), self.value().approximate().abs());
        is_input && V::RANGE.bits_of_steps > 0 && (1.0 / most..=most).contains(&size)
    }

    /// v̂
    #[inline(always)]
    pub(crate) fn value(&self) -> V {
        self.pair.value()
    }

    /// m
    #[inline(always)]
    pub(crate) fn magnitude(&self) -> V::Magnitude {
        self.pair.magnitude()
    }

    /// γₖ
    #[inline(always)]
    fn gamma(&self) -> V::Magnitude {
        V::Magnitude::of(SLACK * V::UNIT * f64::from(self.roundings))
    }

    /// γₖ·m, and the allowance.
    #[inline(always)]
    pub(crate) fn error(&self) -> V::Magnitude {
        self.magnitude() * self.gamma() + V::Magnitude::of(V::RANGE.allowance)
    }

    /// w, with which the error of a product n̂·r̂ with this reciprocal r̂ is at most w times the
    /// magnitude of n̂, which took `roundings`; the one of the product included.
    ///
    /// n̂r̂ − nr = (n̂ − n)·r̂ + n·(r̂ − r). Where one reciprocal serves all numerators, there is
    /// one weight, if all are given the roundings of the worst.
    #[inline(always)]
    pub(crate) fn weight(&self, roundings: u32) -> V::Magnitude {
        let gamma = Self { roundings: roundings.saturating_add(1), ..*self }.gamma();
        match self.ratio {
            Some(ratio) => {
                let slack = V::Magnitude::of(SLACK) * self.gamma();
                self.value().size() * (gamma + ratio * slack) + V::Magnitude::of(V::RANGE.allowance)
            }
            None => self.value().size() * gamma + self.error(),
        }
    }

    /// k
    #[inline(always)]
    pub(crate) fn roundings(&self) -> u32 {
        self.roundings
    }
}

/// What underflowed in a numerator that took `roundings`, as a magnitude: times a
/// [weight](Bounded::weight), which is at least the slack times γ times |r̂|, it is the allowance
/// times |r̂|, at least.
#[inline(always)]
pub(crate) fn underflow<V: Working>(roundings: u32) -> f64 {
    V::RANGE.allowance / (V::UNIT * f64::from(roundings.saturating_add(1)))
}
