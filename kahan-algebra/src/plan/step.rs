//! The plan of a step: what is computed once, when ε and the parameters are known, and what is computed for each state.

use crate::field::Field;
use crate::kahan::RationalMap;
use crate::rational::Rational;

use super::writer::Writer;
use super::{Node, Operation, Plan, PlanBuilder, candidates};

/// A step in straight lines: x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepPlan {
    /// From ε and the parameters to the prepared constants, in order. It has no states.
    pub constants: Plan,
    /// From the states and the prepared constants ([`Operation::Prepared`]) to the numerators, one a component, followed
    /// by the reciprocals, each a quotient 2/d, or 2/d/d′.
    pub kernel: Plan,
    /// For each component the index of its reciprocal among the kernel's reciprocals; `None` where there is no division.
    pub reciprocals: Vec<Option<usize>>,
    /// The plan for lanes, where it is another one: a second division shortens the chain of one orbit, but many orbits at once
    /// are bound by the divider.
    pub lanes: Option<Box<StepPlan>>,
}

impl StepPlan {
    /// The plan of a field's step; `None` where the field is too large for straight lines, and is stepped by elimination.
    #[must_use]
    pub fn of(field: &Field) -> Option<Self> {
        Self::of_map(field, RationalMap::of(field).as_ref())
    }

    /// The same from a map that has been derived already, or was found to be beyond the budget.
    #[must_use]
    pub fn of_map(field: &Field, map: Option<&RationalMap>) -> Option<Self> {
        let plan = |form: &candidates::Candidate| {
            Self::new(&form.builder, field, &form.numerators, &form.reciprocals)
        };
        let best = plan(&candidates::best(field, map)?);
        let other = map.and_then(|map| candidates::with_two_divisions(field, map)).map(|form| plan(&form));
        Some(match other {
            Some(other) if other.recurrence() < best.recurrence() => {
                StepPlan { lanes: Some(Box::new(best)), ..other }
            }
            _ => best,
        })
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
        // Neither with multiply-adds nor without may the chain become longer.
        let doubled = kernel.doubled(&constants).fused();
        let kernel = kernel.fused();
        let kernel = if doubled.cost().chain > kernel.cost().chain { kernel } else { doubled };
        StepPlan { constants, kernel, reciprocals: places, lanes: None }
    }
}

/// 2/d: that the increment is 2εn/d costs no multiplication by 2.
pub(super) fn twice_reciprocal(writer: &mut Writer, denominator: Node) -> Node {
    let two = writer.draft.constant(&Rational::from(2));
    writer.draft.builder.divide(two, denominator)
}

impl Plan {
    /// How many results are products of two values that both contain ε: constants rounded more than once.
    pub(super) fn derived_constants(&self, epsilon: crate::poly::Variable) -> usize {
        let mut contains = vec![false; self.operations.len()];
        let mut derived = vec![false; self.operations.len()];
        for (index, operation) in self.operations.iter().enumerate() {
            let operands: Vec<Node> = operation.operands().collect();
            contains[index] = matches!(operation, Operation::Input(variable) if *variable == epsilon)
                || operands.iter().any(|operand| contains[operand.0]);
            let both = operands.len() > 1 && operands.iter().all(|operand| contains[operand.0]);
            derived[index] = (both && matches!(operation, Operation::Multiply(..)))
                || operands.iter().any(|operand| derived[operand.0]);
        }
        self.outputs.iter().filter(|output| derived[output.0]).count()
    }

    /// Separates what depends on no variable that `varies` from the rest: the results of the first plan are the prepared
    /// constants of the second. Exact literals are not prepared; they cost nothing.
    #[must_use]
    pub fn split(&self, varies: impl Fn(crate::poly::Variable) -> bool) -> (Plan, Plan) {
        let mut fixed = vec![true; self.operations.len()];
        for (index, operation) in self.operations.iter().enumerate() {
            fixed[index] = match operation {
                Operation::Input(variable) => !varies(*variable),
                // A divisor may be zero, which is a pole of the step and no mistake in preparing it.
                Operation::Divide(..) => false,
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
