//! A plan under construction. Values that are ready late are usually combined last.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

use kahan_syntax::rational::Rational;
use kahan_syntax::table::sorted_by_key;

use crate::poly::Variable;

use crate::plan::writing::scaling::Scaling;
use crate::plan::{Input, Node, Operation, PlanBuilder};

#[derive(Clone, Debug)]
pub(in crate::plan) struct PlanDraft {
    pub(in crate::plan) builder: PlanBuilder,
    ready: Vec<u32>,
    fixed: Vec<bool>,
    /// The number of state-dependent operations up to and including each operation, without inputs.
    sizes: Vec<usize>,
    /// The number of states. Variables are ordered: states, then parameters, then ε.
    states: u16,
    epsilon: Variable,
    /// Whether constants may be multiplied with each other. [`Self::product`] explains the effect.
    folds: bool,
}

impl PlanDraft {
    pub(in crate::plan) fn new(scaling: &Scaling) -> Self {
        PlanDraft {
            builder: PlanBuilder::default(),
            ready: Vec::new(),
            fixed: Vec::new(),
            sizes: Vec::new(),
            states: scaling.states(),
            epsilon: scaling.epsilon(),
            folds: scaling.folds,
        }
    }

    fn settle(&mut self) {
        for operation in &self.builder.operations()[self.ready.len()..] {
            let fixed = match operation {
                Operation::Input(Input::Variable(variable)) => {
                    (self.states..=self.epsilon.0).contains(&variable.0)
                }
                Operation::Divide(_, divisor) => {
                    self.builder.operations()[divisor.0] == Operation::Input(Input::Variable(self.epsilon))
                }
                _ => operation.operands().all(|operand| self.fixed[operand.0]),
            };
            let operands = operation.operands().map(|operand| self.ready[operand.0]).max().unwrap_or(0);
            self.ready.push(if fixed { 0 } else { operands + operation.latency() });
            self.fixed.push(fixed);
            let is_counted = !fixed && !matches!(operation, Operation::Input(_));
            let size = self.sizes.last().copied().unwrap_or(0);
            self.sizes.push(size + usize::from(is_counted));
        }
    }

    pub(in crate::plan) fn ready(&mut self, node: Node) -> u32 {
        self.settle();
        self.ready[node.0]
    }

    pub(in crate::plan) fn size_of(&mut self, node: Node) -> usize {
        self.settle();
        let operations = self.builder.operations();
        let mut needed = vec![false; operations.len()];
        needed[node.0] = true;
        let mut size = 0;
        for index in (0..=node.0).rev().filter(|&index| !self.fixed[index]) {
            if needed[index] {
                size += usize::from(!matches!(operations[index], Operation::Input(_)));
                for operand in operations[index].operands() {
                    needed[operand.0] = true;
                }
            }
        }
        size
    }

    pub(in crate::plan) fn length(&self) -> usize {
        self.builder.operations().len()
    }

    pub(in crate::plan) fn truncate(&mut self, length: usize) {
        self.builder.truncate(length);
        self.ready.truncate(length);
        self.fixed.truncate(length);
        self.sizes.truncate(length);
    }

    pub(in crate::plan) fn kernel_size(&mut self) -> usize {
        self.settle();
        self.sizes.last().copied().unwrap_or(0)
    }

    pub(in crate::plan) fn input(&mut self, variable: Variable) -> Node {
        self.builder.input(variable)
    }

    pub(in crate::plan) fn constant(&mut self, value: &Rational) -> Node {
        self.builder.constant(value)
    }

    pub(in crate::plan) fn zero(&mut self) -> Node {
        self.constant(&Rational::zero())
    }

    pub(in crate::plan) fn is_zero(&self, signed: Signed) -> bool {
        self.builder.is_zero(signed.node)
    }

    pub(in crate::plan) fn multiply(&mut self, a: Node, b: Node) -> Node {
        self.builder.multiply(a, b)
    }

    /// Returns the product of all factors. Existing products are preferred, then factors that are
    /// ready early.
    ///
    /// Products of two prepared constants are avoided unless `folds` is set. The rounding error of
    /// such a product is the same in every step, so the errors add up, and integrals drift.
    pub(in crate::plan) fn product(&mut self, factors: &[Node]) -> Node {
        match factors {
            [] => return self.constant(&Rational::one()),
            [a, b] => return self.multiply(*a, *b),
            _ => {}
        }
        let mut factors = factors.to_vec();
        while factors.len() > 2 {
            factors = self.sorted(factors, |node| *node);
            let fixed = factors.iter().filter(|node| self.fixed[node.0]).count();
            let earliest =
                if !self.folds && (1..factors.len()).contains(&fixed) { (fixed - 1, fixed) } else { (0, 1) };
            let (first, second) = self.known_pair(&factors).unwrap_or(earliest);
            let b = factors.remove(second);
            let a = factors.remove(first);
            factors.push(self.multiply(a, b));
        }
        factors.into_iter().reduce(|a, b| self.multiply(a, b)).expect("there is a factor")
    }

