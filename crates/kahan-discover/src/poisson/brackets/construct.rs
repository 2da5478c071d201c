//! Computes the Poisson tensor that a density and n − 2 integrals define.
//!
//! Each gradient is divided by the common factor of its entries, so that the minors stay small. The
//! tensor is multiplied by these factors at the end.

use kahan_algebra::kahan::maximal_minors;
use kahan_algebra::poly::{Budget, Polynomial, gcd_all_within, gcd_within};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;

/// Returns the bracket of functions F and G with {F,G} ρ dx₁∧…∧dxₙ = dF∧dG∧dI₁∧…∧dIₙ₋₂, for a
/// `density` ρ and n − 2 `integrals` I. The result lists the entries above the diagonal.
///
/// The bracket satisfies Jacobi's identity, and the functions I are Casimir functions. Maps that
/// preserve ρ dx and all I preserve the bracket. Returns `None` for a zero density, for dependent
/// integrals, or beyond the budget.
pub(super) fn invariant_tensor(
    symbols: &Symbols,
    density: &RationalFunction,
    integrals: &[RationalFunction],
    budget: &mut Budget,
) -> Option<Vec<RationalFunction>> {
    let n = symbols.dimension();
    let mut factor = density.recip()?;
    let mut directions = Vec::with_capacity(integrals.len());
    for integral in integrals {
        let gradient = Gradient::of(symbols, integral, budget)?;
        factor = factor.mul_within(&gradient.factor, budget).ok()?;
        directions.push(gradient.direction);
    }
    let mut minors = maximal_minors(&directions, budget).ok()?;
    if minors.is_empty() {
        return None;
    }
    let mut entries = Vec::with_capacity(n * (n - 1) / 2);
    for j in 0..n {
        for k in j + 1..n {
            let others = ((1u64 << n) - 1) & !(1 << j | 1 << k);
            let minor = minors.remove(&others).unwrap_or_default();
            // To move x_j and x_k to the front takes j + k − 1 interchanges of neighbours, each of
            // which changes the sign.
            let minor = if (j + k - 1) % 2 == 1 { -&minor } else { minor };
            entries.push(RationalFunction::from(minor).mul_within(&factor, budget).ok()?);
        }
    }
    Some(entries)
}

/// A differential dI, written as `factor` times the vector `direction` of coprime polynomials.
struct Gradient {
    factor: RationalFunction,
    direction: Vec<Polynomial>,
}

impl Gradient {
    fn of(symbols: &Symbols, integral: &RationalFunction, budget: &mut Budget) -> Option<Self> {
        let mut slopes = Vec::with_capacity(symbols.dimension());
        let mut common = Polynomial::one();
        for i in 0..symbols.dimension() {
            let slope = integral.derivative_within(symbols.state(i), budget).ok()?;
            let shared = gcd_within(&common, slope.denominator(), budget).ok()?;
            common = common.mul_within(&quotient(slope.denominator(), &shared, budget)?, budget).ok()?;
            slopes.push(slope);
        }
        let mut direction = Vec::with_capacity(slopes.len());
        for slope in &slopes {
            let cofactor = quotient(&common, slope.denominator(), budget)?;
            direction.push(slope.numerator().mul_within(&cofactor, budget).ok()?);
        }
        let nonzero: Vec<Polynomial> = direction.iter().filter(|entry| !entry.is_zero()).cloned().collect();
        if nonzero.is_empty() {
            return Some(Gradient { factor: RationalFunction::one(), direction });
        }
        let shared = gcd_all_within(&nonzero, budget).ok()?;
        for entry in &mut direction {
            *entry = quotient(entry, &shared, budget)?;
        }
        let factor = RationalFunction::new_within(shared, common, budget).ok()??;
        Some(Gradient { factor, direction })
    }
}

fn quotient(multiple: &Polynomial, divisor: &Polynomial, budget: &mut Budget) -> Option<Polynomial> {
    multiple.div_within(divisor, budget).ok()?
}
