//! The constructor: gradients, their minors, signs.
//!
//! Each gradient is brought over one denominator and freed of what its entries share, so that the minors are those of small
//! polynomials; all the denominators come back as one factor of the whole tensor.

use std::collections::BTreeMap;

use crate::poly::{Budget, OverBudget, Polynomial, gcd_all_within, gcd_within};
use crate::rational_function::RationalFunction;
use crate::symbols::Symbols;

use super::{PoissonError, PoissonTensor};

/// The bracket {F,G} ρ dx₁∧…∧dxₙ = dF∧dG∧dI₁∧…∧dIₙ₋₂ of section 4 of the paper, for the n ≥ 2 states of `symbols`.
///
/// `density` is ρ and `integrals` are I₁ … Iₙ₋₂, in this order (a permutation of them changes the sign as that of
/// columns does); all are functions of states, parameters and ε over `symbols`. The result is antisymmetric, satisfies
/// Jacobi's identity and has the I's as Casimirs, whatever they are; it is invariant under a map that preserves ρ dx and
/// the I's. With n = 2 the one entry is 1/ρ.
///
/// ```
/// use kahan_algebra::poisson::{claim_functions, default_budget, invariant_bracket};
/// use kahan_algebra::{lexer, read, render};
///
/// // E3 of the paper, with the density ρĤK̂ of its second bracket up to the sign.
/// let text = "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;
///     integral H = y/x; density rho = 1/(x^2*(1 + eps^2*(x^2 + y^2)));";
/// let system = read(&lexer::lex(text).tokens).system;
/// let budget = &mut default_budget();
/// let integral = claim_functions(&system.claims[0], budget)?;
/// let density = claim_functions(&system.claims[1], budget)?.remove(0);
/// let bracket = invariant_bracket(&system.field.symbols, &density, &integral, budget)?;
/// let claim = bracket.claim(&system.field.symbols, "P", Vec::new());
/// assert_eq!(
///     render::claim_text(&system, &claim),
///     "bracket P { {y,z} = -y*(1 + eps^2*x^2 + eps^2*y^2); {z,x} = x*(1 + eps^2*x^2 + eps^2*y^2); }"
/// );
/// # Ok::<(), kahan_algebra::poisson::PoissonError>(())
/// ```
///
/// Cost: n gcds a gradient, and the minors of n−2 rows by Laplace expansion, at most n·2ⁿ⁻¹ products of polynomials; zero
/// minors cost nothing.
///
/// # Errors
/// Fewer than two states, not n−2 integrals, a zero density, integrals that are functions of one another, or more work than
/// `budget` allows: see [`PoissonError`].
pub fn invariant_bracket(
    symbols: &Symbols,
    density: &RationalFunction,
    integrals: &[RationalFunction],
    budget: &mut Budget,
) -> Result<PoissonTensor, PoissonError> {
    let n = symbols.dimension();
    if n < 2 {
        return Err(PoissonError::Dimension { dimension: n });
    }
    if integrals.len() != n - 2 {
        return Err(PoissonError::IntegralCount { dimension: n, given: integrals.len() });
    }
    let mut factor = density.recip().ok_or(PoissonError::ZeroDensity)?;
    let mut minors = BTreeMap::from([(Vec::new(), Polynomial::one())]);
    for (index, integral) in integrals.iter().enumerate() {
        let gradient = Gradient::of(symbols, integral, budget)?;
        minors = expand(&minors, &gradient.direction, budget)?;
        if minors.is_empty() {
            return Err(PoissonError::DependentIntegral { index });
        }
        factor = factor.mul_within(&gradient.factor, budget)?;
    }
    let mut entries = Vec::with_capacity(n * (n - 1) / 2);
    for j in 0..n {
        for k in j + 1..n {
            let others: Vec<usize> = (0..n).filter(|&l| l != j && l != k).collect();
            let minor = minors.remove(&others).unwrap_or_default();
            // x_j passes the j variables before it, then x_k the k−1 that are left before it.
            let minor = if (j + k - 1) % 2 == 1 { -&minor } else { minor };
            entries.push(RationalFunction::from(minor).mul_within(&factor, budget)?);
        }
    }
    PoissonTensor::new(symbols, entries)
}

/// dI = factor · direction, the direction being coprime polynomials (all zero for a constant I).
struct Gradient {
    factor: RationalFunction,
    direction: Vec<Polynomial>,
}

impl Gradient {
    fn of(symbols: &Symbols, integral: &RationalFunction, budget: &mut Budget) -> Result<Self, OverBudget> {
        let mut slopes = Vec::with_capacity(symbols.dimension());
        let mut common = Polynomial::one();
        for i in 0..symbols.dimension() {
            let slope = integral.derivative_within(symbols.state(i), budget)?;
            let shared = gcd_within(&common, slope.denominator(), budget)?;
            common = common.mul_within(&quotient(slope.denominator(), &shared, budget)?, budget)?;
            slopes.push(slope);
        }
        let mut direction = Vec::with_capacity(slopes.len());
        for slope in &slopes {
            let cofactor = quotient(&common, slope.denominator(), budget)?;
            direction.push(slope.numerator().mul_within(&cofactor, budget)?);
        }
        let nonzero: Vec<Polynomial> = direction.iter().filter(|entry| !entry.is_zero()).cloned().collect();
        if nonzero.is_empty() {
            return Ok(Gradient { factor: RationalFunction::one(), direction });
        }
        let shared = gcd_all_within(&nonzero, budget)?;
        for entry in &mut direction {
            *entry = quotient(entry, &shared, budget)?;
        }
        let factor = RationalFunction::new_within(shared, common, budget)?;
        Ok(Gradient { factor: factor.unwrap_or_else(RationalFunction::zero), direction })
    }
}

/// The quotient by a known divisor.
fn quotient(
    multiple: &Polynomial,
    divisor: &Polynomial,
    budget: &mut Budget,
) -> Result<Polynomial, OverBudget> {
    Ok(multiple.div_within(divisor, budget)?.unwrap_or_default())
}

/// From the nonzero minors of some rows, by their columns, those with one row more: Laplace expansion along the last row.
fn expand(
    minors: &BTreeMap<Vec<usize>, Polynomial>,
    row: &[Polynomial],
    budget: &mut Budget,
) -> Result<BTreeMap<Vec<usize>, Polynomial>, OverBudget> {
    let mut next: BTreeMap<Vec<usize>, Polynomial> = BTreeMap::new();
    for (columns, minor) in minors {
        budget.charge(row.len() as u64)?;
        for (column, entry) in row.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
            let Err(place) = columns.binary_search(&column) else { continue };
            let product = minor.mul_within(entry, budget)?;
            // The last row's entry stands in the last column and moves left past those behind its own.
            let product = if (columns.len() - place) % 2 == 1 { -&product } else { product };
            let mut widened = columns.clone();
            widened.insert(place, column);
            let sum = next.entry(widened).or_default();
            *sum = sum.add_within(&product, budget)?;
        }
    }
    next.retain(|_, minor| !minor.is_zero());
    Ok(next)
}
