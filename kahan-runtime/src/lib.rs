//! Quadratic vector fields that are read at run time, as Kahan maps.
//!
//! In: a text in the language of `kahan!` ([`Field::parse`]) or a checked
//! [`System`](kahan_algebra::system::System), and values of its parameters ([`Field::with`]). Out:
//! a map over slices of any dimension ([`Map::at`]), a [`KahanMap`](kahan_core::KahanMap) over any
//! scalar ([`Map::as_kahan_map`]), exact orbits with the growth of their heights ([`heights`]), and
//! of a family chains of any number of sites ([`Lattice`]).
//! It must not know the catalog: a field comes from its caller. Beside them, how work is spread
//! over processors ([`threads`]).

mod at;
mod claim;
mod diagnostics;
mod dimension;
mod engine;
mod field;
pub mod heights;
mod indicator;
pub mod interpreted;
mod lattice;
mod line;
mod literal;
mod machine;
mod map;
mod operators;
pub mod orbit;
mod parameters;
mod periodic;
mod text;
pub mod threads;

pub use at::{IntegralDrift, MachineFloat, MapAt, RuntimePoint};
pub use claim::ClaimError;
pub use diagnostics::Diagnostics;
pub use dimension::DimensionError;
pub use field::Field;
pub use indicator::Indicator;
pub use kahan_algebra::rational::Rational;
pub use kahan_core::{Composition, Level};
pub use lattice::{ChainAt, Lattice, LatticeError};
pub use map::Map;
pub use parameters::{ParameterError, ParameterValue};
pub use periodic::{ParametricAt, RationalCycle};
pub use text::FieldText;
