//! Independent integrals with all unknowns, lifted and proved.

use std::time::Instant;

use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::{Symbol, Symbols};

use crate::claims::{Claims, Formula};
use crate::hilbert::{Hilbert, random_relations};
use crate::independent::Independent;
use crate::leaf::{Coordinate, Leaf};
use crate::map::Stepping;
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::pencil::Pencil;
use crate::search::pencils;
use crate::setting::{Draw, Setting};
use crate::space::{lift_space, tidy};

/// The work that putting the formulas of a leaf's coordinates in may take, in products of terms.
const SUBSTITUTION_WORK: u64 = 20_000_000;

/// Independent integrals over ℚ with all unknowns, each proved, of least degree first: as many as there are, or as were
/// found before the deadline. `hilbert` says how many to look for.
pub fn integrals(
    setting: &Setting,
    claims: &Claims<'_>,
    hilbert: &Hilbert,
    random: &mut SplitMix64,
    deadline: Instant,
) -> Vec<Formula> {
    let mut collector =
        Collector { setting, claims, wanted: hilbert.integrals, independent: Independent::new(setting, random), formulas: Vec::new() };
    let modulus = Modulus::mersenne_61();
    let Some(draw) = setting.draw(modulus, random) else { return Vec::new() };
    let Some(relation_degree) = defining_degree(setting, &draw, hilbert, random) else { return Vec::new() };
    let leaf = Leaf::of(&draw.map, random);
    let coordinates = leaf.coordinates(setting, random, deadline);
    if let Some(coordinates) = coordinates {
        for Coordinate { numerator, denominator } in &coordinates {
            collector.offer(numerator.clone(), denominator.clone());
        }
        collector.search_leaf(&leaf, &coordinates, &draw, relation_degree, hilbert.degree(), random, deadline);
    }
    // Which entries of the relations are simple depends on the order of the variables.
    let n = setting.dimension();
    let forward = |shift: usize| (0..n).map(|i| (i + shift) % n).collect::<Vec<_>>();
    let orders = (0..n).flat_map(|shift| [forward(shift), forward(shift).into_iter().rev().collect()]);
    for order in orders {
        if collector.is_done() || Instant::now() >= deadline {
            break;
        }
        let whole = Leaf::whole(order);
        collector.search_leaf(&whole, &[], &draw, relation_degree, hilbert.degree(), random, deadline);
    }
    collector.formulas
}

/// The least degree up to which relations define the orbit's closure.
fn defining_degree(setting: &Setting, draw: &Draw, hilbert: &Hilbert, random: &mut SplitMix64) -> Option<u32> {
    let lowest = hilbert.relation_degree?;
    (lowest..=hilbert.degree()).find(|&degree| {
        let monomials = Monomials::new(setting.dimension(), degree);
        random_relations(&draw.map, &monomials, random).is_some_and(|relations| {
            relations.codimension(draw.map.modulus(), &monomials) == hilbert.integrals
        })
    })
}

struct Collector<'a> {
    setting: &'a Setting,
    claims: &'a Claims<'a>,
    wanted: usize,
    independent: Independent<'a>,
    formulas: Vec<Formula>,
}

