//! Plans in floats that are rounded as one likes. This runs in every expansion of the macro, which
//! is compiled without optimisation: hence plain loops over plain floats.

use super::super::{Operation, Plan};

/// u of floats of 30 bits.
pub(super) const SHORT_UNIT: f64 = 1.0 / (1_u64 << 30) as f64;

/// The nearest float of 30 bits, by Veltkamp's splitting: 2²³ + 1 takes 23 bits away.
pub(super) fn short(value: f64) -> f64 {
    let large = 8_388_609.0 * value;
    large - (large - value)
}

/// A plan with its constants as floats.
pub(super) struct Program<'a> {
    plan: &'a Plan,
    /// A value an operation, those of constants being known.
    start: Vec<f64>,
}

impl<'a> Program<'a> {
    pub(super) fn of(plan: &'a Plan) -> Self {
        let value = |operation: &Operation| match operation {
            Operation::Constant(value) => value.to_f64(),
            _ => 0.0,
        };
        Program { plan, start: plan.operations.iter().map(value).collect() }
    }

    /// The results, everything being rounded by `round`; `inputs` by the index of their variable, a
    /// multiply-add rounds twice.
    pub(super) fn run(&self, round: impl Fn(f64) -> f64, inputs: &[f64], prepared: &[f64]) -> Vec<f64> {
        let mut all = self.start.clone();
        // A slice is indexed by the compiler, a vector by calls.
        let (values, operations): (&mut [f64], &[Operation]) = (&mut all, &self.plan.operations);
        let mut index = 0;
        while index < operations.len() {
            values[index] = match operations[index] {
                Operation::Input(variable) => inputs[variable.0 as usize],
                Operation::Constant(_) => round(values[index]),
                Operation::Prepared(place) => prepared[place],
                Operation::Negate(a) => -values[a.0],
                Operation::Add(a, b) => round(values[a.0] + values[b.0]),
                Operation::Subtract(a, b) => round(values[a.0] - values[b.0]),
                Operation::Multiply(a, b) => round(values[a.0] * values[b.0]),
                Operation::Divide(a, b) => round(values[a.0] / values[b.0]),
                Operation::MultiplyAdd(a, b, c) => round(round(values[a.0] * values[b.0]) + values[c.0]),
                Operation::MultiplySubtract(a, b, c) => round(round(values[a.0] * values[b.0]) - values[c.0]),
                Operation::SubtractProduct(a, b, c) => round(values[a.0] - round(values[b.0] * values[c.0])),
            };
            index += 1;
        }
        let mut results = Vec::with_capacity(self.plan.outputs.len());
        for output in &self.plan.outputs {
            results.push(values[output.0]);
        }
        results
    }
}
