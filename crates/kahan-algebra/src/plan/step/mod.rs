//! The plan of a step: what is computed once, when ε and the parameters are known, and what is
//! computed for each state.
//!
//! - `split` separates prepared constants from the `kernel`.
//! - `doubling`, `fuse`, `signs` and `reciprocals` rewrite the kernel: doubled constants,
//!   multiply-adds, signs. `single_divisions` gives each component a division of its own.
//! - `recurrence` measures the way from a state to the next.

pub(in crate::plan) mod doubling;
pub(in crate::plan) mod fuse;
pub(in crate::plan) mod kernel;
pub(in crate::plan) mod reciprocals;
pub(in crate::plan) mod recurrence;
pub(in crate::plan) mod signs;
pub(in crate::plan) mod single_divisions;
pub(in crate::plan) mod split;

use std::iter::once;

use crate::field::Field;
use crate::kahan::RationalMap;
use crate::kept::Kept;
use crate::symbols::Symbols;

use crate::plan::accuracy::{Accuracy, LARGEST_SIZE};
use crate::plan::forms::candidate::Candidate;
use crate::plan::forms::candidates;
use crate::plan::step::reciprocals::with_signs_of_reciprocals;
use crate::plan::step::signs::{Wanted, with_signs};
use crate::plan::{Kernel, Node, Operation, Plan, PlanBuilder};

/// What a step costs: the figures that a prepared step carries with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepCost {
    /// Operations from a state to the next, a multiply-add counted twice.
    pub operations: u32,
    /// The divisions among them.
    pub divisions: u32,
    /// Cycles from one state to the next in a long orbit.
    pub critical_path: u32,
}

/// A step in straight lines: x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepPlan {
    /// From ε and the parameters to the prepared constants, in order. It has no states.
    pub constants: Plan,
    /// What is computed for each state.
    pub kernel: Kernel,
    /// Whether the step divides by ε when it is prepared: then it serves floats only, and an ε that
    /// is away from zero.
    pub has_inverse_step: bool,
    /// The plan for lanes, where it is another one: a second division can shorten the critical path
    /// of one orbit, but many orbits at once are bound by the divider. Where this plan [divides by
    /// ε](Self::has_inverse_step), also the one for all scalars but floats, and for an ε near zero.
    pub general: Option<Box<StepPlan>>,
    /// The largest of the sizes ‖εf′‖∞ = 1, 10, 100, 1000 up to which this step loses about as
    /// little as elimination with partial pivoting does: measured by the planner, at seeded points.
    /// [`LARGEST_SIZE`] where nothing more is lost as far as it looks.
    pub holds_to: u32,
}

impl StepPlan {
    /// The plan of a field's step; `None` where the field is too large for straight lines, and is
    /// stepped by elimination.
    #[must_use]
    pub fn of(field: &Field) -> Option<Self> {
        Self::of_map(field, None, RationalMap::of(field).as_ref())
    }

    /// The same from what is known: the products of sums that are kept of the field, and its map,
    /// unless that is beyond the budget.
    #[must_use]
    pub(crate) fn of_map(field: &Field, kept: Option<&Kept>, map: Option<&RationalMap>) -> Option<Self> {
        let is_reduced = |map: &RationalMap| map.reduced.common_factor.as_constant().is_none();
        let kept = kept.filter(|kept| kept.needs_sums(&field.symbols) && !map.is_some_and(is_reduced));
        let plan = |form: &Candidate| Self::new(&form.builder, field, &form.numerators, &form.reciprocals);
        let forms = candidates::forms(field, kept, map)?;
        let accuracy = Accuracy::of(field);
        // The cheapest form serves lanes, and one orbit unless another form lets it wait less.
        let cheapest = plan(&forms.best);
        let recurrence = cheapest.recurrence();
        let one_orbit = forms.of_one_orbit(recurrence);
        let one_orbit: Vec<StepPlan> = once(cheapest.clone()).chain(one_orbit.iter().map(plan)).collect();
        let single: Vec<StepPlan> = one_orbit.iter().filter_map(Self::with_single_divisions).collect();
        let others = one_orbit.into_iter().skip(1).chain(single);
        let shortest = others.min_by_key(|plan| (plan.recurrence(), plan.operations()));
        let shortest = shortest.filter(|shortest| shortest.recurrence() < recurrence);
        // Where the cheapest form loses digits in long steps, a steadier one takes its place.
        let mut loss = accuracy.loss(&cheapest);
        let mut general = cheapest;
        if loss.is_refused() {
            let steady = match kept {
                Some(_) => Vec::new(),
                None => candidates::steady_forms(field, map, &forms.best),
            };
            if let Some(steady) = steady.iter().map(plan).find(|form| accuracy.is_kept(form)) {
                loss = accuracy.loss(&steady);
                general = steady;
            }
        }
        general.holds_to = loss.holds_to();
        let shortest = shortest
            .map(|shortest| (accuracy.loss(&shortest), shortest))
            .filter(|(own, _)| !own.is_refused() || loss.is_refused());
        Some(match shortest {
            Some((own, shortest)) => {
                StepPlan { holds_to: own.holds_to(), general: Some(Box::new(general)), ..shortest }
            }
            None => general,
        })
    }

