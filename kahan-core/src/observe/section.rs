//! Where an orbit crosses a section.
//!
//! In: a function whose zeros are the section, and a map that can be stepped by a part of its step.
//! Out: the crossings, each refined on the map's own curve from a point to the next.

#[cfg(feature = "std")]
use std::vec::Vec;

use crate::{Constant, FloatScalar, Orbit, PointOf, Room, Slice, Step};

use super::Observer;

/// The crossings of a section s(x) = 0: of a plane, or of a level of any function.
///
/// A crossing lies between two points of the orbit where s changes its sign, or at the second if s
/// is 0 there. It is refined on the curve x(θ) = φ_{θε}(xₙ), 0 ≤ θ ≤ 1, the map's step with a part
/// of ε: there s vanishes to rounding. The orbit itself has no points between its points; x(θ) is
/// as far from the flow as a step is, O(ε³), and integrals of the map with ε hold on it up to that.
///
/// Cost: s at every step, and some ten steps of the map a crossing.
///
/// ```
/// use kahan_core::observe::{AtMost, Direction, Section};
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// A circle around the origin.
///     pub struct Turn;
///     xdot = y;
///     ydot = -x;
/// }
///
/// let map = Turn.at(0.01);
/// let section = Section::new(&map, |x: &[f64]| x[0], Direction::Rising, AtMost::new(10));
/// let found = map.orbit(vector![0.0, 1.0]).observe(1000, section);
/// // It is on the section to begin with, which is no crossing.
/// assert_eq!(found.all, 3);
/// assert!(found.kept.iter().all(|crossing| (crossing.point[1] - 1.0).abs() < 1e-13));
/// ```
#[derive(Clone, Debug)]
pub struct Section<M: Step, F, S> {
    map: M,
    level: F,
    direction: Direction,
    sink: S,
    /// The point given last, and s there.
    place: M::State,
    height: f64,
    room: Room,
}

/// Which crossings count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Those where s grows.
    Rising,
    /// Those where s falls.
    Falling,
    /// All.
    Both,
}

/// A crossing of a [`Section`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<P, T> {
    /// The step n that the crossing comes after, or is at the end of.
    pub step: u64,
    /// The part θ of the step from xₙ, over 0 up to 1.
    pub part: T,
    /// The time since x₀, 2ε(n + θ).
    pub time: T,
    /// φ_{θε}(xₙ)
    pub point: P,
}

/// More than the secants of any smooth function: where s jumps, the search ends here.
const MOST_SECANTS: usize = 64;

/// What takes crossings: a closure, or [`AtMost`].
pub trait Sink<C> {
    /// What a [`Section`] reports.
    type Report;

    /// Takes the next one.
    fn take(&mut self, crossing: C);

    /// Whether it wants no more, so that the run may end.
    #[inline(always)]
    fn is_full(&self) -> bool {
        false
    }

    /// What came of them.
    fn report(self) -> Self::Report;
}

/// Called with every crossing; nothing is reported.
impl<C, F: FnMut(C)> Sink<C> for F {
    type Report = ();

    fn take(&mut self, crossing: C) {
        self(crossing);
    }

    fn report(self) {}
}

/// The first crossings, in memory that is allocated at the beginning.
#[cfg(feature = "std")]
#[derive(Clone, Debug)]
pub struct AtMost<C> {
    found: Kept<C>,
    capacity: usize,
}

/// What [`AtMost`] reports.
#[cfg(feature = "std")]
#[derive(Clone, Debug, PartialEq)]
pub struct Kept<C> {
    /// The first of them.
    pub kept: Vec<C>,
    /// How many there were, those that were not kept among them.
    pub all: u64,
}

#[cfg(feature = "std")]
impl<C> AtMost<C> {
    /// Keeps `capacity` crossings, and counts the others.
    pub fn new(capacity: usize) -> Self {
        Self { found: Kept { kept: Vec::with_capacity(capacity), all: 0 }, capacity }
    }

    /// Whether there is no more room.
    pub(super) fn has_all(&self) -> bool {
        self.found.kept.len() >= self.capacity
    }
}

#[cfg(feature = "std")]
impl<C> Sink<C> for AtMost<C> {
    type Report = Kept<C>;

    fn take(&mut self, crossing: C) {
        self.found.all += 1;
        if self.found.kept.len() < self.capacity {
            self.found.kept.push(crossing);
        }
    }

    fn report(self) -> Kept<C> {
        self.found
    }
}

