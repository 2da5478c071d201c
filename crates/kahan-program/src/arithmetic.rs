//! Arithmetics, in which programs run: field operations on values, and functions of them.

use core::convert::Infallible;

/// Field operations on values of one sort. Division may fail; so may a constant (a prime that
/// divides a denominator).
pub trait Arithmetic {
    /// The values.
    type Value: Clone;
    /// The constants of programs that run in this arithmetic.
    type Constant;

    /// Returns the value of a constant, where it has one.
    fn constant(&self, value: &Self::Constant) -> Option<Self::Value>;
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
    /// a · b + c; two roundings, unless the arithmetic has a way of its own that rounds less.
    #[inline]
    fn multiply_add(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.add(&self.multiply(a, b), c)
    }
    /// a · b − c, rounded like [`multiply_add`](Self::multiply_add)
    #[inline]
    fn multiply_subtract(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.subtract(&self.multiply(a, b), c)
    }
    /// a − b · c, rounded like [`multiply_add`](Self::multiply_add)
    #[inline]
    fn subtract_product(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.subtract(a, &self.multiply(b, c))
    }
    /// Whether a is zero.
    fn is_zero(&self, a: &Self::Value) -> bool;
    /// Whether elimination should rather divide by a: the larger one of floats; of exact values one
    /// that is not zero.
    fn is_better_pivot(&self, a: &Self::Value, than: &Self::Value) -> bool {
        self.is_zero(than) && !self.is_zero(a)
    }
    /// Whether a is a float so far from 0 and from the largest float that a formula may multiply by
    /// 1/a before it multiplies by a. Exact values never are.
    fn is_moderate(&self, _a: &Self::Value) -> bool {
        false
    }
}

/// An arithmetic in which the functions F have values.
pub trait Calls<F>: Arithmetic {
    /// f(a, b), or f(a) of a function of one argument; `None` outside its domain.
    fn call(&self, function: &F, a: &Self::Value, b: &Self::Value) -> Option<Self::Value>;
}

impl<A: Arithmetic> Calls<Infallible> for A {
    fn call(&self, function: &Infallible, _: &Self::Value, _: &Self::Value) -> Option<Self::Value> {
        match *function {}
    }
}
