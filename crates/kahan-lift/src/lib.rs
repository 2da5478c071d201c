//! Lifting turns an analytic ordinary differential equation into an equivalent quadratic one.
//!
//! The input is a block of equations with functions, quotients and powers. The output is a
//! [`Lift`], a quadratic field in the states and in new variables. Each new variable stands for a
//! function of the states, or for the work of forces. Formulas are exact. Floats serve to choose a
//! lift, to compute initial values, and to project points onto relations. `kahan-algebra` finds
//! what Kahan's map preserves.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

// Each module uses only modules that are declared above it. A test checks this.
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
