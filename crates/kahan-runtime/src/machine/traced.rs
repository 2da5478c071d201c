//! A number whose operations are written down: what the interpreter does with it becomes a program,
//! so that code has the interpreter's operations in their order.

use core::ops::Neg;
use std::cell::RefCell;
use std::marker::PhantomData;

use kahan_core::num_traits::{One, Zero};
use kahan_core::{FloatScalar, Scalar, operators};
use kahan_jit::{Instruction, Program};

use Instruction::{
    Add, Divide, Literal, Maximum, Minimum, Multiply, MultiplyAdd, MultiplySubtract, Negate, RoundToSingle,
    State, Subtract, SubtractProduct,
};

thread_local! {
    /// What this thread is writing.
    static PROGRAM: RefCell<Program> = RefCell::default();
}

/// The program of the numbers that `compute` gives, if it gives some.
pub(super) fn program<T>(compute: impl FnOnce() -> Option<Vec<Traced<T>>>) -> Option<Program> {
    PROGRAM.take();
    let results = compute()?;
    let mut program = PROGRAM.take();
    program.set_results(results.into_iter().map(|number| number.place).collect());
    Some(program)
}

/// The result of an instruction over the float T.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Traced<T> {
    place: usize,
    float: PhantomData<T>,
}

impl<T> Traced<T> {
    /// Writes an instruction.
    pub(super) fn of(instruction: Instruction) -> Self {
        let place = PROGRAM.with_borrow_mut(|program| program.push(instruction));
        Traced { place, float: PhantomData }
    }

    /// Writes entries of the state.
    pub(super) fn states(places: impl IntoIterator<Item = usize>) -> Vec<Self> {
        places.into_iter().map(|place| Self::of(State(place))).collect()
    }

    /// The number of single precision nearest to it.
    pub(super) fn rounded_to_single(self) -> Self {
        Self::of(RoundToSingle(self.place))
    }

    /// |self|
    pub(super) fn magnitude(self) -> Self {
        let place = self.place;
        Self::of(Maximum(place, (-self).place))
    }

    /// The larger of two numbers.
    pub(super) fn larger(self, other: Self) -> Self {
        Self::of(Maximum(self.place, other.place))
    }

    /// The smaller of two numbers.
    pub(super) fn smaller(self, other: Self) -> Self {
        Self::of(Minimum(self.place, other.place))
    }

    /// The number that it is, where that is known.
    pub(super) fn literal(self) -> Option<f64> {
        match self.instruction() {
            Literal(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// The place of −self where this is a number whose sign was changed: a subtraction takes that
    /// instead, with the same bits.
    fn negated(self) -> Option<usize> {
        match self.instruction() {
            Negate(inner) => Some(inner),
            _ => None,
        }
    }

    fn instruction(self) -> Instruction {
        PROGRAM.with_borrow(|program| program.instruction(self.place))
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
        Self::of(Instruction::literal(0.0))
    }

    /// Nothing is known of a number before the program runs.
    fn is_zero(&self) -> bool {
        false
    }
}

impl<T: Copy> One for Traced<T> {
    fn one() -> Self {
        Self::of(Instruction::literal(1.0))
    }
}

impl<T: FloatScalar> Scalar for Traced<T> {
    fn constant(c: &kahan_core::Constant<'_>) -> Self {
        Self::of(Instruction::literal(T::constant(c).approximate()))
    }

    fn quotient(self, divisor: Self) -> Option<Self> {
        Some(self / divisor)
    }

    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        Self::of(match self.negated() {
            Some(inner) => SubtractProduct(addend.place, inner, factor.place),
            None => MultiplyAdd(self.place, factor.place, addend.place),
        })
    }

    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        Self::of(MultiplySubtract(self.place, factor.place, subtrahend.place))
    }

    fn subtract_product(self, a: Self, b: Self) -> Self {
        Self::of(SubtractProduct(self.place, a.place, b.place))
    }
}
