//! From rung to rung: which values the step is computed in, and what is said where none suffices.

use core::array::from_fn;
use core::cell::Cell;
use core::iter::once_with;

use nalgebra::SVector;
use num_traits::Zero;

use crate::linear::vector;
use crate::scalar::Wide;
use crate::{Dd, KahanMap, Lift, Pivot, SingularStep};

use super::attempt::Attempt;
use super::bounded::{ALLOWANCE, Bounded, Working, operations};
use super::number::Number;
use super::pair::Both;

/// A scalar that steps can be promised in.
pub(crate) trait Promised: Pivot + Copy {
    /// u: half the distance of 1 from the next larger number, for the machine's floats.
    const UNIT: f64;

    /// The same number.
    fn widen(&self) -> Wide;
    /// The nearest one.
    fn narrow(value: Wide) -> Self;
}

/// ‖x̃ − exact‖∞ ≤ 64 u ‖exact‖∞ is promised; one u is left for the difference between ‖x̃‖∞ and ‖exact‖∞.
const PROMISE: f64 = 63.0;

/// The step with all numbers embedded into V.
#[inline(always)]
fn attempt<T, V, M, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
    embed: impl Fn(&T) -> V,
) -> Option<Attempt<V, N>>
where
    T: Promised,
    V: Working,
    M: Lift<T, N>,
{
    let largest = Cell::new(embed(eps).size());
    let given = |number: &T| {
        let value = embed(number);
        if V::exceeds(value.size(), largest.get()) {
            largest.set(value.size());
        }
        Bounded::given(value)
    };
    let state = SVector::from_fn(|i, _| given(&x[i]));
    let attempt = Attempt::by_increments(&map.lift(given), &state, Bounded::given(embed(eps)))?;
    V::exceeds(attempt.largest_input(), largest.get()).then_some(attempt)
}

/// The step of `f64`.
#[inline]
pub(crate) fn stable_double<M, const N: usize>(
    map: &M,
    x: &SVector<f64, N>,
    eps: &f64,
) -> Result<SVector<f64, N>, SingularStep>
where
    M: Lift<f64, N>,
{
    match attempt(map, x, eps, |number| *number) {
        Some(attempt) if attempt.is_within(PROMISE * <f64 as Promised>::UNIT) => Ok(vector(attempt.next)),
        _ => called(beyond_double, map, x, eps),
    }
}

/// The step of `f32`, computed in `f64` and rounded once.
#[inline]
pub(crate) fn stable_single<M, const N: usize>(
    map: &M,
    x: &SVector<f32, N>,
    eps: &f32,
) -> Result<SVector<f32, N>, SingularStep>
where
    M: Lift<f32, N>,
{
    let embed = |number: &f32| f64::from(*number);
    attempt(map, x, eps, embed)
        .and_then(|attempt| attempt.rounded(PROMISE * f32::UNIT, |value| value as f32, embed))
        .map_or_else(|| called(in_wide, map, x, eps), Ok)
}

/// The step of [`Dd`].
#[inline]
pub(crate) fn stable_double_double<M, const N: usize>(
    map: &M,
    x: &SVector<Dd, N>,
    eps: &Dd,
) -> Result<SVector<Dd, N>, SingularStep>
where
    M: Lift<Dd, N>,
{
    match attempt(map, x, eps, |number| *number) {
        Some(attempt) if attempt.is_within(PROMISE * <Dd as Promised>::UNIT) => Ok(vector(attempt.next)),
        _ => called(in_wide, map, x, eps),
    }
}

