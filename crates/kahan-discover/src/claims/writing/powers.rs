//! Writes a polynomial P, up to a factor without states, as Σ dₖ Fᵏ, where F is linear in a
//! variable v and the dₖ do not contain v.

use kahan_algebra::poly::{Budget, Monomial, Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text, push_term};
use kahan_algebra::symbols::{Symbol, Symbols};

use super::{MOST_TERMS, MOST_WORK, Product, Sum, begins_negative, product_text};

/// A factor of a sum: the number `content` times the quotient of monomials `front`/`front_below`.
pub(super) struct Scale {
    pub(super) content: Rational,
    pub(super) front: Monomial,
    pub(super) front_below: Monomial,
}

pub(crate) struct PowerExpansion {
    /// The polynomial times `scale`, as a polynomial in `fresh`, which stands for the base F.
    pub(crate) sum: Polynomial,
    pub(crate) fresh: Variable,
    pub(crate) scale: Polynomial,
}

/// Writes the polynomial in powers of `base`, which must be linear in `variable`. The coefficient
/// of `variable` in `base` must be a single term that contains no state.
pub(crate) fn in_powers(
    symbols: &Symbols,
    polynomial: &Polynomial,
    base: &Polynomial,
    variable: Variable,
) -> Option<PowerExpansion> {
    let fresh = symbols.variable(Symbol::SecondState(0));
    if base.degree_in(variable) != 1 || polynomial.contains(fresh) {
        return None;
    }
    let mut parts = base.coefficients_in(variable);
    let slope = parts.remove(&1)?;
    let rest = parts.remove(&0).unwrap_or_default();
    if slope.len() > 1 || symbols.has_state(&slope) {
        return None;
    }
    // Let F = μv + r be the base and K = `highest`. Then μᴷ Σ pᵢ vⁱ = Σ pᵢ μᴷ⁻ⁱ (F − r)ⁱ.
    let highest = polynomial.degree_in(variable);
    let shifted = Polynomial::variable(fresh) - rest;
    let mut budget = Budget::new(MOST_TERMS, MOST_WORK / 10);
    let sum = polynomial.homogenised_at(variable, (&shifted, &slope), highest, &mut budget).ok()?;
    Some(PowerExpansion { sum, fresh, scale: slope.pow_within(highest, &mut budget).ok()? })
}

/// Removes all terms without states. Divides the others by the powers of parameters and ε that all
/// of them have. For example, 1 − ε²(x − ay) becomes x − ay.
fn without_constant(symbols: &Symbols, base: &Polynomial) -> Polynomial {
    let has_states = |monomial: &Monomial| monomial.powers().iter().any(|&(v, _)| symbols.is_state(v));
    let moving = base.terms().filter(|(monomial, _)| has_states(monomial));
    let moving = Polynomial::from_terms(moving.map(|(monomial, value)| (monomial.clone(), value.clone())));
    let (_, common) = moving.monomial_content().split(|variable| symbols.is_state(variable));
    moving.div_monomial(&common).expect("all terms have it").primitive_part()
}

/// Writes a polynomial in powers of the sum of those terms of `base` that contain a state.
pub(super) fn by_powers(
    symbols: &Symbols,
    polynomial: &Polynomial,
    base: &Polynomial,
    variable: Variable,
) -> Option<(String, Scale)> {
    let base = without_constant(symbols, base);
    let base = if begins_negative(&base) { -&base } else { base };
    let PowerExpansion { sum, fresh, scale } = in_powers(symbols, polynomial, &base, variable)?;
    let (factor, coefficient) = scale.leading_term()?;
    if !sum.contains(fresh) {
        return None;
    }
    let front = sum.monomial_content();
    let sum = sum.div_monomial(&front)?;
    let content = sum.content();
    let sum = sum.primitive_part();
    if front.exponent(fresh) > 0 {
        return None;
    }
    // Texts that divide a sum by a power of ε are rejected, because they lose digits at small ε.
    if factor.exponent(symbols.epsilon()) > front.exponent(symbols.epsilon()) {
        return None;
    }
    let content = content.checked_div(coefficient)?;
    let scale = Scale { content, front, front_below: factor.clone() };
    let base_text = Text.polynomial(symbols, &base);
    let base_text = if base.len() > 1 { format!("({base_text})") } else { base_text };
    let mut text = String::new();
    let mut is_negative = false;
    for (exponent, digit) in sum.coefficients_in(fresh) {
        let mut product = Product::of(&[digit]);
        if text.is_empty() {
            is_negative = product.content.is_negative();
        }
        if is_negative {
            product.content = -&product.content;
        }
        let power = Text.power(&base_text, i64::from(exponent));
        product.sums.extend((exponent > 0).then_some((Sum::Written(power), 1)));
        let term = product_text(symbols, &product.content.abs(), &product.front, &product.sums);
        push_term(&mut text, product.content.is_negative(), &term);
    }
    let content = if is_negative { -&scale.content } else { scale.content };
    Some((text, Scale { content, ..scale }))
}
