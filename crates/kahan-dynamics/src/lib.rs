//! Questions about a map that take many orbits of it: which setting is accurate enough, where its
//! orbits close, how far it is from the solution of the equation.
//!
//! In: maps of `kahan-core`, or any [`Step`](kahan_core::Step) with its derivative. Out: a
//! [`Setting`] for a [`Scene`], found by a [`search`] that takes other prices, too; cycles and
//! their branches ([`periodic`]), a [`Flow`]. It must not know where a map comes from: texts, plans
//! and machine code are `kahan-runtime`'s.
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

// From the bottom to the top: each of these imports from those above it only, which
// `tests/tests/layers.rs` sees to.
mod flow;

pub mod periodic;

mod scene;

// The door.
pub mod prelude;

pub use flow::{Flow, NoFlow};
pub use scene::{Need, NoSetting, Precision, Scene, Scheme, Setting, search};
