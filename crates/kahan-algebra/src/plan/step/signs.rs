//! Chooses signs in a kernel, so that it has few subtractions and few negations. If a prepared
//! constant a − b is computed as b − a, the signs of values that depend on it change.
//!
//! Rounding is symmetric, so x̃ stays the same, apart from the signs of zeros and infinities.
//! Similar components then have equal instructions, which compilers vectorise better.

use crate::plan::{Input, Node, Operation, Plan, PlanBuilder};

/// The cost of a negated result. A subtraction costs 1.
const NEGATION_COST: usize = 4;

const ROUNDS: usize = 4;

/// Chooses the signs of prepared differences such that the kernel has few negations and
/// subtractions. Neither the number of operations nor the critical path increases. The search takes
/// time proportional to operations² for each prepared difference and each subtraction.
#[must_use]
pub(in crate::plan) fn with_signs(constants: Plan, kernel: Plan) -> (Plan, Plan) {
    let search = SignSearch::new(&constants, &kernel);
    if search.prepared.iter().all(Option::is_none) {
        return (constants, kernel);
    }
    let signs = search.signs(&search.best());
    let is_turned = |node: &Option<Node>| node.is_some_and(|node| signs.negative[node.0]);
    let turned: Vec<bool> = search.prepared.iter().map(is_turned).collect();
    let rebuilt = search.rebuilt(&signs);
    let (before, after) = (kernel.cost(), rebuilt.cost());
    let is_no_worse =
        after.operations() <= before.operations() && after.critical_path <= before.critical_path;
    if !turned.contains(&true) || !is_no_worse {
        return (constants, kernel);
    }
    (negate_constants(&constants, &turned), rebuilt)
}

/// A search over the signs of prepared differences and of sums with mixed signs. A choice says for
/// each operation whether its sign is reversed.
struct SignSearch<'a> {
    kernel: &'a Plan,
    /// The node of each prepared difference in the kernel.
    prepared: Vec<Option<Node>>,
    /// Whether the sign of each operation may be chosen.
    is_free: Vec<bool>,
}

struct Signs {
    /// Whether each value is replaced by its negative.
    negative: Vec<bool>,
    is_choice: Vec<bool>,
    cost: usize,
}

impl<'a> SignSearch<'a> {
    fn new(constants: &Plan, kernel: &'a Plan) -> Self {
        let mut prepared = vec![None; constants.outputs.len()];
        let mut is_free = vec![false; kernel.operations.len()];
        for (index, operation) in kernel.operations.iter().enumerate() {
            if let Operation::Input(Input::Prepared(place)) = *operation {
                let source = &constants.operations[constants.outputs[place].0];
                if matches!(source, Operation::Subtract(..)) {
                    prepared[place] = Some(Node(index));
                    is_free[index] = true;
                }
            }
        }
        SignSearch { kernel, prepared, is_free }
    }

    /// Returns the best choice that [`Self::locally_improved`] finds from several starts. Some
    /// starts reverse the sign of a single constant, or of everything on which a negated result
    /// depends.
    fn best(&self) -> Vec<bool> {
        let none = vec![false; self.kernel.operations.len()];
        let mut best = self.locally_improved(none.clone());
        let mut cost = self.signs(&best).cost;
        let mut compare = |turned: Vec<bool>, best: &mut Vec<bool>| {
            let other = self.locally_improved(turned);
            let other_cost = self.signs(&other).cost;
            if other_cost < cost {
                (*best, cost) = (other, other_cost);
            }
        };
        for Node(index) in self.prepared.iter().copied().flatten() {
            for mut turned in [best.clone(), none.clone()] {
                turned[index] = !turned[index];
                compare(turned, &mut best);
            }
        }
        for output in 0..self.kernel.outputs.len() {
            if self.signs(&best).negative[self.kernel.outputs[output].0] {
                let mut turned = best.clone();
                self.turn_all_before(self.kernel.outputs[output], &mut turned);
                compare(turned, &mut best);
            }
        }
        best
    }

    fn turn_all_before(&self, node: Node, reversed: &mut [bool]) {
        let mut is_before = vec![false; self.kernel.operations.len()];
        is_before[node.0] = true;
        for index in (0..=node.0).rev().filter(|&index| !self.is_free[index]) {
            if is_before[index] {
                reversed[index] = !reversed[index];
                for operand in self.kernel.operations[index].operands() {
                    is_before[operand.0] = true;
                }
            }
        }
    }

