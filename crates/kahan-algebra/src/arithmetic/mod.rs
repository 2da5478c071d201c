//! The arithmetics that run plans, which are programs of arithmetic operations.

mod dual;
mod fields;
mod functions;
mod linear;
mod sizes;

pub use dual::{Dual, DualNumber};
pub use fields::{Exact, Float32, Float64, Modular};
pub use functions::{Function, Functions};
pub use linear::{Solved, determinant, solve};
pub use sizes::{FractionSize, PolynomialSize, SizeArithmetic};

pub use kahan_program::Arithmetic;

use kahan_syntax::rational::Rational;

/// An arithmetic with rational constants.
pub trait OverRationals: Arithmetic<Constant = Rational> {}

impl<A: Arithmetic<Constant = Rational>> OverRationals for A {}
