//! Writes scaled polynomials as steps, reusing what is there already: a polynomial that was computed before, up to its
//! sign, and one of which a multiple shortens the polynomial at hand.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use crate::poly::{Monomial, Polynomial, Variable};
use crate::rational::Rational;

use super::Node;
use super::draft::{Draft, Signed};
use super::minors::Entry;
use super::nesting::{Goal, Nesting, Part};
use super::scaling::{Scaling, is_power_of_two};

/// The most terms of a polynomial for which multiples of others are looked for: their number grows with its square.
const REUSED: usize = 24;

/// The most terms for which a constant that they have in common may stay inside: its product with each of their factors may be
/// a step already.
const SHARED: usize = 3;

/// A draft with the polynomials that its steps compute.
#[derive(Clone, Debug)]
pub(super) struct Writer {
    pub(super) draft: Draft,
    pub(super) scaling: Scaling,
    /// Steps by polynomial, its leading coefficient positive.
    known: FxHashMap<Polynomial, Signed>,
    /// The keys of `known`, in the order of their making.
    made: Vec<Polynomial>,
    /// Sums among them.
    sums: Vec<Polynomial>,
    /// Steps that stand for symbols.
    put: Vec<(Variable, Node)>,
    /// Sums of constants that were prepared as one.
    coefficients: Vec<Polynomial>,
    /// Forms for `Goal::Early` and `Goal::Few`.
    nestings: [Nesting; 2],
}

impl Writer {
    pub(super) fn new(scaling: Scaling) -> Self {
        let nestings = [Goal::Early, Goal::Few].map(|goal| Nesting::new(goal, scaling.clone()));
        Writer {
            draft: Draft::new(scaling.states(), scaling.folds),
            scaling,
            known: FxHashMap::default(),
            made: Vec::new(),
            sums: Vec::new(),
            put: Vec::new(),
            coefficients: Vec::new(),
            nestings,
        }
    }

    /// A plain or scaled symbol.
    pub(super) fn variable(&mut self, variable: Variable) -> Node {
        match self.scaling.unscaled(variable) {
            None => self.symbol(variable),
            Some(symbol) => {
                let (eps, symbol) = (self.draft.input(self.scaling.epsilon()), self.symbol(symbol));
                self.draft.multiply(eps, symbol)
            }
        }
    }

    /// A plain symbol; a state of the next point is a step.
    fn symbol(&mut self, symbol: Variable) -> Node {
        let put = self.put.iter().find(|(variable, _)| *variable == symbol).map(|(_, node)| *node);
        put.unwrap_or_else(|| self.draft.input(symbol))
    }

    /// From now on a step stands for this symbol.
    pub(super) fn put(&mut self, symbol: Variable, node: Node) {
        self.put.push((symbol, node));
    }

    /// A polynomial, made for the goal.
    pub(super) fn write(&mut self, polynomial: &Polynomial, goal: Goal) -> Signed {
        let (sign, positive) = normalised(polynomial);
        if let Some(&known) = self.known.get(&positive) {
            return flipped(known, sign);
        }
        let written = self.write_new(&positive, goal);
        self.remember(&positive, written);
        flipped(written, sign)
    }

    /// A polynomial in plain symbols and ε, its powers of ε distributed in the first way.
    pub(super) fn write_scaled(&mut self, polynomial: &Polynomial, goal: Goal) -> Signed {
        let scaled = self.scaling.scale_first(polynomial);
        self.write(&scaled, goal)
    }

    /// Notes that a step computes this polynomial in plain symbols and ε.
    pub(super) fn remember_scaled(&mut self, polynomial: &Polynomial, written: Signed) {
        let scaled = self.scaling.scale_first(polynomial);
        self.remember(&scaled, written);
    }

    /// The same in the way that adds the fewest steps.
    pub(super) fn write_cheapest(&mut self, polynomial: &Polynomial) -> Signed {
        let ways = self.scaling.ways(polynomial);
        let written = self.cheapest(&ways, |writer, way| writer.write(way, Goal::Few), |_| 0);
        written.unwrap_or_else(|| Signed::plus(self.draft.zero()))
    }

