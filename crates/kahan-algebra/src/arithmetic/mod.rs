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
pub use sizes::{Size, Sizes};

use kahan_syntax::rational::Rational;

/// Field operations on values of one sort. Division may fail; so may a constant (a prime that
/// divides a denominator).
pub trait Arithmetic {
    /// The values.
    type Value: Clone;

    /// The value of an exact constant, where there is one.
    fn constant(&self, value: &Rational) -> Option<Self::Value>;
    /// a + b
    fn add(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// a − b
    fn subtract(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// a · b
    fn multiply(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// −a
    fn negate(&self, a: &Self::Value) -> Self::Value;
    /// a / b; `None` where b is zero (never for floats, which have infinities).
    fn divide(&self, a: &Self::Value, b: &Self::Value) -> Option<Self::Value>;
    /// a · b + c; as written, unless the arithmetic has a way of its own that rounds less.
    #[inline]
    fn multiply_add(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.add(&self.multiply(a, b), c)
    }
    /// a · b − c, likewise
    #[inline]
    fn multiply_subtract(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.subtract(&self.multiply(a, b), c)
    }
    /// a − b · c, likewise
    #[inline]
    fn subtract_product(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.subtract(a, &self.multiply(b, c))
    }
    /// Whether a step with this ε may be computed from 1/(2ε), see
    /// [`StepPlan`](crate::plan::StepPlan::has_inverse_step); never but for floats.
    fn has_inverse_step(&self, _eps: &Self::Value) -> bool {
        false
    }
    /// Whether a is zero.
    fn is_zero(&self, a: &Self::Value) -> bool;
    /// Whether elimination should rather divide by a: for floats the larger, elsewhere what is not
    /// zero.
    fn is_better_pivot(&self, a: &Self::Value, than: &Self::Value) -> bool {
        self.is_zero(than) && !self.is_zero(a)
    }
}
