//! The interface between a browser's tab and the project's libraries; both sides exchange JSON.
//!
//! In: a subject and a question of `kahan-study`, as JSON. Out: the answer as JSON, with HTML if
//! `kahan-draw` can show it. For an orbit also the columns as floats, since text of a hundred
//! thousand points would be slow. [`Asker`] answers. `border` has the functions that the page's
//! worker calls, and is the only file with `unsafe`. This crate must not know mathematics, nor the
//! look of the page.

mod ask;
mod plane;
mod scene;
mod shown;

#[cfg(target_arch = "wasm32")]
mod border;

pub use ask::{Answered, Asker};
