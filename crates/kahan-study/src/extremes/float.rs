//! What is asked of a scalar whose steps are judged: its values as exact numbers, and the limits of
//! its format.

use kahan_core::nalgebra::SVector;
use kahan_core::{Dd, KahanMap, Lift, Pivot, ThroughF64};

use super::dyadic::Dyadic;

/// A float that can be judged.
pub(crate) trait Float: Pivot + Copy + Into<Dd> + Send + Sync {
    /// Its name in tables.
    const NAME: &'static str;
    /// The tier whose `step` it is: `fast`, or `accurate`.
    const STEP_TIER: &'static str;
    /// The tier of the step that is computed in a wider format and rounded once, where there is
    /// one.
    const WIDER_TIER: Option<&'static str> = None;
    /// The unit u of the promise is 2^−PRECISION.
    const PRECISION: i64;
    /// The floats that a number is made of.
    const WORDS: usize = 1;
    /// How many bits are drawn: all that a number can have.
    const BITS: i64;
    /// The binade of the least number that has all of its bits.
    const LEAST_BINADE: i64;
    /// The binade of the largest number.
    const GREATEST_BINADE: i64;
    /// ε is drawn from ±2^±EPS_BINADES, 1e±300 for `f64`.
    const EPS_BINADES: i64;
    /// ‖x‖ is drawn from 2^±STATE_BINADES, 1e±150 for `f64`.
    const STATE_BINADES: i64;
    /// A stable step may not be flagged below this condition number; `None` where nothing is
    /// promised.
    const FLAG_CONDITION: Option<f64>;

    /// The nearest number.
    fn of(value: f64) -> Self;

    /// Its bits, a word for each float that it is made of.
    fn bits(self) -> Vec<u64>;

    /// The number with these bits.
    fn of_bits(bits: &[u64]) -> Self;

    /// The exact value; `None` if it is not finite.
    fn exact(self) -> Option<Dyadic> {
        let wide: Dd = self.into();
        Some(&Dyadic::of(wide.high())? + &Dyadic::of(wide.low())?)
    }

    /// A number near `value`, by about one unit; infinite beyond the range.
    fn near(value: &Dyadic) -> Self {
        Self::of(value.near_f64())
    }

    /// One of the inputs that are no numbers: ∞, −∞, NaN.
    fn not_finite(which: u64) -> Self {
        Self::of([f64::INFINITY, f64::NEG_INFINITY, f64::NAN][(which % 3) as usize])
    }

    /// The step of [`WIDER_TIER`](Self::WIDER_TIER).
    fn wider_step<M, const N: usize>(_map: M, _x: &SVector<Self, N>, _eps: Self) -> Option<SVector<Self, N>>
    where
        M: Lift<Self, N>,
    {
        None
    }
}

impl Float for f64 {
    const NAME: &'static str = "f64";
    const STEP_TIER: &'static str = "fast";
    const PRECISION: i64 = 53;
    const BITS: i64 = 53;
    const LEAST_BINADE: i64 = -1022;
    const GREATEST_BINADE: i64 = 1023;
    const EPS_BINADES: i64 = 996;
    const STATE_BINADES: i64 = 498;
    const FLAG_CONDITION: Option<f64> = Some(1e12);

    fn of(value: f64) -> Self {
        value
    }

    fn bits(self) -> Vec<u64> {
        vec![self.to_bits()]
    }

    fn of_bits(bits: &[u64]) -> Self {
        Self::from_bits(bits[0])
    }
}

impl Float for f32 {
    const NAME: &'static str = "f32";
    const STEP_TIER: &'static str = "fast";
    const WIDER_TIER: Option<&'static str> = Some("fast through f64");
    const PRECISION: i64 = 24;
    const BITS: i64 = 24;
    const LEAST_BINADE: i64 = -126;
    const GREATEST_BINADE: i64 = 127;
    const EPS_BINADES: i64 = 125;
    const STATE_BINADES: i64 = 62;
    const FLAG_CONDITION: Option<f64> = Some(1e4);

    fn of(value: f64) -> Self {
        value as Self
    }

    fn bits(self) -> Vec<u64> {
        vec![self.to_bits().into()]
    }

    fn of_bits(bits: &[u64]) -> Self {
        Self::from_bits(bits[0] as u32)
    }

    fn wider_step<M, const N: usize>(map: M, x: &SVector<Self, N>, eps: Self) -> Option<SVector<Self, N>>
    where
        M: Lift<Self, N>,
    {
        Some(ThroughF64(map).step(x, eps))
    }
}

impl Float for Dd {
    const NAME: &'static str = "dd";
    const STEP_TIER: &'static str = "accurate";
    const WORDS: usize = 2;
    /// That of the promise; an operation is within it.
    const PRECISION: i64 = 102;
    const BITS: i64 = 106;
    /// Below it the low part loses bits.
    const LEAST_BINADE: i64 = -969;
    const GREATEST_BINADE: i64 = 1023;
    const EPS_BINADES: i64 = 996;
    const STATE_BINADES: i64 = 498;
    const FLAG_CONDITION: Option<f64> = None;

    fn of(value: f64) -> Self {
        value.into()
    }

    fn bits(self) -> Vec<u64> {
        vec![self.high().to_bits(), self.low().to_bits()]
    }

    fn of_bits(bits: &[u64]) -> Self {
        Self::new(f64::from_bits(bits[0]), f64::from_bits(bits[1]))
    }

    fn near(value: &Dyadic) -> Self {
        let high = value.near_f64();
        Dyadic::of(high).map_or(Self::from(high), |leading| Self::new(high, (value - &leading).near_f64()))
    }
}
