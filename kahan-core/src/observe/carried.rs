//! Tangent vectors that follow an orbit, and the observers that look at nothing else.
//!
//! In: the points of the orbit, one after another. Out: K vectors, each at the point given last and
//! scaled by a power of two.

use core::array::from_fn;

#[cfg(feature = "std")]
use crate::EnsembleScalar;
#[cfg(feature = "std")]
use crate::ensemble::columns::GROUP;
use crate::{Constant, FloatScalar, Scalar, StateVector};

#[cfg(feature = "std")]
use super::burst::{BURST, Burst, Grouped, Observers, SideBySide};
use super::growth::{Size, scale};
use super::{Observer, TangentMap};

/// K tangent vectors that a map carries along.
#[derive(Clone, Debug)]
pub struct Carried<M: TangentMap, const K: usize> {
    map: M,
    /// Where the vectors are.
    place: M::State,
    vectors: [M::State; K],
    /// Vector k stands for itself times 2 to this power.
    exponents: [i64; K],
    /// The steps taken.
    steps: u64,
}

impl<M: TangentMap, const K: usize> Carried<M, K> {
    /// Vectors in directions that nothing prefers.
    pub(super) fn new(map: M) -> Self {
        let vectors = from_fn(|k| made_of(&map, |i| any_direction(k, i)));
        Self { place: M::State::zeros(map.dimension()), vectors, exponents: [0; K], steps: 0, map }
    }

    /// To the next point.
    #[inline(always)]
    fn follow(&mut self, step: u64, x: &[M::Scalar]) {
        if step > 0 {
            carry_all(&self.map, self.place.as_slice(), x, &mut self.vectors);
        }
        self.place.as_mut_slice().copy_from_slice(x);
        self.steps = step;
    }

    /// Scales the vectors; the squares of their lengths.
    #[inline(always)]
    pub(super) fn scale(&mut self) -> [Size; K] {
        from_fn(|k| scale(&mut self.vectors[k], &mut self.exponents[k]))
    }

    /// The steps taken.
    pub(super) fn steps(&self) -> u64 {
        self.steps
    }

    /// The vectors, each up to a power of two.
    pub(super) fn vectors(&self) -> [&[M::Scalar]; K] {
        self.vectors.each_ref().map(M::State::as_slice)
    }

    /// The time of one step.
    pub(super) fn time_step(&self) -> f64 {
        2.0 * self.map.eps().approximate()
    }
}

/// The vector of a map's space whose entry i is `entry(i)`.
pub(super) fn made_of<M: TangentMap>(map: &M, entry: impl Fn(usize) -> M::Scalar) -> M::State {
    let mut vector = M::State::zeros(map.dimension());
    vector.as_mut_slice().iter_mut().enumerate().for_each(|(i, place)| *place = entry(i));
    vector
}

/// Carries vectors along, two at a time: what depends on the points alone is then computed once for
/// both.
#[inline(always)]
pub(super) fn carry_all<'a, M: TangentMap<State: 'a>>(
    map: &M,
    x: &[M::Scalar],
    next: &[M::Scalar],
    vectors: impl IntoIterator<Item = &'a mut M::State>,
) {
    let mut vectors = vectors.into_iter();
    while let Some(one) = vectors.next() {
        map.carry_to(x, next, one);
        if let Some(other) = vectors.next() {
            map.carry_to(x, next, other);
        }
    }
}

/// What is looked at in K tangent vectors.
pub trait Indicator<const K: usize> {
    /// What it says in the end.
    type Report;

    /// Whether it looks at each step, or at 0, 1, …, [`PAUSE`] and multiples of that.
    const LOOKS_AT_EACH: bool;

    /// Before the first point, where the squares of the vectors' lengths are these.
    fn new(first: [Size; K]) -> Self;

    /// Looks at the squares of their lengths.
    fn look(&mut self, step: u64, sizes: [Size; K]);

    /// The report on vectors that have been carried to the last point.
    fn report<M: TangentMap>(self, carried: Carried<M, K>) -> Self::Report;
}

/// An observer of K tangent vectors.
#[derive(Clone, Debug)]
pub struct Follower<I, M: TangentMap, const K: usize> {
    carried: Carried<M, K>,
    indicator: I,
}

