//! Derives the map as rational functions x̃ᵢ = Nᵢ/D, and the reduced increments x̃ᵢ − xᵢ = 2ε nᵢ/d.
//!
//! Let the field be pᵢ/qᵢ, A the matrix of Kahan's method, Â = diag(q)·A and D̂ = det Â. By
//! Cramer's rule (x̃ − x)/(2ε) = Â⁻¹p = n̂/D̂, where n̂ⱼ is det Â with column j replaced by p.
//! Division of xD̂ + 2εn̂ and D̂ by ∏q gives N and D. Division of n̂ and D̂ by their gcd gives n
//! and d. At ε = 0, D̂ is ∏q; therefore ε divides neither D̂ nor d, and 2εn/d is in lowest terms. A
//! pole at which only the gcd vanishes is removable.

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::poly::{Budget, Polynomial, Variable, WithinBudget, gcd_all_within};
use crate::symbols::Symbols;

use super::matrix::scaled_matrix;
use super::minors::maximal_minors;

/// The most terms of the map, and of each minor. Larger maps are evaluated by elimination.
pub const TERM_BUDGET: usize = 500;

/// The most multiplications of terms for one map. Unoptimised code computes them in some tens of
/// milliseconds.
const WORK_BUDGET: u64 = 40_000;

/// The map of a field as expanded polynomials, if they are not too large.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RationalMap {
    /// The polynomials N̂ with x̃ = N̂/D̂.
    pub numerators: Vec<Polynomial>,
    /// The denominator D̂ = ∏q · det A.
    pub denominator: Polynomial,
    /// The product ∏q of the denominators of the field. The map is x̃ = N/D with N = N̂/∏q and D =
    /// D̂/∏q = det A.
    pub divisor: Polynomial,
    /// The map in lowest terms.
    pub reduced: Reduced,
}

/// The map x̃ = x + 2ε n/d in lowest terms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reduced {
    /// The numerators n of the increments.
    pub increments: Vec<Polynomial>,
    /// The common denominator d of the increments.
    pub denominator: Polynomial,
    /// The common factor that was cancelled in the increments and the denominator.
    pub common_factor: Polynomial,
}

impl RationalMap {
    /// Derives the map of a field. Returns `None` if the budget is exceeded.
    #[must_use]
    pub fn of(field: &Field) -> Option<Self> {
        let mut budget = Budget::new(TERM_BUDGET, WORK_BUDGET);
        Self::within(field, &mut budget).ok()
    }

    fn within(field: &Field, budget: &mut Budget) -> WithinBudget<Self> {
        let n = field.dimension();
        let mut rows = scaled_matrix(field);
        for (row, component) in rows.iter_mut().zip(&field.components) {
            row.push(component.numerator().clone());
        }
        let mut minors = maximal_minors(&rows, budget)?;
        let all = (1u64 << (n + 1)) - 1;
        let mut without = |column: usize| minors.remove(&(all & !(1 << column))).unwrap_or_default();
        let denominator = without(n);
        // Moving the last column to position j changes the sign n−1−j times.
        let signed = |j: usize, minor: Polynomial| if (n - 1 - j) % 2 == 1 { -&minor } else { minor };
        let increments: Vec<Polynomial> = (0..n).map(|j| signed(j, without(j))).collect();
        let two_eps = Polynomial::variable(field.symbols.epsilon()).scale(&Rational::from(2));
        let mut numerators = Vec::with_capacity(n);
        for (i, increment) in increments.iter().enumerate() {
            let start = denominator.mul_within(&Polynomial::variable(field.symbols.state(i)), budget)?;
            numerators.push(start.add_within(&two_eps.mul_within(increment, budget)?, budget)?);
        }
        budget.admit(denominator.len() + numerators.iter().map(Polynomial::len).sum::<usize>())?;
        let divisor =
            field.components.iter().fold(Polynomial::one(), |product, c| &product * c.denominator());
        let reduced = Reduced::of(increments, &denominator, budget)?;
        Ok(RationalMap { numerators, denominator, divisor, reduced })
    }
}

impl Reduced {
    /// Returns the number of terms of the numerators and the denominator.
    #[must_use]
    pub fn terms(&self) -> usize {
        self.denominator.len() + self.increments.iter().map(Polynomial::len).sum::<usize>()
    }

    /// Returns whether all degrees equal those of `other`. Degrees are those in the states and, if
    /// `counts_eps` is true, in ε.
    #[must_use]
    pub(crate) fn is_as_short(
        &self,
        symbols: &Symbols,
        other: &Reduced,
        others: &Symbols,
        counts_eps: bool,
    ) -> bool {
        let degrees = |reduced: &Reduced, symbols: &Symbols| -> Vec<u32> {
            let varies = |v: Variable| symbols.is_state(v) || (counts_eps && v == symbols.epsilon());
            let all = reduced.increments.iter().chain([&reduced.denominator]);
            all.map(|polynomial| polynomial.degree_where(varies)).collect()
        };
        degrees(self, symbols) == degrees(other, others)
    }

    /// Returns the numerators x·d + 2εn of x̃ over the denominator d.
    #[must_use]
    pub fn numerators(&self, symbols: &Symbols) -> Vec<Polynomial> {
        let two_eps = Polynomial::variable(symbols.epsilon()).scale(&Rational::from(2));
        let numerator = |(i, increment): (usize, &Polynomial)| {
            &(&Polynomial::variable(symbols.state(i)) * &self.denominator) + &(&two_eps * increment)
        };
        self.increments.iter().enumerate().map(numerator).collect()
    }

    fn of(increments: Vec<Polynomial>, denominator: &Polynomial, budget: &mut Budget) -> WithinBudget<Self> {
        let mut all = vec![denominator.clone()];
        all.extend(increments.iter().filter(|increment| !increment.is_zero()).cloned());
        let common_factor = gcd_all_within(&all, budget)?;
        let mut lowered = Vec::with_capacity(increments.len());
        for increment in &increments {
            lowered.push(increment.div_within(&common_factor, budget)?.expect("a common divisor divides"));
        }
        let denominator = denominator.div_within(&common_factor, budget)?.expect("a common divisor divides");
        // A nonzero constant term of the denominator is scaled to 1, which floats represent
        // exactly. Near ε = 0 it dominates the denominator.
        let constant = denominator.coefficient(&crate::poly::Monomial::one());
        let scale = constant.recip().unwrap_or_else(Rational::one);
        Ok(Reduced {
            increments: lowered.iter().map(|increment| increment.scale(&scale)).collect(),
            denominator: denominator.scale(&scale),
            common_factor,
        })
    }
}
