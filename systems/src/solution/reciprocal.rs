//! Solutions of systems with ẋ = −x², which Kahan's method solves exactly. After the time t, x =
//! 1/T with T = t + α. After n steps of length 2ε, x = 1/(2εN) with N = n + τ. Here α and τ are
//! constants. The flows preserve K = xz + y², and the maps of E1 and E2 preserve K/(1 − ε²x²).

use core::marker::PhantomData;

use kahan_core::Scalar;
use kahan_core::nalgebra::SVector;

use super::{OutOfDomain, integer, require, shift_and_divisor};

/// A system with ẋ = −x², with the formulas for y and z on its trajectories.
pub trait ReciprocalFlow<T>: Sized {
    /// Returns an integral β of the flow, such as y/x or xy, at a point with these coordinates.
    fn beta(x: T, y: T) -> T;

    /// Returns the point of the trajectory at `time` = T = t + α.
    fn point(trajectory: &ReciprocalTrajectory<Self, T>, time: T) -> SVector<T, 3>;
}

/// A trajectory of the system S, with x = 1/T and T = t + α.
#[derive(Clone, Debug, PartialEq)]
pub struct ReciprocalTrajectory<S, T> {
    /// The constant α = 1/x₀ in T = t + α, where x₀ is x at t = 0.
    pub alpha: T,
    /// The value of the integral β ([`ReciprocalFlow::beta`]) on the trajectory.
    pub beta: T,
    /// The value γ of the integral K = xz + y².
    pub gamma: T,
    system: PhantomData<S>,
}

impl<S: ReciprocalFlow<T>, T: Scalar> ReciprocalTrajectory<S, T> {
    /// Returns the trajectory through `point` at t = 0. Fails if x = 0.
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

    /// Returns the point at time t. At the pole t = −α, exact scalars panic and floats become
    /// infinite or NaN. Beyond the pole, solutions that contain ln T are NaN.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        S::point(self, t.clone() + self.alpha.clone())
    }
}

/// A system with ẋ = −x² whose map has rational orbits, with the formulas for y and z.
pub trait ReciprocalMap<T>: Sized {
    /// Returns the map's integral β, such as y/x. `divisor` is 1 − ε²x².
    fn integral(x: T, y: T, divisor: T) -> T;

    /// Returns the point of the orbit at `double` = 2N = 2(n + τ).
    fn point(orbit: ReciprocalOrbit<Self, T>, double: T) -> SVector<T, 3>;
}

/// An orbit of the map of the system S, with x = 1/(2εN) and N = n + τ.
#[derive(Clone, Debug, PartialEq)]
pub struct ReciprocalOrbit<S, T> {
    /// Half the time step, ε.
    pub eps: T,
    /// The constant τ = 1/(2εx₀) in N = n + τ, where x₀ is x at n = 0.
    pub tau: T,
    /// The value of the integral β ([`ReciprocalMap::integral`]) on the orbit.
    pub beta: T,
    /// The value γ of the integral K̂ = (xz + y²)/(1 − ε²x²).
    pub gamma: T,
    system: PhantomData<S>,
}

impl<S: ReciprocalMap<T> + Clone, T: Scalar> ReciprocalOrbit<S, T> {
    /// Returns the orbit through `point` at n = 0. Fails if εx = 0 or ε²x² = 1.
    pub fn through(point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let [x, y, z] = point.clone().into();
        let (tau, divisor) = shift_and_divisor(&x, eps)?;
        let beta = S::integral(x.clone(), y.clone(), divisor.clone());
        let gamma = (x * z + y.clone() * y) / divisor;
        Ok(Self { eps: eps.clone(), tau, beta, gamma, system: PhantomData })
    }

    /// Returns the point after n steps; n may be negative. At the pole n = −τ, exact scalars panic
    /// and floats become infinite or NaN.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        S::point(self.clone(), integer::<T>(2) * (integer::<T>(n) + self.tau.clone()))
    }
}
