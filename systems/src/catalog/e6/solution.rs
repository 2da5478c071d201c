//! Orbits and trajectories of E6, which in the coordinates (x − z, x + z, y) is the Euler top with
//! α = (1, −3, 1).

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::euler;
use crate::solution::OutOfDomain;
use crate::special::Real;

/// An orbit of the map of E6 by Jacobi's elliptic functions. In `f64` the error is at most 6 ulp of
/// the point's norm, times the condition number stated at [`e4::Solution`](crate::e4::Solution).
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<T> {
    /// The orbit of the Euler top with α = (1, −3, 1), in the coordinates (x − z, x + z, y).
    pub top: euler::Solution<T>,
}

impl<T: Real> Solution<T> {
    /// Returns the orbit through `point` at n = 0. Fails if ε = 0, if (x, y, z) is a multiple of
    /// (1, 0, 1), or if ε²(x + z)² = 1.
    pub fn through(point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let top = euler::Solution::through(&coefficients(), &to_top(point), eps)?;
        Ok(Self { top })
    }

    /// Returns the point after n steps; n may be negative.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        from_top(&self.top.at(n))
    }
}

/// A trajectory of E6 by Jacobi's elliptic functions.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// The trajectory of the Euler top with α = (1, −3, 1), in the coordinates (x − z, x + z, y).
    pub top: euler::FlowSolution<T>,
}

impl<T: Real> FlowSolution<T> {
    /// Returns the trajectory through `point` at t = 0. Fails at fixed points, multiples of (1, 0,
    /// 1).
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        Ok(Self { top: euler::FlowSolution::through(&coefficients(), &to_top(point))? })
    }

    /// Returns the point at any real time t.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        from_top(&self.top.at(t))
    }
}

fn coefficients<T: Real>() -> [T; 3] {
    [T::one(), T::from_int(-3), T::one()]
}

fn to_top<T: Real>(point: &SVector<T, 3>) -> SVector<T, 3> {
    let [x, y, z] = (*point).into();
    vector![x - z, x + z, y]
}

fn from_top<T: Real>(point: &SVector<T, 3>) -> SVector<T, 3> {
    let [difference, sum, y] = (*point).into();
    vector![(sum + difference) * T::half(), y, (sum - difference) * T::half(),]
}
