//! Runs plans in floats with a given rounding. The macro runs this code at compile time, usually
//! without optimisation. There chains of iterators are slow, so this code uses plain loops for each
//! point.

use kahan_program::Arithmetic;
use kahan_syntax::rational::Rational;

use super::super::{Operation, Plan};
use crate::plan::Input;

/// The unit roundoff of floats with 30 significant bits.
pub(super) const SHORT_UNIT: f64 = 1.0 / (1_u64 << 30) as f64;

/// Rounds to 30 significant bits by Veltkamp's splitting. The factor 2²³ + 1 removes 23 of 53 bits.
pub(super) fn short(value: f64) -> f64 {
    let large = 8_388_609.0 * value;
    large - (large - value)
}

pub(super) struct FloatPlan<'a> {
    plan: &'a Plan,
    start: Vec<f64>,
}

impl<'a> FloatPlan<'a> {
    pub(super) fn of(plan: &'a Plan) -> Self {
        let value = |operation: &Operation| match operation {
            Operation::Constant(value) => value.to_f64(),
            _ => 0.0,
        };
        FloatPlan { plan, start: plan.operations.iter().map(value).collect() }
    }

    /// Runs the plan. The function `round` rounds each result, and each product in a multiply-add.
    pub(super) fn run(&self, round: impl Fn(f64) -> f64, inputs: &[f64], prepared: &[f64]) -> Vec<f64> {
        let mut values = self.start.clone();
        for (value, operation) in values.iter_mut().zip(&self.plan.operations) {
            match *operation {
                Operation::Input(Input::Variable(variable)) => *value = inputs[variable.0 as usize],
                Operation::Input(Input::Prepared(place)) => *value = prepared[place],
                Operation::Constant(_) => *value = round(*value),
                _ => {}
            }
        }
        self.plan.compute(&Rounded(round), 0, &mut values).expect("floats have quotients by zero");
        let mut results = Vec::with_capacity(self.plan.outputs.len());
        for output in &self.plan.outputs {
            results.push(values[output.0]);
        }
        results
    }
}

struct Rounded<R>(R);

impl<R: Fn(f64) -> f64> Arithmetic for Rounded<R> {
    type Value = f64;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<f64> {
        Some((self.0)(value.to_f64()))
    }

    fn add(&self, a: &f64, b: &f64) -> f64 {
        (self.0)(a + b)
    }

    fn subtract(&self, a: &f64, b: &f64) -> f64 {
        (self.0)(a - b)
    }

    fn multiply(&self, a: &f64, b: &f64) -> f64 {
        (self.0)(a * b)
    }

    fn negate(&self, a: &f64) -> f64 {
        -a
    }

    fn divide(&self, a: &f64, b: &f64) -> Option<f64> {
        Some((self.0)(a / b))
    }

    fn is_zero(&self, a: &f64) -> bool {
        *a == 0.0
    }
}
