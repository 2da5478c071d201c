//! The scalars whose steps are tested, with their exact values and the limits of their formats.

use kahan_core::nalgebra::SVector;
use kahan_core::{Dd, ExtendScalars, KahanMap, Pivot, ThroughF64};

use super::dyadic::Dyadic;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Format {
    /// The number p of bits of precision. Error bounds are multiples of u = 2^−p.
    pub(crate) precision: i64,
    /// The least e such that all finite numbers of absolute value at least 2^e have full precision.
    pub(crate) least_binade: i64,
    /// The exponent e such that all finite numbers are below 2^(e+1).
    pub(crate) greatest_binade: i64,
}

pub(crate) trait Float: Pivot + Copy + Into<Dd> + Send + Sync {
    const NAME: &'static str;
    /// The name that tables give to the method `step`: `fast` or `accurate`.
    const STEP_TIER: &'static str;
    /// The name of the method, if any, that computes the step in a wider format and rounds it once.
    const WIDER_TIER: Option<&'static str> = None;
    const FORMAT: Format;
    /// The greatest number of bits in the significand of a random number.
    const BITS: i64;
    /// Random |ε| lie between 2^−EPS_BINADES and 2^EPS_BINADES.
    const EPS_BINADES: i64;
    /// Random ‖x‖ lie between 2^−STATE_BINADES and 2^STATE_BINADES.
    const STATE_BINADES: i64;
    /// A step whose condition number is below this must be accepted by `try_step`. `None` means
    /// that `try_step` may refuse any step.
    const FLAG_CONDITION: Option<f64>;

    fn of(value: f64) -> Self;

    fn exact(self) -> Option<Dyadic> {
        let wide: Dd = self.into();
        Some(&Dyadic::of(wide.high())? + &Dyadic::of(wide.low())?)
    }

    /// Rounds `value` to within about one unit in the last place. Large values become infinite.
    fn near(value: &Dyadic) -> Self {
        Self::of(value.near_f64())
    }

    /// Returns ∞, −∞ or NaN, chosen by `which` modulo 3.
    fn not_finite(which: u64) -> Self {
        Self::of([f64::INFINITY, f64::NEG_INFINITY, f64::NAN][(which % 3) as usize])
    }

    /// Makes the step named by [`WIDER_TIER`](Self::WIDER_TIER), if the scalar type has one.
    fn wider_step<M, const N: usize>(_map: M, _x: &SVector<Self, N>, _eps: Self) -> Option<SVector<Self, N>>
    where
        M: ExtendScalars<Self, N>,
    {
        None
    }
}

impl Float for f64 {
    const NAME: &'static str = "f64";
    const STEP_TIER: &'static str = "fast";
    const FORMAT: Format = Format { precision: 53, least_binade: -1022, greatest_binade: 1023 };
    const BITS: i64 = 53;
    const EPS_BINADES: i64 = 996;
    const STATE_BINADES: i64 = 498;
    const FLAG_CONDITION: Option<f64> = Some(1e12);

    fn of(value: f64) -> Self {
        value
    }
}

impl Float for f32 {
    const NAME: &'static str = "f32";
    const STEP_TIER: &'static str = "fast";
    const WIDER_TIER: Option<&'static str> = Some("fast through f64");
    const FORMAT: Format = Format { precision: 24, least_binade: -126, greatest_binade: 127 };
    const BITS: i64 = 24;
    const EPS_BINADES: i64 = 125;
    const STATE_BINADES: i64 = 62;
    const FLAG_CONDITION: Option<f64> = Some(1e4);

    fn of(value: f64) -> Self {
        value as Self
    }

    fn wider_step<M, const N: usize>(map: M, x: &SVector<Self, N>, eps: Self) -> Option<SVector<Self, N>>
    where
        M: ExtendScalars<Self, N>,
    {
        Some(ThroughF64(map).step(x, eps))
    }
}

impl Float for Dd {
    const NAME: &'static str = "dd";
    const STEP_TIER: &'static str = "accurate";
    /// The format of `Dd`. Below 2^−969, the low part of a number loses bits.
    const FORMAT: Format = Format { precision: 102, least_binade: -969, greatest_binade: 1023 };
    const BITS: i64 = 106;
    const EPS_BINADES: i64 = 996;
    const STATE_BINADES: i64 = 498;
    const FLAG_CONDITION: Option<f64> = None;

    fn of(value: f64) -> Self {
        value.into()
    }

    fn near(value: &Dyadic) -> Self {
        let high = value.near_f64();
        Dyadic::of(high).map_or(Self::from(high), |leading| Self::new(high, (value - &leading).near_f64()))
    }
}
