//! The precision levels, and the report if all levels fail.
//!
//! Each level returns before the next level is called, because wide numbers may need much stack.

#[cfg(feature = "std")]
use core::array::from_fn;
use core::cell::Cell;
use core::iter::once_with;

use nalgebra::SVector;
use num_traits::Zero;

#[cfg(feature = "std")]
use crate::field::linear::increment_by_elimination;
use crate::field::linear::vector;
use crate::scalar::Wide;
use crate::scalar::bounded::{Bounded, UnpackedPair};
#[cfg(feature = "std")]
use crate::scalar::{Capacity, LongNumber, Size, equilibrate_row};
use crate::step::error::Reason;
use crate::{ExtendScalars, KahanMap, PreparedStep, SingularStep};

use super::bounded_step::BoundedStep;
use super::scalars::PromiseScalar;

/// The bound that a step must satisfy, as a multiple of the rounding unit u. The promised bound is
/// one u larger, to cover the difference between ‖x̃‖∞ and ‖exact‖∞.
pub(super) const ERROR_BOUND: f64 = 63.0;

/// Steps of up to this number of operations keep each value and its error magnitude in separate
/// registers. Packing a pair into one register would delay the values of such a short step.
const SHORT_STEP_OPERATIONS: u32 = 36;

#[cfg_attr(not(debug_assertions), inline(always))]
#[cfg_attr(debug_assertions, inline(never))]
pub(super) fn in_own_precision<M: ExtendScalars<T, N>, T: PromiseScalar, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Option<SVector<T, N>> {
    let attempt = if const { M::Prepared::COST.operations <= SHORT_STEP_OPERATIONS } {
        BoundedStep::of::<T, UnpackedPair<T>, M>(map, x, eps, T::clone)
    } else {
        BoundedStep::of::<T, T::Packed, M>(map, x, eps, T::clone)
    };
    // Avoids `filter`, which would move the attempt through memory and delay each step.
    match attempt {
        Some(attempt) if attempt.is_within(ERROR_BOUND * T::UNIT) => Some(vector(attempt.next)),
        _ => None,
    }
}

/// Runs precision level 1 without divisions by ε, because ε is too small or too large for them.
#[cold]
#[inline(never)]
pub(super) fn in_general_form<M: ExtendScalars<T, N>, T: PromiseScalar, const N: usize>(
    map: &M,
    x: SVector<T, N>,
    eps: T,
) -> Option<SVector<T, N>> {
    in_own_precision(map, &x, &eps)
}

#[cfg_attr(not(debug_assertions), inline(always))]
#[cfg_attr(debug_assertions, inline(never))]
pub(super) fn in_next_wider<M: ExtendScalars<T, N>, T: PromiseScalar, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Option<SVector<T, N>> {
    BoundedStep::of::<T, <T::Wider as PromiseScalar>::Packed, M>(map, x, eps, T::embed)
        .and_then(|attempt| attempt.rounded(ERROR_BOUND * T::UNIT, T::round, T::embed))
}

#[inline(never)]
pub(super) fn second_precision<M: ExtendScalars<T, N>, T: PromiseScalar, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Option<SVector<T, N>> {
    in_next_wider(map, x, eps)
}

/// Runs the precision levels 3 to 5, and writes x̃ to `next`. If all levels fail, returns the
/// reason.
#[cold]
#[inline(never)]
pub(super) fn wide_precisions<T: PromiseScalar, M: ExtendScalars<T, N>, const N: usize>(
    map: &M,
    x: SVector<T, N>,
    eps: T,
    next: &mut SVector<T, N>,
) -> Result<(), SingularStep> {
    let is_finite = Cell::new(eps.is_finite_number());
    let given = |number: &T| {
        is_finite.set(is_finite.get() && number.is_finite_number());
        Bounded::from_input(number.widen())
    };
    let last = WideInputs {
        map: map.extend_scalars(given),
        state: SVector::from_fn(|i, _| given(&x[i])),
        eps: given(&eps),
    };
    let report = |reason, determinant, bound| {
        Err(SingularStep::because(reason, determinant, bound, eps.approximate()))
    };
    if !is_finite.get() {
        return report(Reason::NotFinite, f64::NAN, f64::INFINITY);
    }
    let (mut bound, mut is_known) = (f64::INFINITY, false);
    for attempt in last.increments().into_iter().chain(once_with(|| last.reduced_map()).flatten()) {
        bound = attempt.bound().min(bound);
        is_known |= attempt.is_within(ERROR_BOUND * T::UNIT);
        if let Some(settled) = attempt.rounded(ERROR_BOUND * T::UNIT, T::narrow, T::widen) {
            *next = settled;
            return Ok(());
        }
    }
    let [denominator, determinant] = last.denominators();
    let reason = if is_known {
        Reason::BeyondRange
    } else if !determinant.is_defined() {
        Reason::NoField
    } else if is_exactly_zero(&denominator) {
        Reason::Pole
    } else if let Err(reason) = by_elimination(map, &x, &eps, next) {
        reason
    } else {
        return Ok(());
    };
    report(reason, rounded(&determinant), bound)
}