impl<M, F, T, S> Section<M, F, S>
where
    M: Step<Scalar = T>,
    F: Fn(&[T]) -> T,
    T: FloatScalar,
    S: Sink<Crossing<PointOf<M>, T>>,
{
    /// The crossings of `level` = 0 by orbits of `map`, handed to `sink`.
    pub fn new(map: M, level: F, direction: Direction, sink: S) -> Self {
        let place = M::State::zeros(map.dimension());
        Self { map, level, direction, sink, place, height: f64::NAN, room: Room::new() }
    }

    /// The crossing between the point given last and the next, where s has the height `end`: by
    /// secants that keep the zero between two ends. An end that stays twice counts half (the
    /// Illinois method), so that both of them come closer.
    #[cold]
    #[inline(never)]
    fn crossing(&mut self, step: u64, end: T) -> Crossing<PointOf<M>, T> {
        let Self { map, level, place: before, room, .. } = self;
        let eps = *map.eps();
        let mut at = |part: T| {
            let mut state = before.clone();
            // Floats go on at poles.
            let _ = map.part(&(part * eps), state.as_mut_slice(), room);
            state.to_point()
        };
        let two = T::one() + T::one();
        let half = T::one() / two;
        // A part of the step and s there, first of the end that was found last.
        let mut ends = [(T::one(), end), (T::zero(), level(before.point()))];
        let mut point = at(T::one());
        for _ in 0..MOST_SECANTS {
            let [(last, height), (other, other_height)] = ends;
            let part = last - height * (other - last) / (other_height - height);
            if height.is_zero() || part == last || part == other {
                break;
            }
            point = at(part);
            let found = (part, level(point.as_slice()));
            let is_opposite = (found.1.approximate() < 0.0) != (height.approximate() < 0.0);
            ends = [found, if is_opposite { ends[0] } else { (other, other_height * half) }];
        }
        let part = ends[0].0;
        let time = two * eps * (T::constant(&Constant::integer(step.cast_signed())) + part);
        Crossing { step, part, time, point }
    }
}

impl<M, F, T, S> Observer<T> for Section<M, F, S>
where
    M: Step<Scalar = T>,
    F: Fn(&[T]) -> T,
    T: FloatScalar,
    S: Sink<Crossing<PointOf<M>, T>>,
{
    type Report = S::Report;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        let end = (self.level)(x);
        let (before, after) = (self.height, end.approximate());
        self.height = after;
        let rises = self.direction != Direction::Falling && before < 0.0 && after >= 0.0;
        let falls = self.direction != Direction::Rising && before > 0.0 && after <= 0.0;
        if step > 0 && (rises || falls) {
            let crossing = self.crossing(step - 1, end);
            self.sink.take(crossing);
        }
        // What a mode carries behind the point is left as it was: a part of a step ignores it.
        self.place.as_mut_slice()[..x.len()].copy_from_slice(x);
    }

    #[inline]
    fn is_done(&self) -> bool {
        self.sink.is_full()
    }

    fn report(self) -> S::Report {
        self.sink.report()
    }
}

/// Where the orbit of any map from `start` first crosses `level` = 0, within so many steps; `None`
/// where it does not, or ends before. A start on the section is no crossing.
///
/// `map` is a prepared map, a chain, a map read at run time, or a reference to one, `&dyn Step`
/// among them, whose states are `Vec`s. The crossing is refined as a [`Section`]'s are.
///
/// ```
/// use kahan_core::observe::first_crossing;
/// use kahan_core::prelude::*;
/// use kahan_core::Step;
///
/// kahan! {
///     /// A circle around the origin.
///     pub struct Turn;
///     xdot = y;
///     ydot = -x;
/// }
///
/// let map = Turn.at(0.001);
/// let crossing = first_crossing(&map, vector![1.0, 0.0], 10_000, |x| x[0]).unwrap();
/// assert!((crossing.time - std::f64::consts::FRAC_PI_2).abs() < 1e-5);
/// assert!(crossing.point[0].abs() < 1e-15);
///
/// let any: &dyn Step<Scalar = f64> = &map;
/// assert_eq!(first_crossing(any, vec![1.0, 0.0], 10_000, |x| x[0]).unwrap().time, crossing.time);
/// ```
pub fn first_crossing<M, T>(
    map: M,
    start: M::State,
    steps: u64,
    level: impl Fn(&[T]) -> T,
) -> Option<Crossing<PointOf<M>, T>>
where
    M: Step<Scalar = T>,
    T: FloatScalar,
{
    let section = Section::new(&map, level, Direction::Both, First(None));
    Orbit::new(&map, start).observe(steps, section)
}

/// The first crossing.
#[derive(Clone, Debug)]
pub(super) struct First<C>(pub(super) Option<C>);

impl<C> Sink<C> for First<C> {
    type Report = Option<C>;

    fn take(&mut self, crossing: C) {
        self.0.get_or_insert(crossing);
    }

    fn is_full(&self) -> bool {
        self.0.is_some()
    }

    fn report(self) -> Option<C> {
        self.0
    }
}
