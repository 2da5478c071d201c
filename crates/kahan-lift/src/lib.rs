//! Lifting: from an analytic ordinary differential equation to an equivalent quadratic one.
//!
//! In: a block of equations with functions, quotients and powers. Out: a [`Lift`], a quadratic
//! field in the states and in new variables, which stand for functions of the states. Formulas are
//! exact; floats serve only to choose a lift and to compute initial values. Kahan's map is
//! deliberately absent: rules of `kahan-algebra` tell which functions a map preserves.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

// Modules from bottom to top: each uses only those above, as a test checks.
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

pub use choice::LiftCriterion;
pub use embedding::{CalledFunction, Embedding, Input, Operation};
pub use equations::{EquationNames, stated};
pub use lift::{Lift, NewVariable, Options, Relation, RelationBehaviour, lift, lifts};
pub use reembedding::Reembedding;
pub use ring::Function;
