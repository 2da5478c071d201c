//! Computes bounds on the rounding errors of compiled formulas, operation by operation.
//!
//! An operation rounds its result with a relative error of at most the unit roundoff, and passes on
//! the errors of its operands (Higham, Accuracy and Stability of Numerical Algorithms, §3.3). A
//! multiply-add is treated as two roundings, so the bound holds for fused multiply-adds, too.

use kahan_algebra::plan::{Input, Node, Operation, Plan};
use kahan_algebra::poly::Variable;
use kahan_algebra::rational::Rational;

/// Integers up to this size are exact in `f32` and in `f64`.
const EXACT: i64 = 1 << 24;

#[derive(Clone, Debug)]
pub(super) struct Rounded {
    pub(super) exact: Rational,
    pub(super) error: f64,
}

impl Rounded {
    pub(super) fn size(&self) -> f64 {
        self.exact.to_f64().abs()
    }

    pub(super) fn rounded(self, unit: f64) -> Self {
        let error = self.error + unit * (self.size() + self.error);
        Self { error, ..self }
    }

    /// Multiplies without rounding. The errors of both operands contribute to the error.
    pub(super) fn times(&self, other: &Self) -> Self {
        let error = self.size() * other.error + other.size() * self.error + self.error * other.error;
        Self { exact: &self.exact * &other.exact, error }
    }

    /// Divides without rounding. Returns `None` if the divisor's relative error is at least 1/2.
    pub(super) fn over(&self, divisor: &Self) -> Option<Self> {
        let exact = self.exact.checked_div(&divisor.exact)?;
        let size = divisor.size();
        let error = (self.error + exact.to_f64().abs() * divisor.error) / (size - divisor.error);
        (divisor.error < size / 2.0).then_some(Self { exact, error })
    }

    fn plus(&self, other: &Self) -> Self {
        Self { exact: &self.exact + &other.exact, error: self.error + other.error }
    }

    fn negated(&self) -> Self {
        Self { exact: -&self.exact, error: self.error }
    }
}

/// Bounds the errors of compiled formulas. A result is `None` if a divisor is too inaccurate.
pub(super) fn results(
    plan: &Plan,
    prepared: &[Option<Rounded>],
    unit: f64,
    input: impl Fn(Variable) -> Rational,
) -> Vec<Option<Rounded>> {
    let mut values: Vec<Option<Rounded>> = Vec::with_capacity(plan.operations.len());
    for operation in &plan.operations {
        let value = match operation {
            Operation::Input(Input::Variable(variable)) => {
                Some(Rounded { exact: input(*variable), error: 0.0 })
            }
            Operation::Input(Input::Prepared(index)) => prepared[*index].clone(),
            _ => result(operation, unit, |node| values[node.0].as_ref()),
        };
        values.push(value);
    }
    plan.outputs.iter().map(|output| values[output.0].clone()).collect()
}

fn result<'a>(
    operation: &Operation,
    unit: f64,
    value: impl Fn(Node) -> Option<&'a Rounded>,
) -> Option<Rounded> {
    let product = |a, b| Some(value(a)?.times(value(b)?).rounded(unit));
    let result = match *operation {
        Operation::Input(_) => return None,
        Operation::Constant(ref constant) => {
            let is_exact = constant.as_i64().is_some_and(|integer| integer.abs() <= EXACT);
            let exact = Rounded { exact: constant.clone(), error: 0.0 };
            return Some(if is_exact { exact } else { exact.rounded(unit) });
        }
        Operation::Negate(a) => return Some(value(a)?.negated()),
        Operation::Add(a, b) => value(a)?.plus(value(b)?),
        Operation::Subtract(a, b) => value(a)?.plus(&value(b)?.negated()),
        Operation::Multiply(a, b) => return product(a, b),
        Operation::Divide(a, b) => value(a)?.over(value(b)?)?,
        Operation::MultiplyAdd(a, b, c) => product(a, b)?.plus(value(c)?),
        Operation::MultiplySubtract(a, b, c) => product(a, b)?.plus(&value(c)?.negated()),
        Operation::SubtractProduct(a, b, c) => value(a)?.plus(&product(b, c)?.negated()),
        Operation::Call(function, ..) => match function {},
    };
    Some(result.rounded(unit))
}
