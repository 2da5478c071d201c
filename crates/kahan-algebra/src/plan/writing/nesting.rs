//! How to nest one polynomial: which variable to take out of which terms, by what that costs.
//!
//! A polynomial is a sum of terms and of products v·q; every choice of v gives another form. The
//! estimate of a form counts its operations and the cycle in which its value is ready, no operation
//! being shared; the cheapest form is kept.

use std::cell::RefCell;
use std::cmp::Reverse;
use std::rc::Rc;

use kahan_syntax::rational::Rational;
use kahan_syntax::table::sorted_by_key;

use crate::poly::{Monomial, Polynomial, Variable};

use crate::plan::cost::{DERIVED, MULTIPLY, gathered, multiplied};
use crate::plan::numbered::Numbered;
use crate::plan::writing::scaling::{INVERSE_STEP, Scaling, is_power_of_two};

/// The most terms for which all forms are compared; longer polynomials are nested by their most
/// frequent variable.
const COMPARED: usize = 12;

/// What a form should be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::plan) enum Goal {
    /// Ready early: the denominator, which everything waits for.
    Early,
    /// Few operations: the numerators, which are computed while the division runs.
    Few,
}

impl Goal {
    /// What is to be least: under `Early` a cycle is worth an operation.
    pub(in crate::plan) fn price(self, operations: usize, ready: u32) -> u64 {
        match self {
            Goal::Early => 16 * operations as u64 + 16 * u64::from(ready),
            Goal::Few => 16 * operations as u64 + u64::from(ready),
        }
    }
}

/// A summand of a nested form.
#[derive(Clone, Debug)]
pub(in crate::plan) enum Summand {
    /// One term.
    Term(Monomial, Rational),
    /// The monomial (with its coefficient) times a sum.
    Product(Monomial, Rational, Rc<Polynomial>),
}

/// The estimate of a form.
#[derive(Debug)]
struct Estimate {
    operations: usize,
    /// When each summand is ready.
    summands: Vec<u32>,
    form: Form,
}

/// A form, of which the summands are made only where it is chosen.
#[derive(Debug)]
enum Form {
    /// Term by term.
    Flat,
    /// A product, and a rest in the form of its estimate.
    Nested(Summand, Option<(Rc<Polynomial>, Rc<Estimate>)>),
}

/// Polynomials with their estimates.
#[derive(Debug, Default)]
struct Known {
    polynomials: Numbered<Rc<Polynomial>>,
    estimates: Vec<Rc<Estimate>>,
}

/// Estimates, each made once.
#[derive(Debug)]
pub(in crate::plan) struct Nesting {
    goal: Goal,
    scaling: Scaling,
    known: RefCell<Known>,
}

impl Nesting {
    pub(in crate::plan) fn new(goal: Goal, scaling: Scaling) -> Self {
        Nesting { goal, scaling, known: RefCell::default() }
    }

    /// The cheapest form found.
    pub(in crate::plan) fn best(&self, polynomial: &Rc<Polynomial>) -> Vec<Summand> {
        let mut summands = Vec::new();
        let mut next = Some((Rc::clone(polynomial), self.estimate(polynomial)));
        while let Some((polynomial, estimate)) = next {
            next = match &estimate.form {
                Form::Nested(product, rest) => {
                    summands.push(product.clone());
                    rest.clone()
                }
                Form::Flat => {
                    for (monomial, coefficient) in polynomial.terms() {
                        summands.push(Summand::Term(monomial.clone(), coefficient.clone()));
                    }
                    None
                }
            };
        }
        summands
    }

    fn estimate(&self, polynomial: &Rc<Polynomial>) -> Rc<Estimate> {
        let known = self.known.borrow().polynomials.find(polynomial);
        if let Some(number) = known {
            return Rc::clone(&self.known.borrow().estimates[number]);
        }
        let estimate = Rc::new(self.compare(polynomial));
        let mut known = self.known.borrow_mut();
        known.polynomials.number(Rc::clone(polynomial));
        known.estimates.push(Rc::clone(&estimate));
        estimate
    }

    /// Whether a term depends on no state.
    pub(in crate::plan) fn is_fixed(&self, monomial: &Monomial) -> bool {
        monomial.powers().iter().all(|(variable, _)| self.scaling.ready(*variable).is_none())
    }

