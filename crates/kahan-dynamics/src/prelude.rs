//! Names for the choice of settings, flows and cycles.
//!
//! Use `use kahan_dynamics::prelude::*;` together with `use kahan_core::prelude::*;`.

pub use crate::periodic::{Stability, branch, periodic_point};
pub use crate::{Flow, Need, Scene, Setting};
