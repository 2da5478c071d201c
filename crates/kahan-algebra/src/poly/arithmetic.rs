//! Adds two polynomials, and multiplies them, by merging sorted runs of terms. Longer sums are
//! sorted.
//!
//! A product forms a sorted run for each term of the shorter factor, and merges runs of similar
//! length first. Factors of n and m terms take n·m multiplications of terms and at most about
//! n·m·log₂ min(n, m) comparisons.

use std::cmp::Ordering;
use std::convert::Infallible;
use std::ops::{Add, Mul, Neg, Sub};

use kahan_syntax::rational::Rational;

use super::{Monomial, Polynomial, Term};

impl Polynomial {
    /// Returns the sum of all summands. Summands with the flag `true` are subtracted. The cost is
    /// that of sorting.
    pub fn sum_of<'a>(summands: impl IntoIterator<Item = (bool, &'a Self)>) -> Self {
        let Ok(sum) = Self::sum_with(summands, |a, b| Ok::<_, Infallible>(a + b));
        sum
    }

    pub(super) fn sum_with<'a, E>(
        summands: impl IntoIterator<Item = (bool, &'a Self)>,
        add: impl FnMut(&Rational, &Rational) -> Result<Rational, E>,
    ) -> Result<Self, E> {
        let terms = summands.into_iter().flat_map(|(negative, summand)| {
            let signed = move |value: &Rational| if negative { -value } else { value.clone() };
            summand.terms().map(move |(monomial, value)| (monomial.clone(), signed(value)))
        });
        Self::collected(terms.collect(), add)
    }

    /// Multiplies the polynomial by a rational.
    pub fn scale(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        if factor.is_one() {
            return self.clone();
        }
        self.mul_term(&Monomial::one(), factor)
    }

    /// Multiplies the polynomial by a monomial.
    pub fn mul_monomial(&self, monomial: &Monomial) -> Self {
        self.mul_term(monomial, &Rational::ONE)
    }

    /// Multiplies the polynomial by a term with nonzero coefficient.
    pub(super) fn mul_term(&self, monomial: &Monomial, coefficient: &Rational) -> Self {
        let mut terms = Vec::with_capacity(self.terms.len());
        for (own_monomial, own_coefficient) in &self.terms {
            terms.push((own_monomial.mul(monomial), own_coefficient * coefficient));
        }
        Self { terms }
    }
}

pub(super) fn merge(left: Vec<Term>, right: Vec<Term>) -> Vec<Term> {
    if left.is_empty() {
        return right;
    }
    let mut merged = Vec::with_capacity(left.len() + right.len());
    let (mut left, mut right) = (left.into_iter(), right.into_iter());
    let (mut next_left, mut next_right) = (left.next(), right.next());
    loop {
        match (next_left, next_right) {
            (Some(a), Some(b)) => match a.0.cmp(&b.0) {
                Ordering::Greater => {
                    merged.push(a);
                    next_left = left.next();
                    next_right = Some(b);
                }
                Ordering::Less => {
                    merged.push(b);
                    next_left = Some(a);
                    next_right = right.next();
                }
                Ordering::Equal => {
                    let sum = &a.1 + &b.1;
                    if !sum.is_zero() {
                        merged.push((a.0, sum));
                    }
                    next_left = left.next();
                    next_right = right.next();
                }
            },
            (Some(term), None) => {
                merged.push(term);
                merged.extend(left);
                return merged;
            }
            (None, Some(term)) => {
                merged.push(term);
                merged.extend(right);
                return merged;
            }
            (None, None) => return merged,
        }
    }
}

/// A sum of sorted runs. Runs of similar length are merged, so each term is merged only
/// logarithmically many times.
struct Accumulator {
    runs: Vec<Vec<Term>>,
}

impl Accumulator {
    fn push(&mut self, mut run: Vec<Term>) {
        while let Some(last) = self.runs.pop_if(|last| last.len() < 2 * run.len()) {
            run = merge(last, run);
        }
        self.runs.push(run);
    }

    fn finish(mut self) -> Vec<Term> {
        let mut sum = self.runs.pop().unwrap_or_default();
        while let Some(run) = self.runs.pop() {
            sum = merge(run, sum);
        }
        sum
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;

    fn add(self, other: &Polynomial) -> Polynomial {
        Polynomial { terms: merge(self.terms.clone(), other.terms.clone()) }
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;

    fn sub(self, other: &Polynomial) -> Polynomial {
        Polynomial { terms: merge(self.terms.clone(), (-other).terms) }
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;

    fn mul(self, other: &Polynomial) -> Polynomial {
        let (short, long) = if self.len() <= other.len() { (self, other) } else { (other, self) };
        let mut sum = Accumulator { runs: Vec::new() };
        for (monomial, coefficient) in &short.terms {
            sum.push(long.mul_term(monomial, coefficient).terms);
        }
        Polynomial { terms: sum.finish() }
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;

    fn neg(self) -> Polynomial {
        let mut negated = self.clone();
        for term in &mut negated.terms {
            term.1 = -&term.1;
        }
        negated
    }
}

/// Both operands are consumed, and no term is cloned.
impl Add for Polynomial {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { terms: merge(self.terms, other.terms) }
    }
}

impl Sub for Polynomial {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { terms: merge(self.terms, (-&other).terms) }
    }
}
