//! Arithmetics in which programs run: field operations on values, and function calls.

use core::convert::Infallible;

/// The field operations on values of one type.
pub trait Arithmetic {
    /// The type of values.
    type Value: Clone;
    /// The type of a program's constants.
    type Constant;

    /// Returns the value of a constant; `None` if the constant is undefined in this arithmetic.
    fn constant(&self, value: &Self::Constant) -> Option<Self::Value>;
    /// Returns a + b.
    fn add(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// Returns a − b.
    fn subtract(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// Returns a · b.
    fn multiply(&self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// Returns −a.
    fn negate(&self, a: &Self::Value) -> Self::Value;
    /// Returns a / b; `None` if b is zero. Floats return an infinity or NaN instead of `None`.
    fn divide(&self, a: &Self::Value, b: &Self::Value) -> Option<Self::Value>;
    /// Returns a · b + c, rounded twice unless the arithmetic overrides this function.
    #[inline]
    fn multiply_add(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.add(&self.multiply(a, b), c)
    }
    /// Returns a · b − c with the rounding of [`multiply_add`](Self::multiply_add).
    #[inline]
    fn multiply_subtract(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.subtract(&self.multiply(a, b), c)
    }
    /// Returns a − b · c with the rounding of [`multiply_add`](Self::multiply_add).
    #[inline]
    fn subtract_product(&self, a: &Self::Value, b: &Self::Value, c: &Self::Value) -> Self::Value {
        self.subtract(a, &self.multiply(b, c))
    }
    /// Returns whether a is zero.
    fn is_zero(&self, a: &Self::Value) -> bool;
    /// Returns whether a is better than `than` as a pivot. By default, nonzero is better than zero.
    fn is_better_pivot(&self, a: &Self::Value, than: &Self::Value) -> bool {
        self.is_zero(than) && !self.is_zero(a)
    }
    /// Returns whether multiplication by the rounded 1/a may replace division by a.
    fn is_moderate(&self, _a: &Self::Value) -> bool {
        false
    }
}

/// An arithmetic that can call functions of type `F`.
pub trait Calls<F>: Arithmetic {
    /// Returns f(a, b) or f(a); `None` outside the domain of f.
    fn call(&self, function: &F, a: &Self::Value, b: &Self::Value) -> Option<Self::Value>;
}

impl<A: Arithmetic> Calls<Infallible> for A {
    fn call(&self, function: &Infallible, _: &Self::Value, _: &Self::Value) -> Option<Self::Value> {
        match *function {}
    }
}
