//! Periodic points of maps that are read at run time, and proofs over ℚ of those that are rational.
//!
//! In: a map at its ε for [`kahan_dynamics::periodic`], and a cycle that this found. Out: fractions
//! whose orbit closes exactly ([`rational`]), where there are such near the cycle, and how stable
//! it is ([`circle`]).

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
    /// If `x` has not an entry a variable.
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        let mut rows = vec![0.0; x.len() * x.len()];
        assert!(self.jacobian(x, &mut rows).is_ok(), "{} numbers for another number of variables", x.len());
        DMatrix::from_row_slice(x.len(), x.len(), &rows)
    }
}

/// A map whose derivative by one of its parameters, or by ε, is known, too; made by
/// [`MapAt::by`].
#[derive(Clone, Debug)]
pub struct ParametricAt {
    at: MapAt<f64>,
    /// The place of the parameter; that of ε is behind all of them.
    place: usize,
}

impl MapAt<f64> {
    /// This map, as one of those at all values of ε, or of the parameter at this place in
    /// [`Field::parameters`](crate::Field::parameters).
    ///
    /// # Panics
    /// If there is no such parameter.
    #[must_use]
    pub fn by(&self, parameter: Option<usize>) -> ParametricAt {
        let parameters = self.map().parameters().len();
        assert!(parameter.is_none_or(|place| place < parameters), "the map has {parameters} parameters");
        ParametricAt { at: self.clone(), place: parameter.unwrap_or(parameters) }
    }
}

/// Steps are those of the map.
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
    /// If `x` has not an entry a variable.
    fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        self.at.by_constant(self.place, x).expect("x has an entry a variable")
    }
}
