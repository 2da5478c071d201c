//! A number that records its operations. An interpreter that runs over [`Traced`] numbers writes
//! the program of its own operations.

use core::ops::Neg;
use std::cell::{Cell, RefCell};
use std::marker::PhantomData;

use kahan_core::num_traits::{One, Zero};
use kahan_core::{FloatScalar, Scalar, operators};
use kahan_jit::{CalledFunction, Input, Instruction, Program};
use kahan_program::Operation::{
    Add, Call, Constant, Divide, Multiply, MultiplyAdd, MultiplySubtract, Negate, Subtract, SubtractProduct,
};
use kahan_program::{Float, Node};

thread_local! {
    static OPERATIONS: RefCell<Vec<Instruction>> = RefCell::default();
    /// Whether a multiply-add is recorded as a product and a sum.
    static IS_UNFUSED: Cell<bool> = const { Cell::new(false) };
}

/// Runs `compute`, and records each multiply-add as a product and a sum.
pub(super) fn unfused<R>(compute: impl FnOnce() -> R) -> R {
    IS_UNFUSED.set(true);
    let result = compute();
    IS_UNFUSED.set(false);
    result
}

/// Returns the program that computes the numbers returned by `compute`.
pub(super) fn program<T>(compute: impl FnOnce() -> Option<Vec<Traced<T>>>) -> Option<Program> {
    OPERATIONS.take();
    let outputs = compute()?.into_iter().map(|number| number.place).collect();
    Some(Program { operations: OPERATIONS.take(), outputs })
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Traced<T> {
    place: Node,
    float: PhantomData<T>,
}

impl<T> Traced<T> {
    fn of(operation: Instruction) -> Self {
        let place = OPERATIONS.with_borrow_mut(|operations| {
            operations.push(operation);
            Node(operations.len() - 1)
        });
        Traced { place, float: PhantomData }
    }

    pub(super) fn number(value: f64) -> Self {
        Self::of(Constant(Float::of(value)))
    }

    pub(super) fn input(entry: Input) -> Self {
        Self::of(Instruction::Input(entry))
    }

    pub(super) fn states(places: impl IntoIterator<Item = usize>) -> Vec<Self> {
        places.into_iter().map(|place| Self::input(Input::State(place))).collect()
    }

    pub(super) fn rounded_to_single(self) -> Self {
        Self::of(Call(CalledFunction::RoundToSingle, self.place, self.place))
    }

    pub(super) fn magnitude(self) -> Self {
        Self::of(Call(CalledFunction::Maximum, self.place, self.neg().place))
    }

    pub(super) fn larger(self, other: Self) -> Self {
        Self::of(Call(CalledFunction::Maximum, self.place, other.place))
    }

    pub(super) fn smaller(self, other: Self) -> Self {
        Self::of(Call(CalledFunction::Minimum, self.place, other.place))
    }

    pub(super) fn literal(self) -> Option<f64> {
        if let Constant(number) = self.operation() { Some(number.value()) } else { None }
    }

    /// Returns the node a if this number is the negation −a.
    fn negated(self) -> Option<Node> {
        if let Negate(inner) = self.operation() { Some(inner) } else { None }
    }

    fn operation(self) -> Instruction {
        OPERATIONS.with_borrow(|operations| operations[self.place.0])
    }
}

operators! {
    [T: Copy] Traced<T>:
    |a: Self, b: Self| Self::of(match b.negated() {
        Some(inner) => Subtract(a.place, inner),
        None => Add(a.place, b.place),
    }),
    |a: Self, b: Self| Self::of(Subtract(a.place, b.place)),
    |a: Self, b: Self| Self::of(Multiply(a.place, b.place)),
    |a: Self, b: Self| Self::of(Divide(a.place, b.place))
}

impl<T> Neg for Traced<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self::of(Negate(self.place))
    }
}

impl<T: Copy> Zero for Traced<T> {
    fn zero() -> Self {
        Self::number(0.0)
    }

    /// Returns `false`, because values are unknown while a program is traced.
    fn is_zero(&self) -> bool {
        false
    }
}

impl<T: Copy> One for Traced<T> {
    fn one() -> Self {
        Self::number(1.0)
    }
}

impl<T: FloatScalar> Scalar for Traced<T> {
    fn constant(c: &kahan_core::Constant<'_>) -> Self {
        Self::number(T::constant(c).approximate())
    }

    fn quotient(self, divisor: Self) -> Option<Self> {
        Some(self / divisor)
    }

    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        if IS_UNFUSED.get() {
            return self * factor + addend;
        }
        Self::of(match self.negated() {
            Some(inner) => SubtractProduct(addend.place, inner, factor.place),
            None => MultiplyAdd(self.place, factor.place, addend.place),
        })
    }

    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        if IS_UNFUSED.get() {
            return self * factor - subtrahend;
        }
        Self::of(MultiplySubtract(self.place, factor.place, subtrahend.place))
    }

    fn subtract_product(self, a: Self, b: Self) -> Self {
        if IS_UNFUSED.get() {
            return self - a * b;
        }
        Self::of(SubtractProduct(self.place, a.place, b.place))
    }
}
