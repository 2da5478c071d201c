//! The rungs: which values each computes the step in, and the report where none suffices.
//!
//! A rung has left the stack when the next one is called: over wide numbers, and without
//! optimisation over any, a step of many operations needs hundreds of kilobytes.

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
use crate::scalar::bounded::{Both, Bounded};
#[cfg(feature = "std")]
use crate::scalar::{Capacity, Long, Size, level_row};
use crate::step::error::Reason;
use crate::{ExtendScalars, KahanMap, PreparedStep, SingularStep};

use super::attempt::Attempt;
use super::scalars::Promised;

/// ‖x̃ − exact‖∞ ≤ 64 u ‖exact‖∞ is promised; one u is left for the difference between ‖x̃‖∞ and
/// ‖exact‖∞.
pub(super) const PROMISE: f64 = 63.0;

/// The operations up to which values and their magnitudes are computed one after the other: where a
/// step leaves most of a processor's units idle, magnitudes cost no time there, and no value waits
/// for being packed with its own.
const SHORT: u32 = 36;

/// The first rung of a scalar that works for itself.
#[cfg_attr(not(debug_assertions), inline(always))]
#[cfg_attr(debug_assertions, inline(never))]
pub(super) fn in_own_precision<M: ExtendScalars<T, N>, T: Promised, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Option<SVector<T, N>> {
    let attempt = if const { M::Prepared::COST.operations <= SHORT } {
        Attempt::of::<T, Both<T>, M>(map, x, eps, T::clone)
    } else {
        Attempt::of::<T, T::Packed, M>(map, x, eps, T::clone)
    };
    // Not by `filter`, which moves the attempt through memory, and each step of a chain would wait
    // for that.
    match attempt {
        Some(attempt) if attempt.is_within(PROMISE * T::UNIT) => Some(vector(attempt.next)),
        _ => None,
    }
}

/// The first rung of a step that is divided by ε, at an ε that does not allow it: its other form.
///
/// How often each form rounds is known while compiling, as long as no code serves both.
#[cold]
#[inline(never)]
pub(super) fn in_general_form<M: ExtendScalars<T, N>, T: Promised, const N: usize>(
    map: &M,
    x: SVector<T, N>,
    eps: T,
) -> Option<SVector<T, N>> {
    in_own_precision(map, &x, &eps)
}

/// The rung that computes in the next wider scalar and rounds once.
#[cfg_attr(not(debug_assertions), inline(always))]
#[cfg_attr(debug_assertions, inline(never))]
pub(super) fn in_next_wider<M: ExtendScalars<T, N>, T: Promised, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Option<SVector<T, N>> {
    Attempt::of::<T, <T::Wider as Promised>::Packed, M>(map, x, eps, T::embed)
        .and_then(|attempt| attempt.rounded(PROMISE * T::UNIT, T::round, T::embed))
}

/// The second rung, off the stack when it returns.
#[inline(never)]
pub(super) fn second<M: ExtendScalars<T, N>, T: Promised, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Option<SVector<T, N>> {
    in_next_wider(map, x, eps)
}