impl<I: Indicator<K>, M: TangentMap, const K: usize> Follower<I, M, K> {
    /// That of a prepared map, or of a reference to one.
    pub fn new(map: M) -> Self {
        let mut carried = Carried::new(map);
        let indicator = I::new(carried.scale());
        Self { carried, indicator }
    }
}

impl<I: Indicator<K>, M: TangentMap<Scalar: FloatScalar>, const K: usize> Follower<I, M, K> {
    /// Looks at the vectors if it is time to.
    #[inline(always)]
    fn look(&mut self, step: u64) {
        if step < PAUSE || step.is_multiple_of(PAUSE) || looks_at_each::<I, M::Scalar, K>() {
            let sizes = self.carried.scale();
            self.indicator.look(step, sizes);
        }
    }
}

/// An observer that need not see each point: a loop carries its tangent vectors along, and gives
/// them back with a later point.
///
/// Up to step [`PAUSE`] it sees each point. From then on it sees at least those of steps that are
/// powers of two, and of multiples of [`PAUSE`] at which the square of a vector's length is [not
/// moderate](super::are_moderate).
pub trait Resumed<T> {
    /// The number of its tangent vectors.
    fn vectors(&mut self) -> usize;

    /// Tangent vector k at the point seen last.
    fn vector(&mut self, k: usize) -> &[T];

    /// Takes the point of a step, and the vectors there: entry i of vector k is `entry(k, i)`.
    fn resume(&mut self, step: u64, x: &[T], entry: &dyn Fn(usize, usize) -> T);
}

impl<I: Indicator<K>, M: TangentMap<Scalar = T>, T: FloatScalar, const K: usize> Resumed<T>
    for Follower<I, M, K>
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
        // A step is looked at once.
        if core::mem::replace(&mut carried.steps, step) < step {
            self.look(step);
        }
    }
}

impl<I: Indicator<K>, M: TangentMap<Scalar = T>, T: FloatScalar, const K: usize> Observer<T>
    for Follower<I, M, K>
{
    type Report = I::Report;

    const MAY_END: bool = false;

    /// Takes the vectors to the next point, and looks at them if it is time to.
    #[inline(always)]
    fn observe(&mut self, step: u64, x: &[T]) {
        self.carried.follow(step, x);
        self.look(step);
    }

    /// All are carried side by side where they are known to belong to one map that can.
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

    fn resumed(&mut self) -> Option<&mut dyn Resumed<T>> {
        if looks_at_each::<I, T, K>() { None } else { Some(self) }
    }

    fn report(self) -> I::Report {
        self.indicator.report(self.carried)
    }
}

/// Steps after which vectors are scaled that nobody looks at meanwhile.
///
/// For a vector that was of moderate size to leave the range of an `f64` meanwhile, it has to grow
/// or shrink by 2⁶⁰ at each of them; near a pole it does at one or two.
pub const PAUSE: u64 = 16;

/// Whether vectors are looked at after each step: where that is asked for, and in `f32`, whose
/// range they may leave at any.
#[inline(always)]
fn looks_at_each<I: Indicator<K>, T, const K: usize>() -> bool {
    I::LOOKS_AT_EACH || size_of::<T>() <= size_of::<f32>()
}

/// Takes the vectors of a group of trajectories along a burst side by side, and looks at them after
/// each step: from the step after `done` on, until a vector has to be scaled: the steps
/// taken, `None` where there is none left or it cannot be done.
#[cfg(feature = "std")]
fn follow_side_by_side<I, M, T, P, const K: usize>(
    group: &mut Observers<'_, Follower<I, M, K>>,
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
    // Places without a trajectory carry vectors of moderate size, too.
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
    let mut squares = [[[T::one(); GROUP]; K]; BURST];
    let looks_at_each = first < PAUSE || looks_at_each::<I, T, K>();
    let squares = if looks_at_each { squares.as_flattened_mut() } else { &mut [] };
    let work = SideBySide { places, vectors: &mut vectors, squares, level: burst.level };
    let taken = M::carry_side_by_side(maps, work)?;
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
            follower.indicator.look(step, from_fn(size));
        }
        follower.indicator.look(first + taken as u64 - 1, last);
    }
    Some(taken)
}

/// Entry i of vector k: 64ths from 1/64 to 1, in no order that a field would have.
fn any_direction<T: FloatScalar>(k: usize, i: usize) -> T {
    T::constant(&Constant::ratio(((37 * i + 23 * k * (i + 1) + 11) % 64 + 1) as i64, 64))
}
