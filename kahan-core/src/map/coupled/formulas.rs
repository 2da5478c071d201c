//! Formulas as tables in postfix notation, evaluated by one loop.
//!
//! A table takes less code than straight-line operations. Therefore residuals with error bounds and
//! long eliminations evaluate f and f′ from tables. The macro orders the operands so that the stack
//! stays short.

use core::array::from_fn;

use crate::{Constant, Scalar};

const DEEPEST: usize = 16;

/// An instruction of a postfix table.
#[derive(Clone, Copy, Debug)]
pub enum Postfix<'a> {
    /// Pushes an entry of the state.
    State(u16),
    /// Pushes a parameter.
    Parameter(u16),
    /// Pushes an exact number.
    Number(Constant<'a>),
    /// Replaces the top a of the stack by −a.
    Negate,
    /// Replaces the top entry b and the entry a below it by a + b.
    Add,
    /// Replaces the top entry b and the entry a below it by a − b.
    Subtract,
    /// Replaces the top entry b and the entry a below it by b − a.
    SubtractFrom,
    /// Replaces the top entry b and the entry a below it by a·b.
    Multiply,
    /// Replaces the top entry b and the entry a below it by a/b.
    Divide,
    /// Replaces the top entry b and the entry a below it by b/a.
    DivideInto,
    /// Ends a formula. The only entry on the stack is the formula's value.
    Done,
}

pub(super) struct PostfixEvaluator<'a, T> {
    rest: core::slice::Iter<'a, Postfix<'a>>,
    parameters: &'a [T],
    x: &'a [T],
}

impl<'a, T> PostfixEvaluator<'a, T> {
    pub(super) fn of(formulas: &'a [Postfix<'a>], parameters: &'a [T], x: &'a [T]) -> Self {
        Self { rest: formulas.iter(), parameters, x }
    }
}

impl<T: Scalar> Iterator for PostfixEvaluator<'_, T> {
    type Item = T;

    #[inline(never)]
    fn next(&mut self) -> Option<T> {
        let mut stack: [T; DEEPEST] = from_fn(|_| T::zero());
        let mut height = 0;
        for step in self.rest.by_ref() {
            let value = match *step {
                Postfix::State(k) => self.x[usize::from(k)].clone(),
                Postfix::Parameter(k) => self.parameters[usize::from(k)].clone(),
                Postfix::Number(ref number) => T::constant(number),
                Postfix::Done => return Some(stack[0].clone()),
                Postfix::Negate => {
                    height -= 1;
                    -stack[height].clone()
                }
                _ => {
                    height -= 2;
                    let (a, b) = (stack[height].clone(), stack[height + 1].clone());
                    match step {
                        Postfix::Add => a + b,
                        Postfix::Subtract => a - b,
                        Postfix::SubtractFrom => b - a,
                        Postfix::Multiply => a * b,
                        Postfix::Divide => a / b,
                        _ => b / a,
                    }
                }
            };
            stack[height] = value;
            height += 1;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::Postfix::*;
    use super::PostfixEvaluator;
    use crate::Constant;

    #[test]
    fn tables_are_run_in_their_order() {
        // The table holds the formulas 2x₁/p − (p − 1), −x₀(x₁ + ½) and p/x₀.
        let table = [
            Number(Constant::integer(2)),
            State(1),
            Multiply,
            Parameter(0),
            Divide,
            Number(Constant::integer(1)),
            Parameter(0),
            SubtractFrom,
            Subtract,
            Done,
            State(1),
            Number(Constant::ratio(1, 2)),
            Add,
            State(0),
            Multiply,
            Negate,
            Done,
            State(0),
            Parameter(0),
            DivideInto,
            Done,
        ];
        assert!(PostfixEvaluator::of(&table, &[4.0], &[3.0, 5.0]).eq([-0.5, -16.5, 4.0 / 3.0]));
    }
}
