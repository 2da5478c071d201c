//! Names for the choice of settings, flows and cycles.
//!
//! Write `use kahan_dynamics::prelude::*;` together with `use kahan_core::prelude::*;`.

pub use crate::periodic::{Stability, branch, periodic_point};
pub use crate::{Flow, Need, Scene, Setting};
