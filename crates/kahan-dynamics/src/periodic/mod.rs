//! Periodic points: found, judged by their multipliers, and followed as ε or a parameter changes.
//!
//! In: a map with its derivative, and a point near a periodic one. Out: the points of the cycle,
//! how nearly the map closes it, and the eigenvalues of its derivative. Newton's method takes all
//! points of the cycle as unknowns, so that long cycles of unstable maps are found as well as short
//! ones.
//!
//! ```
//! use kahan_dynamics::periodic::{Stability, periodic_point};
//! use kahan_core::prelude::*;
//!
//! kahan! {
//!     /// A pendulum of sorts, with a saddle at (1, 0).
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
mod compiled;
mod condensed;
mod cycle;
mod flow;
mod flow_branch;
mod leaf;
mod newton;
mod returns;
#[cfg(test)]
mod tests;
mod turns;
mod unit;

use kahan_core::nalgebra::DMatrix;

use kahan_core::{Scalar, Step, Workspace};

pub use branch::{Branch, BranchPoint, Mark, branch};
pub use cycle::{NoPeriodicPoint, PeriodicPoint, Stability, periodic_point};
pub use flow::{Extrapolated, FlowCycle, flow_cycle};
pub use flow_branch::flow_branch;
pub use leaf::{Leaf, OnLeaf};
pub use returns::{CloseReturn, close_returns};
pub use turns::{Change, Turn};

/// A map with its derivative.
pub trait Differentiable: Step<Scalar: From<f64>> {
    /// x̃; not finite at a pole.
    fn image(&self, x: &[f64]) -> Vec<f64> {
        let mut image: Vec<Self::Scalar> = x.iter().map(|entry| (*entry).into()).collect();
        // Floats go on at poles.
        let _ = self.advance(&mut image, 1, &mut Workspace::new());
        image.iter().map(Scalar::approximate).collect()
    }

    /// ∂x̃/∂x; not finite at a pole.
    fn derivative(&self, x: &[f64]) -> DMatrix<f64>;
}

/// A map that depends on a number p, at one value of p.
pub trait Parametric: Differentiable {
    /// ∂x̃/∂p; not finite at a pole.
    fn by_parameter(&self, x: &[f64]) -> Vec<f64>;
}