/// Runs precision level 5: solves A(x,ε)·(x̃ − x) = 2ε·f(x) over long numbers and writes x̃ to
/// `next`. The other levels fail if terms of their expanded formulas differ by more digits than
/// their numbers have.
#[cfg(feature = "std")]
#[inline(never)]
fn by_elimination<T: PromiseScalar, M: ExtendScalars<T, N>, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
    next: &mut SVector<T, N>,
) -> Result<(), Reason> {
    let mut tried = Capacity::ALL.into_iter().map(|capacity| eliminated(map, x, eps, next, capacity));
    tried.find_map(|settled| settled).unwrap_or(Err(Reason::Digits(LongNumber::MOST_DIGITS)))
}

/// Eliminates with long numbers of this capacity. Returns `None` if the digits are too few.
#[cfg(feature = "std")]
fn eliminated<T: PromiseScalar, M: ExtendScalars<T, N>, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
    next: &mut SVector<T, N>,
    capacity: Capacity,
) -> Option<Result<(), Reason>> {
    let long = |number: &T| LongNumber::new(number.widen(), capacity);
    let (map, state, eps) = (map.extend_scalars(long), SVector::from_fn(|i, _| long(&x[i])), long(eps));
    let (mut matrix, mut velocity) = (map.matrix(&state, eps.clone()), map.field_at(&state, &eps));
    for i in 0..N {
        equilibrate_row(matrix.row_mut(i).iter_mut(), &mut velocity[i]);
    }
    let increment = increment_by_elimination(matrix, velocity, &eps)?;
    let exact: [LongNumber; N] = from_fn(|i| state[i].clone() + increment[i].clone());
    let rounded: [T; N] = from_fn(|i| T::narrow(exact[i].leading()));
    let largest = |sizes: [Size; N]| {
        let larger = |one: Size, other: Size| if other > one || other.is_unknown() { other } else { one };
        sizes.into_iter().fold(Size::zero(), larger)
    };
    let error = largest(from_fn(|i| (exact[i].clone() - long(&rounded[i])).at_most()));
    let most = Size::from(ERROR_BOUND * T::UNIT) * largest(rounded.map(|number| number.widen().size()));
    if rounded.iter().all(T::is_finite_number) && error <= most {
        *next = vector(rounded);
        return Some(Ok(()));
    }
    // If a known component overflows T, more digits do not help.
    let is_settled = LongNumber::are_settled(exact.iter().zip(rounded.iter().map(T::is_finite_number)));
    is_settled.then_some(Err(Reason::BeyondRange))
}

/// Fails, because long numbers need a heap, which `std` provides.
#[cfg(not(feature = "std"))]
fn by_elimination<T, M, const N: usize>(
    _map: &M,
    _x: &SVector<T, N>,
    _eps: &T,
    _next: &mut SVector<T, N>,
) -> Result<(), Reason> {
    Err(Reason::Digits(Wide::MOST_DIGITS))
}

/// The inputs of the precision levels 3 and 4. The methods are not inlined, so that each frees its
/// stack.
struct WideInputs<M, const N: usize> {
    map: M,
    state: SVector<Bounded<Wide>, N>,
    eps: Bounded<Wide>,
}

impl<M: KahanMap<Bounded<Wide>, N>, const N: usize> WideInputs<M, N> {
    #[inline(never)]
    fn increments(&self) -> Option<BoundedStep<Wide, N>> {
        let quotients = self.map.prepare(&self.eps).quotients(&self.state)?;
        Some(BoundedStep::by_increments(&self.state, quotients))
    }

    #[inline(never)]
    fn reduced_map(&self) -> Option<BoundedStep<Wide, N>> {
        BoundedStep::by_reduced_map(&self.map, &self.state, self.eps)
    }

    #[inline(never)]
    fn denominators(&self) -> [Wide; 2] {
        let Self { map, state, eps } = self;
        [map.reduced_map(state, *eps).1.value(), map.det_matrix(state, *eps).value()]
    }
}

fn is_exactly_zero(number: &Wide) -> bool {
    number.is_zero() && number.radius().is_zero()
}

/// Rounds a determinant to a float. The result is 0 only for an exact zero, and NaN for an
/// overflow.
fn rounded(determinant: &Wide) -> f64 {
    match determinant.to_f64() {
        near if near == 0.0 && !is_exactly_zero(determinant) => f64::MIN_POSITIVE,
        near if near.is_infinite() => f64::NAN,
        near => near,
    }
}
