//! Periodic points of maps, their stability, and continuation in ε or a parameter.
//!
//! From a point near a cycle, the search returns the points of the cycle, the residual, and the
//! multipliers. Newton's method treats all points as unknowns (multiple shooting), so long cycles
//! of unstable maps are found, too.
//!
//! # Example
//!
//! ```
//! use kahan_dynamics::periodic::{Stability, periodic_point};
//! use kahan_core::prelude::*;
//!
//! kahan! {
//!     /// A nonlinear oscillator with a saddle at (1, 0).
//!     pub struct Pendulum;
//!     xdot = y;
//!     ydot = x^2 - x;
//! }
//!
//! let found = periodic_point(&Pendulum.at(0.1), &[0.9, 0.1], 1).unwrap();
//! assert!((found.points[0][0] - 1.0).abs() < 1e-12 && found.points[0][1].abs() < 1e-12);
//! assert_eq!(found.stability(), Stability::Saddle);
//! ```

mod branch;
mod changes;
mod compiled;
mod condensed;
mod cycle;
mod flow;
mod flow_branch;
mod level_set;
mod newton;
mod returns;
#[cfg(test)]
mod tests;
mod unit;

use kahan_core::nalgebra::DMatrix;

use kahan_core::{Scalar, Step, Workspace};

pub use branch::{Branch, BranchPoint, BranchPointKind, branch};
pub use changes::{BranchChange, ChangePoint};
pub use cycle::{NoPeriodicPoint, PeriodicPoint, Stability, periodic_point};
pub use flow::{Extrapolated, FlowCycle, flow_cycle};
pub use flow_branch::flow_branch;
pub use level_set::{LevelSet, OnLevelSet};
pub use returns::{CloseReturn, close_returns};

/// A map with its Jacobian.
pub trait Differentiable: Step<Scalar: From<f64>> {
    /// Returns the image of x, which is not finite at a pole.
    fn image(&self, x: &[f64]) -> Vec<f64> {
        let mut image: Vec<Self::Scalar> = x.iter().map(|entry| (*entry).into()).collect();
        // At a pole, floats become infinite or NaN, and callers test for this.
        let _ = self.advance(&mut image, 1, &mut Workspace::new());
        image.iter().map(Scalar::approximate).collect()
    }

    /// Returns ∂x̃/∂x at `x`, which is not finite at a pole.
    fn derivative(&self, x: &[f64]) -> DMatrix<f64>;
}

/// A map at one value of a parameter p.
pub trait Parametric: Differentiable {
    /// Returns ∂x̃/∂p at `x`, which is not finite at a pole.
    fn by_parameter(&self, x: &[f64]) -> Vec<f64>;
}
