//! Straight lines: which operations are computed in which order, every common subexpression once.
//!
//! A plan is data. The emitter turns it into Rust, and [`Plan::evaluate`] runs the same operations
//! in the same order in any [`Arithmetic`]: rationals, a prime field, dual numbers, degree bounds,
//! rational functions, floats.
//!
//! For most plans `horner` nests polynomials, and that is all. A step is computed billions of
//! times, so five modules take more care of its plan, each of which needs those before it only:
//!
//! 1. `step` decides what is prepared and what is computed for each state, and rewrites that.
//! 2. `writing` decides how a polynomial becomes operations: how it is nested, where ε goes, what
//!    is reused.
//! 3. `accuracy` measures what a long step loses, and refuses forms that lose too much.
//! 4. `forms` decides what is computed: which ways there are to solve A·x̃ = b, and the cheapest.
//! 5. `choice` chooses the form for one orbit, and that for lanes.
//!
//! `values` puts in what a field keeps as it was written, `dense` writes the sums of fields with
//! very many products, `cost` says what operations cost, `words`
//! what they are called.
//!
//! # What each optimisation buys
//!
//! Each was left out alone for 85 fields: the catalog, random fields of two to six variables, and
//! four of up to eight. The table says how many steps change, and the time without over the time
//! with it: the geometric mean over the steps that change, and the largest. *Machine code* is what
//! the runtime compiles, for one orbit and for columns; *compiled* is what the macro writes for the
//! catalog and 20 of the random fields, one orbit, for any x86-64 processor and for one with
//! AVX-512.
//!
//! | left out | steps | one orbit | columns | compiled | compiled, AVX-512 |
//! |---|--:|--:|--:|--:|--:|
//! | determinants of A (`forms::minors`) | 26 | 1.12; 2.0 | 1.22; 2.3 | | |
//! | several ways to scale by ε (`writing::scaling`) | 50 | 1.04; 1.45 | 1.05; 1.35 | | |
//! | all forms of one orbit ([`StepPlan::general`]) | 31 | 1.06; 1.28 | 1.00; 1.01 | | |
//! | division by the time step (`forms::inverse`) | 28 | 1.06; 1.25 | 1.00; 1.02 | | |
//! | a second division (`forms::candidates`) | 2 | 1.05; 1.08 | 1.00; 1.00 | 1.04; 1.12 | 1.27; 1.47 |
//! | reuse of sums (`writing::writer::reuse`) | 44 | 1.00; 1.43 | 1.00; 1.35 | | |
//! | signs of constants (`step::signs`) | 27 | 1.00; 1.01 | 1.00; 1.02 | 1.05; 1.43 | 1.01; 1.12 |
//! | signs of reciprocals (`step::reciprocals`) | 30 | 1.01; 1.05 | 0.99; 1.02 | 1.02; 1.56 | 1.01; 1.15 |
//!
//! Two more were measured with them. (2ε)x as εx + εx went (27 steps: 1.00, 0.99, 1.00 and 1.00 in
//! the mean). A division a component in place of a shared reciprocal is left to fields of one
//! variable (`step::increment`); it changed 6 steps (1.00; 1.03, 1.00; 1.01, 0.97; 1.06 and 0.84;
//! 0.93). For Lotka and Volterra's step, compiled for any x86-64 processor, it saved a fifth of the
//! instructions and 6 % of the time. Ensembles that report how they ended took twice the time with
//! it: they take the form of single orbits, and two divisions bound the lanes.

mod operation;

mod cost;

mod builder;

mod include;

mod horner;

mod values;

mod dense;

mod step;

mod words;

mod writing;

mod accuracy;

mod forms;

mod choice;

pub use builder::PlanBuilder;
pub use cost::Cost;
pub(crate) use dense::DenseField;
pub(crate) use forms::structure::blocks as triangular_blocks;
pub use operation::Operation;
pub use step::kernel::Kernel;
pub use step::{LARGEST_SIZE, StepCost, StepPlan};
pub(crate) use words::{descriptions, kind};

use std::borrow::Borrow;
use std::ops::Range;

use kahan_syntax::table::distinct;

use crate::arithmetic::Arithmetic;
use crate::poly::{Polynomial, Variable};

/// The result of an operation: its index in the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Node(pub usize);

/// A straight-line program with several results.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plan {
    /// The operations, operands before their uses, no operation twice.
    pub operations: Vec<Operation>,
    /// The results.
    pub outputs: Vec<Node>,
}

