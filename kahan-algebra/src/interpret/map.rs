//! The map and its Jacobian at a point.

use crate::arithmetic::{Arithmetic, Dual, solve};
use crate::rational::Rational;
use crate::symbols::Symbol;

use super::increment::Increment;
use super::program::Input;
use super::{Interpreter, Point};

impl Interpreter {
    /// x̃ of the reduced map; `None` at a pole, where a float divides by zero, too.
    pub fn next<A: Arithmetic>(&self, arithmetic: &A, point: &Point<A::Value>) -> Option<Vec<A::Value>> {
        let input = |variable| match self.derived.system.field.symbols.symbol(variable) {
            Symbol::State(i) | Symbol::SecondState(i) => Input::State(i),
            Symbol::Parameter(k) => Input::Fixed(point.parameters[k].clone()),
            Symbol::Epsilon => Input::Fixed(point.eps.clone()),
        };
        let mut state = point.state.clone();
        Increment::of(&self.derived, arithmetic, &point.eps, &input).add_to(&mut state, arithmetic).ok()?;
        Some(state)
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
