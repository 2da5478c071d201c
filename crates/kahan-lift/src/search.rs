//! Searches for a smallest set of monomials that makes the equations quadratic.
//!
//! A set of variables is closed if it covers each monomial in the derivatives. Covered are 1,
//! variables, products of two variables, and, because of relations, combinations of these.
//! Iterative deepening tries ways to write one missing monomial, with bounded exponents. If it
//! takes too long, local changes improve the result of a greedy search. Neither search reads a
//! clock, so results are reproducible.

use std::cmp::Reverse;
use std::collections::BTreeSet;
use std::rc::Rc;

use kahan_algebra::prime_field::Shake256;
use rustc_hash::{FxHashMap, FxHashSet};

use crate::laurent::{Laurent, Monomial};
use crate::ring::{CoordinateDefinition, Ring};
use crate::table::{MonomialId, MonomialTable};

/// The given variables, and the monomials that must be written in variables.
#[derive(Clone, Debug, Default)]
pub(crate) struct CoverProblem {
    /// Monomials that are already variables.
    pub given: Vec<Monomial>,
    /// Polynomials that are already variables.
    pub sums: Vec<Laurent>,
    /// Monomials that must be products of at most two variables. Monomials in derivatives of new
    /// variables must be such products, too.
    pub required: Vec<Monomial>,
    /// Coordinates that may have negative exponents in new variables.
    pub negative: BTreeSet<usize>,
}

#[derive(Clone, Debug)]
pub(crate) struct VariableSets {
    /// Sets of new variables. The smallest sets come first.
    pub sets: Vec<Vec<Laurent>>,
    /// Whether no smaller set exists in which each missing monomial is a product of two variables.
    pub is_optimal: bool,
}

const MOST_SETS: usize = 24;
pub(crate) const MOST_VARIABLES: usize = 60;
/// One local change takes as much time as this many search nodes.
const NODES_A_CHANGE: usize = 20;
const LOCAL_CHANGES: usize = 40;

#[derive(Clone, Debug, Default)]
struct MonomialCover {
    covered: FxHashSet<MonomialId>,
    /// For each product of two variables with at least two uncovered monomials, its monomials.
    composite: Vec<Rc<[MonomialId]>>,
}

impl MonomialCover {
    fn add(&mut self, support: &Rc<[MonomialId]>) {
        let mut missing = support.iter().filter(|one| !self.covered.contains(*one));
        match (missing.next().copied(), missing.next()) {
            (None, _) => {}
            (Some(only), None) => {
                self.covered.insert(only);
            }
            _ => self.composite.push(Rc::clone(support)),
        }
    }

    /// Covers each monomial that is the only uncovered one in a product, until nothing changes.
    fn close(&mut self) {
        loop {
            let before = self.covered.len();
            let composite = std::mem::take(&mut self.composite);
            composite.iter().for_each(|support| self.add(support));
            if self.covered.len() == before {
                return;
            }
        }
    }
}

struct Search<'a> {
    table: MonomialTable<'a>,
    ring: &'a Ring,
    problem: &'a CoverProblem,
    given: Vec<MonomialId>,
    required: Vec<MonomialId>,
    nodes: usize,
    largest: u32,
    /// Whether each new variable must be 1/polynomial, or a product of two other variables.
    founded: bool,
    visited: FxHashMap<Vec<MonomialId>, usize>,
    sets: Vec<Vec<MonomialId>>,
}

/// Returns the smallest sets of at most `most` variables that make the equations quadratic (closed
/// sets), then sets with up to `surplus` more variables. The search visits at most `budget` nodes.
/// Returns `None` if no closed set is found.
pub(crate) fn search(
    ring: &Ring,
    problem: &CoverProblem,
    budget: usize,
    surplus: usize,
    most: usize,
) -> Option<VariableSets> {
    let mut search = Search::new(ring, problem, budget);
    let greedy = search.greedy_set(most);
    // If the greedy search finds no set, a full search rarely succeeds, and gets fewer nodes.
    if greedy.is_none() && most < MOST_VARIABLES {
        search.nodes = budget / NODES_A_CHANGE;
    }
    let most = greedy.as_ref().map_or(most, Vec::len);
    for size in 0..=most {
        search.collect(size);
        if search.sets.is_empty() && search.nodes > 0 {
            continue;
        }
        if search.sets.is_empty() {
            break;
        }
        let mut sets = std::mem::take(&mut search.sets);
        if surplus > 0 {
            search.nodes = budget / 4;
            search.collect(size + surplus);
            let larger = search.sets.drain(..).filter(|set| set.len() > size);
            sets.extend(larger);
        }
        return Some(VariableSets { sets: search.monomials(sets), is_optimal: true });
    }
    let set = search.locally_improved(greedy?, budget / NODES_A_CHANGE);
    Some(VariableSets { sets: search.monomials(vec![set]), is_optimal: false })
}