impl Plan {
    /// The plan that computes these polynomials, one result each.
    #[must_use]
    pub fn of<'a>(polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Self {
        let mut builder = PlanBuilder::default();
        let nodes: Vec<Node> =
            polynomials.into_iter().map(|polynomial| builder.polynomial(polynomial)).collect();
        builder.into_plan(&nodes)
    }

    /// Several plans as one, their results one after another; what they share is computed once.
    #[must_use]
    pub fn together<'a>(plans: impl IntoIterator<Item = &'a Plan>) -> Self {
        let mut builder = PlanBuilder::default();
        let outputs: Vec<Node> = plans.into_iter().flat_map(|plan| builder.include(plan)).collect();
        builder.into_plan(&outputs)
    }

    /// The plan of these results, with those of the operations that they need.
    pub(super) fn of_results(steps: &[Operation], outputs: &[Node]) -> Self {
        Plan::of_needed(&places_of_needed(steps, outputs), steps, outputs)
    }

    /// The plan of these results in the memory of the operations.
    pub(super) fn into_results(steps: Vec<Operation>, outputs: &[Node]) -> Self {
        Plan::of_needed(&places_of_needed(&steps, outputs), steps, outputs)
    }

    fn of_needed(
        places: &[Option<Node>],
        steps: impl IntoIterator<Item = impl Borrow<Operation>>,
        outputs: &[Node],
    ) -> Self {
        let place = |node: Node| places[node.0].expect("operands of what is needed are needed");
        let needed = steps.into_iter().zip(places).filter(|(_, place)| place.is_some());
        let operations = needed.map(|(step, _)| step.borrow().with_operands(place)).collect();
        Plan { operations, outputs: outputs.iter().copied().map(place).collect() }
    }

    /// The plan of one result.
    #[must_use]
    pub fn result(&self, index: usize) -> Self {
        self.part(index..index + 1)
    }

    /// The plan of these results.
    #[must_use]
    pub fn part(&self, results: Range<usize>) -> Self {
        Plan::of_results(&self.operations, &self.outputs[results])
    }

    /// Runs the plan; `input` gives the value of each variable. A result that divides by zero on
    /// its way is `None`; the others are not touched by that. Cost: one
    /// arithmetic operation for each of its own.
    pub fn evaluate<A: Arithmetic>(
        &self,
        arithmetic: &A,
        mut input: impl FnMut(Variable) -> A::Value,
    ) -> Vec<Option<A::Value>> {
        self.evaluate_prepared(arithmetic, &[], |variable| Some(input(variable)))
    }

    /// The same with values for the prepared constants; an input without a value leaves what
    /// depends on it without one.
    pub fn evaluate_prepared<A: Arithmetic>(
        &self,
        arithmetic: &A,
        prepared: &[Option<A::Value>],
        mut input: impl FnMut(Variable) -> Option<A::Value>,
    ) -> Vec<Option<A::Value>> {
        let mut values: Vec<Option<A::Value>> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let value = match operation {
                Operation::Input(variable) => input(*variable),
                Operation::Prepared(index) => prepared.get(*index).cloned().flatten(),
                _ => operation.compute(arithmetic, &values),
            };
            values.push(value);
        }
        self.outputs.iter().map(|output| values[output.0].clone()).collect()
    }

    /// The inputs that the results depend on, in order.
    #[must_use]
    pub fn inputs(&self) -> Vec<Variable> {
        let inputs = self.operations.iter().filter_map(|operation| match operation {
            Operation::Input(variable) => Some(*variable),
            _ => None,
        });
        distinct(inputs)
    }

    /// How many times each operation is used, as an operand or as a result.
    #[must_use]
    pub fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.operations.len()];
        for node in self.operations.iter().flat_map(Operation::operands).chain(self.outputs.iter().copied()) {
            uses[node.0] += 1;
        }
        uses
    }
}

/// The place of each operation among those that the results need; `None` for the others.
fn places_of_needed(steps: &[Operation], outputs: &[Node]) -> Vec<Option<Node>> {
    let mut needed = vec![false; steps.len()];
    for output in outputs {
        needed[output.0] = true;
    }
    for (index, step) in steps.iter().enumerate().rev() {
        if needed[index] {
            for operand in step.operands() {
                needed[operand.0] = true;
            }
        }
    }
    let mut count = 0;
    let place = |is_needed: bool| {
        count += usize::from(is_needed);
        is_needed.then(|| Node(count - 1))
    };
    needed.into_iter().map(place).collect()
}
