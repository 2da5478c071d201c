//! Dual numbers over any arithmetic.

use kahan_syntax::rational::Rational;

use super::{Arithmetic, OverRationals};

/// The arithmetic of dual numbers, which computes derivatives together with values.
#[derive(Debug)]
pub struct Dual<'a, A> {
    /// The arithmetic in which values and derivatives are computed.
    pub base: &'a A,
    /// The number of derivatives of each value.
    pub directions: usize,
}

/// A value and its gradient.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DualNumber<V> {
    /// The value.
    pub value: V,
    /// The derivatives. The list is empty for constants.
    pub gradient: Vec<V>,
}

impl<A: OverRationals> Dual<'_, A> {
    /// Returns a dual number with zero derivatives.
    pub fn fixed(&self, value: A::Value) -> DualNumber<A::Value> {
        DualNumber { value, gradient: Vec::new() }
    }

    /// Returns a variable with derivative 1 in one direction and 0 in all others. Returns `None` if
    /// the arithmetic has no 0 or 1.
    pub fn coordinate(&self, value: A::Value, direction: usize) -> Option<DualNumber<A::Value>> {
        let mut gradient = vec![self.base.constant(&Rational::zero())?; self.directions];
        gradient[direction] = self.base.constant(&Rational::one())?;
        Some(DualNumber { value, gradient })
    }

    fn combine(&self, alpha: &A::Value, a: &[A::Value], beta: &A::Value, b: &[A::Value]) -> Vec<A::Value> {
        let scaled = |factor: &A::Value, gradient: &[A::Value]| -> Vec<A::Value> {
            gradient.iter().map(|entry| self.base.multiply(factor, entry)).collect()
        };
        match (a.is_empty(), b.is_empty()) {
            (true, _) => scaled(beta, b),
            (_, true) => scaled(alpha, a),
            _ => scaled(alpha, a).iter().zip(scaled(beta, b)).map(|(a, b)| self.base.add(a, &b)).collect(),
        }
    }
}

impl<A: OverRationals> Arithmetic for Dual<'_, A> {
    type Value = DualNumber<A::Value>;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<Self::Value> {
        self.base.constant(value).map(|value| self.fixed(value))
    }

    fn add(&self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        let gradient = match (a.gradient.is_empty(), b.gradient.is_empty()) {
            (true, _) => b.gradient.clone(),
            (_, true) => a.gradient.clone(),
            _ => a.gradient.iter().zip(&b.gradient).map(|(a, b)| self.base.add(a, b)).collect(),
        };
        DualNumber { value: self.base.add(&a.value, &b.value), gradient }
    }

    fn subtract(&self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        self.add(a, &self.negate(b))
    }

    fn multiply(&self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        let gradient = self.combine(&b.value, &a.gradient, &a.value, &b.gradient);
        DualNumber { value: self.base.multiply(&a.value, &b.value), gradient }
    }

    fn negate(&self, a: &Self::Value) -> Self::Value {
        let gradient = a.gradient.iter().map(|entry| self.base.negate(entry)).collect();
        DualNumber { value: self.base.negate(&a.value), gradient }
    }

    fn divide(&self, a: &Self::Value, b: &Self::Value) -> Option<Self::Value> {
        // The derivative of a quotient is d(a/b) = (1/b) da − (a/b²) db.
        let one = self.base.constant(&Rational::one())?;
        let inverse = self.base.divide(&one, &b.value)?;
        let value = self.base.multiply(&a.value, &inverse);
        let slope = self.base.negate(&self.base.multiply(&value, &inverse));
        let gradient = self.combine(&inverse, &a.gradient, &slope, &b.gradient);
        Some(DualNumber { value, gradient })
    }

    fn is_zero(&self, a: &Self::Value) -> bool {
        self.base.is_zero(&a.value)
    }
}
