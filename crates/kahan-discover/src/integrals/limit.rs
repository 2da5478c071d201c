//! Changes integrals so that their limit at ε = 0 depends on the states.

use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;

use crate::modular::subspace::primitive_in_states;

const LIMIT_WORK: u64 = 2_000_000;

/// Returns a polynomial P′ such that P′/Q depends on the states at ε = 0. While P/Q tends to a
/// function c without states for ε → 0, P becomes P − cQ, divided by its factors without states.
pub(crate) fn with_a_limit(
    symbols: &Symbols,
    mut numerator: Polynomial,
    denominator: &Polynomial,
) -> Polynomial {
    let at_zero = |polynomial: &Polynomial| polynomial.substitute(symbols.epsilon(), &Rational::zero());
    let below = at_zero(denominator);
    for _ in 0..8 {
        let mut budget = Budget::new(20_000, LIMIT_WORK);
        let limit = RationalFunction::new_within(at_zero(&numerator), below.clone(), &mut budget);
        let Ok(Some(limit)) = limit else { break };
        if symbols.has_state(limit.numerator()) || symbols.has_state(limit.denominator()) {
            break;
        }
        let rest = &numerator * limit.denominator() - denominator * limit.numerator();
        if rest.is_zero() {
            break;
        }
        numerator = primitive_in_states(symbols, &rest);
    }
    numerator
}
