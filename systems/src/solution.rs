//! What the explicit solutions have in common.
//!
//! Each system with a closed solution has two types in its module: `Solution`, the orbit of its
//! Kahan map, with `Solution::through(&point, &eps)` and `.at(n)` for any integer n, and
//! `FlowSolution`, the trajectory of its field, with `FlowSolution::through(&point)` and `.at(&t)`.
//! Systems with parameters take them first. The numbers that fix a solution are public fields under
//! the paper's names. `.at(0)` is the point given. Rational solutions work over every [`Scalar`],
//! so exactly over big rationals; the others over every [`Real`](crate::special::Real). Who does
//! not know the type of a system finds its trajectories through
//! [`Entry::flow`](crate::entry::Entry::flow), in 256 bits.

mod reciprocal;

use core::fmt;

use kahan_core::nalgebra::SVector;
use kahan_core::{Constant, Scalar};

use crate::special::Precise;

pub use reciprocal::{ReciprocalFlow, ReciprocalMap, ReciprocalOrbit, ReciprocalTrajectory};

/// A trajectory: the point at time t.
pub type Trajectory = Box<dyn Fn(&Precise) -> Vec<Precise>>;

/// The trajectories of a flow, from the parameters and the point at t = 0.
///
/// `None` where no solution of the closed form passes through the point, and for a point or
/// parameters of another number.
pub type ClosedFlow = fn(parameters: &[Precise], start: &[Precise]) -> Option<Trajectory>;

/// A solution as a trajectory.
pub(crate) fn trajectory<S: 'static, const N: usize>(
    solution: Result<S, OutOfDomain>,
    at: fn(&S, &Precise) -> SVector<Precise, N>,
) -> Option<Trajectory> {
    let solution = solution.ok()?;
    Some(Box::new(move |t| at(&solution, t).iter().copied().collect()))
}

/// Coordinates as a point, if there are N.
pub(crate) fn point<const N: usize>(coordinates: &[Precise]) -> Option<SVector<Precise, N>> {
    <[Precise; N]>::try_from(coordinates.to_vec()).ok().map(SVector::from)
}

/// No solution of the closed form passes through the point given: a condition on it fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfDomain {
    /// What has to hold, as a formula in the point's coordinates, ε and the parameters.
    pub condition: &'static str,
}

impl fmt::Display for OutOfDomain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no solution of this form passes through the point: it needs {}", self.condition)
    }
}

impl core::error::Error for OutOfDomain {}

/// The real branch that a hyperbolic or elliptic solution of a map belongs to; the map keeps it.
///
/// Between the two lies the set where det A vanishes for one sign of ε; no orbit crosses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// The branch that stays bounded and tends to the flow's solution as ε → 0.
    Inner,
    /// The branch beyond, which alternates in sign from step to step and has poles.
    Outer,
}

/// `Ok` if the condition holds.
pub(crate) fn require(holds: bool, condition: &'static str) -> Result<(), OutOfDomain> {
    if holds { Ok(()) } else { Err(OutOfDomain { condition }) }
}

/// τ = 1/(2εx) and 1 − ε²x², which a rational solution with x = 1/(2ε(n + τ)) needs.
pub(crate) fn shift_and_divisor<T: Scalar>(x: &T, eps: &T) -> Result<(T, T), OutOfDomain> {
    let scaled = eps.clone() * x.clone();
    require(!scaled.is_zero(), "eps x != 0")?;
    let divisor = T::one() - scaled.clone() * scaled.clone();
    require(!divisor.is_zero(), "eps^2 x^2 != 1")?;
    Ok((T::one() / (integer::<T>(2) * scaled), divisor))
}

/// 4N² − 1 = (2N − 1)(2N + 1).
pub(crate) fn square_less_one<T: Scalar + Copy>(shifted: T) -> T {
    let double = shifted + shifted;
    (double - T::one()) * (double + T::one())
}

/// An integer as a scalar.
pub(crate) fn integer<T: Scalar>(n: i64) -> T {
    T::constant(&Constant::integer(n))
}

/// (−1)ⁿ.
pub(crate) fn alternating<T: Scalar>(n: i64) -> T {
    if n % 2 == 0 { T::one() } else { -T::one() }
}
