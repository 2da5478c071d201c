//! Computations with many orbits of a map: choice of the integrator, cycles, reference solutions.
//!
//! The input is a map of `kahan-core`, or any [`Step`](kahan_core::Step) with its derivative. The
//! output is a [`Setting`] for a [`Scene`], a cycle or branch of cycles ([`periodic`]), or a
//! [`Flow`]. Maps from text, plans and machine code belong to `kahan-runtime`.
//!
//! # Example
//!
//! ```
//! use kahan_core::prelude::*;
//! use kahan_dynamics::prelude::*;
//!
//! kahan! {
//!     /// Predator and prey.
//!     pub struct LotkaVolterra;
//!     xdot = x*(1 - y);
//!     ydot = y*(x - 1);
//! }
//!
//! let rest = periodic_point(&LotkaVolterra.at(0.05), &[0.9, 1.1], 1).unwrap();
//! assert_eq!(rest.stability(), Stability::Neutral);
//! let setting = Scene::trajectory(20.0, 1e-6).choose(&LotkaVolterra, &vector![1.5, 1.0]).unwrap();
//! assert!(setting.error() <= 1e-6);
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

// Each module imports only from modules listed before it (`tests/tests/layers.rs`).
mod flow;

pub mod periodic;

mod scene;

pub mod prelude;

pub use flow::{Flow, NoFlow};
pub use scene::{Need, NoSetting, Precision, Scene, Scheme, Setting, search};
