//! Polynomials with a given cofactor under the map: P(φ(x)) = C(x) P(x), linear in P.
//!
//! With C = det ∂x̃/∂x, dx/P is an invariant measure; with C = 1, P is an integral. A quotient of
//! factors whose cofactors multiply to 1/det ∂x̃/∂x is a density too. Two P with the same C have an
//! integral as their quotient, so with integrals the P of one degree form a space; its simplest
//! element is the one to write.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;

use crate::deadline::Deadline;
use crate::map::{ModularMap, Step};
use crate::matrix::Echelon;
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::setting::Setting;
use crate::space::{Form, Names, Space, lift_space, tidy};
use crate::stepping::Stepping;

/// Equations beyond the number of unknowns.
const SPARE: usize = 6;

/// How often a point is drawn again.
const MOST_DRAWS: usize = 16;

/// The density ρ of an invariant measure ρ dx, in factors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Measure {
    /// ρ as a product: factors and their exponents.
    pub factors: Vec<(Polynomial, i32)>,
    /// The degrees of the factors in the states, each as often as it is multiplied or divided by.
    pub degree: u32,
}

fn random_step(map: &ModularMap, random: &mut SplitMix64) -> Option<(Vec<u64>, Step)> {
    (0..MOST_DRAWS).find_map(|_| {
        let point = map.point(random);
        let step = map.step(&point)?;
        Some((point, step))
    })
}

/// The null vectors of P(φ(x)) − det(∂x̃/∂x) P(x) on some monomials; `None` if the map has no value, or
/// the deadline passes.
fn null_vectors(
    map: &ModularMap,
    monomials: &Monomials,
    support: &[usize],
    random: &mut SplitMix64,
    deadline: &Deadline,
) -> Option<Vec<Vec<u64>>> {
    let modulus = map.modulus();
    let mut rows = Vec::with_capacity(support.len() + SPARE);
    for _ in 0..support.len() + SPARE {
        let (point, step) = random_step(map, random)?;
        let (here, there) = (monomials.values(modulus, &point), monomials.values(modulus, &step.next));
        let difference =
            |&index: &usize| modulus.minus(there[index], modulus.times(step.jacobian, here[index]));
        rows.push(support.iter().map(difference).collect());
    }
    let echelon = Echelon::within(modulus, rows, support.len(), deadline)?;
    Some(echelon.null_space(modulus).into_iter().map(|vector| vector.entries).collect())
}

/// The space of the P of degree at most `degree` with the cofactor det ∂x̃/∂x, perhaps of dimension 0; `None` where the map
/// has no value, or the deadline passes.
pub fn measure_space(
    map: &ModularMap,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline,
) -> Option<Space> {
    let monomials = Monomials::new(map.dimension(), degree);
    let all: Vec<usize> = (0..monomials.len()).collect();
    let vectors = null_vectors(map, &monomials, &all, random, deadline)?;
    Some(Space::spanned(map.modulus(), vectors))
}

/// Products of factors are tried to this degree, beyond what linear algebra reaches.
const HIGHEST_PRODUCT: u32 = 12;

/// Quotients are tried up to this sum of the degrees above and below.
const HIGHEST_QUOTIENT: u32 = 16;

/// How a search for a measure ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MeasureSearch {
    /// With a formula.
    Found(Measure),
    /// A polynomial of this degree was seen modulo a prime, and no formula of it was reached.
    Seen(u32),
    /// None of degree at most this; of none at all where the time ran out before anything was looked at.
    NoneUpTo(Option<u32>),
}

/// The measure of least degree, over ℚ with all unknowns; products of `factors` are preferred to anything else. All P are
/// looked at up to the degree `highest`, products up to 12.
pub fn measure(
    setting: &Setting,
    factors: &[Polynomial],
    highest: u32,
    random: &mut SplitMix64,
    deadline: &Deadline,
) -> MeasureSearch {
    let mut looked_up_to = None;
    let Some(draw) = setting.draw(Modulus::mersenne_61(), random) else {
        return MeasureSearch::NoneUpTo(looked_up_to);
    };
    for degree in 0..=highest.max(HIGHEST_PRODUCT) {
        if deadline.passed() {
            break;
        }
        if let Some(factors) = product(setting, factors, degree, &[-1], random) {
            return MeasureSearch::Found(Measure { factors, degree });
        }
        if degree > highest {
            continue;
        }
        let Some(space) = measure_space(&draw.map, degree, random, deadline) else { break };
        if space.dimension() > 0 {
            let measure = lifted(setting, &draw.map, &space, degree, random, deadline);
            return measure.map_or(MeasureSearch::Seen(degree), MeasureSearch::Found);
        }
        looked_up_to = Some(degree);
    }
    let quotient = (0..=HIGHEST_QUOTIENT).find_map(|degree| {
        let factors = product(setting, factors, degree, &[-1, 1], random)?;
        Some(Measure { factors, degree })
    });
    quotient.map_or(MeasureSearch::NoneUpTo(looked_up_to), MeasureSearch::Found)
}

/// The simplest element of a space of P, over ℚ.
fn lifted(
    setting: &Setting,
    map: &ModularMap,
    space: &Space,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline,
) -> Option<Measure> {
    let monomials = Monomials::new(setting.dimension(), degree);
    let simplest = (0..space.dimension()).min_by_key(|&index| space.terms(index))?;
    let places = space.form.support.iter().zip(&space.rows[simplest]).filter(|(_, value)| **value != 0);
    let support: Vec<usize> = places.map(|(&index, _)| index).collect();
    let alone = null_vectors(map, &monomials, &support, random, deadline)?.len() == 1;
    let (form, row) =
        if alone { (Form { support, pivots: vec![0] }, 0) } else { (space.form.clone(), simplest) };
    let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
        let map = setting.at(modulus, unknowns)?;
        let vectors = null_vectors(&map, &monomials, &form.support, random, deadline)?;
        Space::of_form(&modulus, &form, vectors)
    };
    let symbols = setting.family().symbols();
    let polynomials = lift_space(&Names::of(setting), &monomials, &form, at, random, deadline)?;
    Some(Measure { factors: vec![(tidy(symbols, &polynomials[row]), -1)], degree })
}

