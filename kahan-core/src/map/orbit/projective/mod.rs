//! Orbits that go on where a coordinate is infinite.
//!
//! In: an orbit. Out: its points and those after a pole, as points of projective space. While an
//! ordinary step loses nothing ([`memory`]) it is taken; else the orbit goes along lines
//! ([`passage`]), over numbers that depend on a small δ ([`germ`]), until what a pole has brought
//! together is apart again.

mod germ;
mod memory;
mod passage;
mod point;
mod through;

use core::fmt;
use core::iter::FusedIterator;
use core::mem;
use std::boxed::Box;

use nalgebra::SVector;

use crate::step::error::Reason;
use crate::{ExtendScalars, KahanAt, Orbit, PreparedStep, SingularStep};

use passage::{Lost, Passage, Place};
pub use point::ProjectivePoint;
pub use through::ThroughPoles;

/// After so many steps without it, what a pole has brought together is taken to stay so.
const MOST_STEPS: usize = 12;

/// The variables up to which there are lines through a point: their matrices lie on the stack.
const MOST_VARIABLES: usize = 32;

/// The orbit x₀, x₁, … of a Kahan map through its poles, x₀ first; made by
/// [`Orbit::projective`].
#[derive(Clone)]
#[must_use = "an orbit computes nothing until it is iterated"]
pub struct Projective<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> {
    map: M,
    eps: T,
    prepared: M::Prepared,
    at: At<M, T, N>,
    stopped: Option<SingularStep>,
}

