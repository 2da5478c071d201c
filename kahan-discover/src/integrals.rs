//! Independent integrals with all unknowns, lifted and proved.

use std::time::Instant;

use kahan_algebra::poly::{Budget, Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;

use crate::chart::Chart;
use crate::claims::{Claims, Formula};
use crate::constrained::Constraint;
use crate::hilbert::{Hilbert, random_relations};
use crate::independent::Independent;
use crate::leaf::{Coordinate, Leaf};
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::pencil::Pencil;
use crate::search::{pencils_of_entries, spanned_pencils};
use crate::setting::{Draw, Setting};
use crate::space::{lift_space, tidy};
use crate::stepping::Stepping;

/// The work that one look at ε = 0 may take, in products of terms.
const LIMIT_WORK: u64 = 2_000_000;

/// Independent integrals over ℚ with all unknowns, each proved, of least degree first: as many as there are, or as were
/// found before the deadline. `hilbert` says how many to look for.
pub fn integrals(
    setting: &Setting,
    claims: &Claims<'_>,
    hilbert: &Hilbert,
    random: &mut SplitMix64,
    deadline: Instant,
) -> Vec<Formula> {
    let mut collector = Collector {
        setting,
        claims,
        wanted: hilbert.integrals,
        independent: Independent::new(setting, random),
        formulas: Vec::new(),
    };
    let modulus = Modulus::mersenne_61();
    let Some(draw) = setting.draw(modulus, random) else { return Vec::new() };
    let Some(relation_degree) = defining_degree(setting, &draw, hilbert, random) else { return Vec::new() };
    let bounds = Bounds { relation_degree, highest: hilbert.degree(), deadline };
    let leaf = Leaf::of(&draw.map, random);
    if let Some(coordinates) = leaf.coordinates(setting, random, deadline) {
        for Coordinate { numerator, denominator } in &coordinates {
            collector.offer(numerator.clone(), denominator.clone());
        }
        collector.search_leaf(&Chart { leaf, coordinates }, &draw, &bounds, random);
    }
    if !collector.is_done() {
        let chart = Chart { leaf: Leaf::whole((0..setting.dimension()).collect()), coordinates: Vec::new() };
        collector.search_leaf(&chart, &draw, &bounds, random);
    }
    collector.formulas
}

/// The least degree up to which relations define the orbit's closure.
fn defining_degree(
    setting: &Setting,
    draw: &Draw,
    hilbert: &Hilbert,
    random: &mut SplitMix64,
) -> Option<u32> {
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
        let numerator = with_a_limit(symbols, numerator, &denominator);
        if let Some(formula) =
            self.claims.integral(symbols, self.formulas.len() + 1, &numerator, &denominator)
        {
            self.independent.keep(&numerator, &denominator);
            self.formulas.push(formula);
        }
    }

    /// Looks for the integrals that are missing on a leaf.
    fn search_leaf(&mut self, chart: &Chart, draw: &Draw, bounds: &Bounds, random: &mut SplitMix64) {
        let modulus = draw.map.modulus();
        let chosen: Vec<u64> = (0..chart.leaf.unknowns()).map(|_| modulus.sample(random)).collect();
        let Some(map) = chart.leaf.map_at(draw.map.clone(), &chosen, random) else { return };
        if self.is_done() || map.dimension() == 0 {
            return;
        }
        let spanned = spanned_pencils(&map, bounds.relation_degree, self.wanted, random);
        self.take(&spanned, chart, bounds, random);
        for degree in 1..=bounds.highest {
            // Which entries of the relations are simple depends on the order of the variables.
            for leaf in chart.leaf.orders() {
                let chart = Chart { leaf, coordinates: chart.coordinates.clone() };
                if self.is_done() || Instant::now() >= bounds.deadline {
                    return;
                }
                let Some(map) = chart.leaf.map_at(draw.map.clone(), &chosen, random) else { return };
                let found = pencils_of_entries(&map, bounds.relation_degree, degree, random, bounds.deadline);
                for basis in self.take(&found, &chart, bounds, random) {
                    if !self.is_done() {
                        self.search_constrained(&basis, degree, &chart, draw, bounds, random);
                    }
                }
            }
        }
    }

    /// Lifts pencils and keeps their integrals; returns the bases.
    fn take(
        &mut self,
        pencils: &[Pencil],
        chart: &Chart,
        bounds: &Bounds,
        random: &mut SplitMix64,
    ) -> Vec<Vec<Polynomial>> {
        let mut bases = Vec::new();
        for pencil in pencils {
            if self.is_done() {
                break;
            }
            let own = self.setting.unknowns();
            let setting = self.setting;
            let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
                let (generic, entries) = unknowns.split_at(own);
                let map = chart.leaf.map_at(setting.at(modulus, generic)?, entries, random)?;
                pencil.at(&map, random)
            };
            let monomials = Monomials::new(chart.leaf.order().len(), pencil.degree);
            let names = chart.names(setting);
            let form = &pencil.space.form;
            let Some(basis) = lift_space(&names, &monomials, form, at, random, bounds.deadline) else {
                continue;
            };
            self.offer_quotients(&basis, chart);
            bases.push(basis);
        }
        bases
    }

    /// Keeps the quotients of a basis by the simplest of its elements that does not vanish on the leaf.
    fn offer_quotients(&mut self, basis: &[Polynomial], chart: &Chart) {
        let symbols = self.setting.family().symbols();
        let mut order: Vec<usize> = (0..basis.len()).collect();
        order.sort_by_key(|&index| (!has_constant(symbols, &basis[index]), basis[index].len()));
        for &base in &order {
            let before = self.formulas.len();
            for &index in order.iter().filter(|&&index| index != base) {
                let above = with_a_limit(symbols, basis[index].clone(), &basis[base]);
                if let Some((above, below)) = chart.substituted(symbols, &above, &basis[base]) {
                    self.offer(above, below);
                }
            }
            if self.formulas.len() > before {
                return;
            }
        }
    }

    /// Looks on a leaf among orbits with a chosen value of an integral found there, the quotient of the basis.
    fn search_constrained(
        &mut self,
        basis: &[Polynomial],
        degree: u32,
        chart: &Chart,
        draw: &Draw,
        bounds: &Bounds,
        random: &mut SplitMix64,
    ) -> Option<()> {
        let [first, second, ..] = basis else { return None };
        let setting = self.setting;
        let symbols = setting.family().symbols();
        let states: Vec<Variable> = chart.leaf.order().iter().map(|&state| symbols.state(state)).collect();
        let monomials = Monomials::new(states.len(), degree);
        let coefficients = |polynomial: &Polynomial, index: usize| {
            let powers = states.iter().copied().zip(monomials.exponents(index).iter().copied());
            let wanted: Monomial = powers.collect();
            polynomial.group(|variable| symbols.is_state(variable)).remove(&wanted).unwrap_or_default()
        };
        let pairs: Vec<(Polynomial, Polynomial)> = (0..monomials.len())
            .map(|index| (coefficients(first, index), coefficients(second, index)))
            .collect();
        let constraint = Constraint::new(monomials, pairs)?;
        let (numerator, denominator) = chart.substituted(symbols, first, second)?;
        let mut wider = chart.clone();
        wider.coordinates.push(Coordinate { numerator, denominator });
        let names = wider.names(setting);
        let own = setting.unknowns();
        let constrained = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
            let (generic, entries) = unknowns.split_at(own);
            let (value, entries) = entries.split_last()?;
            let map = chart.leaf.map_at(setting.at(modulus, generic)?, entries, random)?;
            constraint.on(map, *value, |variable| {
                names.unknowns.iter().position(|known| *known == variable).map_or(0, |place| unknowns[place])
            })
        };
        let modulus = *draw.map.modulus();
        let extra = (0..names.unknowns.len() - own).map(|_| modulus.sample(random));
        let unknowns: Vec<u64> = draw.unknowns.iter().copied().chain(extra).collect();
        let map = constrained(modulus, &unknowns, random)?;
        for pencil in spanned_pencils(&map, bounds.relation_degree, self.wanted, random) {
            let monomials = Monomials::new(states.len(), pencil.degree);
            let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
                pencil.at(&constrained(modulus, unknowns, random)?, random)
            };
            let basis = lift_space(&names, &monomials, &pencil.space.form, at, random, bounds.deadline)?;
            self.offer_quotients(&basis, &wider);
        }
        Some(())
    }
}

