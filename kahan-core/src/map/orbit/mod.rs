//! Orbits as iterators.
//!
//! In: a map, its first point, ε. Out: x₀, x₁, …, each computed when asked for and not before
//! (exact points grow, so one more than wanted can cost more than all before it). What a step is
//! made of ([`Method`]) and how it is added to the point ([`Accumulation`]) are types: a mode costs
//! what it computes and nothing else. Nothing panics at a pole: an orbit over exact scalars ends
//! there and says why, one over floats goes on with numbers that are not finite. No allocation, no
//! `dyn`, nothing borrowed.

mod accumulation;
mod compensated;
mod method;
#[cfg(feature = "std")]
mod projective;
mod scaled;
mod times;

use core::fmt;
use core::iter::FusedIterator;

use nalgebra::SVector;

use crate::{Scalar, SingularStep};

use super::{KahanAt, KahanMap};

use accumulation::State;
pub use accumulation::{Accumulation, Compensated, Rounded};
pub use method::{Method, Single};
#[cfg(feature = "std")]
pub use projective::{Projective, ProjectivePoint, ThroughPoles};
pub use scaled::Scaled;

/// Methods and accumulations are those of this crate.
pub(crate) mod sealed {
    pub trait Sealed {}
}

/// The orbit x₀, x₁, … of a Kahan map, x₀ first; made by [`KahanMap::orbit`].
///
/// It holds the map and the prepared step, so what depends on ε and the parameters alone is
/// computed once; each point is bit for bit the [`step`](KahanMap::step) of the one before. Its
/// modes are other types of the same iterator:
///
/// | mode | made by | type |
/// |---|---|---|
/// | plain | [`KahanMap::orbit`] | `Orbit<M, T, N>` |
/// | compensated | [`compensated`](Self::compensated) | `Orbit<M, T, N, Single, Compensated>` |
/// | of higher order | [`composed`](Self::composed) | `Orbit<M, T, N, Composed>` |
/// | both | the two, in either order | `Orbit<M, T, N, Composed, Compensated>` |
///
/// [`projective`](Self::projective) turns a plain one into an iterator that goes on at poles.
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
pub struct Orbit<M, T, const N: usize, K = Single, A = Rounded>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
    A: Accumulation,
{
    map: M,
    eps: T,
    stages: K::Stages<M::Prepared>,
    /// The point given last, or x₀ before any was.
    state: A::State<T, N>,
    begun: bool,
    stopped: Option<SingularStep>,
}

impl<M, T, K, A, const N: usize> Orbit<M, T, N, K, A>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
    A: Accumulation,
{
    #[inline]
    pub(crate) fn begin(map: M, eps: T, stages: K::Stages<M::Prepared>, start: SVector<T, N>) -> Self {
        Self { map, eps, stages, state: State::begin(start), begun: false, stopped: None }
    }

    /// The map at its ε, by which this orbit goes.
    pub(crate) fn prepared(&self) -> KahanAt<M, T, N, K> {
        KahanAt { map: self.map.clone(), eps: self.eps.clone(), stages: self.stages.clone() }
    }

    /// The map and ε. Not `map()`, a name that iterators need.
    pub(crate) fn parts(&self) -> (&M, &T) {
        (&self.map, &self.eps)
    }

    /// The same orbit by other steps, from where it is.
    #[inline]
    pub(crate) fn with_stages<L: Method>(self, stages: L::Stages<M::Prepared>) -> Orbit<M, T, N, L, A> {
        let Self { map, eps, state, begun, stopped, .. } = self;
        Orbit { map, eps, stages, state, begun, stopped }
    }

    /// Why the orbit has ended: `Some` from the moment on when a step met a pole of an exact
    /// scalar.
    pub fn stopped(&self) -> Option<&SingularStep> {
        self.stopped.as_ref()
    }

    /// `steps` steps on, or as many as there are, or are wanted, each point seen; whether no pole
    /// was met.
    #[inline(always)]
    fn advance(&mut self, steps: u64, seer: &mut impl Sees<T, N>) -> bool {
        // A state of its own, which the compiler can keep in registers.
        let mut state = self.state.clone();
        for step in 1..=steps {
            if K::run(&self.stages, |step| state.advance(step)).is_none() {
                self.stopped = Some(SingularStep::pole(self.eps.approximate()));
                break;
            }
            seer.see(step, state.point());
            if seer.is_done() {
                break;
            }
        }
        self.state = state;
        self.stopped.is_none()
    }

    /// Shows the next point that the orbit would yield as that of step 0, and those of the `steps`
    /// steps after it, or as many as there are.
    #[inline(always)]
    pub(crate) fn show(&mut self, steps: u64, seer: &mut impl Sees<T, N>) {
        if let Some(first) = self.next() {
            seer.see(0, &first);
            if !seer.is_done() {
                self.advance(steps, seer);
            }
        }
    }
}

/// What sees the points of an orbit, to be inlined into its loop as no closure can be.
pub(crate) trait Sees<T, const N: usize> {
    /// The point after so many steps.
    fn see(&mut self, step: u64, point: &SVector<T, N>);

    /// Whether it has seen enough.
    fn is_done(&self) -> bool;
}

/// Nobody does.
impl<T, const N: usize> Sees<T, N> for () {
    #[inline(always)]
    fn see(&mut self, _step: u64, _point: &SVector<T, N>) {}

    #[inline(always)]
    fn is_done(&self) -> bool {
        false
    }
}

impl<M, T, K, A, const N: usize> Iterator for Orbit<M, T, N, K, A>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
    A: Accumulation,
{
    type Item = SVector<T, N>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        if self.stopped.is_some() {
            return None;
        }
        if self.begun && K::run(&self.stages, |step| self.state.advance(step)).is_none() {
            self.stopped = Some(SingularStep::pole(self.eps.approximate()));
            return None;
        }
        self.begun = true;
        Some(self.state.point().clone())
    }

    #[inline]
    fn nth(&mut self, n: usize) -> Option<Self::Item> {
        if self.stopped.is_some() {
            return None;
        }
        // Two loops rather than a sum, which could overflow.
        let arrived = self.advance(u64::from(self.begun), &mut ()) && self.advance(n as u64, &mut ());
        self.begun = true;
        arrived.then(|| self.state.point().clone())
    }
}

impl<M, T, K, A, const N: usize> FusedIterator for Orbit<M, T, N, K, A>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
    A: Accumulation,
{
}

impl<M, T, K, A, const N: usize> fmt::Debug for Orbit<M, T, N, K, A>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
    A: Accumulation,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { eps, state, stopped, .. } = self;
        f.debug_struct("Orbit")
            .field("eps", eps)
            .field("point", state.point())
            .field("stopped", stopped)
            .finish_non_exhaustive()
    }
}
