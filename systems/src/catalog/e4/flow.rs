//! The trajectories of E4: Jacobi's elliptic functions.

use kahan_core::nalgebra::SVector;

use super::normal_form::{NormalForm, Symmetry};
use crate::solution::{OutOfDomain, require};
use crate::special::{Jacobi, Modulus, Real, jacobi};

/// A trajectory of E4 (Table 5, i = 4): with T = t + α and sn, cn, dn at λT, modulus k,
///
/// x = (λ/2)(dn + k cn), y = (λ/2)(dn − k cn), z = kλ sn, up to the signs of x and y and the swap
/// (x, y, z) → (y, x, −z), all symmetries of the field. With xy > 0: H = λ²(1 − k²)/4, K = λ²(1 +
/// k²)/4.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// α, the shift of time.
    pub alpha: T,
    /// λ > 0, the rate; λ² = (|x| + |y|)² + z².
    pub lambda: T,
    /// The modulus k; 1 where xy = 0.
    pub modulus: Modulus<T>,
    /// What leads from the formula to the trajectory.
    pub symmetry: Symmetry,
}

impl<T: Real> FlowSolution<T> {
    /// The trajectory with this point at t = 0.
    ///
    /// # Errors
    /// Unless x² + y² > 0: a point (0, 0, z) is a fixed point.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        require(!(point[0].is_zero() && point[1].is_zero()), "x^2 + y^2 > 0")?;
        let (NormalForm { sum, difference, height, product }, symmetry) = NormalForm::same_signs(point);
        let large = sum.square() + height.square();
        let small = difference.square() + height.square();
        let lambda = large.sqrt();
        // k² = (d² + z²)/(s² + z²), 1 − k² = 4xy/(s² + z²)
        let modulus = Modulus::from_squares(&(small / large), &(T::from_int(4) * product / large));
        // (sn, cn) at t = 0 are (z, d)/(kλ); k = 0 is the fixed point x = y, z = 0.
        let alpha = if small.is_zero() {
            T::zero()
        } else {
            let size = small.sqrt();
            modulus.inverse(&(height / size), &(difference / size)) / lambda
        };
        Ok(Self { alpha, lambda, modulus, symmetry })
    }

    /// The point at time t, any real number.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { alpha, lambda, modulus, symmetry } = self;
        let Jacobi { sn, cn, dn } = jacobi(&(*lambda * (*t + *alpha)), modulus);
        let amplitude = *lambda * modulus.k;
        symmetry.point(*lambda * dn, amplitude * cn, amplitude * sn)
    }
}
