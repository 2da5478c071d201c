//! Restricts orbits to a level set of a known integral.
//!
//! Let F = P/Q be a known integral. Its value c is an unknown. On the level set P − cQ = 0,
//! coefficients of relations depend on one integral less.

use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::{Random, SplitMix64};

use crate::integrals::accepted::AcceptedIntegrals;
use crate::integrals::reconstructed::SearchLimits;
use crate::integrals::search::spanned_pencils;
use crate::maps::affine_subspace::{Coordinate, MapOnSubspace};
use crate::maps::chart::Chart;
use crate::maps::modular_step::ModularStep;
use crate::maps::parametric_field::evaluate;
use crate::maps::search_field::Sample;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::reconstruct_space;

/// The constraint P − cQ = 0 for an integral P/Q: the monomials and their coefficients.
#[derive(Clone, Debug)]
pub struct Constraint {
    monomials: Monomials,
    coefficients: Vec<(Polynomial, Polynomial)>,
    /// The index of the coordinate for which P − cQ = 0 is solved. P and Q have degree 1 in this
    /// coordinate.
    linear: usize,
}

/// A map whose sampled points satisfy a constraint P − cQ = 0.
#[derive(Clone, Debug)]
pub struct ConstrainedMap<'a> {
    base: MapOnSubspace,
    constraint: &'a Constraint,
    coefficients: Vec<u64>,
}

impl Constraint {
    /// Prepares the constraint P − cQ = 0, given monomials and their coefficients in P and Q.
    /// Returns `None` if no coordinate has degree 1 in the constraint.
    #[must_use]
    pub fn new(monomials: Monomials, coefficients: Vec<(Polynomial, Polynomial)>) -> Option<Self> {
        let is_used = |index: &usize| !(coefficients[*index].0.is_zero() && coefficients[*index].1.is_zero());
        let used: Vec<usize> = (0..monomials.len()).filter(is_used).collect();
        let degree_in = |coordinate: usize| {
            used.iter().map(|&index| monomials.exponents(index)[coordinate]).max().unwrap_or(0)
        };
        let linear = (0..monomials.variables()).find(|&coordinate| degree_in(coordinate) == 1)?;
        Some(Constraint { monomials, coefficients, linear })
    }

    /// Returns the map on the level set P/Q = `value`. Returns `None` if a coefficient is undefined
    /// modulo the prime.
    #[must_use]
    pub fn on(
        &self,
        base: MapOnSubspace,
        value: u64,
        unknown: impl Fn(Variable) -> u64,
    ) -> Option<ConstrainedMap<'_>> {
        let modulus = *base.modulus();
        let coefficient = |(above, below): &(Polynomial, Polynomial)| {
            let (above, below) = (evaluate(&modulus, above, &unknown)?, evaluate(&modulus, below, &unknown)?);
            Some(modulus.minus(above, modulus.times(value, below)))
        };
        let coefficients: Option<Vec<u64>> = self.coefficients.iter().map(coefficient).collect();
        Some(ConstrainedMap { base, constraint: self, coefficients: coefficients? })
    }
}

impl ConstrainedMap<'_> {
    fn residual(&self, point: &[u64]) -> u64 {
        let modulus = self.base.modulus();
        modulus.dot(&self.constraint.monomials.values(modulus, point), &self.coefficients)
    }
}

impl ModularStep for ConstrainedMap<'_> {
    fn modulus(&self) -> &Modulus {
        self.base.modulus()
    }

    fn dimension(&self) -> usize {
        self.base.dimension()
    }

    fn next(&self, point: &[u64]) -> Option<Vec<u64>> {
        self.base.next(point)
    }

    fn point(&self, random: &mut dyn Random) -> Vec<u64> {
        let modulus = *self.modulus();
        loop {
            let mut point: Vec<u64> = (0..self.dimension()).map(|_| modulus.sample(random)).collect();
            point[self.constraint.linear] = 0;
            let base = self.residual(&point);
            point[self.constraint.linear] = modulus.one();
            let slope = modulus.minus(self.residual(&point), base);
            if let Some(inverse) = modulus.inverse(slope) {
                point[self.constraint.linear] = modulus.opposite(modulus.times(base, inverse));
                return point;
            }
        }
    }
}

impl AcceptedIntegrals<'_> {
    /// Searches for further integrals on the level sets of P/Q, where P and Q are the first two
    /// elements of `basis`.
    pub(crate) fn search_constrained(
        &mut self,
        basis: &[Polynomial],
        degree: u32,
        chart: &Chart,
        sample: &Sample,
        limits: &SearchLimits<'_>,
        random: &mut SplitMix64,
    ) -> Option<()> {
        let [first, second, ..] = basis else { return None };
        let searched = self.searched;
        let symbols = searched.family().symbols();
        let states: Vec<Variable> = chart.leaf.order().iter().map(|&state| symbols.state(state)).collect();
        let monomials = Monomials::new(states.len(), degree);
        let mut coefficients =
            [first, second].map(|polynomial| polynomial.group(|variable| symbols.is_state(variable)));
        let pairs = (0..monomials.len()).map(|index| {
            let powers = states.iter().copied().zip(monomials.exponents(index).iter().copied());
            let states: Monomial = powers.collect();
            let [above, below] = coefficients.each_mut().map(|side| side.remove(&states).unwrap_or_default());
            (above, below)
        });
        let pairs = pairs.collect();
        let constraint = Constraint::new(monomials, pairs)?;
        let (numerator, denominator) = chart.substituted(symbols, first, second)?;
        let mut wider = chart.clone();
        wider.coordinates.push(Coordinate { numerator, denominator });
        let names = wider.names(searched);
        let own = searched.unknowns();
        let constrained = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
            let (generic, entries) = unknowns.split_at(own);
            let (value, entries) = entries.split_last()?;
            let map = chart.leaf.map_at(searched.at(modulus, generic)?, entries, random)?;
            constraint.on(map, *value, |variable| {
                let place = names.unknowns.iter().position(|known| *known == variable);
                unknowns[place.expect("the integral's other variables are unknowns")]
            })
        };
        let modulus = *sample.map.modulus();
        let extra = (0..names.unknowns.len() - own).map(|_| modulus.sample(random));
        let unknowns: Vec<u64> = sample.unknowns.iter().copied().chain(extra).collect();
        let map = constrained(modulus, &unknowns, random)?;
        for pencil in spanned_pencils(&map, limits.relation_degree, self.wanted, random, limits.deadline) {
            let monomials = Monomials::new(states.len(), pencil.degree);
            let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
                pencil.at(&constrained(modulus, unknowns, random)?, random, limits.deadline)
            };
            let basis =
                reconstruct_space(&names, &monomials, &pencil.space.form, at, random, limits.deadline)?;
            self.offer_quotients(&basis, &wider);
        }
        Some(())
    }
}
