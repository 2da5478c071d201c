//! Writes polynomials as operations and reuses existing operations. Existing sums are also reused
//! if subtracting a multiple of them shortens the polynomial.

mod cheapest;
mod coefficients;
mod reuse;
mod terms;

use std::rc::Rc;

use kahan_syntax::rational::Rational;
use kahan_syntax::table::sorted_by_key;

use crate::field::Field;
use crate::poly::{Monomial, Polynomial, Variable};

use crate::plan::Node;
use crate::plan::writing::nesting::{FormGoal, Nesting, Summand};
use crate::plan::writing::plan_draft::{PlanDraft, Signed};
use crate::plan::writing::scaling::{INVERSE_STEP, Scaling, scalings};
use kahan_program::Numbered;

/// Multiples of sums are sought only in polynomials of at most this many terms, because the cost of
/// the search is quadratic.
const MAX_REUSE_TERMS: usize = 24;

/// A sum of at most this many terms is also written without factoring out a common constant. The
/// cheaper formula is used.
const MAX_UNFACTORED_TERMS: usize = 3;

/// An entry of a matrix as a written value, and as a polynomial if it is known.
#[derive(Clone, Debug)]
pub(in crate::plan) struct MatrixEntry {
    pub(in crate::plan) polynomial: Option<Polynomial>,
    pub(in crate::plan) written: Signed,
}

/// A draft that remembers which polynomial each operation computes.
#[derive(Clone, Debug)]
pub(in crate::plan) struct Writer {
    pub(in crate::plan) draft: PlanDraft,
    pub(in crate::plan) scaling: Scaling,
    /// The polynomials written so far, with positive leading coefficients.
    made: Numbered<Rc<Polynomial>>,
    steps: Vec<Signed>,
    sums: Vec<usize>,
    put: Vec<(Variable, Node)>,
    /// Sums of constants, each of which is computed once, before the steps.
    coefficients: Vec<Polynomial>,
    nestings: Rc<[Nesting; 2]>,
}

impl Writer {
    /// Returns an empty writer for each way to choose which factors of a term ε multiplies.
    pub(in crate::plan) fn empty(field: &Field) -> Vec<Self> {
        scalings(field).into_iter().map(Self::new).collect()
    }

    fn new(scaling: Scaling) -> Self {
        let nestings =
            Rc::new([FormGoal::Early, FormGoal::Few].map(|goal| Nesting::new(goal, scaling.clone())));
        Writer {
            draft: PlanDraft::new(&scaling),
            scaling,
            made: Numbered::default(),
            steps: Vec::new(),
            sums: Vec::new(),
            put: Vec::new(),
            coefficients: Vec::new(),
            nestings,
        }
    }

    pub(in crate::plan) fn variable(&mut self, variable: Variable) -> Node {
        if variable == INVERSE_STEP {
            return self.inverse_step(&Rational::one());
        }
        match self.scaling.unscaled(variable) {
            None => self.symbol(variable),
            Some(symbol) => {
                let (eps, symbol) = (self.draft.input(self.scaling.epsilon()), self.symbol(symbol));
                self.draft.multiply(eps, symbol)
            }
        }
    }

    /// Returns the prepared constant c/(2ε).
    pub(in crate::plan) fn inverse_step(&mut self, c: &Rational) -> Node {
        let half = self.draft.constant(&(c * &Rational::new(1, 2)));
        let eps = self.draft.input(self.scaling.epsilon());
        self.draft.builder.divide(half, eps)
    }

    /// Returns the node of a symbol, or of the value that replaces it.
    fn symbol(&mut self, symbol: Variable) -> Node {
        let put = self.put.iter().find(|(variable, _)| *variable == symbol).map(|(_, node)| *node);
        put.unwrap_or_else(|| self.draft.input(symbol))
    }

    /// Returns the node of c/d with d = `denominator`. For an increment 2εn/d, c includes the 2.
    pub(in crate::plan) fn reciprocal(&mut self, c: &Rational, denominator: Node) -> Node {
        let c = self.draft.constant(c);
        self.draft.builder.divide(c, denominator)
    }

    pub(in crate::plan) fn eps_over(&mut self, denominator: Node) -> Node {
        let eps = self.draft.input(self.scaling.epsilon());
        self.draft.builder.divide(eps, denominator)
    }

    /// Replaces a symbol by a node in all later polynomials.
    pub(in crate::plan) fn put(&mut self, symbol: Variable, node: Node) {
        self.put.push((symbol, node));
    }

    pub(in crate::plan) fn write(&mut self, polynomial: &Polynomial, goal: FormGoal) -> Signed {
        let (sign, positive) = normalised(polynomial);
        if let Some(number) = self.made.find(&positive) {
            return self.steps[number].flipped(sign);
        }
        let written = self.write_new(&positive, goal);
        self.remember_positive(positive, written);
        written.flipped(sign)
    }

