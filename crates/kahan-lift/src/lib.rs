//! Lifting: from an analytic ordinary differential equation to an equivalent quadratic one.
//!
//! In: a block of equations with functions, quotients and powers. Out: a [`Lift`], a quadratic
//! field in the states and in new variables, which stand for functions of the states. Formulas are
//! exact; floats serve only to choose a lift and to compute initial values. The crate must not know
//! Kahan's map: rules of `kahan-algebra` say which functions a map keeps.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

// A module uses only modules above it; a test checks the order.
mod laurent;

mod ring;

mod read;

mod table;

mod search;

mod equations;

mod linear;

mod energy;

mod quadratic;

mod embedding;

mod stability;

mod candidates;

mod choice;

mod names;

mod lift;

mod reembedding;

pub use choice::Which;
pub use embedding::{Called, Embedding, Input, Operation};
pub use equations::{Stated, stated};
pub use lift::{Along, Lift, NewVariable, Options, Relation, lift, lifts};
pub use reembedding::Reembedding;
pub use ring::Function;
