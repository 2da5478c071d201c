//! Trajectories of E9 in closed form, for ξ = 0, 1, −1, 2 and 1/2.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::Real;
use crate::{e3, e4};

/// A trajectory of E9 in closed form; see [`Quadrature`](super::Quadrature) for other ξ.
#[derive(Clone, Debug, PartialEq)]
pub enum FlowSolution<T> {
    /// The case ξ = 0 (erratum B9): y is constant, and x = λ sech λT, z = λ tanh λT as for E3.
    Zero {
        /// The trajectory of the point (x, 0, z).
        plane: e3::FlowSolution<T>,
        /// The constant coordinate y.
        y: T,
    },
    /// The case ξ = 1, which is E3.
    One(e3::FlowSolution<T>),
    /// The case ξ = −1, which is E4.
    MinusOne(e4::FlowSolution<T>),
    /// The case ξ = 2 (erratum A9), with elementary functions.
    Two(Elementary<T>),
    /// The case ξ = 1/2: the trajectory for ξ = 2 through (y, x, z), at time t/2.
    Half(Elementary<T>),
}

/// A trajectory of E9 for ξ = 2. With w = 1/x² = 2/k² + 2b cosh(kt + φ), the point at time t is
///
///   x = s/√w, y = c/w, z = ẇ/(2w),
///
/// where s is the sign of x, c = H₉ = y/x², k = 2√(2K₉) = 2√(x² + y² + z²) and k²b² = c² + 1/k².
#[derive(Clone, Debug, PartialEq)]
pub struct Elementary<T> {
    /// The constant k, which is twice the radius of the sphere.
    pub k: T,
    /// The constant b > 0, for which k²b² = c² + 1/k².
    pub b: T,
    /// The value c of the integral H₉ = y x^(−2).
    pub c: T,
    /// The phase φ at t = 0.
    pub phase: T,
    /// The sign s = ±1 of x.
    pub sign: T,
}

impl<T: Real> FlowSolution<T> {
    /// Returns the trajectory through `point` at t = 0. Fails unless ξ is 0, 1, −1, 2 or 1/2. Also
    /// fails in the plane x = 0 for ξ = 0 and 2, in the plane y = 0 for ξ = 1/2, and on the line x
    /// = y = 0 for ξ = ±1.
    pub fn through(xi: &T, point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        let two = T::from_int(2);
        if xi.is_zero() {
            let plane = e3::FlowSolution::through(&vector![x, T::zero(), z])?;
            Ok(Self::Zero { plane, y })
        } else if *xi == T::one() {
            e3::FlowSolution::through(point).map(Self::One)
        } else if *xi == -T::one() {
            e4::FlowSolution::through(point).map(Self::MinusOne)
        } else if *xi == two {
            Elementary::through(point).map(Self::Two)
        } else if *xi == T::half() {
            Elementary::through(&vector![y, x, z]).map(Self::Half)
        } else {
            Err(OutOfDomain { condition: "xi = 0, 1, -1, 2 or 1/2" })
        }
    }

    /// Returns the point at any real time t.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        match self {
            Self::Zero { plane, y } => {
                let [x, _, z] = plane.at(t).into();
                vector![x, *y, z]
            }
            Self::One(solution) => solution.at(t),
            Self::MinusOne(solution) => solution.at(t),
            Self::Two(solution) => solution.at(t),
            Self::Half(solution) => {
                let [y, x, z] = solution.at(&(*t * T::half())).into();
                vector![x, y, z]
            }
        }
    }
}

impl<T: Real> Elementary<T> {
    /// Returns the trajectory for ξ = 2 through `point` at t = 0. Fails if x = 0.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        require(!x.is_zero(), "x != 0")?;
        let two = T::from_int(2);
        let k = two * (x.square() + y.square() + z.square()).sqrt();
        let square = x.square();
        let c = y / square;
        let b = (c.square() + T::one() / k.square()).sqrt() / k;
        // At t = 0, ẇ = 2wz = 2bk sinh φ, where w = 1/x².
        let phase = (z / (square * k * b)).asinh();
        Ok(Self { k, b, c, phase, sign: x.sign() })
    }

    /// Returns the point at any real time t.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { k, b, c, phase, sign } = self;
        let two = T::from_int(2);
        let (sine, cosine) = (*k * *t + *phase).sinh_cosh();
        let w = two * (T::one() / k.square() + *b * cosine);
        vector![*sign / w.sqrt(), *c / w, *k * *b * sine / w]
    }
}
