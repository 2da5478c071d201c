//! Crossings of an orbit with a section.

#[cfg(feature = "std")]
use std::vec::Vec;

use crate::{Constant, FloatScalar, Orbit, PointOf, StateVector, Step, Workspace};

use super::Observer;
use super::zero::{ZeroBracket, is_zero, narrow, small};

/// An observer of the crossings with a section s(x) = 0, a plane or a level set of any function s.
///
/// A crossing lies between two points xₙ and xₙ₊₁ of the orbit at which s has different signs. If s
/// is 0 at xₙ₊₁, the crossing is xₙ₊₁. A crossing is refined to rounding accuracy on the curve
///
/// x(θ) = φ_{θε}(xₙ), 0 ≤ θ ≤ 1,
///
/// where φ_ε is the map. This curve is as close to the flow as a step is, O(ε³).
///
/// A sign change without a zero is counted as a jump instead. Jumps occur at a pole or
/// discontinuity of s, or where the curve passes through infinity at a pole of the map. At a
/// crossing in `f64`, |s| is at most 2⁻¹⁷ times the larger of |s(xₙ)| and |s(xₙ₊₁)|. In `f32` the
/// factor is 2⁻⁸.
///
/// A step costs an evaluation of s. A crossing costs about fifteen steps, a jump up to about a
/// hundred.
///
/// ```
/// use kahan_core::observe::{FirstCrossings, Direction, Section};
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
/// let section = Section::new(&map, |x: &[f64]| x[0], Direction::Rising, FirstCrossings::new(10));
/// let found = map.orbit(vector![0.0, 1.0]).observe(1000, section);
/// // It is on the section to begin with, which is no crossing.
/// assert_eq!((found.points.all, found.jumps), (3, 0));
/// assert!(found.points.kept.iter().all(|crossing| (crossing.point[1] - 1.0).abs() < 1e-13));
/// ```
#[derive(Clone, Debug)]
pub struct Section<M: Step, F, S> {
    map: M,
    level: F,
    direction: Direction,
    sink: S,
    jumps: u64,
    /// The latest point.
    place: M::State,
    step: u64,
    height: f64,
    workspace: Workspace,
}

/// The report of a [`Section`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SectionReport<R> {
    /// The report of the [`CrossingReceiver`] that received the crossings.
    pub points: R,
    /// The number of sign changes at jumps of the section's function, for example at poles.
    pub jumps: u64,
}

/// The directions in which sign changes are observed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Direction {
    /// The function of the section changes from negative to positive.
    #[default]
    Rising,
    /// The function of the section changes from positive to negative.
    Falling,
    /// Sign changes in both directions are observed.
    Both,
}

impl Direction {
    /// All directions in which sign changes can be observed.
    pub const ALL: [Self; 3] = [Self::Rising, Self::Falling, Self::Both];

    /// Returns the name of the direction: `rising`, `falling` or `both`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rising => "rising",
            Self::Falling => "falling",
            Self::Both => "both",
        }
    }
}

/// A crossing of a [`Section`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Crossing<P, T> {
    /// The number n of full steps before the crossing.
    pub step: u64,
    /// The fraction θ of a step that leads from xₙ to the crossing, 0 < θ ≤ 1.
    pub part: T,
    /// The time 2ε(n + θ) since the initial point.
    pub time: T,
    /// The point φ_{θε}(xₙ), where φ_ε is the map.
    pub point: P,
}

/// A receiver of crossings, which is a closure or a [`FirstCrossings`].
pub trait CrossingReceiver<C> {
    /// The type of the report.
    type Report;

    /// Receives the next crossing.
    fn take(&mut self, crossing: C);

    /// Returns whether the receiver needs no further crossings. The run may then end.
    #[inline(always)]
    fn is_full(&self) -> bool {
        false
    }

    /// Returns the report on the received crossings.
    fn report(self) -> Self::Report;
}

/// Calls the closure with every crossing.
impl<C, F: FnMut(C)> CrossingReceiver<C> for F {
    type Report = ();

    fn take(&mut self, crossing: C) {
        self(crossing);
    }

    fn report(self) {}
}

/// A receiver that stores the first crossings, in memory allocated at the start.
#[cfg(feature = "std")]
#[derive(Clone, Debug)]
pub struct FirstCrossings<C> {
    found: StoredCrossings<C>,
    capacity: usize,
}

/// The report of [`FirstCrossings`].
#[cfg(feature = "std")]
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StoredCrossings<C> {
    /// The first crossings, at most as many as the capacity.
    pub kept: Vec<C>,
    /// The total number of crossings, including those that are not stored.
    pub all: u64,
}

#[cfg(feature = "std")]
impl<C> FirstCrossings<C> {
    /// Creates a receiver that stores the first `capacity` crossings and counts all crossings.
    pub fn new(capacity: usize) -> Self {
        Self { found: StoredCrossings { kept: Vec::with_capacity(capacity), all: 0 }, capacity }
    }

    pub(super) fn has_all(&self) -> bool {
        self.found.kept.len() >= self.capacity
    }
}

#[cfg(feature = "std")]
impl<C> CrossingReceiver<C> for FirstCrossings<C> {
    type Report = StoredCrossings<C>;

