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
//! A number of the last rungs knows how far it may be off, and m and k follow from that.
//!
//! # Slack
//! Magnitudes are rounded themselves, k times at most, and errors are computed as k·u·m, not as
//! γₖ·m. [`SLACK`] pays for both: what holds of a computed m is
//!
//! > |v| ≤ M and |v̂ − v| ≤ γₖ·M, where M = m/(1−u)ᵏ,
//!
//! and γₖ·M ≤ 17/16·k·u·m as long as t = k·u is at most 1/25, since
//!
//! > γₖ/(1−u)ᵏ/t ≤ (eᵗ − 1)·eᵗ/t = 1 + 3t/2 + 7t²/6 + … ≤ 1.0620 at t = 1/25;
//!
//! what is left, up to 1.0625, pays for the last two roundings of an error. (At t = 1/24 it is
//! 1.0646, more than the slack.) Sums and products keep the inequalities of M by the rules above,
//! as m takes a rounding wherever k grows. Magnitudes of numbers wider than `f64` are rounded to 53
//! bits, of which all that a `u32` can count is less than 2⁻²⁰.
//!
//! In quotients v̂ stands for v, too. Let q = â/b̂. The doubt in b̂ is at most |b̂|/64, so |v| ≤
//! 64/63·(|q| + γ_kₐ·Mₐ/|b̂|), and
//!
//! > |q − v| ≤ (γ_kₐ·Mₐ + |v|·γ_k_b·M_b)/|b̂| ≤ 64/63·γ_max(kₐ, k_b)·(Mₐ + |q|·M_b)/|b̂|.
//!
//! So m is multiplied by the slack once more, which exceeds 64/63 and the roundings of m, and
//! |v̂|/m ≤ (1 + γ_kₐ)/1.0625 < 1 for kₐ·u ≤ 1/25, so the quotient's own rounding is paid for. In a
//! chain c/d/d′/… of n divisors off by ρᵢ ≤ 1/64 each, |v/q − 1| ≤ Π 1/(1−ρᵢ) − 1 ≤ 1.0625·Σ ρᵢ for
//! n ≤ 6. Steps divide by one determinant a block, by eight at most. With the premises below a
//! rounding adds 1 to w or to the bits of B, so t < 10⁻⁴; then the slack of errors is left, too,
//! and n ≤ 14 will do.
//!
//! # Underflow
//! A product, a quotient or a literal that underflows is off by η at most, and m with it. With all
//! inputs at most 2ᴸ in size and all products of them at most 2ᴮ, such errors grow to no more than
//! w·2ᴮ·η: a sum takes the larger w of its terms, and its bit of B pays for the other; a product
//! and a quotient add 1 to those of both operands. As long as w is at most 2¹⁰ and 2¹⁰·2ᴮ·η is
//! below the [allowance](number::Range), which every error contains, none is overlooked.
//! Quotients count as if every divisor were the least, which is checked, and errors are divided by
//! it twice. What a step divides by ε is a constant that is at most 2 to the power
//! [`bits_of_steps`](number::Range) times as large.
//!
//! All of that is known while compiling, but for the inputs: [`Bounded::largest_input`] is what
//! they may be, and whoever makes the values compares. Where operations and constants alone break
//! a premise (k·u ≤ 1/25 among them), no input is small enough; where nothing underflows, any is.

mod formats;
mod known;
mod limit;
mod number;
mod operators;
#[cfg(target_arch = "x86_64")]
mod packed;
mod pair;
mod rules;

#[cfg(feature = "std")]
pub(crate) use known::Known;
pub(crate) use known::backward_error;
pub(crate) use limit::Limit;
use number::MOST_UNDERFLOWS;
pub(crate) use number::{Magnitude, Number, Range, power_of_two};
#[cfg(target_arch = "x86_64")]
pub(crate) use packed::{PackedDouble, PackedSingle};
pub(crate) use pair::{Both, Pair};

/// A double and its magnitude, where no register holds the two.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) type PackedDouble = Both<f64>;
/// A float and its magnitude, where no register holds the two.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) type PackedSingle = Both<f32>;

