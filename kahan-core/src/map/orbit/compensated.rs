//! Compensated orbits of floats. Each step adds the increment at the point to the point plus its
//! stored rounding error.

use nalgebra::{ArrayStorage, SMatrix};

use crate::field::linear::{components, vector};
use crate::step::advance_by;
use crate::{FloatScalar, KahanAt, KahanMap, PreparedStep, StateVector, Step, Stopped, Workspace};

use super::Orbit;

/// A map whose step exposes the increment, which compensated summation requires.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot carry rounding errors beside its points",
    label = "it does not tell the increments of its steps",
    note = "prepared maps of `kahan!` do, compositions of them, and maps that are read at run time; chains do not"
)]
pub trait Increments: Step {
    /// A point followed by its rounding error.
    type Carried: StateVector<Self::Scalar>;

    /// Returns the compensated map; see [`Orbit::compensated`](crate::Orbit::compensated).
    fn compensated(self) -> Compensated<Self>
    where
        Self: Sized,
    {
        Compensated(self)
    }

    /// Steps a point together with its rounding error, the carry. Returns `None` at a pole of an
    /// exact scalar.
    fn next_with_carry(&self, x: &Self::Carried, workspace: &mut Workspace) -> Option<Self::Carried>;

    /// Advances a point with its carry, the rounding error, by `steps` steps.
    ///
    /// # Errors
    /// Returns the errors of [`Step::advance`].
    /// # Panics
    /// Panics as [`Step::advance`] does.
    #[inline]
    fn advance_with_carry(
        &self,
        x: &mut [Self::Scalar],
        steps: u64,
        workspace: &mut Workspace,
    ) -> Result<(), Stopped> {
        advance_by(x, steps, self.eps(), |state| self.next_with_carry(state, workspace))
    }
}

/// A map on points with their rounding errors; see [`Orbit::compensated`].
///
/// A state is a point followed by its carry, the rounding error. Hence a state has twice the map's
/// dimension. The carry is initially zero. The exact sum point + carry is the position on the
/// orbit. A [part](Step::part) of a step changes only the point.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_core::{Increments, Orbit, Step};
///
/// kahan! {
///     /// A circle around the origin.
///     pub struct Turn;
///     xdot = y;
///     ydot = -x;
/// }
///
/// let map = Turn.at(0.05).compensated();
/// let mut orbit = Orbit::new(&map, map.state(&[1.0, 0.0]));
/// // The point alone is yielded.
/// assert_eq!(orbit.nth(100), Turn.orbit(vector![1.0, 0.0], 0.05).compensated().nth(100));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compensated<S>(
    /// The map whose orbits are compensated.
    pub S,
);

impl<S: Increments> Step for Compensated<S> {
    type Scalar = S::Scalar;
    type State = S::Carried;

    fn dimension(&self) -> usize {
        2 * self.0.dimension()
    }

    fn eps(&self) -> &S::Scalar {
        self.0.eps()
    }

    #[inline]
    fn advance(&self, x: &mut [S::Scalar], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        self.0.advance_with_carry(x, steps, workspace)
    }

    fn part(&self, eps: &S::Scalar, x: &mut [S::Scalar], workspace: &mut Workspace) -> Result<(), Stopped> {
        let (point, _) = x.split_at_mut(self.0.dimension());
        self.0.part(eps, point, workspace)
    }

    #[inline(always)]
    fn next(&self, x: &S::Carried, workspace: &mut Workspace) -> Option<S::Carried> {
        self.0.next_with_carry(x, workspace)
    }
}

impl<S: Increments> Increments for &S {
    type Carried = S::Carried;

    #[inline(always)]
    fn next_with_carry(&self, x: &S::Carried, workspace: &mut Workspace) -> Option<S::Carried> {
        S::next_with_carry(self, x, workspace)
    }

    #[inline]
    fn advance_with_carry(
        &self,
        x: &mut [S::Scalar],
        steps: u64,
        workspace: &mut Workspace,
    ) -> Result<(), Stopped> {
        S::advance_with_carry(self, x, steps, workspace)
    }
}

impl<M: KahanMap<T, N>, T: FloatScalar, const N: usize> Increments for KahanAt<M, T, N> {
    type Carried = SMatrix<T, N, 2>;

    #[inline(always)]
    fn next_with_carry(&self, x: &SMatrix<T, N, 2>, _room: &mut Workspace) -> Option<SMatrix<T, N, 2>> {
        let [point, carry] = x.data.0;
        let [point, carry] = self.prepared.next_with_carry(&vector(point), &vector(carry))?;
        Some(SMatrix::from_array_storage(ArrayStorage([*components(&point), *components(&carry)])))
    }
}

impl<S: Increments<Scalar: FloatScalar>> Orbit<S> {
    /// Continues this orbit with compensated (Kahan) summation. The rounding error of each addition
    /// x + (x̃ − x) is added in the next step.
    ///
    /// Benefit: a plain step rounds each component to half an ulp. A compensated step only has the
    /// error of its increment. Therefore the integrals of the map drift less.
    ///
    /// Limits: if the errors of increments have a nonzero mean, drift grows linearly. This drift is
    /// visible beyond about 10⁶ steps in `f32`. In `f64` it is visible if powers of ε round badly;
    /// then [`nearest_short_eps`](crate::nearest_short_eps) helps. Linear fields gain little. Near
    /// poles increments are inaccurate.
    ///
    /// Cost: seven operations per component. The times are in `benches/results`.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Motion along a circle around the origin, with a speed that depends on x.
    ///     pub struct Turn;
    ///     xdot = y*(2 + x);
    ///     ydot = -x*(2 + x);
    /// }
    ///
    /// let start = vector![1.0_f32, 0.0];
    /// let exact = Turn.orbit(vector![1.0, 0.0], 0.001_f32.into()).nth(100_000).unwrap();
    /// let error = |x: Option<SVector<f32, 2>>| (x.unwrap().map(f64::from) - exact).norm();
    /// let plain = error(Turn.orbit(start, 0.001).nth(100_000));
    /// let compensated = error(Turn.orbit(start, 0.001).compensated().nth(100_000));
    /// assert!(compensated < 0.2 * plain);
    /// ```
    #[inline]
    pub fn compensated(self) -> Orbit<Compensated<S>> {
        let carried = |state: S::State| {
            let point = state.as_slice();
            let mut carried = S::Carried::zeros(2 * point.len());
            carried.as_mut_slice()[..point.len()].copy_from_slice(point);
            carried
        };
        self.with_map(Compensated, carried)
    }
}