    fn take(&mut self, crossing: C) {
        self.found.all += 1;
        if self.found.kept.len() < self.capacity {
            self.found.kept.push(crossing);
        }
    }

    fn report(self) -> StoredCrossings<C> {
        self.found
    }
}

impl<M, F, T, S> Section<M, F, S>
where
    M: Step<Scalar = T>,
    F: Fn(&[T]) -> T,
    T: FloatScalar,
    S: CrossingReceiver<Crossing<PointOf<M>, T>>,
{
    /// Creates an observer of orbits of `map`, which passes each crossing of `level` = 0 to `sink`.
    pub fn new(map: M, level: F, direction: Direction, sink: S) -> Self {
        let place = M::State::zeros(map.dimension());
        Self {
            map,
            level,
            direction,
            sink,
            jumps: 0,
            place,
            step: 0,
            height: f64::NAN,
            workspace: Workspace::new(),
        }
    }

    /// Forgets the latest point, so that no crossing is sought between it and the next point.
    /// Callers may then skip points between which the function of the section keeps its sign.
    #[doc(hidden)]
    pub fn restart(&mut self) {
        self.height = f64::NAN;
    }

    /// Returns the crossing between the latest point and x, or `None` for a jump. `end` is s(x),
    /// where s is the function of the section.
    #[cold]
    #[inline(never)]
    fn crossing(&mut self, x: &[T], end: T) -> Option<Crossing<PointOf<M>, T>> {
        let Self { map, level, place: before, workspace, step, .. } = self;
        let eps = *map.eps();
        let mut at = |part: T| {
            let mut state = before.clone();
            if part.is_one() {
                state.as_mut_slice()[..x.len()].copy_from_slice(x);
            } else {
                let _ = map.part(&(part * eps), state.as_mut_slice(), workspace);
            }
            state.to_point()
        };
        let ends = [level(before.point()), end];
        let places = narrow(ends, |part| level(at(part).as_slice()));
        let size = |place: &ZeroBracket<T>| place.height.approximate().abs();
        let [one, other] = places;
        // A zero at the fraction 0 belongs to the previous step; therefore 0 is not chosen.
        let is_one = other.part.is_zero() || (!one.part.is_zero() && size(&one) <= size(&other));
        let part = if is_one { one.part } else { other.part };
        let [point, beside] = if is_one { places } else { [other, one] }.map(|place| at(place.part));
        if !is_zero(places, ends) || is_beyond([before.point(), x], [point.as_slice(), beside.as_slice()]) {
            return None;
        }
        let steps = T::constant(&Constant::integer(step.cast_signed())) + part;
        Some(Crossing { step: *step, part, time: (T::one() + T::one()) * eps * steps, point })
    }
}

/// Returns whether `point`, a point within a step, is infinite or near a pole. Near a pole some
/// variable is much larger than at both `ends` of the step. The variable also differs from its
/// value at the neighbouring point `beside`.
fn is_beyond<T: FloatScalar>(ends: [&[T]; 2], [point, beside]: [&[T]; 2]) -> bool {
    let small = small::<T>();
    point.iter().zip(beside).enumerate().any(|(i, (at, beside))| {
        let [at, apart] = [*at, *at - *beside].map(|number| number.approximate().abs());
        let most = ends.map(|end| end[i].approximate().abs()).into_iter().fold(0.0, f64::max);
        !at.is_finite() || (small * at > most && (apart.is_nan() || apart > small * at))
    })
}

impl<M, F, T, S> Observer<T> for Section<M, F, S>
where
    M: Step<Scalar = T>,
    F: Fn(&[T]) -> T,
    T: FloatScalar,
    S: CrossingReceiver<Crossing<PointOf<M>, T>>,
{
    type Report = SectionReport<S::Report>;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        let end = (self.level)(x);
        let (before, after) = (self.height, end.approximate());
        let rises = self.direction != Direction::Falling && before < 0.0 && after >= 0.0;
        let falls = self.direction != Direction::Rising && before > 0.0 && after <= 0.0;
        if rises || falls {
            // Points at infinity are not observed. A sign change across them is a jump.
            let crossing = if step == self.step + 1 { self.crossing(x, end) } else { None };
            match crossing {
                Some(crossing) => self.sink.take(crossing),
                None => self.jumps += 1,
            }
        }
        (self.step, self.height) = (step, after);
        // Only coordinates are copied, not the rounding errors that compensated states append.
        self.place.as_mut_slice()[..x.len()].copy_from_slice(x);
    }

    #[inline]
    fn is_done(&self) -> bool {
        self.sink.is_full()
    }

    fn report(self) -> Self::Report {
        SectionReport { points: self.sink.report(), jumps: self.jumps }
    }
}

/// Returns the first crossing with `level` = 0 of the orbit from `start` within `steps` steps, if
/// any. A zero at `start` and jumps of `level` are no crossings.
///
/// `map` is a prepared map, a chain, a map read at run time, or a reference to one of these. The
/// states of a `&dyn Step` are `Vec`s. The crossing is refined as in a [`Section`].
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
    Orbit::new(&map, start).observe(steps, section).points
}

#[derive(Clone, Debug)]
pub(super) struct First<C>(pub(super) Option<C>);

impl<C> CrossingReceiver<C> for First<C> {
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
