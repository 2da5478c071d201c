//! Simplifies integrals P/Q by subtraction of a known product from the numerator.
//!
//! Let M be a product of factors of known integrals with M(x̃)/M(x) = Q(x̃)/Q(x). Then M/Q is an
//! integral. If P/M is constant on the zeros of a factor q of Q, then q divides αP − βM for some α
//! and β. Both contain no state except constant ones.

use kahan_algebra::poly::{Polynomial, Variable, gcd, gcd_all};
use kahan_algebra::rational::Rational;

use crate::claims::writing::{in_powers, state_factors};
use crate::densities::products::exponents;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::{SampledStep, SearchField};
use crate::modular::subspace::primitive_in_states;

/// Cancels factors of the denominator one by one: replaces the numerator P by αP − βM, with a
/// product M of `factors`, which divide known integrals.
pub(crate) fn reduced(
    searched: &SearchField,
    step: &SampledStep,
    factors: &[Polynomial],
    numerator: Polynomial,
    denominator: Polynomial,
) -> (Polynomial, Polynomial) {
    let symbols = searched.family().symbols();
    let (mut numerator, mut denominator) = (numerator, denominator);
    while let Some((above, below)) = without_factor(searched, step, factors, &numerator, &denominator) {
        let common = gcd(&above, &below);
        let lowest = |side: &Polynomial| side.checked_div(&common).expect("a common divisor divides");
        (numerator, denominator) =
            (primitive_in_states(symbols, &lowest(&above)), primitive_in_states(symbols, &lowest(&below)));
    }
    (numerator, denominator)
}

/// Forms a combination αP − βM of the numerator P and a product M of `factors`, so that a factor q
/// of the denominator divides it. Returns the combination and the denominator, both divided by q.
fn without_factor(
    searched: &SearchField,
    step: &SampledStep,
    factors: &[Polynomial],
    numerator: &Polynomial,
    denominator: &Polynomial,
) -> Option<(Polynomial, Polynomial)> {
    let symbols = searched.family().symbols();
    let poles = state_factors(symbols, denominator);
    if poles.is_empty() {
        return None;
    }
    let products = products(searched, step, factors, numerator, denominator)?;
    let moves = moving_states(searched, step, factors);
    for pole in &poles {
        for variable in pole.variables().into_iter().filter(|&variable| symbols.is_state(variable)) {
            let rest = |polynomial: &Polynomial| {
                let written = in_powers(symbols, polynomial, pole, variable)?;
                let rest = written.sum.coefficients_in(written.fresh).remove(&0)?;
                Some((rest, written.scale))
            };
            let Some((own, own_scale)) = rest(numerator) else { continue };
            for product in &products {
                let Some((other, other_scale)) = rest(product) else { continue };
                let (alpha, beta) = (content_in(&moves, &own), content_in(&moves, &other));
                let (shape, same) = (own.checked_div(&alpha)?, other.checked_div(&beta)?);
                let beta = match (shape == same, shape == -&same) {
                    (true, _) => beta,
                    (false, true) => -&beta,
                    (false, false) => continue,
                };
                let left = &(&beta * &own_scale) * numerator;
                let right = &(&alpha * &other_scale) * product;
                let difference = &left - &right;
                if !difference.variables().iter().any(|variable| moves.contains(variable)) {
                    continue;
                }
                let above = difference.checked_div(pole)?;
                return Some((above, denominator.checked_div(pole)?));
            }
        }
    }
    None
}

fn moving_states(searched: &SearchField, step: &SampledStep, factors: &[Polynomial]) -> Vec<Variable> {
    let symbols = searched.family().symbols();
    let rests = |variable: Variable| {
        let single = Polynomial::variable(variable);
        factors.contains(&single) && step.keeps(searched, &single)
    };
    (0..searched.dimension()).map(|i| symbols.state(i)).filter(|&variable| !rests(variable)).collect()
}

fn content_in(variables: &[Variable], polynomial: &Polynomial) -> Polynomial {
    let groups = polynomial.group(|variable| variables.contains(&variable));
    let common = gcd_all(&groups.into_values().collect::<Vec<_>>());
    common.scale(&polynomial.content().checked_div(&common.content()).unwrap_or_else(Rational::one))
}

/// Returns the products M of `factors` with M(x̃)/M(x) = Q(x̃)/Q(x), where Q is the denominator.
/// The degree of M is at most that of the numerator.
fn products(
    searched: &SearchField,
    step: &SampledStep,
    factors: &[Polynomial],
    numerator: &Polynomial,
    denominator: &Polynomial,
) -> Option<Vec<Polynomial>> {
    let symbols = searched.family().symbols();
    let modulus = step.sample.map.modulus();
    let cofactors: Vec<u64> =
        factors.iter().map(|factor| step.cofactor(searched, factor)).collect::<Option<_>>()?;
    let degrees: Vec<u32> = factors.iter().map(|factor| symbols.degree(factor)).collect();
    let wanted = step.cofactor(searched, denominator)?;
    let mut found = Vec::new();
    for total in 1..=symbols.degree(numerator) {
        for candidate in exponents(&degrees, total, &[1]) {
            let own = cofactors.iter().zip(&candidate).fold(modulus.one(), |product, (base, &exponent)| {
                modulus.times(product, modulus.power(*base, exponent.unsigned_abs()))
            });
            if own == wanted {
                let powers = factors.iter().zip(&candidate);
                found.push(powers.fold(Polynomial::one(), |product, (factor, &exponent)| {
                    (0..exponent).fold(product, |product, _| &product * factor)
                }));
            }
        }
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::prime_field::SplitMix64;
    use kahan_algebra::{lexer, read};

    #[test]
    fn contributions_of_other_integrals_to_a_pole_are_subtracted() {
        let text = "xdot = x*(y - w); ydot = y*(z - x); zdot = z*(w - y); wdot = w*(x - z);";
        let field = read(&lexer::lex(text).tokens).system().expect("a system").field;
        let symbols = &field.symbols;
        let [x, y, z, w] = [0, 1, 2, 3].map(|i| Polynomial::variable(symbols.state(i)));
        let eps = Polynomial::variable(symbols.epsilon());
        let sum = &(&x + &y) + &(&z + &w);
        let difference = &eps * &(&y - &w);
        let poles = [&Polynomial::one() + &difference, &Polynomial::one() - &difference];
        let below = &poles[0] * &poles[1];
        let product = &x * &z;
        let mixed = &(&sum * &below) + &(&eps * &product).scale(&Rational::from(5));
        let searched = SearchField::new(&field, None);
        let step = searched.step(&mut SplitMix64::new(1)).expect("the map has a value");
        let factors = [x, z, poles[0].clone(), poles[1].clone()];
        let found = reduced(&searched, &step, &factors, mixed.clone(), below.clone());
        assert_eq!(found, (sum, Polynomial::one()));
        let kept = reduced(&searched, &step, &factors[2..], mixed.clone(), below.clone());
        assert_eq!(kept, (mixed, below));
    }
}
