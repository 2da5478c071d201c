//! Orbits as iterators.
//!
//! In: a map at its ε, and its first state. Out: x₀, x₁, …, each computed when asked for and not
//! before (exact points grow, so one more than wanted can cost more than all before it). What a
//! step is made of, and what is carried beside a point, is the map's affair: a mode costs what it
//! computes and nothing else. Nothing panics at a pole: an orbit over exact scalars ends there and
//! says why, one over floats goes on with numbers that are not finite.

mod compensated;
#[cfg(feature = "std")]
mod projective;
mod scaled;
mod times;

use core::fmt;
use core::iter::FusedIterator;

use crate::step::check_length;
use crate::{PointOf, Scalar, SingularStep, StateVector, Step, Workspace};

pub use compensated::{Compensated, Increments};
#[cfg(feature = "std")]
pub use projective::{Projective, ProjectivePoint, ThroughPoles};
pub use scaled::Scaled;

/// The orbit x₀, x₁, … of a map S at its ε, x₀ first; made by [`KahanMap::orbit`], and of any map
/// by [`Orbit::new`].
///
/// It holds the prepared map, so what depends on ε and the parameters alone is computed once; each
/// point is bit for bit the [step](Step::next) of the one before. Its modes are other types of the
/// same iterator:
///
/// | mode | made by | map |
/// |---|---|---|
/// | plain | [`KahanMap::orbit`] | [`KahanAt`](crate::KahanAt) |
/// | compensated | [`compensated`](Self::compensated) | [`Compensated<KahanAt<…>>`](Compensated) |
/// | of higher order | [`composed`](Self::composed) | [`Composed<KahanAt<…>>`](crate::Composed) |
/// | both | the two, in either order | `Compensated<Composed<KahanAt<…>>>` |
/// | of a chain, of a map read at run time, of a map chosen at run time | [`Orbit::new`] | the map, `&map`, `&dyn Step<Scalar = f64>` |
///
/// What a mode carries beside the point is not yielded. [`projective`](Self::projective) turns a
/// plain one into an iterator that goes on at poles.
///
/// [`KahanMap::orbit`]: crate::KahanMap::orbit
///
/// # There and back
/// The map with −ε is the inverse map, so n steps and n steps back come home: exactly over exact
/// scalars. Over floats each of the 2n steps rounds, and the rest of the way carries its rounding
/// along. With φ the map, ‖∂φ⁻ᵏ(xₖ)‖ says by how much k steps back from xₖ enlarge an error there;
/// with δₖ the most that a step to xₖ rounds by (16 u ‖xₖ‖ at ordinary points), the rounding at
/// each xₖ counts once on the way there and once on the way back. The distance from x₀ at the end
/// is at most
///
/// δ₀ + 2 (‖∂φ⁻¹(x₁)‖ δ₁ + ‖∂φ⁻²(x₂)‖ δ₂ + … + ‖∂φ⁻ⁿ(xₙ)‖ δₙ)
///
/// in the maximum norm, up to terms of order u². On an orbit that stays on a curve or torus errors
/// grow at most in proportion to k, so the distance at most to n²; near chaos both grow
/// exponentially.
///
/// # Cost
/// [`nth`](Iterator::nth) runs as fast as a loop over [`KahanAt::step`](crate::KahanAt::step)
/// written by hand.
#[derive(Clone)]
#[must_use = "an orbit computes nothing until it is iterated"]
pub struct Orbit<S: Step> {
    pub(crate) map: S,
    /// The state given last, or the first one before any was.
    pub(crate) state: S::State,
    begun: bool,
    stopped: Option<SingularStep>,
    pub(crate) workspace: Workspace,
}

impl<S: Step> Orbit<S> {
    /// The orbit of a map from this state.
    ///
    /// # Panics
    /// If the state has not as many numbers as the map's.
    #[inline]
    pub fn new(map: S, start: S::State) -> Self {
        check_length(start.as_slice().len(), map.dimension());
        Self { map, state: start, begun: false, stopped: None, workspace: Workspace::new() }
    }

    /// Replaces the map and converts the state; keeps whether the orbit has begun or ended.
    #[inline]
    pub(crate) fn with_map<R: Step>(
        self,
        map_of: impl FnOnce(S) -> R,
        state_of: impl FnOnce(S::State) -> R::State,
    ) -> Orbit<R> {
        let Self { map, state, begun, stopped, workspace } = self;
        Orbit { map: map_of(map), state: state_of(state), begun, stopped, workspace }
    }

    /// Why the orbit has ended: `Some` from the moment on when a step met a pole of an exact
    /// scalar.
    pub fn stopped(&self) -> Option<&SingularStep> {
        self.stopped.as_ref()
    }

    /// Ends it at a pole.
    pub(crate) fn stop(&mut self) {
        self.stopped = Some(SingularStep::pole(self.map.eps().approximate()));
    }
}

impl<S: Step> Iterator for Orbit<S> {
    type Item = PointOf<S>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        if self.stopped.is_some() {
            return None;
        }
        if self.begun && self.state.step_with(&self.map, &mut self.workspace).is_none() {
            self.stop();
            return None;
        }
        self.begun = true;
        Some(self.state.to_point())
    }

    #[inline]
    fn nth(&mut self, n: usize) -> Option<Self::Item> {
        if self.stopped.is_some() {
            return None;
        }
        // No run of more steps than a counter holds ends.
        let steps = (n as u64).saturating_add(self.begun.into());
        self.begun = true;
        if let Err(stopped) = self.map.advance(self.state.as_mut_slice(), steps, &mut self.workspace) {
            self.stopped = Some(stopped.why);
            return None;
        }
        Some(self.state.to_point())
    }
}

impl<S: Step> FusedIterator for Orbit<S> {}

impl<S: Step> fmt::Debug for Orbit<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Orbit")
            .field("eps", self.map.eps())
            .field("point", &self.state.to_point())
            .field("stopped", &self.stopped)
            .finish_non_exhaustive()
    }
}