/// How far to look.
struct Bounds {
    relation_degree: u32,
    highest: u32,
    deadline: Instant,
}

/// Whether the polynomial is not 0 where all states are.
fn has_constant(symbols: &Symbols, polynomial: &Polynomial) -> bool {
    polynomial.terms().any(|(monomial, _)| monomial.degree_where(|variable| symbols.is_state(variable)) == 0)
}

/// P such that P/Q depends on the states at ε = 0 too: where it is a constant c there, (P − cQ)/εᵏ instead. On a leaf what
/// chooses it counts as constant.
fn with_a_limit(symbols: &Symbols, mut numerator: Polynomial, denominator: &Polynomial) -> Polynomial {
    let at_zero = |polynomial: &Polynomial| polynomial.substitute(symbols.epsilon(), &Rational::zero());
    let below = at_zero(denominator);
    for _ in 0..8 {
        let mut budget = Budget::new(20_000, LIMIT_WORK);
        let limit = RationalFunction::new_within(at_zero(&numerator), below.clone(), &mut budget);
        let Ok(Some(limit)) = limit else { break };
        let varies = |side: &Polynomial| side.variables().iter().any(|&variable| symbols.is_state(variable));
        if varies(limit.numerator()) || varies(limit.denominator()) {
            break;
        }
        let rest = &numerator * limit.denominator() - denominator * limit.numerator();
        if rest.is_zero() {
            break;
        }
        numerator = tidy(symbols, &rest);
    }
    numerator
}