    /// An entry of a matrix, its powers of ε distributed in the first way.
    pub(super) fn entry(&mut self, polynomial: &Polynomial, goal: Goal) -> Entry {
        let polynomial = self.scaling.scale_first(polynomial);
        let written = self.write(&polynomial, goal);
        Entry { polynomial, written }
    }

    /// The same in the way that adds the fewest steps.
    pub(super) fn cheapest_entry(&mut self, polynomial: &Polynomial) -> Entry {
        let ways = self.scaling.ways(polynomial);
        let write = |writer: &mut Self, way: &Polynomial| Entry {
            polynomial: way.clone(),
            written: writer.write(way, Goal::Few),
        };
        let entry = self.cheapest(&ways, write, |_| 0);
        entry.unwrap_or_else(|| Entry {
            polynomial: Polynomial::zero(),
            written: Signed::plus(self.draft.zero()),
        })
    }

    /// The step that computes this polynomial over scaled symbols, if there is one.
    pub(super) fn known(&mut self, polynomial: &Polynomial) -> Option<Signed> {
        let polynomial = if self.scaling.folds { self.gathered(polynomial) } else { polynomial.clone() };
        let (sign, positive) = normalised(&polynomial);
        self.known.get(&positive).map(|&known| flipped(known, sign))
    }

    /// The factors of a term, in the way that adds the fewest steps, and its sign.
    pub(super) fn cheapest_term(&mut self, term: &Polynomial) -> (Vec<Node>, bool) {
        let ways = self.scaling.ways(term);
        let factors = |writer: &mut Self, way: &Polynomial| {
            way.leading_term()
                .map(|(monomial, coefficient)| writer.factors_of_term(monomial, coefficient))
                .unwrap_or_default()
        };
        self.cheapest(&ways, factors, |(nodes, _)| nodes.len()).unwrap_or_default()
    }

    /// Notes that a step computes this polynomial.
    pub(super) fn remember(&mut self, polynomial: &Polynomial, written: Signed) {
        let (sign, positive) = normalised(polynomial);
        if self.known.contains_key(&positive) {
            return;
        }
        if positive.len() > 1 {
            self.sums.push(positive.clone());
        }
        self.made.push(positive.clone());
        self.known.insert(positive, flipped(written, sign));
    }

    /// The attempt that makes the fewest steps, its result's own price added; the others leave no trace.
    pub(super) fn cheapest<A, R>(
        &mut self,
        attempts: &[A],
        mut write: impl FnMut(&mut Self, &A) -> R,
        price: impl Fn(&R) -> usize,
    ) -> Option<R> {
        let (first, rest) = attempts.split_first()?;
        if rest.is_empty() {
            return Some(write(self, first));
        }
        let (length, made, sums) = (self.draft.length(), self.made.len(), self.sums.len());
        let (put, coefficients) = (self.put.len(), self.coefficients.len());
        let mut best: Option<(usize, &A)> = None;
        for attempt in attempts {
            let result = write(self, attempt);
            let size = self.draft.kernel_size() + price(&result);
            if best.is_none_or(|(least, _)| size < least) {
                best = Some((size, attempt));
            }
            self.draft.truncate(length);
            self.sums.truncate(sums);
            self.put.truncate(put);
            self.coefficients.truncate(coefficients);
            for polynomial in self.made.drain(made..) {
                self.known.remove(&polynomial);
            }
        }
        best.map(|(_, attempt)| write(self, attempt))
    }

    /// The polynomial with each sum of constants that multiplies one product of states as one coefficient; of products of
    /// constants only where they may be rounded twice.
    fn gathered(&mut self, polynomial: &Polynomial) -> Polynomial {
        let scaling = self.scaling.clone();
        let groups = polynomial.group(|variable| scaling.ready(variable).is_some());
        let mut terms = Vec::new();
        for (states, coefficient) in groups {
            let is_plain = coefficient.degree() < 2;
            if coefficient.len() < 2 || states.is_one() || !(self.scaling.folds || is_plain) {
                terms.extend(
                    coefficient.terms().map(|(monomial, value)| (states.mul(monomial), value.clone())),
                );
                continue;
            }
            let (content, sum) = (coefficient.content(), coefficient.primitive_part());
            let variable = self.coefficient(&sum);
            terms.push((states.mul(&Monomial::variable(variable)), content));
        }
        Polynomial::from_terms(terms)
    }

