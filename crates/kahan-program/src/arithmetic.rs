//! Arithmetics in which programs run: field operations on values, and function calls.

use core::convert::Infallible;

/// Field operations on values of one type. Divisions may fail; constants too, modulo a prime.
pub trait Arithmetic {
    /// The type of values.
    type Value: Clone;
    /// The type of a program's constants.
    type Constant;

    /// Returns the value of a constant; `None` if this arithmetic has no value for it.
    fn constant(&self, value: &Self::Constant) -> Option<Self::Value>;
    /// Returns a + b.
    fn add(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// Returns a − b.
    fn subtract(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// Returns a · b.
    fn multiply(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// Returns −a.
    fn negate(&self, a: &Self::Value) -> Self::Value;
    /// Returns a / b; `None` if b is zero (floats return an infinity or NaN instead).
    fn divide(&self, a: &Self::Value, b: &Self::Value) -> Option<Self::Value>;
    /// Returns a · b + c, rounded twice unless the arithmetic overrides this.
    #[inline]
    fn multiply_add(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.add(&self.multiply(a, b), c)
    }
    /// Returns a · b − c, rounded like [`multiply_add`](Self::multiply_add).
    #[inline]
    fn multiply_subtract(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.subtract(&self.multiply(a, b), c)
    }
    /// Returns a − b · c, rounded like [`multiply_add`](Self::multiply_add).
    #[inline]
    fn subtract_product(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.subtract(a, &self.multiply(b, c))
    }
    /// Returns whether a is zero.
    fn is_zero(&self, a: &Self::Value) -> bool;
    /// Returns whether a is a better pivot: larger among floats, nonzero among exact values.
    fn is_better_pivot(&self, a: &Self::Value, than: &Self::Value) -> bool {
        self.is_zero(than) && !self.is_zero(a)
    }
    /// Returns whether a float is far enough from 0 and overflow to replace division by a with
    /// multiplication by 1/a. Exact values return `false`.
    fn is_moderate(&self, _a: &Self::Value) -> bool {
        false
    }
}

/// An arithmetic that can call the functions F.
pub trait Calls<F>: Arithmetic {
    /// Returns f(a, b), or f(a) for a function of one argument; `None` outside the domain of f.
    fn call(&self, function: &F, a: &Self::Value, b: &Self::Value) -> Option<Self::Value>;
}

impl<A: Arithmetic> Calls<Infallible> for A {
    fn call(&self, function: &Infallible, _: &Self::Value, _: &Self::Value) -> Option<Self::Value> {
        match *function {}
    }
}
