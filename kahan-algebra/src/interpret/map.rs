//! The map and its Jacobian at a point: by the step's plan, or by elimination where there is none.

use crate::arithmetic::{Arithmetic, Dual, Solved, solve};
use crate::plan::StepPlan;
use crate::rational::Rational;

use super::{Interpreter, Point};

impl Interpreter {
    /// x̃ of the reduced map; `None` at a pole.
    pub fn next<A: Arithmetic>(&self, arithmetic: &A, point: &Point<A::Value>) -> Option<Vec<A::Value>> {
        match self.derived.step() {
            Some(step) => self.stepped(arithmetic, step.at(arithmetic, &point.eps), point),
            None => self.eliminated(arithmetic, point),
        }
    }

    /// x̃ = x + numerator · reciprocal, as generated code computes it.
    fn stepped<A: Arithmetic>(
        &self,
        arithmetic: &A,
        step: &StepPlan,
        point: &Point<A::Value>,
    ) -> Option<Vec<A::Value>> {
        let constants = self.run_partly(arithmetic, &step.constants, point, None);
        let input = |variable| Some(self.value_of(variable, point, None));
        let values = step.kernel.evaluate_prepared(arithmetic, &constants, input);
        let values: Vec<A::Value> = values.into_iter().collect::<Option<_>>()?;
        let (numerators, reciprocals) = values.split_at(point.state.len());
        let moved = point.state.iter().zip(numerators).zip(&step.reciprocals);
        let moved = moved.map(|((x, numerator), place)| match place {
            Some(place) => arithmetic.add(x, &arithmetic.multiply(numerator, &reciprocals[*place])),
            None => arithmetic.add(x, numerator),
        });
        Some(moved.collect())
    }

    /// x̃ = x + 2ε v with Av = f, by elimination.
    fn eliminated<A: Arithmetic>(&self, arithmetic: &A, point: &Point<A::Value>) -> Option<Vec<A::Value>> {
        let field = self.run(arithmetic, &self.derived.field, point, None)?;
        let right: Vec<Vec<A::Value>> = field.into_iter().map(|value| vec![value]).collect();
        let Solved { solution, .. } = solve(arithmetic, &self.matrix(arithmetic, point)?, &right)?;
        let two_eps = arithmetic.add(&point.eps, &point.eps);
        let moved = point.state.iter().zip(solution.iter().flatten());
        Some(moved.map(|(x, slope)| arithmetic.add(x, &arithmetic.multiply(&two_eps, slope))).collect())
    }

    /// ∂x̃/∂x: of the reduced map by dual numbers, else A(x,ε)⁻¹A(x̃,−ε).
    pub(super) fn jacobian<A: Arithmetic>(
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
        let lifted = Point {
            state: coordinates.collect::<Option<_>>()?,
            parameters: point.parameters.iter().map(|value| dual.fixed(value.clone())).collect(),
            eps: dual.fixed(point.eps.clone()),
        };
        let moved = self.next(&dual, &lifted)?;
        let zero = arithmetic.constant(&Rational::zero())?;
        let row =
            |gradient: Vec<A::Value>| if gradient.is_empty() { vec![zero.clone(); n] } else { gradient };
        Some(moved.into_iter().map(|value| row(value.gradient)).collect())
    }
}
