//! Factors multivariate polynomials over ℚ into powers of irreducible primitive polynomials.
//!
//! Variables that divide all terms are split off. All variables but one are set to numbers. The
//! resulting univariate image is factored (`univariate`), and its factors are lifted to the other
//! variables (`multivariate`, `sparse`, `series`). Dividing the polynomial by the lifted factors
//! proves them right. A factor with an irreducible image is irreducible. The numbers are random,
//! and affect only the speed and the completeness of the result. A budget limits the work. Without
//! enough budget, factors may be reducible.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod crt_factors;
pub mod dense;
mod hensel;
mod modular;
mod multivariate;
mod root;
mod series;
mod sparse;
mod square_free;
#[cfg(test)]
mod tests;
mod univariate;
mod vandermonde;

pub use root::root;

use kahan_algebra::poly::{Budget, OverBudget, Polynomial, Variable, degree_bounds};
use kahan_algebra::rational::Rational;

/// A polynomial, written as content · ∏ factor^exponent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factors {
    /// The rational factor, including the sign of the polynomial. The polynomial 0 has content 0.
    pub content: Rational,
    /// The factors and their exponents, sorted by degree, then by number of terms. Factors are
    /// pairwise coprime. Each factor has coprime integer coefficients and a positive leading
    /// coefficient.
    pub factors: Vec<(Polynomial, u32)>,
    /// Whether every factor is proved irreducible.
    pub is_complete: bool,
}

/// After the budget runs out, polynomials with more terms than this are not made square-free.
const SQUARE_FREE_TERMS: usize = 20_000;
const SQUARE_FREE_WORK: u64 = 4_000_000;

/// Returns the irreducible factors over ℚ by the methods of Zassenhaus (1969) and Wang (1978).
///
/// If the budget runs out, `is_complete` is false, and the factors may be reducible. They are still
/// square-free unless the gcds are too expensive. Their product is the polynomial in every case.
///
/// An irreducible polynomial costs one pass over its terms for each variable and one univariate
/// factorisation. Products of factors with t terms each, in n variables, cost about n·t lifts of
/// bivariate polynomials. A budget of ten million lasts a few seconds at most.
pub fn factors(polynomial: &Polynomial, budget: &mut Budget) -> Factors {
    if polynomial.is_zero() {
        return Factors { content: Rational::ZERO, factors: Vec::new(), is_complete: true };
    }
    let (mut factors, core) = without_monomial(polynomial);
    let found = irreducible(&core, budget).ok().flatten();
    let is_complete = found.is_some();
    factors.extend(found.unwrap_or_else(|| {
        square_free::square_free(&core, &mut Budget::new(SQUARE_FREE_TERMS, SQUARE_FREE_WORK))
    }));
    factors.sort_by(|(left, _), (right, _)| {
        let key = |polynomial: &Polynomial| (polynomial.degree(), polynomial.len());
        key(left).cmp(&key(right)).then_with(|| right.terms().cmp(left.terms()))
    });
    let factors = Factors { content: polynomial.content(), factors, is_complete };
    debug_assert_eq!(factors.product(), *polynomial);
    factors
}

impl Factors {
    /// Multiplies out content · ∏ factor^exponent.
    pub fn product(&self) -> Polynomial {
        self.factors.iter().fold(Polynomial::constant(self.content.clone()), |product, (factor, exponent)| {
            (0..*exponent).fold(product, |product, _| &product * factor)
        })
    }
}

type Powers = Vec<(Polynomial, u32)>;

/// Splits off the largest monomial that divides the polynomial. The rest becomes primitive.
fn without_monomial(polynomial: &Polynomial) -> (Powers, Polynomial) {
    let monomial = polynomial.monomial_content();
    let rest = polynomial.div_monomial(&monomial).expect("the monomial content divides");
    let powers = monomial.powers().iter();
    (powers.map(|&(variable, e)| (Polynomial::variable(variable), e)).collect(), rest.primitive_part())
}

/// Factors a primitive polynomial that no variable divides. Returns `None` if the factors are not
/// found.
fn irreducible(polynomial: &Polynomial, budget: &mut Budget) -> Result<Option<Powers>, OverBudget> {
    let Some(main) = main_variable(polynomial) else { return Ok(Some(Vec::new())) };
    let Some((mut factors, rest)) = content(polynomial, main, budget)? else { return Ok(None) };
    if rest.degree_in(main) == 1 {
        factors.push((rest, 1));
        return Ok(Some(factors));
    }
    let Some(others) = multivariate::factors(&rest, main, budget)? else { return Ok(None) };
    factors.extend(others);
    Ok(Some(factors))
}

/// Prefers variables of degree 1, then a low degree and a leading coefficient with few terms.
fn main_variable(polynomial: &Polynomial) -> Option<Variable> {
    polynomial.variables().into_iter().min_by_key(|&variable| {
        let degree = polynomial.degree_in(variable);
        (degree > 1, polynomial.leading_coefficient_in(variable).len() * degree as usize)
    })
}

/// Splits off the factors that do not contain `main`. They divide each coefficient of the
/// polynomial in `main`, so they are factors of the shortest coefficient.
fn content(
    polynomial: &Polynomial,
    main: Variable,
    budget: &mut Budget,
) -> Result<Option<(Powers, Polynomial)>, OverBudget> {
    let mut coefficients: Vec<Polynomial> = polynomial.coefficients_in(main).into_values().collect();
    coefficients.sort_by_key(Polynomial::len);
    for coefficient in &mut coefficients {
        *coefficient = without_monomial(coefficient).1;
    }
    let shortest = &coefficients[0];
    let mut shared = shortest.variables();
    for other in &coefficients[1..] {
        if shared.is_empty() {
            break;
        }
        let bounds = degree_bounds(shortest, other, budget)?;
        shared.retain(|variable| bounds.get(variable).is_some_and(|bound| *bound > 0));
    }
    let mut rest = polynomial.clone();
    if shared.is_empty() {
        return Ok(Some((Vec::new(), rest)));
    }
    let Some(candidates) = irreducible(shortest, budget)? else { return Ok(None) };
    let mut factors = Vec::new();
    for (candidate, most) in candidates {
        if !candidate.variables().iter().all(|variable| shared.contains(variable)) {
            continue;
        }
        let mut exponent = 0;
        while exponent < most
            && let Some(quotient) = rest.div_within(&candidate, budget)?
        {
            rest = quotient;
            exponent += 1;
        }
        if exponent > 0 {
            factors.push((candidate, exponent));
        }
    }
    Ok(Some((factors, rest)))
}