/// Finds a set that makes the equations quadratic, not always a smallest one. Each variable is a
/// product of two others, or the inverse of a polynomial.
pub(crate) fn founded(ring: &Ring, problem: &CoverProblem) -> Option<Vec<Laurent>> {
    let mut search = Search { founded: true, ..Search::new(ring, problem, 0) };
    let mut seeds: Vec<MonomialId> = Vec::new();
    for coordinate in &ring.coordinates {
        let CoordinateDefinition::Root(base, 1) = &coordinate.meaning else { continue };
        for (term, _) in base.terms() {
            // Powers are built from smaller ones: x⁴ is the square of x², and x³ is the product of
            // x² and x.
            let mut power = term.clone();
            while power.size() > 1 {
                let id = search.table.id(&power);
                if !seeds.contains(&id) && search.is_allowed(id) {
                    seeds.push(id);
                }
                let first = power.powers().next().map_or(0, |(first, _)| first);
                power = power.square_root().unwrap_or_else(|| power.over(&Monomial::power(first, 1)));
            }
        }
    }
    let closed = search.closure(seeds, MOST_VARIABLES, 0)?;
    let set = search.without_unnecessary(closed);
    search.are_founded(&set).then(|| search.monomials(vec![set]).pop())?
}

impl<'a> Search<'a> {
    fn new(ring: &'a Ring, problem: &'a CoverProblem, budget: usize) -> Self {
        let sizes = problem.required.iter().map(Monomial::size);
        let mut table = MonomialTable::new(ring);
        Search {
            ring,
            problem,
            given: problem.given.iter().map(|one| table.id(one)).collect(),
            required: problem.required.iter().map(|one| table.id(one)).collect(),
            nodes: budget,
            largest: 2 * sizes.max().unwrap_or(0) + 4,
            founded: false,
            visited: FxHashMap::default(),
            sets: Vec::new(),
            table,
        }
    }

    fn is_founded(&mut self, id: MonomialId, new: &[MonomialId]) -> bool {
        if !self.founded || self.table.monomial(id).size() == 1 {
            return true;
        }
        let monomial = self.table.monomial(id).clone();
        self.is_product(&monomial, new)
    }

    fn is_product(&mut self, monomial: &Monomial, new: &[MonomialId]) -> bool {
        let own = self.table.id(monomial);
        let variables: Vec<MonomialId> =
            self.given.iter().chain(new).copied().filter(|&one| one != own).collect();
        variables.iter().any(|&variable| {
            let other = monomial.over(self.table.monomial(variable));
            variables.contains(&self.table.id(&other))
        })
    }

    fn are_founded(&mut self, set: &[MonomialId]) -> bool {
        set.iter().all(|&id| {
            let monomial = self.table.monomial(id).clone();
            let (coordinate, _) = monomial.powers().next().expect("no variable is 1");
            match &self.ring.coordinates[coordinate].meaning {
                CoordinateDefinition::Root(base, _) if monomial.size() == 1 => {
                    base.terms().all(|(term, _)| {
                        let product = term.times(&monomial);
                        product == monomial || self.is_product(&product, set)
                    })
                }
                _ => monomial.size() == 1 || self.is_product(&monomial, set),
            }
        })
    }

    fn monomials(&self, sets: Vec<Vec<MonomialId>>) -> Vec<Vec<Laurent>> {
        let set = |ids: Vec<MonomialId>| {
            let mut set: Vec<Monomial> = ids.iter().map(|&id| self.table.monomial(id).clone()).collect();
            set.sort_unstable_by_key(|one| (one.size(), Reverse(one.clone())));
            set.into_iter().map(Laurent::from).collect()
        };
        sets.into_iter().map(set).collect()
    }

    fn collect(&mut self, size: usize) {
        self.visited.clear();
        let cover = self.cover(&[]);
        self.extend(&mut Vec::new(), &cover, size);
    }

    /// Returns the monomials that products of at most two variables cover.
    fn cover(&mut self, new: &[MonomialId]) -> MonomialCover {
        let mut cover = MonomialCover::default();
        cover.covered.insert(MonomialTable::ONE);
        for (i, sum) in self.problem.sums.iter().enumerate() {
            cover.composite.push(self.table.support(sum));
            for other in &self.problem.sums[i..] {
                cover.composite.push(self.table.support(&self.ring.product(sum, other)));
            }
        }
        let given = self.given.clone();
        let mut variables: Vec<MonomialId> = Vec::new();
        for &variable in given.iter().chain(new) {
            self.join(&mut cover, &variables, variable);
            variables.push(variable);
        }
        cover.close();
        cover
    }

