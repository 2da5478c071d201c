//! What is asked of a scalar whose steps are judged: its values as exact numbers, and the limits of its format.

use kahan_core::Pivot;

use super::dyadic::Dyadic;

/// A float that can be judged.
pub(crate) trait Float: Pivot + Copy + Send + Sync {
    /// Its name in tables.
    const NAME: &'static str;
    /// The tier whose `step` it is: `fast`, or `accurate`.
    const STEP_TIER: &'static str;
    /// The unit u of the promise is 2^−PRECISION.
    const PRECISION: i64;
    /// The binade of the least number that has all of its bits.
    const LEAST_BINADE: i64;
    /// The binade of the largest number.
    const GREATEST_BINADE: i64;
    /// ε is drawn from ±2^±EPS_BINADES, 1e±300 for `f64`.
    const EPS_BINADES: i64;
    /// ‖x‖ is drawn from 2^±STATE_BINADES, 1e±150 for `f64`.
    const STATE_BINADES: i64;
    /// A stable step may not be flagged below this condition number; `None` where nothing is promised.
    const FLAG_CONDITION: Option<f64>;

    /// The exact value; `None` if it is not finite.
    fn exact(self) -> Option<Dyadic>;

    /// A number near `value`, by about one unit; infinite beyond the range.
    fn near(value: &Dyadic) -> Self;

    /// One of the inputs that are no numbers: ∞, −∞, NaN.
    fn not_finite(which: u64) -> Self;
}

impl Float for f64 {
    const NAME: &'static str = "f64";
    const STEP_TIER: &'static str = "fast";
    const PRECISION: i64 = 53;
    const LEAST_BINADE: i64 = -1022;
    const GREATEST_BINADE: i64 = 1023;
    const EPS_BINADES: i64 = 996;
    const STATE_BINADES: i64 = 498;
    const FLAG_CONDITION: Option<f64> = Some(1e12);

    fn exact(self) -> Option<Dyadic> {
        Dyadic::of(self)
    }

    fn near(value: &Dyadic) -> Self {
        value.near_f64()
    }

    fn not_finite(which: u64) -> Self {
        [Self::INFINITY, Self::NEG_INFINITY, Self::NAN][(which % 3) as usize]
    }
}

impl Float for f32 {
    const NAME: &'static str = "f32";
    const STEP_TIER: &'static str = "fast";
    const PRECISION: i64 = 24;
    const LEAST_BINADE: i64 = -126;
    const GREATEST_BINADE: i64 = 127;
    const EPS_BINADES: i64 = 125;
    const STATE_BINADES: i64 = 62;
    const FLAG_CONDITION: Option<f64> = Some(1e4);

    fn exact(self) -> Option<Dyadic> {
        Dyadic::of(f64::from(self))
    }

    fn near(value: &Dyadic) -> Self {
        value.near_f64() as Self
    }

    fn not_finite(which: u64) -> Self {
        [Self::INFINITY, Self::NEG_INFINITY, Self::NAN][(which % 3) as usize]
    }
}
