//! Counts the operations of a step, by taking the step with numbers that count every operation.

use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use kahan_core::num_traits::{One, Zero};
use kahan_core::prelude::*;
use kahan_core::{Constant, PreparedStep};

thread_local! {
    static OPERATIONS: Cell<usize> = const { Cell::new(0) };
}

/// Operations counted for a division: two Newton iterations of two operations each, and a product.
const ESTIMATED_DIVISION: usize = 5;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Counted(f64);

fn counted(operations: usize, value: f64) -> Counted {
    OPERATIONS.set(OPERATIONS.get() + operations);
    Counted(value)
}

/// Counts the operations of one step. Returns 0 without `HAS_LANES`, because `widen` would panic.
pub(crate) fn operations<const N: usize>(step: &impl PreparedStep<f64, N>) -> usize {
    fn of<S: PreparedStep<f64, N>, const N: usize>(step: &S) -> usize {
        if !S::HAS_LANES {
            return 0;
        }
        let wide = step.widen(|constant| Counted(*constant));
        OPERATIONS.set(0);
        let next = wide.next(&SVector::from([Counted(0.5); N]));
        assert!(next.is_some(), "floats always have a reciprocal");
        OPERATIONS.get()
    }
    of(step)
}

impl Scalar for Counted {
    fn constant(c: &Constant<'_>) -> Self {
        Counted(f64::constant(c))
    }

    fn reciprocal(&self) -> Option<Self> {
        Some(counted(ESTIMATED_DIVISION, 1.0 / self.0))
    }

    fn quotient(self, divisor: Self) -> Option<Self> {
        Some(self / divisor)
    }

    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        counted(1, self.0 * factor.0 + addend.0)
    }

    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        counted(1, self.0 * factor.0 - subtrahend.0)
    }

    fn subtract_product(self, a: Self, b: Self) -> Self {
        counted(1, self.0 - a.0 * b.0)
    }
}

impl Zero for Counted {
    fn zero() -> Self {
        Counted(0.0)
    }

    fn is_zero(&self) -> bool {
        self.0 == 0.0
    }
}

impl One for Counted {
    fn one() -> Self {
        Counted(1.0)
    }
}

/// Negations are not counted, since the next operation absorbs them.
impl Neg for Counted {
    type Output = Self;

    fn neg(self) -> Self {
        Counted(-self.0)
    }
}

macro_rules! binary {
    ($($trait:ident $method:ident, $assign:ident $assign_method:ident, $operator:tt, $cost:expr;)*) => {$(
        impl $trait for Counted {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                counted($cost, self.0 $operator other.0)
            }
        }

        impl $assign for Counted {
            fn $assign_method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}

binary! {
    Add add, AddAssign add_assign, +, 1;
    Sub sub, SubAssign sub_assign, -, 1;
    Mul mul, MulAssign mul_assign, *, 1;
    Div div, DivAssign div_assign, /, ESTIMATED_DIVISION;
}
