//! Trajectories of E4 by Jacobi's elliptic functions.

use kahan_core::nalgebra::SVector;

use super::normal_form::{NormalForm, Symmetry};
use crate::solution::{OutOfDomain, require};
use crate::special::{Jacobi, Modulus, Real, jacobi};

/// A trajectory of E4 (Hone and Petrera, Table 5, i = 4). With T = t + α, and the functions sn, cn
/// and dn at λT for the modulus k, the point at time t is
///
///   x = (λ/2)(dn + k cn), y = (λ/2)(dn − k cn), z = kλ sn,
///
/// The field's symmetries, which change signs of x and y or map (x, y, z) to (y, x, −z), give the
/// other trajectories. H = ±λ²(1 − k²)/4, with the sign of xy, and K = λ²(1 + k²)/4.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// The time shift α in T = t + α.
    pub alpha: T,
    /// The rate λ > 0, for which λ² = (|x| + |y|)² + z².
    pub lambda: T,
    /// The modulus k, which is 1 if xy = 0.
    pub modulus: Modulus<T>,
    /// The symmetry that maps the point of the formula to the point of the trajectory.
    pub symmetry: Symmetry,
}

impl<T: Real> FlowSolution<T> {
    /// Returns the trajectory through `point` at t = 0. Fails at the fixed points x = y = 0.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        require(!(point[0].is_zero() && point[1].is_zero()), "x^2 + y^2 > 0")?;
        let (NormalForm { sum, difference, height, product }, symmetry) = NormalForm::same_signs(point);
        let large = sum.square() + height.square();
        let small = difference.square() + height.square();
        let lambda = large.sqrt();
        // With s = x + y and d = x − y, k² = (d² + z²)/(s² + z²) and 1 − k² = 4xy/(s² + z²).
        let modulus = Modulus::from_squares(&(small / large), &(T::from_int(4) * product / large));
        // With d = x − y, (sn, cn) = (z, d)/(kλ) at t = 0. If k = 0, the point is fixed.
        let alpha = if small.is_zero() {
            T::zero()
        } else {
            let size = small.sqrt();
            modulus.inverse(&(height / size), &(difference / size)) / lambda
        };
        Ok(Self { alpha, lambda, modulus, symmetry })
    }

    /// Returns the point at any real time t.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { alpha, lambda, modulus, symmetry } = self;
        let Jacobi { sn, cn, dn } = jacobi(&(*lambda * (*t + *alpha)), modulus);
        let amplitude = *lambda * modulus.k;
        symmetry.point(*lambda * dn, amplitude * cn, amplitude * sn)
    }
}