    fn join(&mut self, cover: &mut MonomialCover, others: &[MonomialId], variable: MonomialId) {
        cover.covered.insert(variable);
        for &other in others.iter().chain([&variable]) {
            let product = self.table.product(other, variable);
            match self.table.rewritten(product) {
                None => {
                    cover.covered.insert(product);
                }
                Some(support) => cover.composite.push(Rc::clone(support)),
            }
        }
        for sum in &self.problem.sums {
            let shifted = self.ring.normalised(&sum.shifted(self.table.monomial(variable)));
            cover.composite.push(self.table.support(&shifted));
        }
    }

    fn joined(&mut self, cover: &MonomialCover, new: &[MonomialId], variable: MonomialId) -> MonomialCover {
        let mut joined = cover.clone();
        let others: Vec<MonomialId> = self.given.iter().chain(new).copied().collect();
        self.join(&mut joined, &others, variable);
        joined.close();
        joined
    }

    /// Returns the required monomials that are not covered, in ascending order.
    fn missing(&mut self, cover: &MonomialCover, new: &[MonomialId]) -> Vec<MonomialId> {
        let mut missing = self.required.clone();
        new.iter().for_each(|&variable| missing.extend(self.table.derivative(variable).iter()));
        missing.retain(|one| !cover.covered.contains(one));
        missing.sort_unstable();
        missing.dedup();
        missing
    }

    fn is_allowed(&self, id: MonomialId) -> bool {
        let monomial = self.table.monomial(id);
        let negative = &self.problem.negative;
        id != MonomialTable::ONE
            && !self.given.contains(&id)
            && self.table.rewritten(id).is_none()
            && monomial.size() <= self.largest
            && monomial.powers().all(|(coordinate, exponent)| exponent > 0 || negative.contains(&coordinate))
    }

    /// Returns monomials m that turn `target` into a product: it is m, m², or m times a variable.
    fn single_factors(&mut self, target: MonomialId, new: &[MonomialId]) -> Vec<MonomialId> {
        let monomial = self.table.monomial(target).clone();
        let variables: Vec<MonomialId> = self.given.iter().chain(new).copied().collect();
        let quotients = variables.iter().map(|&variable| monomial.over(self.table.monomial(variable)));
        let mut candidates: Vec<Monomial> =
            std::iter::once(monomial.clone()).chain(monomial.square_root()).chain(quotients).collect();
        candidates.sort_unstable_by(|a, b| a.size().cmp(&b.size()).then_with(|| a.cmp(b)));
        candidates.dedup();
        let ids: Vec<MonomialId> = candidates.iter().map(|one| self.table.id(one)).collect();
        ids.into_iter().filter(|&id| self.is_allowed(id)).collect()
    }

    /// Returns pairs of new monomials with product `target`. No exponent exceeds that of `target`.
    fn pairs(&mut self, target: MonomialId) -> Vec<[MonomialId; 2]> {
        let target = self.table.monomial(target).clone();
        let mut halves = vec![Monomial::one()];
        for (coordinate, exponent) in target.powers() {
            let range = exponent.min(0)..=exponent.max(0);
            let power = |power| Monomial::power(coordinate, 1).pow(power);
            halves =
                halves.iter().flat_map(|half| range.clone().map(|own| half.times(&power(own)))).collect();
        }
        let mut pairs = Vec::new();
        for left in halves {
            let right = target.over(&left);
            if left < right {
                let pair = [self.table.id(&left), self.table.id(&right)];
                if pair.iter().all(|&one| self.is_allowed(one)) {
                    pairs.push(pair);
                }
            }
        }
        pairs
    }

    fn extend(&mut self, new: &mut Vec<MonomialId>, cover: &MonomialCover, more: usize) {
        if self.nodes == 0 || self.sets.len() >= MOST_SETS {
            return;
        }
        self.nodes -= 1;
        let mut key = new.clone();
        key.sort_unstable();
        if self.visited.get(&key).is_some_and(|&before| before >= more) {
            return;
        }
        self.visited.insert(key.clone(), more);
        let missing = self.missing(cover, new);
        if missing.is_empty() {
            if !self.sets.contains(&key) {
                self.sets.push(key);
            }
            return;
        }
        if more == 0 {
            return;
        }
        let mut options: Option<(Vec<MonomialId>, MonomialId)> = None;
        for &target in missing.iter().take(40) {
            let singles = self.single_factors(target, new);
            if options.as_ref().is_none_or(|(best, _)| singles.len() < best.len()) {
                options = Some((singles, target));
            }
        }
        let (singles, target) = options.expect("something is missing");
        for single in singles {
            let joined = self.joined(cover, new, single);
            if more > 1 || missing.iter().all(|one| joined.covered.contains(one)) {
                new.push(single);
                self.extend(new, &joined, more - 1);
                new.pop();
            }
        }
        if more >= 2 {
            for [left, right] in self.pairs(target) {
                if new.contains(&left) || new.contains(&right) {
                    continue;
                }
                let joined = self.joined(cover, new, left);
                new.push(left);
                let joined = self.joined(&joined, new, right);
                new.push(right);
                self.extend(new, &joined, more - 2);
                new.truncate(new.len() - 2);
            }
        }
    }

