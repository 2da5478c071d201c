//! Orbits as iterators over the points x₀, x₁, …, each computed on demand.
//!
//! At a pole, an orbit over exact scalars ends and stores the reason. Over floats an orbit
//! continues with infinities or NaNs.

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

/// The orbit x₀, x₁, … of a map S at a fixed ε; see [`KahanMap::orbit`] and [`Orbit::new`].
///
/// Everything that depends only on ε and the parameters is computed once. Each point is bit for bit
/// the [step](Step::next) of the previous point. The type S of the map selects the mode:
///
/// | mode | made by | map |
/// |---|---|---|
/// | plain | [`KahanMap::orbit`] | [`KahanAt`](crate::KahanAt) |
/// | compensated | [`compensated`](Self::compensated) | [`Compensated<KahanAt<…>>`](Compensated) |
/// | of higher order | [`composed`](Self::composed) | [`Composed<KahanAt<…>>`](crate::Composed) |
/// | compensated, of higher order | both, in any order | `Compensated<Composed<KahanAt<…>>>` |
/// | plain, for chains and run-time maps | [`Orbit::new`] | the map, `&map`, `&dyn Step<…>` |
///
/// A compensated orbit yields points without their rounding errors.
/// [`projective`](Self::projective) continues a plain orbit through poles. [`nth`](Iterator::nth)
/// is as fast as a handwritten loop over [`KahanAt::step`](crate::KahanAt::step).
///
/// [`KahanMap::orbit`]: crate::KahanMap::orbit
///
/// # Forward and back
/// The map with −ε is the inverse map. Hence n steps forward and n steps back return to x₀; over
/// exact scalars they return exactly. Over floats each of the 2n steps rounds, and later steps
/// propagate the errors. Let φ be the map, and let δₖ bound the rounding error of a forward or
/// backward step that ends at xₖ. Ordinary points have the bound δₖ = 16 u ‖xₖ‖, where u is the
/// rounding unit. The final distance from x₀ in the maximum norm is at most
///
///   δ₀ + 2 (‖∂φ⁻¹(x₁)‖ δ₁ + ‖∂φ⁻²(x₂)‖ δ₂ + … + ‖∂φ⁻ⁿ(xₙ)‖ δₙ)
///
/// up to terms of order u². On a periodic or quasi-periodic orbit the distance grows at most like
/// n², in chaotic regions exponentially.
#[derive(Clone)]
#[must_use = "an orbit computes nothing until it is iterated"]
pub struct Orbit<S: Step> {
    pub(crate) map: S,
    /// The last yielded state, or the initial state before the first point is yielded.
    pub(crate) state: S::State,
    begun: bool,
    stopped: Option<SingularStep>,
    pub(crate) workspace: Workspace,
}

impl<S: Step> Orbit<S> {
    /// Creates the orbit of a map that starts at this state.
    ///
    /// # Panics
    /// If the length of the state is not the map's dimension.
    #[inline]
    pub fn new(map: S, start: S::State) -> Self {
        check_length(start.as_slice().len(), map.dimension());
        Self { map, state: start, begun: false, stopped: None, workspace: Workspace::new() }
    }

    #[inline]
    pub(crate) fn with_map<R: Step>(
        self,
        map_of: impl FnOnce(S) -> R,
        state_of: impl FnOnce(S::State) -> R::State,
    ) -> Orbit<R> {
        let Self { map, state, begun, stopped, workspace } = self;
        Orbit { map: map_of(map), state: state_of(state), begun, stopped, workspace }
    }

    /// Returns the reason why the orbit has ended. An orbit ends only at a pole of an exact scalar.
    pub fn stopped(&self) -> Option<&SingularStep> {
        self.stopped.as_ref()
    }

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
        // A sum that saturates is harmless, because 2⁶⁴ steps never end.
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