    /// Writes a polynomial. Powers of ε multiply states or parameters first, by `ScalingPriority`.
    pub(in crate::plan) fn write_scaled(&mut self, polynomial: &Polynomial, goal: FormGoal) -> Signed {
        let scaled = self.scaling.scale_first(polynomial);
        self.write(&scaled, goal)
    }

    /// Records that `written` is the value of a polynomial.
    pub(in crate::plan) fn remember_scaled(&mut self, polynomial: &Polynomial, written: Signed) {
        let scaled = self.scaling.scale_first(polynomial);
        self.remember(&scaled, written);
    }

    /// Writes an entry of a matrix, with powers of ε as in [`Self::write_scaled`].
    pub(in crate::plan) fn entry(&mut self, polynomial: &Polynomial, goal: FormGoal) -> MatrixEntry {
        let polynomial = self.scaling.scale_first(polynomial);
        let written = self.write(&polynomial, goal);
        MatrixEntry { polynomial: Some(polynomial), written }
    }

    pub(in crate::plan) fn known(&mut self, polynomial: &Polynomial) -> Option<Signed> {
        let gathered = self.gather_coefficients(polynomial);
        let (sign, positive) = normalised(gathered.as_ref().unwrap_or(polynomial));
        self.made.find(&positive).map(|number| self.steps[number].flipped(sign))
    }

    pub(in crate::plan) fn remember(&mut self, polynomial: &Polynomial, written: Signed) {
        let (sign, positive) = normalised(polynomial);
        self.remember_positive(positive, written.flipped(sign));
    }

    fn remember_positive(&mut self, polynomial: Rc<Polynomial>, written: Signed) {
        let is_sum = polynomial.len() > 1;
        let number = self.made.number(polynomial);
        if number == self.steps.len() {
            self.steps.push(written);
            if is_sum {
                self.sums.push(number);
            }
        }
    }

    fn write_new(&mut self, polynomial: &Rc<Polynomial>, goal: FormGoal) -> Signed {
        if let Some(gathered) = self.gather_coefficients(polynomial) {
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
            let inner = polynomial.div_monomial(&common).expect("all terms have it").primitive_part();
            if goal == FormGoal::Few && inner.len() <= MAX_UNFACTORED_TERMS && self.has_constant(&common) {
                let write = |writer: &mut Self, is_product: &bool| match is_product {
                    true => writer.multiple(&common, &content, &inner, goal),
                    false => writer.write_flat(polynomial),
                };
                return self.cheapest(&[true, false], write, |_| 0);
            }
            return self.multiple(&common, &content, &inner, goal);
        }
        if goal == FormGoal::Few
            && polynomial.len() <= MAX_REUSE_TERMS
            && let Some(written) = self.write_reusing(polynomial)
        {
            return written;
        }
        self.write_nested(polynomial, goal)
    }

    fn has_constant(&self, monomial: &Monomial) -> bool {
        monomial.powers().iter().any(|(variable, _)| self.scaling.ready(*variable).is_none())
    }

    fn write_flat(&mut self, polynomial: &Polynomial) -> Signed {
        let terms = polynomial.terms();
        let terms: Vec<Signed> = terms.map(|(power, value)| self.term(power, value, None)).collect();
        self.draft.signed_sum(&terms)
    }

    fn write_nested(&mut self, polynomial: &Rc<Polynomial>, goal: FormGoal) -> Signed {
        let nestings = Rc::clone(&self.nestings);
        let nesting = &nestings[usize::from(goal == FormGoal::Few)];
        let mut fixed = Vec::new();
        let mut terms = Vec::new();
        // Later summands may reuse nested products and terms of low degree, which come first.
        let parts = sorted_by_key(nesting.best(polynomial), |part| match part {
            Summand::Term(monomial, _) => monomial.degree(),
            Summand::Product(..) => 0,
        });
        for part in parts {
            match part {
                Summand::Term(monomial, coefficient) if nesting.is_fixed(&monomial) => {
                    fixed.push((monomial, coefficient));
                }
                Summand::Term(monomial, coefficient) => terms.push(self.term(&monomial, &coefficient, None)),
                Summand::Product(monomial, content, inner) => {
                    terms.push(self.multiple(&monomial, &content, &inner, goal));
                }
            }
        }
        if !fixed.is_empty() {
            terms.push(self.fixed_sum(fixed));
        }
        self.draft.signed_sum(&terms)
    }

    fn multiple(
        &mut self,
        monomial: &Monomial,
        coefficient: &Rational,
        inner: &Polynomial,
        goal: FormGoal,
    ) -> Signed {
        let written = self.write(inner, goal);
        let product = self.term(monomial, coefficient, Some(written.node));
        product.flipped(written.negative)
    }
}

/// Makes the leading coefficient positive. Returns whether the sign changed.
fn normalised(polynomial: &Polynomial) -> (bool, Rc<Polynomial>) {
    let negative = polynomial.leading_term().is_some_and(|(_, coefficient)| coefficient.is_negative());
    (negative, Rc::new(if negative { -polynomial } else { polynomial.clone() }))
}