/// Rungs 3 to 5, and the report where all fail; x̃ goes to `next`.
#[cold]
#[inline(never)]
pub(super) fn in_wide<T: Promised, M: ExtendScalars<T, N>, const N: usize>(
    map: &M,
    x: SVector<T, N>,
    eps: T,
    next: &mut SVector<T, N>,
) -> Result<(), SingularStep> {
    let is_finite = Cell::new(eps.is_finite_number());
    let given = |number: &T| {
        is_finite.set(is_finite.get() && number.is_finite_number());
        Bounded::given(number.widen())
    };
    let last = InWide {
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
        is_known |= attempt.is_within(PROMISE * T::UNIT);
        if let Some(settled) = attempt.rounded(PROMISE * T::UNIT, T::narrow, T::widen) {
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

/// Rung 5: the equation A(x,ε)·(x̃ − x) = 2ε·f(x) itself, solved over numbers of many digits; x̃
/// goes to `next`.
///
/// No formula that was expanded or reduced is in its way, whose terms may be larger than all
/// digits; and it needs of the map no more than A and f.
#[cfg(feature = "std")]
#[inline(never)]
fn by_elimination<T: Promised, M: ExtendScalars<T, N>, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
    next: &mut SVector<T, N>,
) -> Result<(), Reason> {
    let mut tried = Capacity::ALL.into_iter().map(|capacity| eliminated(map, x, eps, next, capacity));
    tried.find_map(|settled| settled).unwrap_or(Err(Reason::Digits(Long::MOST_DIGITS)))
}

/// The same with this capacity; `None` where it leaves the step open.
#[cfg(feature = "std")]
fn eliminated<T: Promised, M: ExtendScalars<T, N>, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
    next: &mut SVector<T, N>,
    capacity: Capacity,
) -> Option<Result<(), Reason>> {
    let long = |number: &T| Long::new(number.widen(), capacity);
    let (map, state, eps) = (map.extend_scalars(long), SVector::from_fn(|i, _| long(&x[i])), long(eps));
    let (mut matrix, mut velocity) = (map.matrix(&state, eps.clone()), map.field_at(&state, &eps));
    for i in 0..N {
        level_row(matrix.row_mut(i).iter_mut(), &mut velocity[i]);
    }
    let increment = increment_by_elimination(matrix, velocity, &eps)?;
    let exact: [Long; N] = from_fn(|i| state[i].clone() + increment[i].clone());
    let rounded: [T; N] = from_fn(|i| T::narrow(exact[i].leading()));
    let largest = |sizes: [Size; N]| {
        let larger = |one: Size, other: Size| if other > one || other.is_unknown() { other } else { one };
        sizes.into_iter().fold(Size::zero(), larger)
    };
    let error = largest(from_fn(|i| (exact[i].clone() - long(&rounded[i])).at_most()));
    let most = Size::from(PROMISE * T::UNIT) * largest(rounded.map(|number| number.widen().size()));
    if rounded.iter().all(T::is_finite_number) && error <= most {
        *next = vector(rounded);
        return Some(Ok(()));
    }
    // What is known and does not round to a step is what the scalar has no range for.
    let is_settled = Long::are_settled(exact.iter().zip(rounded.iter().map(T::is_finite_number)));
    is_settled.then_some(Err(Reason::BeyondRange))
}

/// Without a heap the digits of the last numbers are all that there are.
#[cfg(not(feature = "std"))]
fn by_elimination<T, M, const N: usize>(
    _map: &M,
    _x: &SVector<T, N>,
    _eps: &T,
    _next: &mut SVector<T, N>,
) -> Result<(), Reason> {
    Err(Reason::Digits(Wide::MOST_DIGITS))
}

/// What rungs 3 and 4 compute with. Each of its functions is called: it is the same for every
/// scalar that comes here, and it has left the stack when the next one begins.
struct InWide<M, const N: usize> {
    map: M,
    state: SVector<Bounded<Wide>, N>,
    eps: Bounded<Wide>,
}

impl<M: KahanMap<Bounded<Wide>, N>, const N: usize> InWide<M, N> {
    /// The increment form.
    #[inline(never)]
    fn increments(&self) -> Option<Attempt<Wide, N>> {
        let quotients = self.map.prepare(&self.eps).quotients(&self.state)?;
        Some(Attempt::by_increments(&self.state, quotients))
    }

    /// The form N/D.
    #[inline(never)]
    fn reduced_map(&self) -> Option<Attempt<Wide, N>> {
        Attempt::by_reduced_map(&self.map, &self.state, self.eps)
    }

    /// D of the reduced map, and det A(x,ε).
    #[inline(never)]
    fn denominators(&self) -> [Wide; 2] {
        let Self { map, state, eps } = self;
        [map.reduced_map(state, *eps).1.value(), map.det_matrix(state, *eps).value()]
    }
}

fn is_exactly_zero(number: &Wide) -> bool {
    number.is_zero() && number.radius().is_zero()
}

/// A determinant as a float that is 0 only where the determinant is, and infinite nowhere.
fn rounded(determinant: &Wide) -> f64 {
    match determinant.to_f64() {
        near if near == 0.0 && !is_exactly_zero(determinant) => f64::MIN_POSITIVE,
        near if near.is_infinite() => f64::NAN,
        near => near,
    }
}