    /// The variable that stands for a sum of constants.
    fn coefficient(&mut self, sum: &Polynomial) -> Variable {
        if let Some(k) = self.coefficients.iter().position(|known| known == sum) {
            return self.scaling.coefficient(k);
        }
        let variable = self.scaling.coefficient(self.coefficients.len());
        let terms = sum.terms().map(|(monomial, value)| (monomial.clone(), value.clone())).collect();
        let written = self.fixed_sum(terms);
        let node = if written.negative { self.draft.builder.negate(written.node) } else { written.node };
        self.coefficients.push(sum.clone());
        self.put(variable, node);
        variable
    }

    fn write_new(&mut self, polynomial: &Polynomial, goal: Goal) -> Signed {
        let gathered = self.gathered(polynomial);
        if gathered != *polynomial {
            return self.write(&gathered, goal);
        }
        if let Some(value) = polynomial.as_constant() {
            return Signed::plus(self.draft.constant(&value));
        }
        let common = polynomial.monomial_content();
        let content = polynomial.content();
        if polynomial.len() == 1 {
            return self.term(&common, &content, None);
        }
        if !common.is_one() || !content.is_one() {
            let inner = polynomial.div_monomial(&common).unwrap_or_default().primitive_part();
            if goal == Goal::Few && inner.len() <= SHARED && self.has_constant(&common) {
                let write = |writer: &mut Self, apart: &bool| match apart {
                    true => writer.multiple(&common, &content, &inner, goal),
                    false => writer.write_flat(polynomial),
                };
                let written = self.cheapest(&[true, false], write, |_| 0);
                return written.unwrap_or_else(|| Signed::plus(self.draft.zero()));
            }
            return self.multiple(&common, &content, &inner, goal);
        }
        if goal == Goal::Few
            && polynomial.len() <= REUSED
            && let Some(written) = self.write_reusing(polynomial)
        {
            return written;
        }
        self.write_nested(polynomial, goal)
    }

    fn has_constant(&self, monomial: &Monomial) -> bool {
        monomial.powers().iter().any(|(variable, _)| self.scaling.ready(*variable).is_none())
    }

    /// Term by term.
    fn write_flat(&mut self, polynomial: &Polynomial) -> Signed {
        let terms: Vec<Signed> = polynomial
            .terms()
            .map(|(monomial, coefficient)| self.term(monomial, coefficient, None))
            .collect();
        self.draft.signed_sum(&terms)
    }

    fn write_nested(&mut self, polynomial: &Polynomial, goal: Goal) -> Signed {
        let nesting = self.nestings[usize::from(goal == Goal::Few)].clone();
        let mut fixed = Vec::new();
        let mut terms = Vec::new();
        let mut parts = nesting.best(polynomial);
        // Low degrees first: their products can be factors of the others.
        parts.sort_by_key(|part| match part {
            Part::Term(monomial, _) => monomial.degree(),
            Part::Product(..) => 0,
        });
        for part in parts {
            match part {
                Part::Term(monomial, coefficient) if nesting.is_fixed(&monomial) => {
                    fixed.push((monomial, coefficient));
                }
                Part::Term(monomial, coefficient) => terms.push(self.term(&monomial, &coefficient, None)),
                Part::Product(monomial, content, inner) => {
                    terms.push(self.multiple(&monomial, &content, &inner, goal));
                }
            }
        }
        if !fixed.is_empty() {
            terms.push(self.fixed_sum(fixed));
        }
        self.draft.signed_sum(&terms)
    }

