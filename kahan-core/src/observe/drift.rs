//! The changes of integrals of motion along an orbit.

use core::array::from_fn;

use crate::Scalar;

use super::Observer;

/// An observer of integrals, which measures how far their values move from the initial values.
///
/// ```
/// use kahan_core::observe::Drift;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// A circle around the origin.
///     pub struct Turn;
///     xdot = y;
///     ydot = -x;
/// }
///
/// let radius = Drift::of(|x: &[f64]| [x[0] * x[0] + x[1] * x[1]]);
/// let [drifted] = Turn.orbit(vector![1.0, 0.0], 0.01).observe(1000, radius);
/// assert!(drifted.last <= drifted.max && drifted.max < 1e-13);
/// ```
#[derive(Clone, Debug)]
pub struct Drift<F, T, const M: usize> {
    integrals: F,
    first: [T; M],
    last: [T; M],
    /// For each integral I, the largest |I − I(x₀)|, or NaN after the first NaN.
    max: [f64; M],
}

/// The distance |I − I(x₀)|/|I(x₀)| of an integral I, or |I − I(x₀)| if I(x₀) = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Drifted {
    /// The maximum over all steps, NaN if the integral was ever NaN.
    pub max: f64,
    /// The relative distance after the last step.
    pub last: f64,
}

impl<F: Fn(&[T]) -> [T; M], T: Scalar, const M: usize> Drift<F, T, M> {
    /// Creates an observer of `integrals`, a function that computes all integrals at once.
    pub fn of(integrals: F) -> Self {
        let zeros = || from_fn(|_| T::zero());
        Self { integrals, first: zeros(), last: zeros(), max: [0.0; M] }
    }

    #[inline(always)]
    fn distance(&self, i: usize) -> f64 {
        (self.last[i].clone() - self.first[i].clone()).approximate().abs()
    }
}

impl<F: Fn(&[T]) -> [T; M], T: Scalar, const M: usize> Observer<T> for Drift<F, T, M> {
    type Report = [Drifted; M];

    const MAY_END: bool = false;

    #[inline(always)]
    fn observe(&mut self, step: u64, x: &[T]) {
        self.last = (self.integrals)(x);
        if step == 0 {
            self.first = self.last.clone();
        }
        for i in 0..M {
            let distance = self.distance(i);
            if distance > self.max[i] || distance.is_nan() {
                self.max[i] = distance;
            }
        }
    }

    fn report(self) -> [Drifted; M] {
        from_fn(|i| {
            let first = self.first[i].approximate().abs();
            let scale = if first == 0.0 { 1.0 } else { first };
            Drifted { max: self.max[i] / scale, last: self.distance(i) / scale }
        })
    }
}
