//! The interface between a browser's tab and the project's libraries.
//!
//! [`Asker`] answers the page's questions in JSON and HTML. Columns of orbits are floats, because
//! text would be slow.

mod ask;
mod plane;
mod scene;
mod shown;

#[cfg(target_arch = "wasm32")]
mod border;

pub use ask::{Answered, Asker};
