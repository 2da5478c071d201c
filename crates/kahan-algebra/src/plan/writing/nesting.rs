//! Chooses the nested form of a polynomial by estimated cost.
//!
//! A form is a sum of terms and of products v·q of a variable v and a polynomial q. The estimate of
//! a form counts operations, and the cycles until the value is ready. A budget limits the number of
//! examined terms. Beyond the budget, all variables are factored out at once.

use std::cell::{Cell, RefCell};
use std::cmp::Reverse;
use std::rc::Rc;

use kahan_syntax::rational::Rational;
use kahan_syntax::table::sorted_by_key;

use crate::poly::{Monomial, Polynomial, Variable};

use kahan_program::Numbered;
use kahan_program::cost::{ADD, MULTIPLY};

use crate::plan::horner::by_frequency;
use crate::plan::writing::scaling::{INVERSE_STEP, Scaling, is_power_of_two};

/// The ways to factor out a variable are compared for polynomials of at most this many terms. In
/// longer ones, the most frequent variable is factored out.
const MAX_COMPARED_TERMS: usize = 12;

const MOST_LOOKED_AT: usize = 1_000_000;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::plan) enum FormGoal {
    /// For denominators: the value should be ready early, because all later operations wait for it.
    Early,
    /// For numerators: the value should need few operations. The division takes longer anyway.
    Few,
}

impl FormGoal {
    /// Returns the price in 1/16 operations. A cycle costs 16 for `Early`, and 1 for `Few`.
    pub(in crate::plan) fn price(self, operations: usize, ready: u32) -> u64 {
        match self {
            FormGoal::Early => 16 * operations as u64 + 16 * u64::from(ready),
            FormGoal::Few => 16 * operations as u64 + u64::from(ready),
        }
    }
}

#[derive(Clone, Debug)]
pub(in crate::plan) enum Summand {
    Term(Monomial, Rational),
    Product(Monomial, Rational, Rc<Polynomial>),
}

#[derive(Debug)]
struct Estimate {
    operations: usize,
    summands: Vec<u32>,
    form: SumForm,
}

/// The chosen form of a polynomial.
#[derive(Debug)]
enum SumForm {
    Flat,
    /// A product v·q, and the other terms.
    Nested(Summand, Option<(Rc<Polynomial>, Rc<Estimate>)>),
    Grouped(Vec<Summand>),
}

#[derive(Debug, Default)]
struct EstimateCache {
    polynomials: Numbered<Rc<Polynomial>>,
    estimates: Vec<Rc<Estimate>>,
}

#[derive(Debug)]
pub(in crate::plan) struct Nesting {
    goal: FormGoal,
    scaling: Scaling,
    known: RefCell<EstimateCache>,
    looked_at: Cell<usize>,
}

impl Nesting {
    pub(in crate::plan) fn new(goal: FormGoal, scaling: Scaling) -> Self {
        Nesting { goal, scaling, known: RefCell::default(), looked_at: Cell::new(0) }
    }

