//! Programs drawn at random, and what they compute: what allocation and code are compared with.

mod allocation;
mod code;
mod draw;
#[cfg(unix)]
mod hostile;
mod refused;
mod run;

pub(crate) use draw::{Draw, random_program};
pub(crate) use run::{run, same, subtract_product};
