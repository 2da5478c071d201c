//! The trajectories of E9 where they are elementary or have Jacobi's functions: ξ = 0, 1, −1, 2,
//! 1/2.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::Real;
use crate::{e3, e4};

/// A trajectory of E9 in closed form (section 6.3); for other ξ there is the
/// [`Quadrature`](super::Quadrature).
#[derive(Clone, Debug, PartialEq)]
pub enum FlowSolution<T> {
    /// ξ = 0 (erratum B9): y is constant and (x, 0, z) a trajectory of E3, x = λ sech λT, z = λ
    /// tanh λT.
    Zero {
        /// The trajectory of (x, 0, z).
        plane: e3::FlowSolution<T>,
        /// The constant y.
        y: T,
    },
    /// ξ = 1: E3.
    One(e3::FlowSolution<T>),
    /// ξ = −1: E4.
    MinusOne(e4::FlowSolution<T>),
    /// ξ = 2 (erratum A9): elementary.
    Two(Elementary<T>),
    /// ξ = 1/2: the trajectory of ξ = 2 through (y, x, z), in the time t/2.
    Half(Elementary<T>),
}

/// A trajectory of E9 with ξ = 2: with w = 1/x² = 2/k² + 2b cosh(kt + φ),
///
/// x = s/√w, y = c/w, z = ẇ/(2w), where c = H₉ = y/x², k = 2√(2K₉) = 2√(x² + y² + z²), k²b² = c² +
/// 1/k².
#[derive(Clone, Debug, PartialEq)]
pub struct Elementary<T> {
    /// k, twice the radius of the sphere.
    pub k: T,
    /// b > 0.
    pub b: T,
    /// c, the value of H₉ = y x^(−2).
    pub c: T,
    /// φ, the phase at t = 0.
    pub phase: T,
    /// s, the sign of x.
    pub sign: T,
}

impl<T: Real> FlowSolution<T> {
    /// The trajectory of E9 with this ξ that has this point at t = 0.
    ///
    /// # Errors
    /// Unless ξ is 0, 1, −1, 2 or 1/2, and the point is not a fixed point: x ≠ 0 for ξ = 0 and ξ =
    /// 2, y ≠ 0 for ξ = 1/2 (other points of these planes move, but as points of E3's form), x² +
    /// y² > 0 for ξ = ±1.
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

    /// The point at time t, any real number.
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
    /// The trajectory of E9 with ξ = 2 that has this point at t = 0.
    ///
    /// # Errors
    /// Unless x ≠ 0: the plane x = 0 is kept, and its solutions are of E3's form.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        require(!x.is_zero(), "x != 0")?;
        let two = T::from_int(2);
        let k = two * (x.square() + y.square() + z.square()).sqrt();
        let square = x.square();
        let c = y / square;
        let b = (c.square() + T::one() / k.square()).sqrt() / k;
        // ẇ = 2wz = 2bk sinh φ at t = 0
        let phase = (z / (square * k * b)).asinh();
        Ok(Self { k, b, c, phase, sign: x.sign() })
    }

    /// The point at time t, any real number.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { k, b, c, phase, sign } = self;
        let two = T::from_int(2);
        let (sine, cosine) = (*k * *t + *phase).sinh_cosh();
        let w = two * (T::one() / k.square() + *b * cosine);
        vector![*sign / w.sqrt(), *c / w, *k * *b * sine / w]
    }
}