    /// What depends on no state: one prepared constant, whatever it costs.
    fn fixed_sum(&mut self, terms: Vec<(Monomial, Rational)>) -> Signed {
        let nodes: Vec<Signed> =
            terms.iter().map(|(monomial, coefficient)| self.term(monomial, coefficient, None)).collect();
        self.draft.signed_sum(&nodes)
    }

    /// coefficient · monomial · inner
    fn multiple(
        &mut self,
        monomial: &Monomial,
        coefficient: &Rational,
        inner: &Polynomial,
        goal: Goal,
    ) -> Signed {
        let written = self.write(inner, goal);
        let product = self.term(monomial, coefficient, Some(written.node));
        Signed { node: product.node, negative: product.negative != written.negative }
    }

    /// coefficient · monomial · factor
    fn term(&mut self, monomial: &Monomial, coefficient: &Rational, factor: Option<Node>) -> Signed {
        let (mut factors, negative) = self.factors_of_term(monomial, coefficient);
        factors.extend(factor);
        Signed { node: self.draft.product(&factors), negative }
    }

    /// The factors of a term and its sign. A power of two goes into the ε of a scaled symbol, where it costs nothing.
    pub(super) fn factors_of_term(
        &mut self,
        monomial: &Monomial,
        coefficient: &Rational,
    ) -> (Vec<Node>, bool) {
        let negative = coefficient.is_negative();
        let size = if negative { -coefficient } else { coefficient.clone() };
        let mut symbols: Vec<Variable> = monomial
            .powers()
            .iter()
            .flat_map(|&(variable, exponent)| std::iter::repeat_n(variable, exponent as usize))
            .collect();
        let mut factors: Vec<Node> = Vec::new();
        if self.scaling.folds {
            return (self.folded_factors(&size, &symbols), negative);
        }
        if !size.is_one() {
            let scaled = symbols.iter().position(|&variable| self.scaling.unscaled(variable).is_some());
            match scaled.filter(|_| is_power_of_two(&size)) {
                Some(place) => {
                    let symbol = self.scaling.unscaled(symbols.remove(place));
                    factors.push(self.scaled_by(&size, symbol));
                }
                None => factors.push(self.draft.constant(&size)),
            }
        }
        factors.extend(symbols.into_iter().map(|variable| self.variable(variable)));
        (factors, negative)
    }

    /// The same with all constants in one, and that in the ε of a scaled state if there is one.
    fn folded_factors(&mut self, size: &Rational, symbols: &[Variable]) -> Vec<Node> {
        let is_state = |variable: &Variable| self.scaling.ready(*variable).is_some();
        let (mut states, constants): (Vec<Variable>, Vec<Variable>) =
            symbols.iter().partition(|v| is_state(v));
        let mut fixed: Vec<Node> = constants.into_iter().map(|variable| self.variable(variable)).collect();
        if !size.is_one() {
            fixed.push(self.draft.constant(size));
        }
        let mut factors = Vec::new();
        if !fixed.is_empty() {
            let scaled = states.iter().position(|&variable| self.scaling.unscaled(variable).is_some());
            if let Some(symbol) = scaled.and_then(|place| self.scaling.unscaled(states.remove(place))) {
                fixed.push(self.draft.input(self.scaling.epsilon()));
                factors.push(self.symbol(symbol));
            }
            let fixed = self.draft.product(&fixed);
            match factors.pop() {
                Some(symbol) => factors.push(self.draft.multiply(fixed, symbol)),
                None => factors.push(fixed),
            }
        }
        factors.extend(states.into_iter().map(|variable| self.variable(variable)));
        factors
    }

    /// (cε)·v with cε prepared.
    fn scaled_by(&mut self, c: &Rational, symbol: Option<Variable>) -> Node {
        let (eps, c) = (self.draft.input(self.scaling.epsilon()), self.draft.constant(c));
        let prepared = self.draft.multiply(c, eps);
        match symbol {
            Some(symbol) => {
                let symbol = self.symbol(symbol);
                self.draft.multiply(prepared, symbol)
            }
            None => prepared,
        }
    }

