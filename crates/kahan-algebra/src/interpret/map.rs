//! Evaluates the map and its Jacobian at a point.

use kahan_program::Program;
use kahan_syntax::rational::Rational;

use crate::arithmetic::{Dual, OverRationals, solve};
use crate::plan::{Node, Operation, StepPlan};

use super::{Evaluator, Point};

impl<A: OverRationals> Evaluator<'_, A> {
    pub(super) fn next(&self) -> Option<Vec<A::Value>> {
        match self.derived.step() {
            Some(step) => self.next_by(step.at(self.arithmetic, &self.point.eps)),
            None => self.next_by_elimination(),
        }
    }

    fn next_by(&self, step: &StepPlan) -> Option<Vec<A::Value>> {
        let (plan, state) = (&step.kernel.plan, &self.point.state);
        let prepared = self.run_partly(&step.constants, state);
        let divisors = plan.operations.iter().filter_map(|operation| match *operation {
            Operation::Divide(_, divisor) => Some(divisor),
            _ => None,
        });
        let outputs: Vec<Node> = plan.outputs.iter().copied().chain(divisors).collect();
        let kernel_and_divisors = Program { operations: &plan.operations[..], outputs };
        let values = kernel_and_divisors.evaluate(self.arithmetic, |input| {
            input.value(&prepared, |variable| Some(self.value_of(variable, state)))
        });
        let values: Vec<A::Value> = values.into_iter().collect::<Option<_>>()?;
        let (results, divisors) = values.split_at(plan.outputs.len());
        // A zero divisor means a pole, even if floats give a value.
        if divisors.iter().any(|divisor| self.arithmetic.is_zero(divisor)) {
            return None;
        }
        let next = |(x, (numerator, reciprocal)): (_, (_, Option<_>))| match reciprocal {
            Some(reciprocal) => self.arithmetic.multiply_add(numerator, reciprocal, x),
            None => self.arithmetic.add(x, numerator),
        };
        Some(state.iter().zip(step.kernel.factors(results)).map(next).collect())
    }

    /// Returns x̃ from the solution of A (x̃ − x)/(2ε) = f.
    fn next_by_elimination(&self) -> Option<Vec<A::Value>> {
        let (arithmetic, eps) = (self.arithmetic, &self.point.eps);
        let right: Vec<_> = self.run(self.derived.field())?.into_iter().map(|value| vec![value]).collect();
        let slopes = solve(arithmetic, &self.matrix()?, &right)?.solution;
        let two_eps = arithmetic.add(eps, eps);
        let next =
            |(x, slope): (_, &Vec<A::Value>)| arithmetic.add(x, &arithmetic.multiply(&two_eps, &slope[0]));
        Some(self.point.state.iter().zip(&slopes).map(next).collect())
    }

    pub(super) fn jacobian(&self, next: &[A::Value]) -> Option<Vec<Vec<A::Value>>> {
        let Evaluator { derived, arithmetic, point } = *self;
        let Point { state, parameters, eps } = point;
        if derived.step().is_none() {
            let (state, eps) = (next.to_vec(), arithmetic.negate(eps));
            let back = Point { state, parameters: parameters.clone(), eps };
            let right = Evaluator { point: &back, ..*self }.matrix()?;
            return solve(arithmetic, &self.matrix()?, &right).map(|solved| solved.solution);
        }
        let n = state.len();
        let dual = Dual { base: arithmetic, directions: n };
        let coordinates =
            state.iter().enumerate().map(|(index, value)| dual.coordinate(value.clone(), index));
        let extended = Point {
            state: coordinates.collect::<Option<_>>()?,
            parameters: parameters.iter().map(|value| dual.fixed(value.clone())).collect(),
            eps: dual.fixed(eps.clone()),
        };
        let moved = Evaluator { derived, arithmetic: &dual, point: &extended }.next()?;
        let zero = arithmetic.constant(&Rational::zero())?;
        let row =
            |gradient: Vec<A::Value>| if gradient.is_empty() { vec![zero.clone(); n] } else { gradient };
        Some(moved.into_iter().map(|value| row(value.gradient)).collect())
    }
}
