//! Where an orbit crosses a section.
//!
//! In: a function whose zeros are the section, and a map that can be stepped by a part of its step.
//! Out: the crossings, each refined on the map's own curve from a point to the next.

use core::marker::PhantomData;
#[cfg(feature = "std")]
use std::vec::Vec;

use crate::FloatScalar;

use super::{Between, Observer};

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
pub struct Section<M: Between<T>, F, T, S> {
    map: M,
    level: F,
    direction: Direction,
    sink: S,
    place: M::Point,
    /// s at the point given last.
    height: f64,
    scalar: PhantomData<T>,
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

impl<M, F, T, S> Section<M, F, T, S>
where
    M: Between<T>,
    F: Fn(&[T]) -> T,
    T: FloatScalar,
    S: Sink<Crossing<M::Point, T>>,
{
    /// The crossings of `level` = 0 by orbits of `map`, handed to `sink`.
    pub fn new(map: M, level: F, direction: Direction, sink: S) -> Self {
        let place = map.point(|_| T::zero());
        Self { map, level, direction, sink, place, height: f64::NAN, scalar: PhantomData }
    }

    /// The crossing between the point given last and the next, where s has the height `end`: by
    /// secants that keep the zero between two ends. An end that stays twice counts half (the
    /// Illinois method), so that both of them come closer.
    #[cold]
    #[inline(never)]
    fn crossing(&self, step: u64, end: T) -> Crossing<M::Point, T> {
        let at = |part: T| self.map.between(self.place.as_ref(), part);
        let half = T::one() / (T::one() + T::one());
        // A part of the step and s there, first of the end that was found last.
        let mut ends = [(T::one(), end), (T::zero(), (self.level)(self.place.as_ref()))];
        let mut point = at(T::one());
        for _ in 0..MOST_SECANTS {
            let [(last, height), (other, other_height)] = ends;
            let part = last - height * (other - last) / (other_height - height);
            if height.is_zero() || part == last || part == other {
                break;
            }
            point = at(part);
            let found = (part, (self.level)(point.as_ref()));
            let is_opposite = (found.1.approximate() < 0.0) != (height.approximate() < 0.0);
            ends = [found, if is_opposite { ends[0] } else { (other, other_height * half) }];
        }
        Crossing { step, part: ends[0].0, point }
    }
}

impl<M, F, T, S> Observer<T> for Section<M, F, T, S>
where
    M: Between<T>,
    F: Fn(&[T]) -> T,
    T: FloatScalar,
    S: Sink<Crossing<M::Point, T>>,
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
            self.sink.take(self.crossing(step - 1, end));
        }
        self.place.as_mut().copy_from_slice(x);
    }

    fn report(self) -> S::Report {
        self.sink.report()
    }
}
