//! The solutions of systems with ẋ = −x², which Kahan's method solves exactly.
//!
//! A trajectory has x = 1/T with T = t + α, and an orbit of the map x = 1/(2εN) with N = n + τ.
//! Besides both keep K = xz + y², the map up to its denominator 1 − ε²x². What is particular to a
//! system is y, and how z follows from it.

use core::marker::PhantomData;

use kahan_core::Scalar;
use kahan_core::nalgebra::SVector;

use super::{OutOfDomain, integer, require, shift_and_divisor};

/// What is particular to the trajectories of a system with ẋ = −x².
pub trait ReciprocalFlow<T>: Sized {
    /// β, which is constant along a trajectory.
    fn beta(x: T, y: T) -> T;

    /// The point where T = t + α has this value.
    fn point(trajectory: &ReciprocalTrajectory<Self, T>, time: T) -> SVector<T, 3>;
}

/// A trajectory with x = 1/T, T = t + α, of the system S.
#[derive(Clone, Debug, PartialEq)]
pub struct ReciprocalTrajectory<S, T> {
    /// α = 1/x₀, the shift of time.
    pub alpha: T,
    /// β, by [`ReciprocalFlow::beta`].
    pub beta: T,
    /// γ, the value of K = xz + y².
    pub gamma: T,
    system: PhantomData<S>,
}

impl<S: ReciprocalFlow<T>, T: Scalar> ReciprocalTrajectory<S, T> {
    /// The trajectory with this point at t = 0.
    ///
    /// # Errors
    /// Unless x ≠ 0.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = point.clone().into();
        require(!x.is_zero(), "x != 0")?;
        Ok(Self {
            alpha: T::one() / x.clone(),
            beta: S::beta(x.clone(), y.clone()),
            gamma: x * z + y.clone() * y,
            system: PhantomData,
        })
    }

    /// The point at time t. At t = −α the trajectory has a pole: a panic for exact scalars, a
    /// result that is not finite for floats. Beyond it a rational formula continues analytically,
    /// and a logarithm has no value.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        S::point(self, t.clone() + self.alpha.clone())
    }
}

/// What is particular to the orbits of a system with ẋ = −x² whose map has rational solutions.
pub trait ReciprocalMap<T>: Sized {
    /// β, the value of the integral Ĥ, from x, y and 1 − ε²x².
    fn integral(x: T, y: T, divisor: T) -> T;

    /// The point where 2N = 2(n + τ) has this value.
    fn point(orbit: ReciprocalOrbit<Self, T>, double: T) -> SVector<T, 3>;
}

/// An orbit with x = 1/(2εN), N = n + τ, of the map of the system S.
#[derive(Clone, Debug, PartialEq)]
pub struct ReciprocalOrbit<S, T> {
    /// ε, half the time step.
    pub eps: T,
    /// τ = 1/(2εx₀), the shift of n.
    pub tau: T,
    /// β, the value of the integral Ĥ.
    pub beta: T,
    /// γ, the value of the integral K̂ = (xz + y²)/(1 − ε²x²).
    pub gamma: T,
    system: PhantomData<S>,
}

impl<S: ReciprocalMap<T> + Clone, T: Scalar> ReciprocalOrbit<S, T> {
    /// The orbit with this point at n = 0; ε is half the time step.
    ///
    /// # Errors
    /// Unless εx ≠ 0 and ε²x² ≠ 1.
    pub fn through(point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let [x, y, z] = point.clone().into();
        let (tau, divisor) = shift_and_divisor(&x, eps)?;
        let beta = S::integral(x.clone(), y.clone(), divisor.clone());
        let gamma = (x * z + y.clone() * y) / divisor;
        Ok(Self { eps: eps.clone(), tau, beta, gamma, system: PhantomData })
    }

    /// The point n steps on, or back for n < 0. At n = −τ the orbit has a pole: a panic for exact
    /// scalars, a result that is not finite for floats.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        S::point(self.clone(), integer::<T>(2) * (integer::<T>(n) + self.tau.clone()))
    }
}
