//! Lifting: from any analytic ordinary differential equation to an equivalent quadratic one.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod laurent;
pub mod ring;
mod read;
pub mod search;
mod table;
pub mod equations;