    /// Returns the positions of two `factors` whose product exists already. Equal `factors` must be
    /// adjacent. Returns `None` if there are too many different factors.
    fn known_pair(&self, factors: &[Node]) -> Option<(usize, usize)> {
        const MOST_COMPARED: usize = 64;

        let mut runs: Vec<Range<usize>> = Vec::new();
        for run in factors.chunk_by(|a, b| a == b) {
            let start = runs.last().map_or(0, |last| last.end);
            runs.push(start..start + run.len());
        }
        if runs.len() > MOST_COMPARED {
            return None;
        }
        let mut known: Vec<(usize, usize)> = Vec::new();
        let mut partners = vec![0; runs.len()];
        for (i, one) in runs.iter().enumerate() {
            for (j, other) in runs.iter().enumerate().skip(i) {
                let is_pair = i != j || one.len() > 1;
                if is_pair && self.builder.has_product(factors[one.start], factors[other.start]) {
                    known.push((i, j));
                    partners[i] += other.len() - usize::from(i == j);
                    if i != j {
                        partners[j] += one.len();
                    }
                }
            }
        }
        let (i, j) = known.into_iter().min_by_key(|&(i, j)| partners[i].min(partners[j]))?;
        Some((runs[i].start, runs[j].start + usize::from(i == j)))
    }

    /// Returns the sum of signed terms. Early terms are added first.
    pub(in crate::plan) fn sum(&mut self, terms: &[Signed]) -> Node {
        let sum = self.signed_sum(terms);
        self.node(sum)
    }

    pub(in crate::plan) fn node(&mut self, signed: Signed) -> Node {
        if signed.negative { self.builder.negate(signed.node) } else { signed.node }
    }

    /// Returns a node and a sign. Their product is the sum of the signed terms.
    pub(in crate::plan) fn signed_sum(&mut self, terms: &[Signed]) -> Signed {
        self.settle();
        let waiting = terms.iter().zip(0_i64..);
        let mut waiting: BinaryHeap<_> =
            waiting.map(|(&term, place)| Reverse((self.order(term.node), place, term))).collect();
        let mut made = 0;
        while let Some(Reverse((_, _, first))) = waiting.pop() {
            let Some(Reverse((_, _, second))) = waiting.pop() else { return first };
            let sum = self.pair(first, second);
            self.settle();
            made -= 1;
            waiting.push(Reverse((self.order(sum.node), made, sum)));
        }
        Signed::plus(self.zero())
    }

    fn pair(&mut self, a: Signed, b: Signed) -> Signed {
        match (a.negative, b.negative) {
            (false, false) => Signed::plus(self.builder.add(a.node, b.node)),
            (false, true) => Signed::plus(self.builder.subtract(a.node, b.node)),
            (true, false) => Signed::plus(self.builder.subtract(b.node, a.node)),
            (true, true) => Signed { node: self.builder.add(a.node, b.node), negative: true },
        }
    }

    /// Sorts values by the cycle when they are ready. Constants come first.
    fn sorted<V>(&mut self, values: Vec<V>, node: impl Fn(&V) -> Node) -> Vec<V> {
        self.settle();
        sorted_by_key(values, |value| self.order(node(value)))
    }

    fn order(&self, node: Node) -> (bool, u32, Node) {
        (!self.fixed[node.0], self.ready[node.0], node)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::plan) struct Signed {
    pub(in crate::plan) node: Node,
    pub(in crate::plan) negative: bool,
}

impl Signed {
    pub(in crate::plan) fn plus(node: Node) -> Self {
        Signed { node, negative: false }
    }

    pub(in crate::plan) fn flipped(self, flip: bool) -> Self {
        Signed { negative: self.negative != flip, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::writing::scaling::scalings;

    fn product_of(names: u16, times: usize) -> PlanDraft {
        let field = crate::read(&crate::lexer::lex("xdot = x;").tokens).system().expect("a system").field;
        let mut draft = PlanDraft::new(&scalings(&field)[0]);
        let factors: Vec<Node> = (1..=names).map(|name| draft.input(Variable(name))).collect();
        draft.product(&factors.repeat(times));
        draft
    }

    #[test]
    fn a_long_power_is_made_by_squaring() {
        assert_eq!(product_of(1, 1 << 10).length(), 11);
    }

    #[test]
    fn a_long_product_is_made_factor_by_factor() {
        assert_eq!(product_of(4000, 1).length(), 4000 + 3999);
    }
}
