//! Orbits and trajectories of the Euler top with nonzero α of both signs, derived from those of E4.
//! In the coordinates (x − y, x + y, z), E4 is the Euler top with α = (−1, −1, 1). Kahan's map
//! commutes with linear changes of variables, such as permuting and scaling the axes.

use kahan_core::nalgebra::SVector;

use crate::e4;
use crate::solution::{OutOfDomain, require};
use crate::special::Real;

/// The linear change of variables from an Euler top to E4, which permutes and scales the axes. The
/// axis whose α differs in sign from the other two becomes the third. Let β = (−1, −1, 1) and rᵢ =
/// βᵢ/αᵢ. The scaling xᵢ = cᵢXᵢ with cᵢ² = rⱼrₖ for {i, j, k} = {1, 2, 3} turns αᵢ into βᵢ.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduction<T> {
    /// The axes of the top that become the first, second and third coordinate of E4.
    pub axes: [usize; 3],
    /// The factor cᵢ that scales each axis, in the order of `axes`.
    pub scaling: [T; 3],
}

impl<T: Real> Reduction<T> {
    /// Returns the change of variables for the coefficients α₁, α₂, α₃. Fails if a coefficient is
    /// zero or if all have one sign.
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

    fn to_e4(&self, point: &SVector<T, 3>) -> SVector<T, 3> {
        let [difference, sum, height] =
            core::array::from_fn(|place| point[self.axes[place]] / self.scaling[place]);
        let half = T::half();
        SVector::from([(sum + difference) * half, (sum - difference) * half, height])
    }

    fn back_from_e4(&self, point: &SVector<T, 3>) -> SVector<T, 3> {
        let [x, y, z] = (*point).into();
        let mut result = SVector::from([T::zero(), T::zero(), T::zero()]);
        for (place, value) in [x - y, x + y, z].into_iter().enumerate() {
            result[self.axes[place]] = value * self.scaling[place];
        }
        result
    }
}

/// An orbit of the Euler top's map, for coefficients that do not all have one sign. In `f64` the
/// error is at most 16 ulp of the point's norm, multiplied by the condition of [`e4::Solution`].
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
    /// The change of variables from the top to E4.
    pub reduction: Reduction<T>,
    /// The corresponding orbit of the map of E4, with the same ε and n.
    pub orbit: e4::Solution<T>,
}

impl<T: Real> Solution<T> {
    /// Returns the orbit through `point` at n = 0 for the coefficients α₁, α₂, α₃. Fails if
    /// [`Reduction::of`] or [`e4::Solution::through`] does.
    pub fn through(coefficients: &[T; 3], point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let reduction = Reduction::of(coefficients)?;
        let orbit = e4::Solution::through(&reduction.to_e4(point), eps)?;
        Ok(Self { reduction, orbit })
    }

    /// Returns the point after n steps; n may be negative.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        self.reduction.back_from_e4(&self.orbit.at(n))
    }
}

/// A trajectory of the Euler top, for coefficients that do not all have one sign.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// The change of variables from the top to E4.
    pub reduction: Reduction<T>,
    /// The corresponding trajectory of E4, with the same t.
    pub trajectory: e4::FlowSolution<T>,
}

impl<T: Real> FlowSolution<T> {
    /// Returns the trajectory through `point` at t = 0 for the coefficients α₁, α₂, α₃. Fails if
    /// [`Reduction::of`] or [`e4::FlowSolution::through`] does.
    pub fn through(coefficients: &[T; 3], point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let reduction = Reduction::of(coefficients)?;
        let trajectory = e4::FlowSolution::through(&reduction.to_e4(point))?;
        Ok(Self { reduction, trajectory })
    }

    /// Returns the point at any real time t.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        self.reduction.back_from_e4(&self.trajectory.at(t))
    }
}