    /// Reverses single choices as long as the cost falls.
    fn locally_improved(&self, mut reversed: Vec<bool>) -> Vec<bool> {
        let mut best = self.signs(&reversed);
        for _ in 0..ROUNDS {
            let before = best.cost;
            for index in 0..reversed.len() {
                if !best.is_choice[index] || self.is_free[index] {
                    continue;
                }
                reversed[index] = !reversed[index];
                let other = self.signs(&reversed);
                if other.cost < best.cost {
                    best = other;
                } else {
                    reversed[index] = !reversed[index];
                }
            }
            if best.cost == before {
                break;
            }
        }
        reversed
    }

    fn signs(&self, reversed: &[bool]) -> Signs {
        let length = self.kernel.operations.len();
        let mut signs =
            Signs { negative: Vec::with_capacity(length), is_choice: Vec::with_capacity(length), cost: 0 };
        for (index, operation) in self.kernel.operations.iter().enumerate() {
            let of = |node: Node| signs.negative[node.0];
            let (negative, is_choice) = match *operation {
                Operation::Input(Input::Prepared(_)) => {
                    (self.is_free[index] && reversed[index], self.is_free[index])
                }
                Operation::Input(_) | Operation::Constant(_) => (false, false),
                Operation::Negate(a) => (!of(a), false),
                Operation::Multiply(a, b) | Operation::Divide(a, b) => (of(a) != of(b), false),
                _ => {
                    let (first, second) = summands(operation, of);
                    if first == second { (first, false) } else { (reversed[index], true) }
                }
            };
            if is_choice && !self.is_free[index] {
                signs.cost += 1;
            }
            signs.negative.push(negative);
            signs.is_choice.push(is_choice);
        }
        signs.cost +=
            NEGATION_COST * self.kernel.outputs.iter().filter(|output| signs.negative[output.0]).count();
        signs
    }

    fn rebuilt(&self, signs: &Signs) -> Plan {
        let mut builder = PlanBuilder::default();
        let renamed = builder.include_with(self.kernel, |builder, index, renamed| {
            let operation = &self.kernel.operations[index];
            let new = |node: Node| renamed[node.0];
            let (first, second) = summands(operation, |node| signs.negative[node.0]);
            let (first, second) = (first != signs.negative[index], second != signs.negative[index]);
            let operation = match *operation {
                Operation::Negate(a) => return renamed[a.0],
                Operation::Add(a, b) | Operation::Subtract(a, b) => match (first, second) {
                    (false, false) => Operation::Add(new(a), new(b)),
                    (false, true) => Operation::Subtract(new(a), new(b)),
                    _ => Operation::Subtract(new(b), new(a)),
                },
                Operation::MultiplyAdd(a, b, c)
                | Operation::MultiplySubtract(a, b, c)
                | Operation::SubtractProduct(c, a, b) => {
                    let is_difference = matches!(operation, Operation::SubtractProduct(..));
                    let (product, addend) = if is_difference { (second, first) } else { (first, second) };
                    match (product, addend) {
                        (false, false) => Operation::MultiplyAdd(new(a), new(b), new(c)),
                        (false, true) => Operation::MultiplySubtract(new(a), new(b), new(c)),
                        _ => Operation::SubtractProduct(new(c), new(a), new(b)),
                    }
                }
                _ => operation.with_operands(new),
            };
            builder.push(operation)
        });
        let carried = |output: &Node| match signs.negative[output.0] {
            true => builder.changed_sign(renamed[output.0]),
            false => renamed[output.0],
        };
        let outputs: Vec<Node> = self.kernel.outputs.iter().map(carried).collect();
        builder.finish(&outputs)
    }
}

/// Returns for each of the two summands of an operation whether it is subtracted. The function `of`
/// returns whether an operand is negated. Returns (false, false) for operations without summands.
fn summands(operation: &Operation, of: impl Fn(Node) -> bool) -> (bool, bool) {
    match *operation {
        Operation::Add(a, b) => (of(a), of(b)),
        Operation::Subtract(a, b) => (of(a), !of(b)),
        Operation::MultiplyAdd(a, b, c) => (of(a) != of(b), of(c)),
        Operation::MultiplySubtract(a, b, c) => (of(a) != of(b), !of(c)),
        Operation::SubtractProduct(a, b, c) => (of(a), of(b) == of(c)),
        _ => (false, false),
    }
}

fn negate_constants(constants: &Plan, turned: &[bool]) -> Plan {
    let mut builder = PlanBuilder::default();
    let all = builder.include_all(&constants.operations);
    let output = |(output, turned): (&Node, &bool)| match constants.operations[output.0] {
        Operation::Subtract(a, b) if *turned => builder.push(Operation::Subtract(all[b.0], all[a.0])),
        _ => all[output.0],
    };
    let outputs: Vec<Node> = constants.outputs.iter().zip(turned).map(output).collect();
    builder.finish(&outputs)
}

#[cfg(test)]
mod tests;