/// The simplest product of powers of the given polynomials, exponents of these `signs`, whose
/// degrees add up to `degree` and whose cofactor is 1/det ∂x̃/∂x.
fn product(
    setting: &Setting,
    factors: &[Polynomial],
    degree: u32,
    signs: &[i32],
    random: &mut SplitMix64,
) -> Option<Vec<(Polynomial, i32)>> {
    let symbols = setting.family().symbols();
    let degrees: Vec<u32> =
        factors.iter().map(|factor| factor.degree_where(|variable| symbols.is_state(variable))).collect();
    let modulus = Modulus::mersenne_61();
    // For each of two points the factors' cofactors, their inverses, and the determinant.
    let mut samples: Vec<(Vec<[u64; 2]>, u64)> = Vec::new();
    for _ in 0..2 {
        let draw = setting.draw(modulus, random)?;
        let (point, step) = random_step(&draw.map, random)?;
        let cofactors: Option<Vec<[u64; 2]>> = factors
            .iter()
            .map(|factor| {
                let here = setting.evaluate(&modulus, factor, &draw, &point)?;
                let there = setting.evaluate(&modulus, factor, &draw, &step.next)?;
                let cofactor = |above, below| Some(modulus.times(above, modulus.inverse(below)?));
                Some([cofactor(there, here)?, cofactor(here, there)?])
            })
            .collect();
        samples.push((cofactors?, step.jacobian));
    }
    let candidates = exponents(&degrees, degree, signs);
    let has_cofactor = |exponents: &Vec<i32>| {
        samples.iter().all(|(cofactors, jacobian)| {
            let powers = cofactors.iter().zip(exponents).map(|(bases, &exponent)| {
                modulus.power(bases[usize::from(exponent < 0)], exponent.unsigned_abs())
            });
            powers.fold(*jacobian, |product, power| modulus.times(product, power)) == modulus.one()
        })
    };
    let terms = |exponents: &Vec<i32>| -> usize {
        let each = exponents.iter().zip(factors);
        each.map(|(exponent, factor)| exponent.unsigned_abs() as usize * (factor.len() + 1)).sum()
    };
    // Denominators of integrals become constants at ε = 0, as the density of the flow's volume is.
    let is_of_flow = |exponents: &Vec<i32>| {
        let mut used = exponents.iter().zip(factors).filter(|(exponent, _)| **exponent != 0);
        used.all(|(_, factor)| {
            let at_zero = factor.substitute(symbols.epsilon(), &Rational::zero());
            !at_zero.variables().into_iter().any(|variable| symbols.is_state(variable))
        })
    };
    let key = |exponents: &Vec<i32>| (!is_of_flow(exponents), terms(exponents));
    let best = candidates.into_iter().filter(has_cofactor).min_by_key(key)?;
    let used = factors.iter().cloned().zip(best).filter(|(_, exponent)| *exponent != 0);
    Some(used.collect())
}

/// Exponents of these signs with Σ |exponent|·degree = total: all, or as many as half a million steps
/// reach. Many factors have more combinations than can be looked at.
pub(crate) fn exponents(degrees: &[u32], total: u32, signs: &[i32]) -> Vec<Vec<i32>> {
    const MOST_STEPS: usize = 500_000;
    let mut found = Vec::new();
    extend(degrees, total, signs, &mut Vec::new(), &mut found, &mut { MOST_STEPS });
    found
}

fn extend(
    degrees: &[u32],
    total: u32,
    signs: &[i32],
    begun: &mut Vec<i32>,
    found: &mut Vec<Vec<i32>>,
    steps: &mut usize,
) {
    const MOST: usize = 20_000;
    if *steps == 0 || found.len() == MOST {
        return;
    }
    *steps -= 1;
    let Some((&first, rest)) = degrees.split_first() else {
        found.extend((total == 0).then(|| begun.clone()));
        return;
    };
    for size in 0..=total.checked_div(first).unwrap_or(0) {
        for &sign in if size == 0 { &signs[..1] } else { signs } {
            begun.push(sign * size as i32);
            extend(rest, total - size * first, signs, begun, found, steps);
            begun.pop();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::{lexer, read};

    #[test]
    fn a_density_may_be_a_quotient_of_factors() {
        // E1, whose density 1/(y²(1 − ε²x²)) is made here of y and y³(1 − ε²x²).
        let field = read(&lexer::lex("xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z;").tokens).system.field;
        let setting = Setting::new(&field, None);
        let symbols = &field.symbols;
        let variable = Polynomial::variable;
        let (x, y, eps) =
            (variable(symbols.state(0)), variable(symbols.state(1)), variable(symbols.epsilon()));
        let square = |polynomial: &Polynomial| polynomial * polynomial;
        let long = &(&square(&y) * &y) * &(Polynomial::one() - &square(&eps) * &square(&x));
        let factors = [long.clone(), y.clone()];
        // One over a polynomial is not looked for up to degree 4, where there is one.
        let far = Deadline::never();
        let found = measure(&setting, &factors, 2, &mut SplitMix64::new(1), &far);
        assert_eq!(found, MeasureSearch::Found(Measure { factors: vec![(long, -1), (y, 1)], degree: 6 }));
    }
}
