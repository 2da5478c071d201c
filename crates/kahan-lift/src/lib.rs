//! Lifting: from any analytic ordinary differential equation to an equivalent quadratic one.
//!
//! In: a block of equations with functions, quotients and powers. Out: a [`Lift`], a quadratic
//! field in the states and in new variables that stand for functions of them. All formulas are
//! exact; floats serve the choice between lifts and the first values of new variables. The crate
//! must not know Kahan's map: what a map keeps is found by its rules in `kahan-algebra`.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

// Each needs those before it only, which a test guards.
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
