//! Tangent vectors propagated along an orbit, and the observers that need only these vectors.

use core::array::from_fn;

#[cfg(feature = "std")]
use crate::EnsembleScalar;
#[cfg(feature = "std")]
use crate::ensemble::columns::GROUP;
use crate::{Constant, FloatScalar, Scalar, StateVector};

#[cfg(feature = "std")]
use super::burst::{BURST_STEPS, Burst, Grouped, Observers, SideBySide};
use super::growth::{Size, scale};
use super::{Observer, TangentMap};

/// K tangent vectors that are propagated along an orbit of a map.
#[derive(Clone, Debug)]
pub struct Carried<M: TangentMap, const K: usize> {
    map: M,
    place: M::State,
    vectors: [M::State; K],
    /// The binary exponents: tangent vector k is `vectors[k]`·2^`exponents[k]`.
    exponents: [i64; K],
    steps: u64,
}

impl<M: TangentMap, const K: usize> Carried<M, K> {
    /// Starts with arbitrary vectors, which avoid the axes and other special directions.
    pub(super) fn new(map: M) -> Self {
        let vectors = from_fn(|k| state_from_entries(&map, |i| any_direction(k, i)));
        Self { place: M::State::zeros(map.dimension()), vectors, exponents: [0; K], steps: 0, map }
    }

    #[inline(always)]
    fn follow(&mut self, step: u64, x: &[M::Scalar]) {
        if step > 0 {
            carry_all(&self.map, self.place.as_slice(), x, &mut self.vectors);
        }
        self.place.as_mut_slice().copy_from_slice(x);
        self.steps = step;
    }

    /// Scales the vectors to lengths far from the limits of the floats. Returns their squared
    /// lengths before scaling.
    #[inline(always)]
    pub(super) fn scale(&mut self) -> [Size; K] {
        from_fn(|k| scale(&mut self.vectors[k], &mut self.exponents[k]))
    }

    pub(super) fn steps(&self) -> u64 {
        self.steps
    }

    pub(super) fn vectors(&self) -> [&[M::Scalar]; K] {
        self.vectors.each_ref().map(M::State::as_slice)
    }

    pub(super) fn time_step(&self) -> f64 {
        2.0 * self.map.eps().approximate()
    }
}

pub(super) fn state_from_entries<M: TangentMap>(map: &M, entry: impl Fn(usize) -> M::Scalar) -> M::State {
    let mut vector = M::State::zeros(map.dimension());
    vector.as_mut_slice().iter_mut().enumerate().for_each(|(i, place)| *place = entry(i));
    vector
}

/// Propagates vectors from `x` to `next` in pairs; compilers compute a pair's common terms once.
#[inline(always)]
pub(super) fn carry_all<'a, M: TangentMap<State: 'a>>(
    map: &M,
    x: &[M::Scalar],
    next: &[M::Scalar],
    vectors: impl IntoIterator<Item = &'a mut M::State>,
) {
    let mut vectors = vectors.into_iter();
    while let Some(one) = vectors.next() {
        map.push_forward_to(x, next, one);
        if let Some(other) = vectors.next() {
            map.push_forward_to(x, next, other);
        }
    }
}

/// An indicator that is computed from the lengths of K tangent vectors.
pub trait Indicator<const K: usize> {
    /// The type of the report.
    type Report;

    /// Whether the indicator needs lengths at every step. Otherwise it gets lengths at every step
    /// up to [`PAUSE`], and later at multiples of [`PAUSE`].
    const LOOKS_AT_EACH: bool;

    /// Creates the indicator from the squared lengths of the vectors at the first point.
    fn new(first: [Size; K]) -> Self;

    /// Records the squared lengths of the vectors after `step` steps.
    fn read_lengths(&mut self, step: u64, sizes: [Size; K]);

    /// Returns the report. `carried` holds the vectors at the last point.
    fn report<M: TangentMap>(self, carried: Carried<M, K>) -> Self::Report;
}

/// An observer that propagates K tangent vectors and computes an `Indicator` from them.
#[derive(Clone, Debug)]
pub struct IndicatorObserver<I, M: TangentMap, const K: usize> {
    carried: Carried<M, K>,
    indicator: I,
}

impl<I: Indicator<K>, M: TangentMap, const K: usize> IndicatorObserver<I, M, K> {
    /// Creates an observer for orbits of a prepared map, which is given by value or by reference.
    pub fn new(map: M) -> Self {
        let mut carried = Carried::new(map);
        let indicator = I::new(carried.scale());
        Self { carried, indicator }
    }
}

impl<I: Indicator<K>, M: TangentMap<Scalar: FloatScalar>, const K: usize> IndicatorObserver<I, M, K> {
    /// Scales the vectors and passes their lengths to the indicator, if this step needs lengths.
    #[inline(always)]
    fn read_lengths(&mut self, step: u64) {
        if step < PAUSE || step.is_multiple_of(PAUSE) || looks_at_each::<I, M::Scalar, K>() {
            let sizes = self.carried.scale();
            self.indicator.read_lengths(step, sizes);
        }
    }
}

/// An observer that need not see every point, because its caller can propagate its tangent vectors
/// to a later point.
///
/// The observer must see all steps up to [`PAUSE`], and later all steps that are powers of two. It
/// must also see a multiple of [`PAUSE`] at which a vector needs [scaling](super::are_moderate).
pub trait SparseObserver<T> {
    /// Returns the number of tangent vectors.
    fn vectors(&mut self) -> usize;

    /// Returns tangent vector k at the latest point.
    fn vector(&mut self, k: usize) -> &[T];

