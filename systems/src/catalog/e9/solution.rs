//! Orbits of the map of E9 for ξ = 0, 1, −1. For other ξ the map is not integrable (Hone and
//! Petrera, Section 7).

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::OutOfDomain;
use crate::special::Real;
use crate::{e3, e4};

/// An orbit of the map of E9 in closed form.
#[derive(Clone, Debug, PartialEq)]
pub enum Solution<T> {
    /// The case ξ = 0: y is constant, and (x, 0, z) is on an orbit of the map of E3.
    Zero {
        /// The orbit of the point (x, 0, z).
        plane: e3::Solution<T>,
        /// The constant coordinate y.
        y: T,
    },
    /// The case ξ = 1, which is the map of E3.
    One(e3::Solution<T>),
    /// The case ξ = −1, which is the map of E4.
    MinusOne(e4::Solution<T>),
}

impl<T: Real> Solution<T> {
    /// Returns the orbit through `point` at n = 0. Fails if ξ is not 0, 1 or −1, or if
    /// [`e3::Solution::through`] or [`e4::Solution::through`] fails.
    pub fn through(xi: &T, point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        if xi.is_zero() {
            let [x, y, z] = (*point).into();
            let plane = e3::Solution::through(&vector![x, T::zero(), z], eps)?;
            Ok(Self::Zero { plane, y })
        } else if *xi == T::one() {
            e3::Solution::through(point, eps).map(Self::One)
        } else if *xi == -T::one() {
            e4::Solution::through(point, eps).map(Self::MinusOne)
        } else {
            Err(OutOfDomain { condition: "xi = 0, 1 or -1" })
        }
    }

    /// Returns the point after n steps; n may be negative.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        match self {
            Self::Zero { plane, y } => {
                let [x, _, z] = plane.at(n).into();
                vector![x, *y, z]
            }
            Self::One(solution) => solution.at(n),
            Self::MinusOne(solution) => solution.at(n),
        }
    }
}