    /// Operations from a state to the next: the kernel's, the last multiplication where there is
    /// one, and an addition for each component.
    #[must_use]
    pub fn operations(&self) -> usize {
        let products = self.kernel.reciprocal_of.iter().flatten().count();
        self.kernel.plan.cost().operations() + products + self.kernel.dimension()
    }

    /// What the step costs, as generated code says it.
    #[must_use]
    pub fn cost(&self) -> StepCost {
        let count = |n: u64| u32::try_from(n).expect("plans have a budget of terms");
        StepCost {
            operations: count(self.operations() as u64),
            divisions: count(self.kernel.plan.cost().divisions as u64),
            critical_path: count(self.cycles()),
        }
    }

    /// x̃ from x and the prepared constants: the kernel, and its last multiply-add a component.
    ///
    /// A numerator −n is subtracted rather than negated, as every compiler does it.
    #[must_use]
    pub fn next(&self, symbols: &Symbols) -> Plan {
        let mut operations = self.kernel.plan.operations.clone();
        let mut push = |operation: Operation| {
            operations.push(operation);
            Node(operations.len() - 1)
        };
        let mut outputs = Vec::with_capacity(self.kernel.dimension());
        for (i, (&numerator, reciprocal)) in self.kernel.factors(&self.kernel.plan.outputs).enumerate() {
            let state = push(Operation::Input(symbols.state(i)));
            let negated = match self.kernel.plan.operations[numerator.0] {
                Operation::Negate(inner) => Some(inner),
                _ => None,
            };
            outputs.push(push(match (negated, reciprocal.copied()) {
                (Some(inner), Some(reciprocal)) => Operation::SubtractProduct(state, inner, reciprocal),
                (Some(inner), None) => Operation::Subtract(state, inner),
                (None, Some(reciprocal)) => Operation::MultiplyAdd(numerator, reciprocal, state),
                (None, None) => Operation::Add(state, numerator),
            }));
        }
        // Each operation once, and none that no result needs.
        Plan::together([&Plan { operations, outputs }])
    }

    /// Whether values with a name are kept from being packed into vectors.
    ///
    /// Of three components one is left over from every pair, and the shuffles cost up to an eighth
    /// of a step. Two make one vector; for more, what says it would make steps so large that
    /// compilers no longer inline them into loops.
    #[must_use]
    pub fn fences_values(&self) -> bool {
        self.kernel.dimension() == 3
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
        let (constants, kernel) = builder
            .finish(&outputs)
            .split(field.symbols.epsilon(), |variable| field.symbols.is_state(variable));
        // Neither with multiply-adds nor without may the critical path become longer.
        let doubled = kernel.doubled(&constants).fused();
        let kernel = kernel.fused();
        let kernel =
            if doubled.cost().critical_path > kernel.cost().critical_path { kernel } else { doubled };
        let (constants, kernel) = with_signs(constants, kernel, Wanted::TurnedConstants);
        let kernel = with_signs_of_reciprocals(Kernel { plan: kernel, reciprocal_of: places });
        // Reciprocals of parameters are still inputs here; `mapped` puts them in later. So a
        // division that is found now is one by ε.
        let has_inverse_step =
            constants.operations.iter().any(|operation| matches!(operation, Operation::Divide(..)));
        StepPlan { constants, kernel, has_inverse_step, general: None, holds_to: LARGEST_SIZE }
    }

    /// The same step, its constants being what `change` makes of them.
    #[must_use]
    pub(crate) fn mapped(self, change: &dyn Fn(&Plan) -> Plan) -> Self {
        let general = self.general.map(|general| Box::new(general.mapped(change)));
        StepPlan { constants: change(&self.constants), general, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The forms of one orbit below the cheapest form's recurrence, of those that are made up to
    /// `recurrence`, and how many those are.
    fn shorter(field: &Field, map: &RationalMap, recurrence: impl Fn(u64) -> u64) -> (Vec<StepPlan>, usize) {
        let plan =
            |form: &Candidate| StepPlan::new(&form.builder, field, &form.numerators, &form.reciprocals);
        let forms = candidates::forms(field, None, Some(map)).expect("the field is small");
        let limit = plan(&forms.best).recurrence();
        let made: Vec<StepPlan> = forms.of_one_orbit(recurrence(limit)).iter().map(plan).collect();
        let single = made.iter().filter_map(StepPlan::with_single_divisions);
        let shorter = made.iter().cloned().chain(single).filter(|plan| plan.recurrence() < limit);
        (shorter.collect(), made.len())
    }

    #[test]
    fn no_form_that_an_orbit_waits_less_for_is_given_up() {
        let mut given_up = 0;
        for text in [
            "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z;",
            "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;",
            "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);",
            "xdot = x*(1 - y); ydot = y*(x - 1);",
            "struct P { a, b } xdot = a*x*y; ydot = b*y^2 - x;",
            "struct P { a, b, c, d, k } xdot = a*x*(1 - x/k) - b*x*y; ydot = c*x*y - d*y - b*y*z; zdot = b*y*z - a*z;",
        ] {
            let field = crate::read(&kahan_syntax::lexer::lex(text).tokens).system().expect("a system").field;
            let map = RationalMap::of(&field).expect("the field is small");
            let (all, made) = shorter(&field, &map, |_| u64::MAX);
            let (some, fewer) = shorter(&field, &map, |limit| limit);
            assert_eq!(all, some, "{text}");
            given_up += made - fewer;
        }
        assert!(given_up > 0, "no form is given up");
    }
}
