//! Shared definitions for closed formulas of orbits and trajectories.
//!
//! In the module of a system with closed formulas, `Solution` is an orbit of Kahan's map, with
//! `Solution::through(&point, &eps)`, and `.at(n)` for any integer n. `FlowSolution` is a
//! trajectory, with `FlowSolution::through(&point)` and `.at(&t)`. If the system has parameters,
//! `through` takes them before the point. Up to rounding, `.at(0)` is the given point. Rational
//! solutions accept every [`Scalar`], others every [`Real`](crate::special::Real).

mod reciprocal;

use core::fmt;

use kahan_core::nalgebra::SVector;
use kahan_core::{Constant, Scalar};

use crate::special::Float256;

pub use reciprocal::{ReciprocalFlow, ReciprocalMap, ReciprocalOrbit, ReciprocalTrajectory};

/// A trajectory, as a function from the time t to the point.
pub type Trajectory = Box<dyn Fn(&Float256) -> Vec<Float256>>;

/// A function from the parameters and the point at t = 0 to a trajectory. The result is `None` if
/// the closed formula does not hold at the point, or if an argument has the wrong length.
pub type ClosedFlow = fn(parameters: &[Float256], start: &[Float256]) -> Option<Trajectory>;

pub(crate) fn trajectory<S: 'static, const N: usize>(
    solution: Result<S, OutOfDomain>,
    at: fn(&S, &Float256) -> SVector<Float256, N>,
) -> Option<Trajectory> {
    let solution = solution.ok()?;
    Some(Box::new(move |t| at(&solution, t).iter().copied().collect()))
}

/// Converts coordinates to a point, or returns `None` unless there are N coordinates.
pub(crate) fn point<const N: usize>(coordinates: &[Float256]) -> Option<SVector<Float256, N>> {
    <[Float256; N]>::try_from(coordinates.to_vec()).ok().map(SVector::from)
}

/// The error that a closed formula for the solution does not hold at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfDomain {
    /// The condition that the point violates, as a formula.
    pub condition: &'static str,
}

impl fmt::Display for OutOfDomain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no solution of this form passes through the point: it needs {}", self.condition)
    }
}

impl core::error::Error for OutOfDomain {}

/// A real branch of a hyperbolic or elliptic solution, on which an orbit stays. At its boundary, a
/// step forward or backward is singular, with det A(x, ε) = 0 or det A(x, −ε) = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// The bounded branch, which for ε → 0 tends to the solution of the flow.
    Inner,
    /// The unbounded branch, which has poles.
    Outer,
}

pub(crate) fn require(holds: bool, condition: &'static str) -> Result<(), OutOfDomain> {
    if holds { Ok(()) } else { Err(OutOfDomain { condition }) }
}

/// Returns τ = 1/(2εx) and 1 − ε²x², for rational solutions with x = 1/(2ε(n + τ)) after n steps.
pub(crate) fn shift_and_divisor<T: Scalar>(x: &T, eps: &T) -> Result<(T, T), OutOfDomain> {
    let scaled = eps.clone() * x.clone();
    require(!scaled.is_zero(), "eps x != 0")?;
    let divisor = T::one() - scaled.clone() * scaled.clone();
    require(!divisor.is_zero(), "eps^2 x^2 != 1")?;
    Ok((T::one() / (integer::<T>(2) * scaled), divisor))
}

/// Returns 4N² − 1 for N = `shifted`.
pub(crate) fn square_less_one<T: Scalar + Copy>(shifted: T) -> T {
    let double = shifted + shifted;
    (double - T::one()) * (double + T::one())
}

pub(crate) fn integer<T: Scalar>(n: i64) -> T {
    T::constant(&Constant::integer(n))
}

pub(crate) fn alternating<T: Scalar>(n: i64) -> T {
    if n % 2 == 0 { T::one() } else { -T::one() }
}
