//! Dual numbers in instructions: the operations of kahan-core's dual numbers in their order, so
//! that a Jacobian has the bits of generated code.

use std::cell::Cell;

use kahan_algebra::arithmetic::{Arithmetic, DualNumber};
use kahan_algebra::rational::Rational;

use super::recorder::Recorder;

/// Dual numbers in so many directions, written into a program.
#[derive(Debug)]
pub(super) struct Duals<'a> {
    base: &'a Recorder,
    directions: usize,
    /// Whether quotients are those of a kernel, where a gradient is multiplied by a reciprocal.
    is_kernel: Cell<bool>,
}

type Dual = DualNumber<usize>;

impl<'a> Duals<'a> {
    pub(super) fn new(base: &'a Recorder, directions: usize) -> Self {
        Duals { base, directions, is_kernel: Cell::new(false) }
    }

    /// From here on quotients are those of a kernel.
    pub(super) fn begin_kernel(&self) {
        self.is_kernel.set(true);
    }

    /// A number that does not move.
    pub(super) fn fixed(&self, value: usize) -> Dual {
        DualNumber { value, gradient: vec![self.number(0); self.directions] }
    }

    /// The coordinate of a direction.
    pub(super) fn coordinate(&self, value: usize, direction: usize) -> Dual {
        let mut coordinate = self.fixed(value);
        coordinate.gradient[direction] = self.number(1);
        coordinate
    }

    fn number(&self, value: i64) -> usize {
        self.base.constant(&Rational::from(value)).unwrap_or_else(|| unreachable!("every number is written"))
    }

    fn quotient(&self, a: usize, b: usize) -> usize {
        self.base.divide(&a, &b).unwrap_or_else(|| unreachable!("floats divide by everything"))
    }

    fn each(&self, a: &Dual, b: &Dual, entry: impl Fn(&usize, &usize) -> usize) -> Vec<usize> {
        a.gradient.iter().zip(&b.gradient).map(|(a, b)| entry(a, b)).collect()
    }
}

impl Arithmetic for Duals<'_> {
    type Value = Dual;

    fn constant(&self, value: &Rational) -> Option<Dual> {
        self.base.constant(value).map(|value| self.fixed(value))
    }

    fn add(&self, a: &Dual, b: &Dual) -> Dual {
        let gradient = self.each(a, b, |a, b| self.base.add(a, b));
        DualNumber { value: self.base.add(&a.value, &b.value), gradient }
    }

    fn subtract(&self, a: &Dual, b: &Dual) -> Dual {
        let gradient = self.each(a, b, |a, b| self.base.subtract(a, b));
        DualNumber { value: self.base.subtract(&a.value, &b.value), gradient }
    }

    fn multiply(&self, a: &Dual, b: &Dual) -> Dual {
        let entry = |of_a: &usize, of_b: &usize| {
            self.base.add(&self.base.multiply(of_a, &b.value), &self.base.multiply(&a.value, of_b))
        };
        DualNumber { value: self.base.multiply(&a.value, &b.value), gradient: self.each(a, b, entry) }
    }

    fn negate(&self, a: &Dual) -> Dual {
        let gradient = a.gradient.iter().map(|entry| self.base.negate(entry)).collect();
        DualNumber { value: self.base.negate(&a.value), gradient }
    }

    fn divide(&self, a: &Dual, b: &Dual) -> Option<Dual> {
        if !self.is_kernel.get() {
            let value = self.quotient(a.value, b.value);
            let entry = |of_a: &usize, of_b: &usize| {
                self.quotient(self.base.subtract(of_a, &self.base.multiply(&value, of_b)), b.value)
            };
            return Some(DualNumber { value, gradient: self.each(a, b, entry) });
        }
        let reciprocal = self.quotient(self.number(1), b.value);
        if self.base.literal(a.value) == Some(1.0) {
            let slope = self.base.negate(&self.base.multiply(&reciprocal, &reciprocal));
            let gradient = b.gradient.iter().map(|entry| self.base.multiply(&slope, entry)).collect();
            return Some(DualNumber { value: reciprocal, gradient });
        }
        let value = self.quotient(a.value, b.value);
        let entry = |of_a: &usize, of_b: &usize| {
            let slope = self.base.subtract(of_a, &self.base.multiply(&value, of_b));
            self.base.multiply(&slope, &reciprocal)
        };
        Some(DualNumber { value, gradient: self.each(a, b, entry) })
    }

    fn is_zero(&self, _: &Dual) -> bool {
        false
    }
}
