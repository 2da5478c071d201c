//! Orbits that continue through poles, in projective space.
//!
//! The orbit takes ordinary steps while these preserve enough digits ([`memory`]). Near a pole, a
//! step brings distant points together. There the orbit follows lines ([`passage`]) whose points
//! depend on a small δ ([`delta_series`]), until points of different δ are apart again. From the
//! twelfth step on, the passage ends at a finite point.

mod delta_series;
mod memory;
mod passage;
mod passage_scalar;
mod point;

use core::fmt;
use core::iter::FusedIterator;
use core::mem;
use std::boxed::Box;

use nalgebra::SVector;

use crate::step::error::Reason;
use crate::{ExtendScalars, KahanAt, Orbit, PreparedStep, SingularStep};

use passage::{NoLimit, Passage, PassagePoint};
pub use passage_scalar::ThroughPoles;
pub use point::ProjectivePoint;

/// After this number of steps, a passage through a pole ends at its next finite point.
const MOST_STEPS: usize = 12;

/// The maximum number of variables for passages through poles. Larger matrices would need too much
/// stack.
const MOST_VARIABLES: usize = 32;

/// The orbit of a Kahan map, continued through poles; see [`Orbit::projective`].
#[derive(Clone)]
#[must_use = "an orbit computes nothing until it is iterated"]
pub struct Projective<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> {
    map: M,
    eps: T,
    prepared: M::Prepared,
    at: OrbitPosition<M, T, N>,
    stopped: Option<SingularStep>,
}

#[derive(Clone)]
enum OrbitPosition<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> {
    First(SVector<T, N>),
    Point {
        x: SVector<T, N>,
        /// Whether the absolute values in every row of εf′(x) are known to sum to at most ½.
        is_flat: bool,
    },
    Passage(Box<Passage<M, T, N>>),
    Nowhere,
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> OrbitPosition<M, T, N> {
    fn point(x: SVector<T, N>) -> Self {
        OrbitPosition::Point { x, is_flat: false }
    }
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> Orbit<KahanAt<M, T, N>> {
    /// Continues this orbit through its poles, as points of projective space.
    ///
    /// The n-th point is the limit of φⁿ(x₀ + δv) as δ → 0, for the map φ and any direction v. A
    /// map may contract a curve or surface to one point, and separate the merged points some steps
    /// later; `kahan poles` finds such curves. Until the separation, the orbit follows lines
    /// through the point before the contraction. If twelve steps separate no points, the orbit
    /// continues from the merged point.
    ///
    /// Exact orbits are exact. Over floats, points away from poles have the bits of
    /// [`KahanMap::orbit`](crate::KahanMap::orbit), and a passage through a pole loses at most ten
    /// bits. From a float near a pole but not at it, the next point is large but finite, unless it
    /// exceeds the range of the scalar. In more than 32 variables the orbit takes only ordinary
    /// steps.
    ///
    /// Over floats a point costs a step and the matrix A. If |εf′| is not small, a second matrix
    /// and two eliminations are added. Over exact scalars a point costs a step and a determinant. A
    /// step near a pole allocates, and is much slower.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Solutions from x > 0 reach +∞ in finite time. Orbits of the map then return from −∞.
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
        let at = if begun { OrbitPosition::point(state) } else { OrbitPosition::First(state) };
        Projective { map, eps, prepared, at, stopped: None }
    }
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> Projective<M, T, N> {
    /// Returns the reason why the orbit has ended. Either the state is not finite, limits along two
    /// lines differ (a point of indeterminacy), or no limit is recognisable.
    pub fn stopped(&self) -> Option<&SingularStep> {
        self.stopped.as_ref()
    }

    fn stop(&mut self, reason: Reason) -> Option<ProjectivePoint<T, N>> {
        let eps = self.eps.approximate();
        self.stopped = Some(SingularStep::because(reason, f64::NAN, f64::INFINITY, eps));
        None
    }

    /// Returns the next point if it is the first, if it belongs to a passage through a pole, or if
    /// `next` rejected the ordinary step to it.
    #[cold]
    fn next_beyond_steps(&mut self) -> Option<ProjectivePoint<T, N>> {
        match mem::replace(&mut self.at, OrbitPosition::Nowhere) {
            OrbitPosition::First(x) => Some(self.at_point(x)),
            OrbitPosition::Point { x, .. } => self.after(x),
            OrbitPosition::Passage(passage) => self.continue_passage(passage),
            OrbitPosition::Nowhere => None,
        }
    }

    fn after(&mut self, x: SVector<T, N>) -> Option<ProjectivePoint<T, N>> {
        let next = self.prepared.next(&x);
        if let Some(next) = &next
            && T::retains_digits(&self.map, &x, next, &self.eps, &mut false)
        {
            return Some(self.at_point(next.clone()));
        }
        if !x.iter().all(T::is_finite_number) {
            return self.stop(Reason::NotFinite);
        }
        match self.begin(x) {
            Ok(point) => Some(point),
            Err(NoLimit::Ambiguous) => self.stop(Reason::Indeterminate),
            // Without a limit, the orbit continues with the ordinary step if that is finite.
            Err(NoLimit::Unknown) => match next.filter(|next| next.iter().all(T::is_finite_number)) {
                Some(next) => Some(self.at_point(next)),
                None => self.stop(Reason::Unfollowed),
            },
        }
    }

    fn at_point(&mut self, x: SVector<T, N>) -> ProjectivePoint<T, N> {
        self.at = OrbitPosition::point(x.clone());
        x.into()
    }

    fn begin(&mut self, x: SVector<T, N>) -> Result<ProjectivePoint<T, N>, NoLimit> {
        if N > MOST_VARIABLES {
            return Err(NoLimit::Unknown);
        }
        let mut passage = Box::new(Passage::from(&self.map, &self.eps, x));
        let place = passage.advance()?;
        Ok(self.arrive(passage, place))
    }

    fn continue_passage(&mut self, mut passage: Box<Passage<M, T, N>>) -> Option<ProjectivePoint<T, N>> {
        match passage.advance() {
            Ok(place) => Some(self.arrive(passage, place)),
            Err(NoLimit::Ambiguous) => self.stop(Reason::Indeterminate),
            Err(NoLimit::Unknown) => self.leave_passage(*passage),
        }
    }

    fn arrive(&mut self, passage: Box<Passage<M, T, N>>, place: PassagePoint<T, N>) -> ProjectivePoint<T, N> {
        let PassagePoint { point, is_through } = place;
        let is_over =
            is_through == Some(true) || (passage.steps_taken() >= MOST_STEPS && !point.is_infinite());
        self.at = match point.clone().affine() {
            Some(x) if is_over => OrbitPosition::point(x),
            _ => OrbitPosition::Passage(passage),
        };
        point
    }

    /// Ends the passage, and continues from its last point if this point is finite.
    fn leave_passage(&mut self, passage: Passage<M, T, N>) -> Option<ProjectivePoint<T, N>> {
        match passage.into_last_point().and_then(ProjectivePoint::affine) {
            Some(x) => self.after(x),
            None => self.stop(Reason::Unfollowed),
        }
    }
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> Iterator for Projective<M, T, N> {
    type Item = ProjectivePoint<T, N>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        // Updates the state in place, because a moved state would slow down the orbit.
        if let OrbitPosition::Point { x, is_flat } = &mut self.at
            && let Some(next) = self.prepared.next(x)
            && T::retains_digits(&self.map, x, &next, &self.eps, is_flat)
        {
            x.clone_from(&next);
            return Some(next.into());
        }
        self.next_beyond_steps()
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