    fn compare(&self, polynomial: &Polynomial) -> Estimate {
        let candidates = self.candidates(polynomial);
        let mut best = if candidates.is_empty() || polynomial.len() <= COMPARED {
            Some(self.flat(polynomial))
        } else {
            None
        };
        for variable in candidates {
            let estimate = self.nested(polynomial, variable);
            if best.as_ref().is_none_or(|best| self.price(&estimate) < self.price(best)) {
                best = Some(estimate);
            }
        }
        best.unwrap_or_else(|| self.flat(polynomial))
    }

    fn price(&self, estimate: &Estimate) -> u64 {
        self.goal.price(estimate.operations, gathered(&estimate.summands))
    }

    /// Variables in at least two terms; for long polynomials only the most frequent one.
    fn candidates(&self, polynomial: &Polynomial) -> Vec<Variable> {
        let mut counts: Vec<(usize, Variable)> = Vec::new();
        for (monomial, _) in polynomial.terms() {
            for &(variable, _) in monomial.powers() {
                match counts.iter_mut().find(|(_, known)| known.0 == variable.0) {
                    Some((count, _)) => *count += 1,
                    None => counts.push((1, variable)),
                }
            }
        }
        counts.retain(|&(count, variable)| {
            count > 1 && (variable == INVERSE_STEP || self.scaling.ready(variable).is_some())
        });
        let mut counts = sorted_by_key(counts, |&(count, variable)| (Reverse(count), variable));
        if polynomial.len() > COMPARED {
            counts.truncate(1);
        }
        counts.into_iter().map(|(_, variable)| variable).collect()
    }

    /// Every term on its own; what depends on no state is one prepared summand.
    fn flat(&self, polynomial: &Polynomial) -> Estimate {
        let mut estimate = Estimate { operations: 0, summands: Vec::new(), form: Form::Flat };
        let mut has_fixed = false;
        for (monomial, coefficient) in polynomial.terms() {
            let (operations, ready) = self.term(monomial, coefficient);
            if ready == 0 && operations == 0 && self.is_fixed(monomial) {
                if has_fixed {
                    continue;
                }
                has_fixed = true;
            }
            estimate.operations += operations;
            estimate.summands.push(ready);
        }
        estimate.operations += estimate.summands.len().saturating_sub(1);
        estimate
    }

    /// Operations of a term, and when it is ready.
    fn term(&self, monomial: &Monomial, coefficient: &Rational) -> (usize, u32) {
        let mut factors: Vec<u32> = Vec::new();
        let mut has_fixed = false;
        for &(variable, exponent) in monomial.powers() {
            match self.scaling.ready(variable) {
                Some(ready) => factors.resize(factors.len() + exponent as usize, ready),
                None => has_fixed = true,
            }
        }
        let is_scaled = factors.iter().any(|&ready| ready > 0);
        let free =
            coefficient.is_one() || (-coefficient).is_one() || (is_scaled && is_power_of_two(coefficient));
        if factors.is_empty() {
            let is_derived = !self.scaling.folds && monomial.exponent(INVERSE_STEP) > 1;
            return (if is_derived { DERIVED } else { 0 }, 0);
        }
        if has_fixed || !free {
            factors.push(0);
        }
        (factors.len() - 1, multiplied(factors))
    }

    fn nested(&self, polynomial: &Polynomial, variable: Variable) -> Estimate {
        let (quotient, rest) = polynomial.split_at(variable);
        let mut monomial = quotient.monomial_content();
        let inner = if monomial.is_one() {
            quotient
        } else {
            quotient.div_monomial(&monomial).expect("all terms have it")
        };
        monomial.multiply_by(variable, 1);
        let content = inner.content();
        let (content, inner) =
            if content.is_one() { (content, inner) } else { (content, inner.primitive_part()) };
        let inner = Rc::new(inner);
        let (mut operations, factor_ready) = self.term(&monomial, &content);
        let quotient = self.estimate(&inner);
        operations += quotient.operations + 1;
        let ready = factor_ready.max(gathered(&quotient.summands)) + MULTIPLY;
        let product = Summand::Product(monomial, content, inner);
        let mut summands = vec![ready];
        if rest.is_zero() {
            return Estimate { operations, summands, form: Form::Nested(product, None) };
        }
        let rest = Rc::new(rest);
        let own = self.estimate(&rest);
        operations += own.operations + 1;
        summands.extend_from_slice(&own.summands);
        Estimate { operations, summands, form: Form::Nested(product, Some((rest, own))) }
    }
}
