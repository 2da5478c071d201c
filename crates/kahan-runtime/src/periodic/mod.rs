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
use kahan_dynamics::periodic::Differentiable;

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