    pub(in crate::plan) fn best(&self, polynomial: &Rc<Polynomial>) -> Vec<Summand> {
        let mut summands = Vec::new();
        let mut next = Some((Rc::clone(polynomial), self.estimate(polynomial)));
        while let Some((polynomial, estimate)) = next {
            next = match &estimate.form {
                SumForm::Nested(product, rest) => {
                    summands.push(product.clone());
                    rest.clone()
                }
                SumForm::Grouped(own) => {
                    summands.extend_from_slice(own);
                    None
                }
                SumForm::Flat => {
                    summands.extend(terms_of(&polynomial));
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

    pub(in crate::plan) fn is_fixed(&self, monomial: &Monomial) -> bool {
        monomial.powers().iter().all(|(variable, _)| self.scaling.ready(*variable).is_none())
    }

    fn compare(&self, polynomial: &Polynomial) -> Estimate {
        self.looked_at.set(self.looked_at.get() + polynomial.len());
        if self.looked_at.get() > MOST_LOOKED_AT {
            return self.estimate_grouped(polynomial);
        }
        let candidates = self.candidates(polynomial);
        let mut best = if candidates.is_empty() || polynomial.len() <= MAX_COMPARED_TERMS {
            Some(self.estimate_flat(polynomial))
        } else {
            None
        };
        for variable in candidates {
            let estimate = self.estimate_nested(polynomial, variable);
            if best.as_ref().is_none_or(|best| self.price(&estimate) < self.price(best)) {
                best = Some(estimate);
            }
        }
        best.unwrap_or_else(|| self.estimate_flat(polynomial))
    }

    fn price(&self, estimate: &Estimate) -> u64 {
        self.goal.price(estimate.operations, sum_ready(&estimate.summands))
    }

    /// Returns the variables in at least two terms. For long polynomials, returns only the most
    /// frequent variable.
    fn candidates(&self, polynomial: &Polynomial) -> Vec<Variable> {
        let counts = polynomial.frequencies().into_iter();
        let counts = counts.filter(|&(variable, count)| count > 1 && self.may_be_out(variable));
        let mut counts = sorted_by_key(counts, |&(variable, count)| (Reverse(count), variable));
        if polynomial.len() > MAX_COMPARED_TERMS {
            counts.truncate(1);
        }
        counts.into_iter().map(|(variable, _)| variable).collect()
    }

    /// Returns whether a variable may be factored out. Parameters may not, because they are
    /// multiplied into prepared constants.
    fn may_be_out(&self, variable: Variable) -> bool {
        variable == INVERSE_STEP || self.scaling.ready(variable).is_some()
    }

    /// Estimates the form that adds term by term. The terms without states are added in advance, to
    /// one prepared constant.
    fn estimate_flat(&self, polynomial: &Polynomial) -> Estimate {
        let mut estimate = Estimate { operations: 0, summands: Vec::new(), form: SumForm::Flat };
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
            return (if is_derived { DERIVED_CONSTANT_PRICE } else { 0 }, 0);
        }
        if has_fixed || !free {
            factors.push(0);
        }
        (factors.len() - 1, product_ready(factors))
    }

    fn estimate_nested(&self, polynomial: &Polynomial, variable: Variable) -> Estimate {
        let (quotient, rest) = polynomial.clone().split_at(variable);
        let (product, mut operations, ready) = self.product(variable, quotient);
        let mut summands = vec![ready];
        if rest.is_zero() {
            return Estimate { operations, summands, form: SumForm::Nested(product, None) };
        }
        let rest = Rc::new(rest);
        let own = self.estimate(&rest);
        operations += own.operations + 1;
        summands.extend_from_slice(&own.summands);
        Estimate { operations, summands, form: SumForm::Nested(product, Some((rest, own))) }
    }

    fn estimate_grouped(&self, polynomial: &Polynomial) -> Estimate {
        let (products, rest) = by_frequency(polynomial, |variable| self.may_be_out(variable));
        let flat = self.estimate_flat(&rest);
        let mut own: Vec<Summand> = terms_of(&rest).collect();
        let Estimate { mut operations, mut summands, .. } = flat;
        for (variable, quotient) in products {
            let (product, count, ready) = self.product(variable, quotient);
            own.push(product);
            operations += count + 1;
            summands.push(ready);
        }
        Estimate { operations, summands, form: SumForm::Grouped(own) }
    }

    /// Returns a product as summand, with its number of operations and the cycle when it is ready.
    fn product(&self, variable: Variable, quotient: Polynomial) -> (Summand, usize, u32) {
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
        let (operations, factor_ready) = self.term(&monomial, &content);
        let quotient = self.estimate(&inner);
        let ready = factor_ready.max(sum_ready(&quotient.summands)) + MULTIPLY;
        (Summand::Product(monomial, content, inner), operations + quotient.operations + 1, ready)
    }
}

fn terms_of(polynomial: &Polynomial) -> impl Iterator<Item = Summand> {
    polynomial.terms().map(|(monomial, coefficient)| Summand::Term(monomial.clone(), coefficient.clone()))
}

/// A prepared constant that is rounded twice costs as much as this many operations.
pub(in crate::plan) const DERIVED_CONSTANT_PRICE: usize = 3;

/// Returns the cycle in which a sum is ready, if early values are added first.
fn sum_ready(ready: &[u32]) -> u32 {
    combined_ready(ready.to_vec(), ADD)
}

/// Returns the cycle in which a product is ready, if early values are multiplied first.
fn product_ready(ready: Vec<u32>) -> u32 {
    combined_ready(ready, MULTIPLY)
}

/// Returns the cycle in which a single value is left, if each operation combines the two earliest
/// values and takes `latency` cycles.
fn combined_ready(all: Vec<u32>, latency: u32) -> u32 {
    let mut ready = sorted_by_key(all, |at| Reverse(*at));
    while let [.., later, _] = ready[..] {
        ready.truncate(ready.len() - 2);
        let at = later + latency;
        ready.insert(ready.partition_point(|other| *other >= at), at);
    }
    ready.first().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::writing::scaling::scalings;

    #[test]
    fn forms_of_a_long_polynomial_are_compared_within_the_budget() {
        let state = |k: usize| Monomial::variable(Variable(k as u16));
        let pairs = (0..200).flat_map(|i| (i..200).map(move |j| (i, j)));
        let terms = pairs.map(|(i, j)| (state(i).mul(&state(j)), Rational::from((200 * i + j + 1) as i64)));
        let polynomial = Rc::new(Polynomial::from_terms(terms));
        let text: String = (0..200).map(|k| format!("x{k}dot = x{k};")).collect();
        let field = crate::read(&crate::lexer::lex(&text).tokens).system().expect("a system").field;
        let scaling = scalings(&field).swap_remove(0);

        let nesting = Nesting::new(FormGoal::Few, scaling);
        let summands = nesting.best(&polynomial);
        let looked_at = nesting.looked_at.get();
        assert!(looked_at > MOST_LOOKED_AT, "{looked_at}");
        assert!(looked_at <= MOST_LOOKED_AT + 5 * polynomial.len(), "{looked_at}");
        let sum = summands.iter().fold(Polynomial::zero(), |sum, summand| {
            let (monomial, coefficient, inner) = match summand {
                Summand::Term(monomial, coefficient) => (monomial, coefficient, Rc::new(Polynomial::one())),
                Summand::Product(monomial, coefficient, inner) => (monomial, coefficient, Rc::clone(inner)),
            };
            &sum + &(&Polynomial::term(monomial.clone(), coefficient.clone()) * &inner)
        });
        assert_eq!(sum, *polynomial);
    }
}