impl Collector<'_> {
    fn is_done(&self) -> bool {
        self.formulas.len() >= self.wanted
    }

    /// Keeps P/Q if it is independent of what is known and is proved.
    fn offer(&mut self, numerator: Polynomial, denominator: Polynomial) {
        let symbols = self.setting.family().symbols();
        if self.is_done() || !self.independent.admits(&numerator, &denominator) {
            return;
        }
        let (numerator, denominator) = (tidy(symbols, &numerator), tidy(symbols, &denominator));
        if let Some(formula) = self.claims.integral(symbols, self.formulas.len() + 1, &numerator, &denominator) {
            self.independent.keep(&numerator, &denominator);
            self.formulas.push(formula);
        }
    }

    /// Looks for the integrals that are missing on a leaf.
    #[expect(clippy::too_many_arguments, reason = "what one search is about")]
    fn search_leaf(
        &mut self,
        leaf: &Leaf,
        coordinates: &[Coordinate],
        draw: &Draw,
        relation_degree: u32,
        highest: u32,
        random: &mut SplitMix64,
        deadline: Instant,
    ) {
        let modulus = draw.map.modulus();
        let chosen: Vec<u64> = (0..leaf.unknowns()).map(|_| modulus.sample(random)).collect();
        let Some(map) = leaf.map_at(draw.map.clone(), &chosen, random) else { return };
        let wanted = self.wanted.saturating_sub(self.formulas.len().min(leaf.unknowns()));
        if wanted == 0 || map.dimension() == 0 {
            return;
        }
        for pencil in pencils(&map, relation_degree, wanted, highest, random, deadline) {
            let Some(basis) = self.lift_pencil(&pencil, leaf, random, deadline) else { continue };
            let symbols = self.setting.family().symbols();
            let base = denominator_of(symbols, &basis);
            for numerator in (0..basis.len()).filter(|&index| index != base).map(|index| &basis[index]) {
                let quotient = if coordinates.is_empty() {
                    Some((numerator.clone(), basis[base].clone()))
                } else {
                    substituted(symbols, coordinates, numerator, &basis[base])
                };
                if let Some((numerator, denominator)) = quotient {
                    self.offer(numerator, denominator);
                }
            }
        }
    }

    fn lift_pencil(
        &self,
        pencil: &Pencil,
        leaf: &Leaf,
        random: &mut SplitMix64,
        deadline: Instant,
    ) -> Option<Vec<Polynomial>> {
        let symbols = self.setting.family().symbols();
        let monomials = Monomials::new(leaf.order().len(), pencil.degree);
        let own = self.setting.unknowns();
        let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
            let (generic, entries) = unknowns.split_at(own);
            let map = leaf.map_at(self.setting.at(modulus, generic)?, entries, random)?;
            pencil.at(&map, random)
        };
        let unknowns = [self.setting.unknown_variables(), leaf.variables(self.setting)].concat();
        let states: Vec<Variable> = leaf.order().iter().map(|&state| symbols.state(state)).collect();
        lift_space(&unknowns, &states, &monomials, &pencil.space.form, at, random, deadline)
    }
}

/// The element to divide by: one that is not 0 at the origin, the shortest of them.
fn denominator_of(symbols: &Symbols, basis: &[Polynomial]) -> usize {
    let has_constant = |polynomial: &Polynomial| {
        polynomial.terms().any(|(monomial, _)| monomial.degree_where(|variable| symbols.is_state(variable)) == 0)
    };
    (0..basis.len()).min_by_key(|&index| (!has_constant(&basis[index]), basis[index].len())).unwrap_or(0)
}

/// P/Q in lowest terms with cⱼ replaced by its formula; `None` beyond the budget.
fn substituted(
    symbols: &Symbols,
    coordinates: &[Coordinate],
    numerator: &Polynomial,
    denominator: &Polynomial,
) -> Option<(Polynomial, Polynomial)> {
    let mut budget = Budget::new(20_000, SUBSTITUTION_WORK);
    let mut quotient = [numerator.clone(), denominator.clone()];
    for (j, coordinate) in coordinates.iter().enumerate() {
        let variable = symbols.variable(Symbol::SecondState(j));
        let highest = quotient.iter().map(|side| side.degree_in(variable)).max()?;
        for side in &mut quotient {
            let mut sum = Polynomial::zero();
            for (exponent, coefficient) in side.coefficients_in(variable) {
                let above = coordinate.numerator.pow_within(exponent, &mut budget).ok()?;
                let below = coordinate.denominator.pow_within(highest - exponent, &mut budget).ok()?;
                let power = above.mul_within(&below, &mut budget).ok()?;
                sum = sum + coefficient.mul_within(&power, &mut budget).ok()?;
            }
            *side = sum;
        }
    }
    let [above, below] = quotient;
    let reduced = RationalFunction::new_within(above, below, &mut budget).ok()??;
    Some((reduced.numerator().clone(), reduced.denominator().clone()))
}
