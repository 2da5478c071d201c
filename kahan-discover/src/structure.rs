//! Structure of the field itself: its divergence, its linear and quadratic integrals, whether det(I − t f′) is even in t.

use std::time::Instant;

use kahan_algebra::field::Field;
use kahan_algebra::kahan::RationalMap;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational_function::RationalFunction;

use crate::independent::Independent;
use crate::map::ModularMap;
use crate::matrix::Echelon;
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::relations::monomial_gradients;
use crate::setting::Setting;
use crate::space::{Form, Names, Space, lift_space, tidy};
use crate::stepping::Stepping;

/// Equations beyond the number of unknowns.
const SPARE: usize = 6;

/// div f = Σ ∂fᵢ/∂xᵢ.
#[must_use]
pub fn divergence(field: &Field) -> RationalFunction {
    field.components.iter().enumerate().fold(RationalFunction::zero(), |sum, (i, component)| {
        let slope = component.numerator.derivative(field.symbols.state(i));
        let term = RationalFunction::new(slope, component.denominator.clone());
        &sum + &term.unwrap_or_else(RationalFunction::zero)
    })
}

/// Whether det(I − t f′(x)) is even in t, as it is at three random points modulo a prime. Then dx/det A(x,ε) is an invariant
/// measure of the map, because det ∂x̃/∂x = det A(x̃,−ε)/det A(x,ε).
pub fn is_even(setting: &Setting, random: &mut SplitMix64) -> bool {
    (0..3).all(|_| {
        let modulus = Modulus::mersenne_61();
        setting.draw(modulus, random).is_some_and(|draw| {
            let (point, t) = (draw.map.point(random), modulus.sample(random));
            draw.map.determinant(&point, t) == draw.map.determinant(&point, modulus.opposite(t))
        })
    })
}

/// det A(x,ε) up to factors free of states, where it stays within the budget of terms; ε is put in where it is fixed.
#[must_use]
pub fn determinant(setting: &Setting, map: &RationalMap) -> Polynomial {
    let symbols = setting.family().symbols();
    let denominator = match setting.eps() {
        Some(eps) => map.denominator.substitute(symbols.epsilon(), eps),
        None => map.denominator.clone(),
    };
    tidy(symbols, &denominator)
}

/// Functionally independent polynomial integrals of the flow ẋ = f(x), of degree at most `degree`, lowest first, lifted over
/// the parameters: exactly the P with ∇P·f = 0 modulo a prime at random parameters.
pub fn flow_integrals(
    setting: &Setting,
    degree: u32,
    random: &mut SplitMix64,
    deadline: Instant,
) -> Option<Vec<Polynomial>> {
    let symbols = setting.family().symbols();
    let mut independent = Independent::new(setting, random);
    let mut integrals: Vec<Polynomial> = Vec::new();
    for degree in 1..=degree {
        let monomials = Monomials::new(setting.dimension(), degree);
        let draw = setting.draw(Modulus::mersenne_61(), random)?;
        let all: Vec<usize> = (1..monomials.len()).collect();
        let vectors = flow_null_vectors(&draw.map, &monomials, &all, random);
        if vectors.is_empty() {
            continue;
        }
        // The constant 1 is left out of the columns and stands in front again.
        let spread = vectors.into_iter().map(|vector| [vec![0], vector].concat()).collect();
        let form = Space::spanned(draw.map.modulus(), spread).form;
        let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
            let map = setting.at(modulus, unknowns)?;
            on_form(&map, &monomials, &form, random)
        };
        for polynomial in lift_space(&Names::of(setting), &monomials, &form, at, random, deadline)? {
            let polynomial = tidy(symbols, &polynomial);
            if independent.admits(&polynomial, &Polynomial::one()) {
                independent.keep(&polynomial, &Polynomial::one());
                integrals.push(polynomial);
            }
        }
    }
    Some(integrals)
}

fn on_form(map: &ModularMap, monomials: &Monomials, form: &Form, random: &mut SplitMix64) -> Option<Space> {
    Space::of_form(map.modulus(), form, flow_null_vectors(map, monomials, &form.support, random))
}

/// The null vectors of ∇P·f on some monomials.
fn flow_null_vectors(
    map: &ModularMap,
    monomials: &Monomials,
    support: &[usize],
    random: &mut SplitMix64,
) -> Vec<Vec<u64>> {
    let modulus = map.modulus();
    let rows = (0..support.len() + SPARE).map(|_| {
        let point = map.point(random);
        let (value, _) = map.field(&point);
        let slopes = monomial_gradients(modulus, monomials, &point);
        let along = |&index: &usize| {
            let products = slopes[index].iter().zip(&value);
            products.fold(0, |sum, (a, b)| modulus.plus(sum, modulus.times(*a, *b)))
        };
        support.iter().map(along).collect()
    });
    let echelon = Echelon::of(modulus, rows.collect(), support.len());
    echelon.null_space(modulus).into_iter().map(|vector| vector.entries).collect()
}
