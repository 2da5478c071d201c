//! Finds which integrals of the map φ_ε its compositions preserve, too.
//!
//! The integrals are tested on φ_{γ₁ε} ∘ φ_{γ₂ε} ∘ φ_{γ₁ε} with random γ₁ and γ₂, the symmetric
//! pattern of composition methods of higher order.

use kahan_algebra::prime_field::SplitMix64;

use crate::claims::proved::Formula;
use crate::deadline::Deadline;
use crate::maps::map::ModularMap;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::orbits::hilbert::{Hilbert, random_relations};

/// The integrals that the compositions of a map at different ε preserve.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CompositionIntegrals {
    /// The Hilbert function of a generic orbit of the composed map.
    pub hilbert: Hilbert,
    /// For each given formula, whether the composed map preserves it.
    pub formulas: Vec<bool>,
    /// Pairs of formulas that the composed map changes, but whose quotient it preserves.
    pub quotients: Vec<(usize, usize)>,
}

struct ComposedMap {
    outer: ModularMap,
    inner: ModularMap,
}

impl ModularStep for ComposedMap {
    fn modulus(&self) -> &Modulus {
        self.outer.modulus()
    }

    fn dimension(&self) -> usize {
        self.outer.dimension()
    }

    fn next(&self, point: &[u64]) -> Option<Vec<u64>> {
        self.outer.next(&self.inner.next(&self.outer.next(point)?)?)
    }
}

/// Tests modulo a prime which `formulas` the map φ_{γ₁ε} ∘ φ_{γ₂ε} ∘ φ_{γ₁ε} preserves, for random
/// γ₁ and γ₂. An ε in a formula is that of φ_ε.
///
/// Returns `None` if the map is undefined or the deadline passes.
pub fn survivors(
    searched: &SearchField,
    formulas: &[Formula],
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<CompositionIntegrals> {
    let modulus = Modulus::mersenne_61();
    let sample = searched.sample(modulus, random)?;
    let eps = sample.map.eps();
    let parameters = &sample.unknowns[..searched.family().symbols().parameters.len()];
    let scaled = |factor: u64| searched.family().at(modulus, parameters, modulus.times(factor, eps));
    let (outer, inner) = (modulus.sample(random), modulus.sample(random));
    let composed = ComposedMap { outer: scaled(outer)?, inner: scaled(inner)? };
    let monomials = Monomials::new(searched.dimension(), degree);
    let relations = random_relations(&composed, &monomials, random, deadline)?;
    let hilbert = Hilbert::from_relations(&relations, &modulus, &monomials);
    let next = composed.next(&relations.start)?;
    let value = |formula: &Formula, point: &[u64]| {
        let above = searched.evaluate(&formula.numerator, &sample, point)?;
        let below = searched.evaluate(&formula.denominator, &sample, point)?;
        Some(modulus.times(above, modulus.inverse(below)?))
    };
    let factor = |formula: &Formula| {
        let (here, there) = (value(formula, &relations.start)?, value(formula, &next)?);
        Some(modulus.times(there, modulus.inverse(here)?))
    };
    let factors: Vec<Option<u64>> = formulas.iter().map(factor).collect();
    let survives: Vec<bool> = factors.iter().map(|factor| *factor == Some(modulus.one())).collect();
    let mut quotients = Vec::new();
    for (i, own) in factors.iter().enumerate().filter(|(i, own)| own.is_some() && !survives[*i]) {
        let same = factors[i + 1..].iter().position(|other| other == own);
        quotients.extend(same.map(|offset| (i, i + 1 + offset)));
    }
    Some(CompositionIntegrals { hilbert, formulas: survives, quotients })
}