/// What a rung that is called says of a step, entry by entry.
///
/// Functions that are called take and give states in memory. What they see here are copies, so that the state of a loop and the
/// result of the first rung, which is inlined, stay in registers: else every step would wait for its way through memory.
#[inline(always)]
fn called<M, T: Copy, const N: usize>(
    rung: impl Fn(&M, SVector<T, N>, T, &mut SVector<T, N>) -> Option<SingularStep>,
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep> {
    let mut next: SVector<T, N> = vector(from_fn(|i| x[i]));
    match rung(map, next, *eps, &mut next) {
        None => Ok(vector(from_fn(|i| next[i]))),
        Some(error) => Err(error),
    }
}

/// The second rung, and those after it; x̃ goes to `next`.
#[cold]
#[inline(never)]
fn beyond_double<M, const N: usize>(
    map: &M,
    x: SVector<f64, N>,
    eps: f64,
    next: &mut SVector<f64, N>,
) -> Option<SingularStep>
where
    M: Lift<f64, N>,
{
    let embed = |number: &f64| Dd::from(*number);
    let settled = attempt(map, &x, &eps, embed)
        .and_then(|attempt| attempt.rounded(PROMISE * <f64 as Promised>::UNIT, f64::from, embed));
    match settled {
        Some(settled) => {
            *next = settled;
            None
        }
        None => in_wide(map, x, eps, next),
    }
}

/// The last two rungs, and the report where both fail; x̃ goes to `next`.
#[cold]
#[inline(never)]
fn in_wide<T, M, const N: usize>(
    map: &M,
    x: SVector<T, N>,
    eps: T,
    next: &mut SVector<T, N>,
) -> Option<SingularStep>
where
    T: Promised,
    M: Lift<T, N>,
{
    let given = |number: &T| Bounded::given(number.widen());
    let lifted = map.lift(given);
    let state = SVector::from_fn(|i, _| given(&x[i]));
    let increments = wide_increments(&lifted, &state, given(&eps));
    let quotients = once_with(|| Attempt::by_quotients(&lifted, &state, given(&eps)));
    let mut bound = f64::INFINITY;
    for attempt in increments.into_iter().chain(quotients.flatten()) {
        bound = attempt.bound().min(bound);
        if let Some(settled) = attempt.rounded(PROMISE * T::UNIT, T::narrow, T::widen) {
            *next = settled;
            return None;
        }
    }
    let determinant = lifted.det_matrix(&state, given(&eps)).value();
    Some(SingularStep::unestablished(report(determinant), bound, eps.approximate()))
}

/// The increment form in [`Wide`]; apart, because it is the same for every scalar that comes here.
#[inline(never)]
fn wide_increments<M, const N: usize>(
    map: &M,
    x: &SVector<Bounded<Wide>, N>,
    eps: Bounded<Wide>,
) -> Option<Attempt<Wide, N>>
where
    M: KahanMap<Bounded<Wide>, N>,
{
    Attempt::by_increments(map, x, eps)
}

/// A determinant as a float that is 0 only where the determinant is, and infinite nowhere.
fn report(determinant: Wide) -> f64 {
    match determinant.to_f64() {
        near if near == 0.0 && !determinant.is_zero() => f64::MIN_POSITIVE,
        near if near.is_infinite() => f64::NAN,
        near => near,
    }
}

impl Number for f64 {
    type Magnitude = f64;
    const UNIT: f64 = f64::EPSILON / 2.0;
    const ALLOWANCE: f64 = ALLOWANCE;

    #[inline(always)]
    fn size(&self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn magnitude(value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn exceeds(one: f64, other: f64) -> bool {
        one > other
    }
}

impl Working for f64 {
    #[cfg(target_arch = "x86_64")]
    type Pair = super::packed::Packed;
    #[cfg(not(target_arch = "x86_64"))]
    type Pair = Both<f64>;

    operations!(inline(always));
}

impl Number for Dd {
    type Magnitude = f64;
    /// 16 u² of `f64`, at least the bound of each of its operations.
    const UNIT: f64 = f64::EPSILON * f64::EPSILON * 4.0;
    const ALLOWANCE: f64 = ALLOWANCE;

    #[inline(always)]
    fn size(&self) -> f64 {
        self.high().abs()
    }

    #[inline(always)]
    fn magnitude(value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn exceeds(one: f64, other: f64) -> bool {
        one > other
    }
}

impl Working for Dd {
    type Pair = Both<Dd>;

    operations!(inline(never));
}

impl Number for Wide {
    type Magnitude = Wide;
    /// Four times that of an operation, so that a constant, made by a division of cut off numbers, is one, too.
    const UNIT: f64 = f64::from_bits(((1023 + Wide::UNIT_EXPONENT + 2) as u64) << 52);
    const ALLOWANCE: f64 = 0.0;

    fn size(&self) -> Wide {
        self.abs()
    }

    fn magnitude(value: f64) -> Wide {
        Wide::from(value)
    }

    fn is_exact(&self) -> bool {
        Wide::is_exact(self)
    }

    fn exceeds(one: Wide, other: Wide) -> bool {
        one.magnitude_exceeds(&other)
    }
}

impl Working for Wide {
    type Pair = Both<Wide>;

    operations!(inline(never));
}

impl Promised for f32 {
    const UNIT: f64 = f32::EPSILON as f64 / 2.0;

    fn widen(&self) -> Wide {
        Wide::from(*self)
    }

    fn narrow(value: Wide) -> Self {
        value.to_f32()
    }
}

impl Promised for f64 {
    const UNIT: f64 = f64::EPSILON / 2.0;

    fn widen(&self) -> Wide {
        Wide::from(*self)
    }

    fn narrow(value: Wide) -> Self {
        value.to_f64()
    }
}

impl Promised for Dd {
    /// That of its operations' bounds.
    const UNIT: f64 = <Self as Number>::UNIT;

    fn widen(&self) -> Wide {
        Wide::from_double_double(self.high(), self.low())
    }

    fn narrow(value: Wide) -> Self {
        let (high, low) = value.to_double_double();
        Dd::new(high, low)
    }
}
