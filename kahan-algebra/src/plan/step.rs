//! The plan of a step: what is computed once, when ε and the parameters are known, and what is computed for each state.

use crate::field::Field;
use crate::kahan::RationalMap;
use crate::poly::Polynomial;
use crate::rational::Rational;

use super::{Node, Operation, Plan, PlanBuilder};

/// A step in straight lines: x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepPlan {
    /// From ε and the parameters to the prepared constants, in order. It has no states.
    pub constants: Plan,
    /// From the states and the prepared constants ([`Operation::Prepared`]) to the numerators, one a component, followed
    /// by the reciprocals, each a quotient 1/d.
    pub kernel: Plan,
    /// For each component the index of its reciprocal among the kernel's reciprocals; `None` where there is no division.
    pub reciprocals: Vec<Option<usize>>,
}

impl StepPlan {
    /// The plan of a field's step; `None` where the closed form is beyond the budget.
    #[must_use]
    pub fn of(field: &Field) -> Option<Self> {
        RationalMap::of(field).map(|map| Self::of_map(field, &map))
    }

    /// The plan of a map that has been derived already.
    #[must_use]
    pub fn of_map(field: &Field, map: &RationalMap) -> Self {
        let mut builder = PlanBuilder::default();
        let two_eps = Polynomial::variable(field.symbols.epsilon()).scale(&Rational::from(2));
        let two_eps = builder.polynomial(&two_eps);
        let numerators: Vec<Node> = map
            .reduced
            .increments
            .iter()
            .map(|increment| {
                let increment = builder.polynomial(increment);
                builder.multiply(two_eps, increment)
            })
            .collect();
        let denominator = builder.polynomial(&map.reduced.denominator);
        let one = builder.constant(&Rational::one());
        let reciprocal = builder.divide(one, denominator);
        Self::new(&builder, field, &numerators, &vec![Some(reciprocal); numerators.len()])
    }

    /// Separates the constants from the kernel.
    fn new(builder: &PlanBuilder, field: &Field, numerators: &[Node], reciprocals: &[Option<Node>]) -> Self {
        let mut distinct: Vec<Node> = Vec::new();
        let places = reciprocals.iter().map(|reciprocal| {
            let reciprocal = (*reciprocal)?;
            Some(distinct.iter().position(|&known| known == reciprocal).unwrap_or_else(|| {
                distinct.push(reciprocal);
                distinct.len() - 1
            }))
        });
        let places: Vec<Option<usize>> = places.collect();
        let outputs: Vec<Node> = numerators.iter().chain(&distinct).copied().collect();
        let (constants, kernel) = builder.finish(&outputs).split(|variable| field.symbols.is_state(variable));
        StepPlan { constants, kernel, reciprocals: places }
    }
}

impl Plan {
    /// Separates what depends on no variable that `varies` from the rest: the results of the first plan are the prepared
    /// constants of the second. Exact literals are not prepared; they cost nothing.
    #[must_use]
    pub fn split(&self, varies: impl Fn(crate::poly::Variable) -> bool) -> (Plan, Plan) {
        let mut fixed = vec![true; self.operations.len()];
        for (index, operation) in self.operations.iter().enumerate() {
            fixed[index] = match operation {
                Operation::Input(variable) => !varies(*variable),
                _ => operation.operands().all(|operand| fixed[operand.0]),
            };
        }
        let is_literal = |node: Node| match &self.operations[node.0] {
            Operation::Constant(_) => true,
            Operation::Negate(a) => matches!(self.operations[a.0], Operation::Constant(_)),
            _ => false,
        };
        let mut prepared: Vec<Node> = Vec::new();
        let mut kernel = PlanBuilder::default();
        let mut renamed: Vec<Option<Node>> = vec![None; self.operations.len()];
        let needed = |index: usize| !fixed[index] || self.outputs.contains(&Node(index));
        for (index, operation) in self.operations.iter().enumerate().filter(|(index, _)| needed(*index)) {
            let uses: Vec<Node> =
                if fixed[index] { vec![Node(index)] } else { operation.operands().collect() };
            for operand in uses.into_iter().filter(|operand| fixed[operand.0]) {
                if renamed[operand.0].is_some() {
                    continue;
                }
                renamed[operand.0] = Some(if is_literal(operand) {
                    kernel.include_node(self, operand)
                } else {
                    prepared.push(operand);
                    kernel.prepared(prepared.len() - 1)
                });
            }
            if !fixed[index] {
                let operation = operation.with_operands(|operand| renamed[operand.0].unwrap_or(operand));
                renamed[index] = Some(kernel.exactly(operation));
            }
        }
        let outputs: Vec<Node> =
            self.outputs.iter().map(|output| renamed[output.0].unwrap_or(*output)).collect();
        let mut constants = PlanBuilder::default();
        let all = constants.include_all(self);
        let prepared: Vec<Node> = prepared.iter().map(|node| all[node.0]).collect();
        (constants.finish(&prepared), kernel.finish(&outputs))
    }
}