/// What magnitudes are multiplied by before they are believed: they are rounded, and (1+u)ᵏ − 1 is
/// more than k·u. Quotients are multiplied by it once more, as they are made of rounded values.
pub(crate) const SLACK: f64 = 1.0625;

/// A value v̂ with |v̂ − v| ≤ γₖ·m, and how both are held.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounded<V: Number, P: Pair<V> = Both<V>> {
    /// v̂ and m
    pair: P,
    /// k
    roundings: u32,
    /// w
    underflows: u32,
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

impl<V: Number, P: Pair<V>> Bounded<V, P> {
    /// A value and its magnitude, without an operation so far.
    #[inline(always)]
    fn of(pair: P) -> Self {
        Self { pair, roundings: 0, underflows: 0, inputs: 0, bits: 0, inverse: None, ratio: None }
    }

    /// An input: a number that is what it says.
    #[inline(always)]
    pub(crate) fn given(value: V) -> Self {
        Self { inputs: 1, ..Self::of(Pair::new(value, value.size())) }
    }

    /// A literal, known while compiling; one that is rounded may underflow.
    #[inline(always)]
    pub(crate) fn literal(value: V, roundings: u32) -> Self {
        // The exponent of the next power of two.
        let bits = ((value.approximate().to_bits() >> 52 & 0x7ff) as u32).saturating_sub(1022);
        let pair = Pair::new(value, value.size());
        Self { roundings, underflows: roundings, bits, ..Self::of(pair) }.settled()
    }

    /// How large inputs may be: the L of all premises.
    #[inline(always)]
    pub(crate) fn largest_input(&self) -> Limit {
        let Range { allowance, bits_of_products, .. } = V::RANGE;
        if allowance == 0.0 {
            return Limit::ANY;
        }
        let most_roundings = const { (0.04 / V::UNIT) as u32 };
        let is_broken = self.roundings > most_roundings
            || self.underflows > MOST_UNDERFLOWS
            || self.bits > bits_of_products;
        if is_broken {
            return Limit::NONE;
        }
        Limit::below((bits_of_products - self.bits) / self.inputs.max(1))
    }

    /// A value of which nothing is known. No input is small enough for what is made of it: a
    /// magnitude alone would not do, as infinity times zero is not a number and compares with none.
    #[inline(always)]
    pub(crate) fn unknown(value: V) -> Self {
        let pair = Pair::new(value, V::Magnitude::of(f64::INFINITY));
        Self { roundings: 1, bits: u32::MAX, ..Self::of(pair) }
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

    /// γₖ in units u.
    #[inline(always)]
    fn gamma_in_units(&self) -> V::Magnitude {
        V::Magnitude::of(SLACK * f64::from(self.roundings))
    }

    /// γₖ·m, and the allowance.
    #[inline(always)]
    pub(crate) fn error(&self) -> V::Magnitude {
        self.magnitude() * self.gamma() + V::Magnitude::of(V::RANGE.allowance)
    }

    /// The weight of this reciprocal r̂: the error of a product n̂·r̂ is at most so many units u
    /// times the magnitude of n̂, which took `roundings`; the one of the product included.
    ///
    /// n̂r̂ − nr = (n̂ − n)·r̂ + n·(r̂ − r). Where one reciprocal serves all numerators, there is
    /// one weight, if all are given the roundings of the worst. It is more than |r̂|, so that a
    /// bound made of it overflows where the product does.
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

    /// k
    #[inline(always)]
    pub(crate) fn roundings(&self) -> u32 {
        self.roundings
    }
}

/// What underflowed in a numerator that took `roundings`, as a magnitude: times a
/// [weight](Bounded::weight) in units u, which is at least the slack times k times |r̂|, it is the
/// allowance times |r̂|, at least.
#[inline(always)]
pub(crate) fn underflow<V: Number>(roundings: u32) -> f64 {
    V::RANGE.allowance / (V::UNIT * f64::from(roundings.saturating_add(1)))
}
