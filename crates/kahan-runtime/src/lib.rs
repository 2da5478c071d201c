//! Quadratic vector fields read at run time, as Kahan maps.
//!
//! In: a text in the language of `kahan!` ([`Field::parse`]) or a checked
//! [`System`](kahan_algebra::system::System), and values of its parameters ([`Field::with`]). Out:
//! a map over slices of any dimension ([`Map::at`]), a [`KahanMap`](kahan_core::KahanMap) over any
//! scalar ([`Map::as_kahan_map`]), orbits ([`Follow`]), exact orbits and their heights
//! ([`heights`]), and chains of a family ([`Lattice`]). The crate does not know the catalog.
//!
//! # Example
//!
//! Run-time maps and chains are [`Step`](kahan_core::Step)s like compiled maps, so that a program
//! can choose among them:
//!
//! ```
//! use kahan_core::Step;
//! use kahan_core::observe::first_crossing;
//! use kahan_runtime::{Field, FieldText, Lattice};
//!
//! let eps = 0.01; // half the time step
//! let spring = Field::parse("qdot = p; pdot = -q;").unwrap().map().unwrap().at(eps);
//! let text = "for i in periodic { q[i]dot = p[i]; p[i]dot = q[i-1] - 3*q[i] + q[i+1]; }";
//! let family = FieldText::new(text.to_owned(), "springs".to_owned()).family().unwrap().unwrap();
//! let none: [(&str, [f64; 1]); 0] = [];
//! let springs = Lattice::of(&family).at(eps, 5, none).unwrap();
//!
//! let choice: [&dyn Step<Scalar = f64>; 2] = [&spring, &springs];
//! for map in choice {
//!     // All masses begin at 1, at rest.
//!     let start = (0..map.dimension()).map(|k| if k % 2 == 0 { 1.0 } else { 0.0 }).collect();
//!     let crossing = first_crossing(map, start, 1000, |x| x[0]).unwrap();
//!     assert!((crossing.time - std::f64::consts::FRAC_PI_2).abs() < 1e-4);
//! }
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod at;
mod claim;
mod coefficients;
mod denominator;
mod diagnostics;
mod dimension;
mod end;
mod engine;
mod field;
mod follow;
mod fraction;
pub mod heights;
pub mod interpreted;
mod lattice;
mod line;
mod literal;
mod machine_code;
mod map;
mod observed;
pub mod orbit;
mod parameters;
mod periodic;
mod text;
pub mod threads;

pub use at::{
    Gradient, IntegralDrift, MachineFloat, MapAt, PassedPoleCount, PassedPoles, RuntimeFloat, RuntimePoint,
    WhileFinite,
};
pub use claim::ClaimError;
pub use coefficients::{ArrayRows, CoefficientError, Coefficients};
pub use diagnostics::Diagnostics;
pub use dimension::DimensionError;
pub use end::End;
pub use field::Field;
pub use follow::{Follow, Followed};
pub use fraction::Fraction;
pub use kahan_algebra::rational::Rational;
pub use kahan_algebra::variational::Sensitivity;
pub use kahan_core::{Composition, Level};
pub use lattice::{ChainAt, Lattice, LatticeError};
pub use map::Map;
pub use observed::{Observable, ObservationRequest, ObservedFloat, ObservedValue, Relations};
pub use parameters::{ParameterError, ParameterValue};
pub use periodic::{MOST_DIGITS as MOST_DIGITS_OF_CYCLES, ParametricAt, RationalCycle};
pub use text::FieldText;
