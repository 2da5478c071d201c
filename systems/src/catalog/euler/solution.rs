//! The orbits and trajectories of the Euler top: those of E4 in other coordinates.
//!
//! E4 in (x − y, x + y, z) is the Euler top with α = (−1, −1, 1). Linear changes of variables
//! commute with Kahan's map, so a scaling xᵢ = cᵢXᵢ carries any α that it brings to this form,
//! together with a permutation of the axes.

use kahan_core::nalgebra::SVector;

use crate::e4;
use crate::solution::{OutOfDomain, require};
use crate::special::Real;

/// The linear change of variables that makes an Euler top E4: a permutation and a scaling of the
/// axes.
///
/// With rᵢ = βᵢ/αᵢ, β = (−1, −1, 1), the scaling xᵢ = cᵢXᵢ turns αᵢ into βᵢ when cⱼcₖ/cᵢ = rᵢ, so
/// cᵢ² = rⱼrₖ: real when the rᵢ have one sign. The permutation puts the axis whose α has a sign of
/// its own in the third place.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduction<T> {
    /// The axis of the top that stands in the first, second and third place.
    pub axes: [usize; 3],
    /// The scalings c of the axes in these places.
    pub scaling: [T; 3],
}

impl<T: Real> Reduction<T> {
    /// The change of variables for the coefficients α₁, α₂, α₃.
    ///
    /// # Errors
    /// Unless no coefficient is zero and not all have the same sign: such tops are not E4 over the
    /// real numbers.
    pub fn of(coefficients: &[T; 3]) -> Result<Self, OutOfDomain> {
        let nonzero = coefficients.iter().all(|a| a.is_positive() || a.is_negative());
        require(nonzero, "a1, a2, a3 != 0")?;
        let negative = coefficients.each_ref().map(Real::is_negative);
        let odd =
            (0..3).find(|&i| negative[i] != negative[(i + 1) % 3] && negative[i] != negative[(i + 2) % 3]);
        let odd = odd.ok_or(OutOfDomain { condition: "a1, a2, a3 of different signs" })?;
        let axes = [(odd + 1) % 3, (odd + 2) % 3, odd];
        let [r1, r2, r3] = [
            -T::one() / coefficients[axes[0]],
            -T::one() / coefficients[axes[1]],
            T::one() / coefficients[odd],
        ];
        let sign = r3.sign();
        let scaling = [(r2 * r3).sqrt(), (r3 * r1).sqrt(), sign * (r1 * r2).sqrt()];
        Ok(Self { axes, scaling })
    }

    /// A point of the top in the coordinates of E4.
    fn to_e4(&self, point: &SVector<T, 3>) -> SVector<T, 3> {
        let [difference, sum, height] =
            core::array::from_fn(|place| point[self.axes[place]] / self.scaling[place]);
        let half = T::half();
        SVector::from([(sum + difference) * half, (sum - difference) * half, height])
    }

    /// A point of E4 in the coordinates of the top.
    fn back_from_e4(&self, point: &SVector<T, 3>) -> SVector<T, 3> {
        let [x, y, z] = (*point).into();
        let mut result = SVector::from([T::zero(), T::zero(), T::zero()]);
        for (place, value) in [x - y, x + y, z].into_iter().enumerate() {
            result[self.axes[place]] = value * self.scaling[place];
        }
        result
    }
}

/// An orbit of the Euler top's map, for coefficients that are not all of one sign (sections 2 and
/// 5; derived here).
///
/// In `f64` the error at n is at most 16 ulp of the point's norm times its condition, as for
/// [`e4::Solution`].
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_systems::{EulerTop, euler};
///
/// let (top, eps) = ([1.0, -3.0, 1.0], 0.125);
/// let start = vector![0.5, 0.25, -0.75];
/// let solution = euler::Solution::through(&top, &start, &eps).unwrap();
/// let third = EulerTop { a1: 1.0, a2: -3.0, a3: 1.0 }.orbit(start, eps).nth(3).unwrap();
/// assert!((solution.at(3) - third).norm() < 1e-14);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<T> {
    /// The change of variables.
    pub reduction: Reduction<T>,
    /// The orbit of dE4, with the same ε and n.
    pub orbit: e4::Solution<T>,
}

impl<T: Real> Solution<T> {
    /// The orbit of the top with coefficients α₁, α₂, α₃ that has this point at n = 0; ε is half
    /// the time step.
    ///
    /// # Errors
    /// Where [`Reduction::of`] or [`e4::Solution::through`] has one.
    pub fn through(coefficients: &[T; 3], point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let reduction = Reduction::of(coefficients)?;
        let orbit = e4::Solution::through(&reduction.to_e4(point), eps)?;
        Ok(Self { reduction, orbit })
    }

    /// The point n steps on, or back for n < 0.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        self.reduction.back_from_e4(&self.orbit.at(n))
    }
}

/// A trajectory of the Euler top, for coefficients that are not all of one sign (section 3; derived
/// here).
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// The change of variables.
    pub reduction: Reduction<T>,
    /// The trajectory of E4, in the same time.
    pub trajectory: e4::FlowSolution<T>,
}

impl<T: Real> FlowSolution<T> {
    /// The trajectory of the top with coefficients α₁, α₂, α₃ that has this point at t = 0.
    ///
    /// # Errors
    /// Where [`Reduction::of`] or [`e4::FlowSolution::through`] has one.
    pub fn through(coefficients: &[T; 3], point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let reduction = Reduction::of(coefficients)?;
        let trajectory = e4::FlowSolution::through(&reduction.to_e4(point))?;
        Ok(Self { reduction, trajectory })
    }

    /// The point at time t, any real number.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        self.reduction.back_from_e4(&self.trajectory.at(t))
    }
}
