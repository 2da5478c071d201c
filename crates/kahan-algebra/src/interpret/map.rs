//! The map and its Jacobian at a point.

use kahan_syntax::rational::Rational;

use crate::arithmetic::{Arithmetic, Dual, solve};
use kahan_program::Program;

use crate::plan::{Node, Operation, StepPlan};

use super::{Interpreter, Point};

impl Interpreter {
    /// x̃ of the reduced map; `None` at a pole, where a float divides by zero, too.
    pub fn next<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Option<Vec<A::Value>> {
        match self.derived.step() {
            Some(step) => self.next_by(step.at(arithmetic, &point.eps), arithmetic, point),
            None => self.next_by_elimination(arithmetic, point),
        }
    }

    fn next_by<A: Arithmetic<Constant = Rational>>(
        &self,
        step: &StepPlan,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Option<Vec<A::Value>> {
        let plan = &step.kernel.plan;
        let prepared = self.run_partly(arithmetic, &step.constants, point, None);
        let divisors = plan.operations.iter().filter_map(|operation| match *operation {
            Operation::Divide(_, divisor) => Some(divisor),
            _ => None,
        });
        let outputs: Vec<Node> = plan.outputs.iter().copied().chain(divisors).collect();
        let kernel_and_divisors = Program { operations: &plan.operations[..], outputs };
        let values = kernel_and_divisors.evaluate(arithmetic, |input| {
            input.value(&prepared, |variable| Some(self.value_of(variable, point, None)))
        });
        let values: Vec<A::Value> = values.into_iter().collect::<Option<_>>()?;
        let (results, divisors) = values.split_at(plan.outputs.len());
        // A float has a value where it divides by zero, and still that is a pole.
        if divisors.iter().any(|divisor| arithmetic.is_zero(divisor)) {
            return None;
        }
        let next = |(x, (numerator, reciprocal)): (_, (_, Option<_>))| match reciprocal {
            Some(reciprocal) => arithmetic.multiply_add(numerator, reciprocal, x),
            None => arithmetic.add(x, numerator),
        };
        Some(point.state.iter().zip(step.kernel.factors(results)).map(next).collect())
    }

    /// A (x̃ − x)/(2ε) = f
    fn next_by_elimination<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Option<Vec<A::Value>> {
        let matrix = self.matrix(arithmetic, point)?;
        let field = self.run(arithmetic, self.derived.field(), point, None)?;
        let right: Vec<Vec<A::Value>> = field.into_iter().map(|component| vec![component]).collect();
        let slopes = solve(arithmetic, &matrix, &right)?.solution;
        let two_eps = arithmetic.add(&point.eps, &point.eps);
        let next =
            |(x, slope): (_, &Vec<A::Value>)| arithmetic.add(x, &arithmetic.multiply(&two_eps, &slope[0]));
        Some(point.state.iter().zip(&slopes).map(next).collect())
    }

    /// ∂x̃/∂x, where x̃ is `next`: of the reduced map by dual numbers, else A(x,ε)⁻¹A(x̃,−ε).
    pub fn jacobian<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
        next: &[A::Value],
    ) -> Option<Vec<Vec<A::Value>>> {
        if self.derived.step().is_none() {
            let back = Point {
                state: next.to_vec(),
                parameters: point.parameters.clone(),
                eps: arithmetic.negate(&point.eps),
            };
            let (matrix, right) = (self.matrix(arithmetic, point)?, self.matrix(arithmetic, &back)?);
            return solve(arithmetic, &matrix, &right).map(|solved| solved.solution);
        }
        let n = point.state.len();
        let dual = Dual { base: arithmetic, directions: n };
        let coordinates =
            point.state.iter().enumerate().map(|(index, value)| dual.coordinate(value.clone(), index));
        let extended = Point {
            state: coordinates.collect::<Option<_>>()?,
            parameters: point.parameters.iter().map(|value| dual.fixed(value.clone())).collect(),
            eps: dual.fixed(point.eps.clone()),
        };
        let moved = self.next(&dual, &extended)?;
        let zero = arithmetic.constant(&Rational::zero())?;
        let row =
            |gradient: Vec<A::Value>| if gradient.is_empty() { vec![zero.clone(); n] } else { gradient };
        Some(moved.into_iter().map(|value| row(value.gradient)).collect())
    }
}