    /// Receives the point of a step and the vectors at this point. `entry(k, i)` is entry i of
    /// vector k.
    fn resume(&mut self, step: u64, x: &[T], entry: &dyn Fn(usize, usize) -> T);
}

impl<I: Indicator<K>, M: TangentMap<Scalar = T>, T: FloatScalar, const K: usize> SparseObserver<T>
    for IndicatorObserver<I, M, K>
{
    fn vectors(&mut self) -> usize {
        K
    }

    fn vector(&mut self, k: usize) -> &[T] {
        self.carried.vectors[k].as_slice()
    }

    fn resume(&mut self, step: u64, x: &[T], entry: &dyn Fn(usize, usize) -> T) {
        let carried = &mut self.carried;
        for (k, vector) in carried.vectors.iter_mut().enumerate() {
            vector.as_mut_slice().iter_mut().enumerate().for_each(|(i, own)| *own = entry(k, i));
        }
        carried.place.as_mut_slice().copy_from_slice(x);
        if core::mem::replace(&mut carried.steps, step) < step {
            self.read_lengths(step);
        }
    }
}

impl<I: Indicator<K>, M: TangentMap<Scalar = T>, T: FloatScalar, const K: usize> Observer<T>
    for IndicatorObserver<I, M, K>
{
    type Report = I::Report;

    const MAY_END: bool = false;

    #[inline(always)]
    fn observe(&mut self, step: u64, x: &[T]) {
        self.carried.follow(step, x);
        self.read_lengths(step);
    }

    /// Propagates all trajectories in lanes if their observers have one map in common.
    #[cfg(feature = "std")]
    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>)
    where
        T: EnsembleScalar,
    {
        let mut done = 0;
        while let Some(taken) = follow_side_by_side(group, burst, done) {
            done += taken;
        }
        for (lane, follower) in group.iter_mut().flatten().enumerate() {
            burst.show(lane, done, |step, x| follower.observe(step, x));
        }
    }

    fn resumed(&mut self) -> Option<&mut dyn SparseObserver<T>> {
        if looks_at_each::<I, T, K>() { None } else { Some(self) }
    }

    fn report(self) -> I::Report {
        self.indicator.report(self.carried)
    }
}

/// The number of steps between scalings of vectors whose lengths are not needed at every step.
///
/// Only a growth by 2⁶⁰ in every step could leave the range of `f64` within this many steps.
pub const PAUSE: u64 = 16;

/// Returns whether vectors are scaled after every step. The indicator may need lengths at every
/// step, or a single step may leave the range of `f32`.
#[inline(always)]
fn looks_at_each<I: Indicator<K>, T, const K: usize>() -> bool {
    I::LOOKS_AT_EACH || size_of::<T>() <= size_of::<f32>()
}

/// Propagates the tangent vectors of a group in lanes until a vector must be scaled. Returns the
/// number of steps taken, or `None` if the group cannot advance in lanes.
#[cfg(feature = "std")]
fn follow_side_by_side<I, M, T, P, const K: usize>(
    group: &mut Observers<'_, IndicatorObserver<I, M, K>>,
    burst: &Burst<'_, P>,
    done: usize,
) -> Option<usize>
where
    I: Indicator<K>,
    M: TangentMap<Scalar = T>,
    T: EnsembleScalar + FloatScalar,
    P: Grouped<T>,
{
    let places = &burst.seen[done..];
    if places.len() < 2 {
        return None;
    }
    // Unused lanes get vectors of ones, which need no scaling and therefore stop no other lane.
    let mut ones = places.first()?.clone();
    ones.as_mut().fill([T::one(); GROUP]);
    let mut vectors: [P; K] = from_fn(|_| ones.clone());
    let mut maps = [None; GROUP];
    for (lane, follower) in group.iter_mut().flatten().enumerate() {
        let carried = &follower.carried;
        for (columns, vector) in vectors.iter_mut().zip(carried.vectors()) {
            for (column, entry) in columns.as_mut().iter_mut().zip(vector) {
                column[lane] = *entry;
            }
        }
        maps[lane] = Some(&carried.map);
    }
    let first = maps[0]?;
    let maps = maps.map(|map| map.unwrap_or(first));
    let first = burst.before + 1 + done as u64;
    let mut squares = [[[T::one(); GROUP]; K]; BURST_STEPS];
    let looks_at_each = first < PAUSE || looks_at_each::<I, T, K>();
    let squares = if looks_at_each { squares.as_flattened_mut() } else { &mut [] };
    let work = SideBySide { places, vectors: &mut vectors, squares, level: burst.level };
    let taken = M::push_forward_group(maps, work)?;
    for (lane, follower) in group.iter_mut().flatten().enumerate() {
        let carried = &mut follower.carried;
        for (columns, vector) in vectors.iter().zip(&mut carried.vectors) {
            columns.read(lane, vector.as_mut_slice());
        }
        burst.seen[done + taken].read(lane, carried.place.as_mut_slice());
        carried.steps = first + taken as u64 - 1;
        let exponents = carried.exponents;
        let last = carried.scale();
        for (step, squares) in (first..).zip(squares.chunks_exact(K).take(taken - 1)) {
            let size = |k: usize| Size::of_square(squares[k][lane].approximate(), exponents[k]);
            follower.indicator.read_lengths(step, from_fn(size));
        }
        follower.indicator.read_lengths(first + taken as u64 - 1, last);
    }
    Some(taken)
}

/// Returns entry i of vector k, an arbitrary multiple of 1/64 up to 1.
fn any_direction<T: FloatScalar>(k: usize, i: usize) -> T {
    T::constant(&Constant::ratio(((37 * i + 23 * k * (i + 1) + 11) % 64 + 1) as i64, 64))
}
