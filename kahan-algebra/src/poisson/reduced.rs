//! The field of rational functions in lowest terms, as an arithmetic that plans run in.
//!
//! [`Functions`](crate::arithmetic::Functions) is its quicker sibling that never reduces: enough to decide what is zero,
//! not to say what a function is.

use std::cell::RefCell;

use crate::arithmetic::Arithmetic;
use crate::poly::{Budget, OverBudget};
use crate::rational::Rational;
use crate::rational_function::RationalFunction;

/// Reduced rational functions; everything is charged to one budget, and what follows its end is [`OverBudget`].
pub(super) struct Reduced<'a> {
    budget: RefCell<&'a mut Budget>,
}

type Value = Result<RationalFunction, OverBudget>;

impl<'a> Reduced<'a> {
    pub(super) fn new(budget: &'a mut Budget) -> Self {
        Reduced { budget: RefCell::new(budget) }
    }

    fn combine(
        &self,
        a: &Value,
        b: &Value,
        operation: impl FnOnce(&RationalFunction, &RationalFunction, &mut Budget) -> Value,
    ) -> Value {
        match (a, b) {
            (Ok(a), Ok(b)) => operation(a, b, &mut self.budget.borrow_mut()),
            _ => Err(OverBudget),
        }
    }
}

impl Arithmetic for Reduced<'_> {
    type Value = Value;

    fn constant(&self, value: &Rational) -> Option<Value> {
        Some(Ok(RationalFunction::constant(value.clone())))
    }

    fn add(&self, a: &Value, b: &Value) -> Value {
        self.combine(a, b, RationalFunction::add_within)
    }

    fn subtract(&self, a: &Value, b: &Value) -> Value {
        self.combine(a, b, RationalFunction::sub_within)
    }

    fn multiply(&self, a: &Value, b: &Value) -> Value {
        self.combine(a, b, RationalFunction::mul_within)
    }

    fn negate(&self, a: &Value) -> Value {
        a.as_ref().map(|a| -a).map_err(|error| *error)
    }

    fn divide(&self, a: &Value, b: &Value) -> Option<Value> {
        match (a, b) {
            (Ok(a), Ok(b)) => a.div_within(b, &mut self.budget.borrow_mut()).transpose(),
            _ => Some(Err(OverBudget)),
        }
    }

    fn is_zero(&self, a: &Value) -> bool {
        a.as_ref().is_ok_and(RationalFunction::is_zero)
    }
}
