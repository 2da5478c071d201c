//! Periodic points of run-time maps, with exact proofs for rational cycles.
//!
//! In: a cycle in floats, which [`kahan_dynamics::periodic`] found. Out: a cycle of fractions near
//! it ([`rational`]) and its stability ([`circle`]), if such a cycle is found.

mod circle;
mod rational;
#[cfg(test)]
mod tests;

use kahan_core::nalgebra::DMatrix;
use kahan_core::{Step, Stopped, Workspace};
use kahan_dynamics::periodic::{Differentiable, Parametric};

use crate::MapAt;

pub use rational::{MOST_DIGITS, RationalCycle};

impl Differentiable for MapAt<f64> {
    /// # Panics
    /// If the length of `x` is not the dimension of the map.
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        let mut rows = vec![0.0; x.len() * x.len()];
        assert!(self.jacobian(x, &mut rows).is_ok(), "{} numbers for another number of variables", x.len());
        DMatrix::from_row_slice(x.len(), x.len(), &rows)
    }
}

/// A map with its derivative with respect to one parameter, or ε; made by [`MapAt::by`].
#[derive(Clone, Debug)]
pub struct ParametricAt {
    at: MapAt<f64>,
    /// The index of the parameter. The index after the last parameter stands for ε.
    place: usize,
}

impl MapAt<f64> {
    /// Returns the map with its derivative with respect to one parameter, given by its index in
    /// [`Field::parameters`](crate::Field::parameters). If `parameter` is `None`, the derivative is
    /// with respect to ε.
    ///
    /// # Panics
    /// If the index is out of range.
    #[must_use]
    pub fn by(&self, parameter: Option<usize>) -> ParametricAt {
        let parameters = self.map().parameters().len();
        assert!(parameter.is_none_or(|place| place < parameters), "the map has {parameters} parameters");
        ParametricAt { at: self.clone(), place: parameter.unwrap_or(parameters) }
    }
}

impl ParametricAt {
    /// Returns the index of the parameter of the derivative. The index after the last parameter
    /// stands for ε.
    #[must_use]
    pub fn place(&self) -> usize {
        self.place
    }
}

impl Step for ParametricAt {
    type Scalar = f64;
    type State = Vec<f64>;

    fn dimension(&self) -> usize {
        Step::dimension(&self.at)
    }

    fn eps(&self) -> &f64 {
        Step::eps(&self.at)
    }

    #[track_caller]
    fn advance(&self, x: &mut [f64], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        Step::advance(&self.at, x, steps, workspace)
    }

    #[track_caller]
    fn part(&self, eps: &f64, x: &mut [f64], workspace: &mut Workspace) -> Result<(), Stopped> {
        self.at.part(eps, x, workspace)
    }
}

impl Differentiable for ParametricAt {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        self.at.derivative(x)
    }
}

impl Parametric for ParametricAt {
    /// # Panics
    /// If the length of `x` is not the dimension of the map.
    fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        self.at.by_constant(self.place, x).expect("x has an entry a variable")
    }
}
