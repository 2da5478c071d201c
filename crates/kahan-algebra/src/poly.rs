//! Multivariate polynomials over ℚ in a sparse normal form.
//!
//! Terms are strictly decreasing in graded lexicographic order and have nonzero coefficients. Equal
//! polynomials are therefore equal as data. This module provides no names of variables, no
//! evaluation at a point and no factorisation.

mod arithmetic;
mod budget;
mod calculus;
mod division;
mod gcd;
mod images;
mod monomial;
mod powers;
mod root;
#[cfg(test)]
mod tests;

use std::convert::Infallible;
use std::fmt;

pub use budget::{Budget, OverBudget, WithinBudget};
pub use gcd::{gcd, gcd_all, gcd_all_within, gcd_within};
pub use images::{RESIDUES_PER_TERM, degree_bounds};
pub use monomial::{Monomial, Variable};

use kahan_syntax::rational::Rational;

pub(crate) type Term = (Monomial, Rational);

/// A polynomial with rational coefficients. The zero polynomial has no terms and degree 0.
#[derive(Clone, PartialEq, Eq, Hash, Default)]
pub struct Polynomial {
    terms: Vec<Term>,
}

impl Polynomial {
    /// Returns the polynomial 0.
    pub fn zero() -> Self {
        Self::default()
    }

    /// Returns the polynomial 1.
    pub fn one() -> Self {
        Self::constant(Rational::ONE)
    }

    /// Returns a constant polynomial.
    pub fn constant(value: Rational) -> Self {
        Self::term(Monomial::one(), value)
    }

    /// Returns the polynomial of a single variable.
    pub fn variable(variable: Variable) -> Self {
        Self::term(Monomial::variable(variable), Rational::ONE)
    }

    /// Returns the product of a monomial and a coefficient.
    pub fn term(monomial: Monomial, coefficient: Rational) -> Self {
        if coefficient.is_zero() { Self::zero() } else { Self { terms: vec![(monomial, coefficient)] } }
    }

    /// Returns the sum of terms in any order. The cost is that of sorting.
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, Rational)>) -> Self {
        let Ok(sum) = Self::collected(terms.into_iter().collect(), |a, b| Ok::<_, Infallible>(a + b));
        sum
    }

    fn collected<E>(
        mut unsorted: Vec<Term>,
        mut add: impl FnMut(&Rational, &Rational) -> Result<Rational, E>,
    ) -> Result<Self, E> {
        if is_decreasing(&unsorted) && unsorted.iter().all(|term| !term.1.is_zero()) {
            return Ok(Self { terms: unsorted });
        }
        unsorted.sort_by(|left, right| right.0.cmp(&left.0));
        let mut terms: Vec<Term> = Vec::with_capacity(unsorted.len());
        for (monomial, coefficient) in unsorted {
            match terms.last_mut() {
                Some(last) if last.0 == monomial => last.1 = add(&last.1, &coefficient)?,
                _ => {
                    drop_if_zero(&mut terms);
                    terms.push((monomial, coefficient));
                }
            }
        }
        drop_if_zero(&mut terms);
        Ok(Self { terms })
    }

    fn from_sorted(terms: Vec<Term>) -> Self {
        debug_assert!(terms.is_sorted_by(|left, right| left.0 > right.0));
        Self { terms }
    }

    /// Returns the terms in graded lexicographic order, highest first.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> + ExactSizeIterator {
        self.terms.iter().map(|(monomial, coefficient)| (monomial, coefficient))
    }

    pub(crate) fn as_terms(&self) -> &[Term] {
        &self.terms
    }

    /// Returns the highest term. Returns `None` for the polynomial 0.
    pub fn leading_term(&self) -> Option<(&Monomial, &Rational)> {
        self.terms.first().map(|(monomial, coefficient)| (monomial, coefficient))
    }

    /// Returns the number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Returns whether the polynomial is 0, like [`is_zero`](Self::is_zero).
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// Returns whether the polynomial is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Returns whether the polynomial is 1.
    pub fn is_one(&self) -> bool {
        self.terms.len() == 1 && self.terms[0].0.is_one() && self.terms[0].1.is_one()
    }

    /// Returns the value of the polynomial if it is constant.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.leading_term() {
            None => Some(Rational::ZERO),
            // In a graded order, only a constant polynomial has the leading monomial 1.
            Some((monomial, coefficient)) => monomial.is_one().then(|| coefficient.clone()),
        }
    }

    /// Returns the coefficient of `monomial`, which is 0 if it does not occur. The cost is that of
    /// a binary search.
    pub fn coefficient(&self, monomial: &Monomial) -> Rational {
        match self.terms.binary_search_by(|term| monomial.cmp(&term.0)) {
            Ok(index) => self.terms[index].1.clone(),
            Err(_) => Rational::ZERO,
        }
    }

    /// Returns the total degree.
    pub fn degree(&self) -> u32 {
        self.terms.first().map_or(0, |(monomial, _)| monomial.degree())
    }

    /// Returns the highest exponent of `variable`.
    pub fn degree_in(&self, variable: Variable) -> u32 {
        let mut degree = 0;
        for (monomial, _) in &self.terms {
            degree = degree.max(monomial.exponent(variable));
        }
        degree
    }

    /// Returns the degree in the variables that satisfy `belongs`.
    pub fn degree_where(&self, mut belongs: impl FnMut(Variable) -> bool) -> u32 {
        let mut degree = 0;
        for (monomial, _) in &self.terms {
            degree = degree.max(monomial.degree_where(&mut belongs));
        }
        degree
    }

    /// Returns the variables of the polynomial, in order.
    pub fn variables(&self) -> Vec<Variable> {
        let mut variables: Vec<Variable> = Vec::new();
        for (monomial, _) in &self.terms {
            for (variable, _) in monomial.powers() {
                if let Err(place) = variables.binary_search(variable) {
                    variables.insert(place, *variable);
                }
            }
        }
        variables
    }

    /// Returns whether `variable` occurs in the polynomial.
    pub fn contains(&self, variable: Variable) -> bool {
        self.terms.iter().any(|(monomial, _)| monomial.exponent(variable) > 0)
    }

    /// Returns whether every exponent of `variable` is even.
    pub fn is_even_in(&self, variable: Variable) -> bool {
        self.terms.iter().all(|(monomial, _)| monomial.exponent(variable).is_multiple_of(2))
    }
}

fn is_decreasing(terms: &[Term]) -> bool {
    let mut index = 1;
    while index < terms.len() {
        if terms[index - 1].0.cmp(&terms[index].0).is_le() {
            return false;
        }
        index += 1;
    }
    true
}

fn drop_if_zero(terms: &mut Vec<Term>) {
    if terms.last().is_some_and(|term| term.1.is_zero()) {
        terms.pop();
    }
}

impl From<Rational> for Polynomial {
    fn from(value: Rational) -> Self {
        Self::constant(value)
    }
}

impl fmt::Debug for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        for (index, (monomial, coefficient)) in self.terms.iter().enumerate() {
            let plus = if index == 0 { "" } else { " + " };
            write!(f, "{plus}{coefficient}")?;
            for (variable, exponent) in monomial.powers() {
                write!(f, "*v{}", variable.0)?;
                if *exponent != 1 {
                    write!(f, "^{exponent}")?;
                }
            }
        }
        Ok(())
    }
}
