//! Irreducible factors of multivariate polynomials over ℚ.
//!
//! In goes a polynomial, out come a rational number and powers of irreducible primitive polynomials
//! whose product it is. The steps: rational content and monomial; contents in a main variable,
//! found as common factors of its shortest coefficient; a polynomial that is primitive and linear
//! in it is irreducible. Else all other variables become integers (`multivariate`), the
//! polynomial in one variable that is left is factored (`univariate`), and its factors are
//! lifted, one variable after another (`sparse`). Powers are lifted as such, so that square-free
//! parts, whose gcds are dear, are only sought where the budget runs out. The crate must not know
//! vector fields, nor names of variables.
//!
//! What holds: division decides what a factor is, and an irreducible image that a factor is
//! irreducible; seeded random points decide only how fast, and a budget of work, never a clock,
//! when to stop.
//!
//! Sources: Yun, SYMSAC 1976; Zassenhaus, J. Number Theory 1, 1969; Wang, Math. Comp. 32, 1978;
//! Zippel, EUROSAM 1979; Geddes, Czapor and Labahn, Algorithms for Computer Algebra, 1992, chapters
//! 6 and 8. Absent on purpose: recombination of multivariate factors; new points, at which fewer
//! factors fall apart, serve as well (Hilbert's irreducibility theorem).
//!
//! Modules in reading order: `square_free`, `multivariate`; `sparse`, `series`, `vandermonde`,
//! `combined` (its lifts); `univariate`, `modular`, `lifted`; `root`; `dense`.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod combined;
pub mod dense;
mod lifted;
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

/// A polynomial as content · ∏ factor^exponent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factors {
    /// The rational factor, with the sign; 0 for the polynomial 0.
    pub content: Rational,
    /// Pairwise coprime polynomials with coprime integer coefficients, the leading one positive,
    /// and their exponents; by degree, then by length.
    pub factors: Vec<(Polynomial, u32)>,
    /// Whether every factor is known to be irreducible.
    pub is_complete: bool,
}

/// What may be spent on square-free parts where the budget ran out.
const SQUARE_FREE_TERMS: usize = 20_000;
const SQUARE_FREE_WORK: u64 = 4_000_000;

/// The irreducible factors over ℚ (Zassenhaus 1969, in several variables after Wang 1978).
///
/// Where the budget does not suffice, what resists is returned square-free and `is_complete` is
/// false; if the gcds for that become too long as well, it is returned as it is. Either way the
/// product is the polynomial. Costs, for what is irreducible, a pass over the terms a variable and
/// a factorisation in one variable; for factors of t terms in n variables, about n·t lifts in two
/// variables. A budget of ten million lasts a few seconds at most.
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
    /// The polynomial whose factors these are.
    pub fn product(&self) -> Polynomial {
        self.factors.iter().fold(Polynomial::constant(self.content.clone()), |product, (factor, exponent)| {
            (0..*exponent).fold(product, |product, _| &product * factor)
        })
    }
}

/// Polynomials with their exponents.
type Powers = Vec<(Polynomial, u32)>;

/// The single variables that divide a polynomial, and the primitive part of what is left.
fn without_monomial(polynomial: &Polynomial) -> (Powers, Polynomial) {
    let monomial = polynomial.monomial_content();
    let rest = polynomial.div_monomial(&monomial).expect("the monomial content divides");
    let powers = monomial.powers().iter();
    (powers.map(|&(variable, e)| (Polynomial::variable(variable), e)).collect(), rest.primitive_part())
}

/// The irreducible factors of a primitive polynomial that no variable divides; `None` where they
/// could not be found.
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

/// The variable in which the polynomial is linear, or else one of low degree with a short leading
/// coefficient.
fn main_variable(polynomial: &Polynomial) -> Option<Variable> {
    polynomial.variables().into_iter().min_by_key(|&variable| {
        let degree = polynomial.degree_in(variable);
        (degree > 1, polynomial.leading_coefficient_in(variable).len() * degree as usize)
    })
}

/// The factors without `main`, and the rest, which has none: they divide every coefficient, so they
/// are among the factors of the shortest one. `None` where that could not be factored.
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
