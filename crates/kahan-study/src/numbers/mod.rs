//! Scalar types of computations, and numbers in answers.

mod double_double;
pub mod exact;
mod number;
mod scalar;
mod typed;

pub use double_double::DoubleDouble;
pub use number::Number;
pub use scalar::{Printable, ScalarKind};
pub use typed::{number, whole};
