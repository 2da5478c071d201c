//! Kahan's method for quadratic differential equations: `kahan!` turns ẋ = f(x) into its birational map x ↦ x̃.
//!
//! A field f(x) = Q(x) + Bx + c, with Q(x,y) the symmetric bilinear form of Q, has the map
//! (x̃ − x)/(2ε) = Q(x,x̃) + ½B(x + x̃) + c, which is linear in x̃ and is inverted by ε ↦ −ε.
//! **ε is half the time step** everywhere in this crate; [`eps_from_dt`] converts.
//!
//! ```
//! use kahan_core::prelude::*;
//!
//! kahan! {
//!     pub struct LotkaVolterra;
//!     xdot = x*(1 - y);
//!     ydot = y*(x - 1);
//! }
//!
//! let (start, eps) = (vector![0.5, 1.7], 0.05);
//! let next = LotkaVolterra.step(&start, eps);
//! assert!((LotkaVolterra.step_back(&next, eps) - start).norm() < 1e-15);
//! let after_a_hundred = LotkaVolterra.orbit(start, eps).compensated().nth(1000);
//! ```
//!
//! Begin with [`kahan!`], the language of fields and of what is claimed about them; then [`KahanMap`], all that a system can do;
//! [`Orbit`] and [`Composition`], long runs and higher orders; [`Ensemble`], many trajectories at once; [`Scene`], the cheapest
//! setting that is accurate enough.
//!
//! In: a system written with [`kahan!`], or the two traits [`QuadraticField`] and [`KahanMap`] written by hand.
//! Out: steps, matrices, Jacobians and orbits over any [`Scalar`]: `f32`, `f64`, exact rationals, or the user's.
//! Nothing here knows the syntax of fields or algebra with symbols; that lies behind the macro.
//! Without default features the crate is `no_std`; float scalars never allocate in any configuration.

#![no_std]

#[cfg(any(test, feature = "std"))]
extern crate std;

mod composition;
mod elimination;
#[cfg(feature = "std")]
mod ensemble;
mod epsilon;
mod error;
mod error_estimate;
mod field;
#[cfg(feature = "std")]
mod flow;
mod kahan_macro;
mod lift;
mod linear;
mod map;
mod named;
mod orbit;
mod prepared;
mod prepared_step;
mod scalar;
#[cfg(feature = "std")]
mod scene;
mod stable;
mod through_f64;
mod try_step;
mod vector_macro;

pub mod prelude;

#[doc(hidden)]
pub mod __private;

#[cfg(test)]
mod tests;

pub use composition::{Composed, ComposedAt, Composition, Method, PreparedMap, Single};
pub use elimination::Elimination;
#[cfg(feature = "std")]
pub use ensemble::{Axis, Ensemble, EnsembleScalar, Level, Reciprocal};
pub use epsilon::nearest_short_eps;
pub use error::SingularStep;
pub use error_estimate::{ErrorEstimates, Estimated};
pub use field::QuadraticField;
#[cfg(feature = "std")]
pub use flow::{Flow, FlowScalar, NoFlow};
pub use lift::Lift;
pub use map::{KahanMap, eps_from_dt};
pub use named::{Integrals, Named};
pub use orbit::{Accumulation, Compensated, Orbit, Rounded, Scaled};
pub use prepared::KahanAt;
pub use prepared_step::{PreparedStep, Quotients, StepCost, WideStep};
pub use scalar::{Constant, Dd, FloatScalar, Pivot, Scalar};
#[cfg(feature = "std")]
pub use scene::{Need, NoSetting, Precision, Scene, Setting};
pub use through_f64::ThroughF64;

pub use nalgebra;
#[cfg(feature = "exact")]
pub use num_rational;
pub use num_traits;

/// The examples of the README, as tests.
#[cfg(all(doctest, feature = "exact"))]
#[doc = include_str!("../../README.md")]
struct Readme;