    /// The polynomial as multiples of sums that exist already, and a rest; `None` where no multiple shortens it.
    fn write_reusing(&mut self, polynomial: &Polynomial) -> Option<Signed> {
        let mut rest = polynomial.clone();
        let mut multipliers: BTreeMap<usize, Polynomial> = BTreeMap::new();
        while let Some((sum, multiplier, left)) = self.best_multiple(&rest) {
            let entry = multipliers.entry(sum).or_default();
            *entry = &*entry + &multiplier;
            rest = left;
        }
        if multipliers.is_empty() {
            return None;
        }
        let mut terms = Vec::new();
        for (sum, multiplier) in multipliers {
            let sum = self.known[&self.sums[sum]];
            let multiplier = self.write(&multiplier, Goal::Few);
            let node = self.draft.product(&[multiplier.node, sum.node]);
            terms.push(Signed { node, negative: multiplier.negative != sum.negative });
        }
        if !rest.is_zero() {
            terms.push(self.write(&rest, Goal::Few));
        }
        Some(self.draft.signed_sum(&terms))
    }

    /// The sum g and the term m for which P − m·g is shortest, if it is shorter by two terms, or nothing.
    fn best_multiple(&self, polynomial: &Polynomial) -> Option<(usize, Polynomial, Polynomial)> {
        let mut best: Option<(usize, usize, Multiple)> = None;
        for (index, sum) in self.sums.iter().enumerate().filter(|(_, sum)| sum.len() <= polynomial.len()) {
            let least = best.as_ref().map_or(polynomial.len() - 1, |(left, ..)| *left);
            if let Some((left, multiple)) = shortest_rest(polynomial, sum, least) {
                best = Some((left, index, multiple));
            }
        }
        let (_, index, Multiple { monomial, ratio, .. }) = best?;
        let multiplier = Polynomial::term(monomial, ratio);
        let left = polynomial - &(&multiplier * &self.sums[index]);
        Some((index, multiplier, left))
    }
}

/// A term m, and how m·g meets a polynomial.
struct Multiple {
    monomial: Monomial,
    ratio: Rational,
    /// Terms of m·g that the polynomial has,
    equal: usize,
    /// and those that it has with another coefficient.
    unequal: usize,
}

/// The term m that leaves the fewest terms of P − m·g, if that are fewer than `least`.
fn shortest_rest(polynomial: &Polynomial, sum: &Polynomial, least: usize) -> Option<(usize, Multiple)> {
    let mut multiples: Vec<Multiple> = Vec::new();
    for (monomial, coefficient) in polynomial.terms() {
        for (divisor, scale) in sum.terms() {
            let Some(quotient) = monomial.div(divisor) else { continue };
            let Some(ratio) = coefficient.checked_div(scale) else { continue };
            let mut is_known = false;
            for multiple in multiples.iter_mut().filter(|multiple| multiple.monomial == quotient) {
                if multiple.ratio == ratio {
                    multiple.equal += 1;
                    is_known = true;
                } else {
                    multiple.unequal += 1;
                }
            }
            if !is_known {
                let others = multiples.iter().filter(|multiple| multiple.monomial == quotient);
                let unequal = others.map(|multiple| multiple.equal).sum();
                multiples.push(Multiple { monomial: quotient, ratio, equal: 1, unequal });
            }
        }
    }
    let rest = |multiple: &Multiple| polynomial.len() + sum.len() - 2 * multiple.equal - multiple.unequal;
    let best = multiples.into_iter().filter(|multiple| multiple.equal > 1).min_by_key(rest)?;
    let left = rest(&best);
    (left < least).then_some((left, best))
}

/// The sign of the leading coefficient, and the polynomial with a positive one.
fn normalised(polynomial: &Polynomial) -> (bool, Polynomial) {
    let negative = polynomial.leading_term().is_some_and(|(_, coefficient)| coefficient.is_negative());
    (negative, if negative { -polynomial } else { polynomial.clone() })
}

fn flipped(signed: Signed, flip: bool) -> Signed {
    Signed { node: signed.node, negative: signed.negative != flip }
}