/// Where an orbit is.
#[derive(Clone)]
enum At<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> {
    /// Before the first point.
    First(SVector<T, N>),
    /// At a point that has lost nothing.
    Point {
        x: SVector<T, N>,
        /// Whether |εf′| is known to be small there.
        is_flat: bool,
    },
    /// On its way through a pole.
    Passage(Box<Passage<M, T, N>>),
    /// At its end.
    Nowhere,
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> At<M, T, N> {
    fn point(x: SVector<T, N>) -> Self {
        At::Point { x, is_flat: false }
    }
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> Orbit<KahanAt<M, T, N>> {
    /// The same orbit through its poles, from where it is: points of projective space, which are at
    /// infinity where the map has a pole.
    ///
    /// The n-th point is the limit of φⁿ(x₀ + δv) as δ → 0, φ the map, for any direction v: the
    /// value of the n-th iterate as a rational map of projective space. That goes further than to
    /// step from point to point. A map may bring all points of a curve or surface to one point, at
    /// infinity or not, and some steps later take them apart again, each to its place; `kahan
    /// poles` tells for which curves that is so. The orbit goes along lines through the point
    /// before, which know where they came from, until then. Where what was lost is not back after
    /// twelve steps, it goes on from the one point that there is.
    ///
    /// Exact orbits are exact: lines are series in δ.
    ///
    /// Over floats points have the bits of [`KahanMap::orbit`](crate::KahanMap::orbit) as long as
    /// A(x,ε) and A(x̃,−ε) are far from singular: no pivot is below a 1024th of its row or column,
    /// as far as x̃ has digits to say so. Near a pole an ordinary orbit loses as many digits as it
    /// comes near, first in large coordinates, then in those to which it comes back. Here such
    /// points and those after them are computed in seventeen digits of 64 bits and each is rounded
    /// once, until a rounding counts for no more than ten bits at the point from where it came; so
    /// ten bits are what an orbit may lose on its way through a pole. A float that is near a pole
    /// and not at it has a next point that is large and not infinite, unless that is beyond the
    /// range of the scalar. In more than 32 variables the orbit takes ordinary steps only.
    ///
    /// Cost: over floats, a step and the matrix A, with two of them and eliminations where |εf′| is
    /// not small; over exact scalars, a step and a determinant. Ordinary steps of floats allocate
    /// nothing. A step near a pole costs several orders of magnitude more than an ordinary one, or
    /// over exact scalars a number of exact steps for each term of the series, and it allocates.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Escapes to infinity in finite time, and comes back from the other side.
    ///     pub struct Riccati;
    ///     xdot = x^2;
    /// }
    ///
    /// // 1/x̃ = 1/x − 2ε
    /// let mut orbit = Riccati.orbit(vector![1.0], 0.25).projective();
    /// let points: Vec<Option<f64>> =
    ///     orbit.by_ref().take(5).map(|point| point.affine().map(|x| x[0])).collect();
    /// assert_eq!(points, [Some(1.0), Some(2.0), None, Some(-2.0), Some(-1.0)]);
    /// assert!(orbit.stopped().is_none());
    /// ```
    pub fn projective(self) -> Projective<M, T, N> {
        let Self { map: KahanAt { map, eps, prepared }, state, begun, .. } = self;
        let at = if begun { At::point(state) } else { At::First(state) };
        Projective { map, eps, prepared, at, stopped: None }
    }
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> Projective<M, T, N> {
    /// Why the orbit has ended: `Some` from the moment on when it met a point of indeterminacy,
    /// where the map has one limit along one line and another along another, or when not even the
    /// longest series, or the smallest δ, showed a limit.
    pub fn stopped(&self) -> Option<&SingularStep> {
        self.stopped.as_ref()
    }

    fn stop(&mut self, reason: Reason) -> Option<ProjectivePoint<T, N>> {
        let eps = self.eps.approximate();
        self.stopped = Some(SingularStep::because(reason, f64::NAN, f64::INFINITY, eps));
        None
    }

    /// The next point where it is not one ordinary step from the last.
    #[cold]
    fn elsewhere(&mut self) -> Option<ProjectivePoint<T, N>> {
        match mem::replace(&mut self.at, At::Nowhere) {
            At::First(x) => Some(self.at_point(x)),
            At::Point { x, .. } => self.after(x),
            At::Passage(passage) => self.along(passage),
            At::Nowhere => None,
        }
    }

    /// The point after an ordinary one.
    fn after(&mut self, x: SVector<T, N>) -> Option<ProjectivePoint<T, N>> {
        let next = self.prepared.next(&x);
        if let Some(next) = &next
            && T::keeps(&self.map, &x, next, &self.eps, &mut false)
        {
            return Some(self.at_point(next.clone()));
        }
        if !x.iter().all(T::is_finite_number) {
            return self.stop(Reason::NotFinite);
        }
        match self.begin(x) {
            Ok(point) => Some(point),
            Err(Lost::Ambiguous) => self.stop(Reason::Indeterminate),
            // What an orbit does that looks at nothing.
            Err(Lost::Unknown) => match next.filter(|next| next.iter().all(T::is_finite_number)) {
                Some(next) => Some(self.at_point(next)),
                None => self.stop(Reason::Unfollowed),
            },
        }
    }

    fn at_point(&mut self, x: SVector<T, N>) -> ProjectivePoint<T, N> {
        self.at = At::point(x.clone());
        x.into()
    }

    /// The point after x, along lines.
    fn begin(&mut self, x: SVector<T, N>) -> Result<ProjectivePoint<T, N>, Lost> {
        if N > MOST_VARIABLES {
            return Err(Lost::Unknown);
        }
        let mut passage = Box::new(Passage::from(&self.map, &self.eps, x));
        let place = passage.advance()?;
        Ok(self.arrive(passage, place))
    }

    /// The next point along the lines of `passage`.
    fn along(&mut self, mut passage: Box<Passage<M, T, N>>) -> Option<ProjectivePoint<T, N>> {
        match passage.advance() {
            Ok(place) => Some(self.arrive(passage, place)),
            Err(Lost::Ambiguous) => self.stop(Reason::Indeterminate),
            Err(Lost::Unknown) => self.forget(*passage),
        }
    }

    /// Keeps the lines as long as they are needed.
    fn arrive(&mut self, passage: Box<Passage<M, T, N>>, place: Place<T, N>) -> ProjectivePoint<T, N> {
        let Place { point, is_through } = place;
        let is_over = is_through == Some(true) || (passage.taken() >= MOST_STEPS && !point.is_infinite());
        self.at = match point.clone().affine() {
            Some(x) if is_over => At::point(x),
            _ => At::Passage(passage),
        };
        point
    }

    /// The next point from the last one alone, where the lines end.
    fn forget(&mut self, passage: Passage<M, T, N>) -> Option<ProjectivePoint<T, N>> {
        match passage.into_last().and_then(ProjectivePoint::affine) {
            Some(x) => self.after(x),
            None => self.stop(Reason::Unfollowed),
        }
    }
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> Iterator for Projective<M, T, N> {
    type Item = ProjectivePoint<T, N>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        // In its place: a state that is moved is waited for in the chain of an orbit.
        if let At::Point { x, is_flat } = &mut self.at
            && let Some(next) = self.prepared.next(x)
            && T::keeps(&self.map, x, &next, &self.eps, is_flat)
        {
            x.clone_from(&next);
            return Some(next.into());
        }
        self.elsewhere()
    }
}

impl<M, T, const N: usize> FusedIterator for Projective<M, T, N>
where
    M: ExtendScalars<T, N>,
    T: ThroughPoles,
{
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> fmt::Debug for Projective<M, T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { eps, stopped, .. } = self;
        f.debug_struct("Projective").field("eps", eps).field("stopped", stopped).finish_non_exhaustive()
    }
}
