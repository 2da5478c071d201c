//! The border between a browser's tab and the project's libraries: JSON in, JSON out.
//!
//! In: a subject and a question of `kahan-study`, as JSON. Out: the answer as JSON, with HTML where
//! `kahan-draw` sets or draws it; of an orbit the columns, too, as floats, since text of a hundred
//! thousand points would take longer than the points. [`Asker`] answers; `border` is what
//! the page's worker calls, and the only file with `unsafe`. This crate must not know mathematics,
//! nor what the page looks like.

mod ask;
mod plane;
mod scene;
mod shown;

#[cfg(target_arch = "wasm32")]
mod border;

pub use ask::{Answered, Asker};
