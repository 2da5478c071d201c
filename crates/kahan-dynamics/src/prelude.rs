//! What a file that asks about orbits wants in scope beside `kahan_core::prelude::*`:
//! `use kahan_dynamics::prelude::*;`.

pub use crate::periodic::{Stability, branch, periodic_point};
pub use crate::{Flow, Need, Scene, Setting};
