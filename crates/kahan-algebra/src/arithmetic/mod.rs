//! The arithmetics in which a plan runs.

mod dual;
mod exact;
mod float;
mod functions;
mod linear;
mod modular;
mod sizes;

pub use dual::{Dual, DualNumber};
pub use exact::Exact;
pub use float::{Float32, Float64};
pub use functions::{Function, Functions};
pub use linear::{Solved, determinant, solve};
pub use modular::Modular;
pub use sizes::{Length, Size, Sizes};

pub use kahan_program::Arithmetic;

use kahan_syntax::rational::Rational;

/// An arithmetic whose constants are rational numbers.
pub trait OverRationals: Arithmetic<Constant = Rational> {}

impl<A: Arithmetic<Constant = Rational>> OverRationals for A {}