    /// Returns a set that makes the equations quadratic. Variables that leave the fewest missing
    /// monomials are added first. Unnecessary variables are removed at the end.
    fn greedy_set(&mut self, most: usize) -> Option<Vec<MonomialId>> {
        let closed = self.closure(Vec::new(), most, 0)?;
        Some(self.without_unnecessary(closed))
    }

    /// Drops a variable and lets `closure` complete the others, as long as the set gets smaller.
    fn without_unnecessary(&mut self, mut best: Vec<MonomialId>) -> Vec<MonomialId> {
        let mut at = 0;
        while at < best.len() {
            let mut fewer = best.clone();
            fewer.remove(at);
            let smaller = self.closure(fewer, best.len() - 1, 0);
            match smaller.filter(|smaller| !self.founded || self.are_founded(smaller)) {
                Some(smaller) => (best, at) = (smaller, 0),
                None => at += 1,
            }
        }
        best
    }

    /// Adds variables to `new` until they make the equations quadratic; `None` if this takes more
    /// than `most` variables. Different values of `twist` lead to different choices.
    fn closure(&mut self, mut new: Vec<MonomialId>, most: usize, twist: u64) -> Option<Vec<MonomialId>> {
        let mut cover = self.cover(&new);
        loop {
            let missing = self.missing(&cover, &new);
            let turn =
                |id: MonomialId| u64::from(id).wrapping_mul(twist | 1).rotate_left(17).wrapping_mul(twist);
            let size = |id: MonomialId| self.table.monomial(id).size();
            let Some(&target) = missing.iter().min_by_key(|&&id| (size(id), turn(id), id)) else {
                return Some(new);
            };
            if new.len() >= most {
                return None;
            }
            let mut ranked: Vec<(usize, u64, MonomialId, MonomialCover)> = Vec::new();
            for single in self.single_factors(target, &new) {
                if !self.is_founded(single, &new) {
                    continue;
                }
                let joined = self.joined(&cover, &new, single);
                let left = missing.iter().filter(|one| !joined.covered.contains(one)).count();
                let added = self.table.derivative(single);
                let added = added.iter().filter(|one| !joined.covered.contains(one)).count();
                ranked.push((left + added, turn(single), single, joined));
            }
            ranked.sort_by_key(|&(left, turn, single, _)| (left, turn, single));
            let second = twist != 0 && ranked.len() > 1 && turn(target) % 4 == 0;
            let Some((_, _, next, joined)) = ranked.into_iter().nth(usize::from(second)) else {
                let pairs = self.pairs(target).into_iter().flatten();
                let next = pairs.filter(|one| !new.contains(one)).collect::<Vec<MonomialId>>();
                let next = next.into_iter().find(|&one| self.is_founded(one, &new))?;
                cover = self.joined(&cover, &new, next);
                new.push(next);
                continue;
            };
            (cover, new) = (joined, [new, vec![next]].concat());
        }
    }

    /// Improves a closed set by removing up to four random variables and closing the set again.
    fn locally_improved(&mut self, mut best: Vec<MonomialId>, most: usize) -> Vec<MonomialId> {
        let mut random = Shake256::new(b"local changes");
        let mut since = 0;
        let mut current = best.clone();
        while since < most.min(LOCAL_CHANGES * best.len()) {
            since += 1;
            let seed = random.next_seed();
            let twist = u64::from_le_bytes(seed[..8].try_into().expect("eight bytes"));
            let mut fewer = current.clone();
            for &byte in &seed[8..9 + usize::from(seed[31] % 4)] {
                if !fewer.is_empty() {
                    fewer.remove(usize::from(byte) % fewer.len());
                }
            }
            if let Some(next) = self.closure(fewer, current.len(), twist) {
                if next.len() < best.len() {
                    since = 0;
                    best = next.clone();
                }
                current = next;
            }
        }
        best
    }
}
