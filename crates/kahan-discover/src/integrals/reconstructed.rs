//! Reconstructs independent integrals over ℚ(parameters, ε), and proves them.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::symbols::Symbols;

use crate::claims::proved::{Claims, Formula};
use crate::deadline::Deadline;
use crate::integrals::accepted::AcceptedIntegrals;
use crate::integrals::independence::IndependentGradients;
use crate::integrals::limit::with_a_limit;
use crate::integrals::members::members;
use crate::integrals::pencil::Pencil;
use crate::integrals::search::{FormulaLimits, pencils_of_entries, spanned_pencils};
use crate::maps::affine_subspace::{AffineSubspace, Coordinate};
use crate::maps::chart::Chart;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::{Sample, SearchField};
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::reconstruct_space;
use crate::orbits::hilbert::Hilbert;

/// The degree up to which integrals are searched if the number of coefficients allows it.
const HIGHEST_DEGREE: u32 = 8;

/// The most monomials for which all orders of the variables are tried.
const MAX_MONOMIALS_FOR_ALL_ORDERS: usize = 100;

/// The inputs and limits of a search.
pub struct SearchGoals<'a> {
    /// Independent integrals that are already proved.
    pub proved: &'a [Formula],
    /// Polynomial integrals of the flow that the map preserves.
    pub kept: &'a [Polynomial],
    /// Further integrals P/Q, with a deadline. Each integral is tried after the search of its
    /// degree. The rest are tried at the end, unless the deadline has passed.
    pub further: (&'a [(Polynomial, Polynomial)], &'a Deadline<'a>),
    /// The number and degrees of integrals, as seen on orbits. `None` means no search.
    pub hilbert: Option<&'a Hilbert>,
    /// Integrals P/Q known already, accepted unless the search finds others of lower degree.
    pub known: &'a [(Polynomial, Polynomial)],
    /// The limits on the size of formulas.
    pub reach: FormulaLimits,
    /// A function that is called with each integral as soon as it is proved.
    pub tell: &'a dyn Fn(&Formula),
}

/// Finds and proves independent integrals over ℚ(parameters, ε), of least degree first. The search
/// ends at the deadline, or when it has found the number of integrals in `aims.hilbert`.
pub fn integrals(
    searched: &SearchField,
    claims: &Claims<'_>,
    aims: &SearchGoals<'_>,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Vec<Formula> {
    let mut collector = AcceptedIntegrals {
        searched,
        claims,
        wanted: usize::MAX,
        known: aims.known,
        further: aims.further.0,
        step: searched.step(random),
        independent: IndependentGradients::of(searched, aims.proved, random),
        tell: aims.tell,
        formulas: aims.proved.to_vec(),
    };
    for kept in aims.kept {
        collector.offer_one(kept.clone(), Polynomial::one());
    }
    collector.wanted = aims.hilbert.map_or(0, |hilbert| hilbert.integrals);
    if let Some(hilbert) = aims.hilbert.filter(|_| !collector.is_done()) {
        collector.search(hilbert, aims.reach, random, deadline);
    }
    let (further, end) = aims.further;
    if !further.is_empty() && !end.passed() {
        // `further` may hold more integrals than the orbits showed, so all of them may be accepted.
        collector.wanted = usize::MAX;
        collector.offer_further(u32::MAX);
    }
    collector.formulas
}

impl AcceptedIntegrals<'_> {
    /// Searches on the level sets of linear relations, then in the whole space.
    fn search(
        &mut self,
        hilbert: &Hilbert,
        reach: FormulaLimits,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<()> {
        let searched = self.searched;
        let sample = searched.sample(Modulus::mersenne_61(), random)?;
        let relation_degree = hilbert.defining_degree(&sample.map, random, deadline)?;
        let limits = SearchLimits { relation_degree, highest: hilbert.degree(), reach, deadline };
        let leaf = AffineSubspace::of(&sample.map, random);
        if let Some(coordinates) = leaf.coordinates(searched, random, deadline) {
            for Coordinate { numerator, denominator } in &coordinates {
                self.offer(numerator.clone(), denominator.clone());
            }
            self.search_leaf(&Chart { leaf, coordinates }, &sample, &limits, random);
        }
        if !self.is_done() {
            let leaf = AffineSubspace::whole((0..searched.dimension()).collect());
            self.search_leaf(&Chart { leaf, coordinates: Vec::new() }, &sample, &limits, random);
        }
        Some(())
    }

    fn search_leaf(
        &mut self,
        chart: &Chart,
        sample: &Sample,
        limits: &SearchLimits<'_>,
        random: &mut SplitMix64,
    ) {
        let modulus = sample.map.modulus();
        let chosen: Vec<u64> = (0..chart.leaf.unknowns()).map(|_| modulus.sample(random)).collect();
        let Some(map) = chart.leaf.map_at(sample.map.clone(), &chosen, random) else { return };
        if self.is_done() || map.dimension() == 0 {
            return;
        }
        let spanned = spanned_pencils(&map, limits.relation_degree, self.wanted, random, limits.deadline);
        self.take(&spanned, chart, limits, random);
        for degree in 1..=limits.highest.max(HIGHEST_DEGREE) {
            self.offer_known(degree);
            // All orders of the variables are tried if this is cheap, because the order determines
            // which coefficients of the relations are simple.
            let is_cheap = Monomials::count(map.dimension(), degree) <= MAX_MONOMIALS_FOR_ALL_ORDERS;
            let orders = if is_cheap { usize::MAX } else { limits.reach.orders };
            for leaf in chart.leaf.orders().take(orders) {
                let chart = Chart { leaf, coordinates: chart.coordinates.clone() };
                if self.is_done() || limits.deadline.passed() {
                    return;
                }
                let Some(map) = chart.leaf.map_at(sample.map.clone(), &chosen, random) else { return };
                let known = |point: &[u64]| self.known_gradients(&chart.leaf, sample, point);
                let SearchLimits { relation_degree, reach, deadline, .. } = *limits;
                let found = pencils_of_entries(&map, relation_degree, degree, reach, known, random, deadline);
                for basis in self.take(&found, &chart, limits, random) {
                    if !self.is_done() {
                        self.search_constrained(&basis, degree, &chart, sample, limits, random);
                    }
                }
            }
        }
    }

    fn take(
        &mut self,
        pencils: &[Pencil],
        chart: &Chart,
        limits: &SearchLimits<'_>,
        random: &mut SplitMix64,
    ) -> Vec<Vec<Polynomial>> {
        let mut bases = Vec::new();
        for pencil in pencils {
            let shortest = (0..pencil.space.dimension()).map(|index| pencil.space.terms(index)).min();
            if shortest.is_some_and(|terms| terms > limits.reach.terms) {
                continue;
            }
            self.offer_known(pencil.degree);
            if self.is_done() {
                break;
            }
            let own = self.searched.unknowns();
            let searched = self.searched;
            let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
                let (generic, entries) = unknowns.split_at(own);
                let map = chart.leaf.map_at(searched.at(modulus, generic)?, entries, random)?;
                pencil.at(&map, random, limits.deadline)
            };
            let monomials = Monomials::new(chart.leaf.order().len(), pencil.degree);
            let names = chart.names(searched);
            let form = &pencil.space.form;
            let basis = reconstruct_space(&names, &monomials, form, at, random, limits.deadline);
            let Some(basis) = basis.or_else(|| self.special_basis(pencil, chart, limits)) else { continue };
            self.offer_quotients(&basis, chart);
            bases.push(basis);
        }
        bases
    }

    /// Returns elements P + cQ of a pencil that factor, have lower degree or do not contain ε, if
    /// at least two are found.
    fn special_basis(
        &self,
        pencil: &Pencil,
        chart: &Chart,
        limits: &SearchLimits<'_>,
    ) -> Option<Vec<Polynomial>> {
        let n = self.searched.dimension();
        if pencil.space.dimension() != 2 || chart.leaf.order().len() < n || limits.deadline.passed() {
            return None;
        }
        let monomials = Monomials::new(n, pencil.degree);
        let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
            let map = chart.leaf.map_at(self.searched.at(modulus, unknowns)?, &[], random)?;
            let space = pencil.at(&map, random, limits.deadline)?;
            Some([0, 1].map(|index| {
                reordered(&space.element(index, monomials.len()), chart.leaf.order(), &monomials)
            }))
        };
        let members = members(self.searched, &monomials, at);
        (members.len() > 1).then_some(members)
    }

    /// Divides the elements of `basis` by one of them, and accepts the quotients as integrals. The
    /// divisor is the simplest element for which some quotient is accepted.
    pub(crate) fn offer_quotients(&mut self, basis: &[Polynomial], chart: &Chart) {
        let symbols = self.searched.family().symbols();
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
}

/// Reorders coefficients: their variables change from `order` to the order of the states.
fn reordered(coefficients: &[u64], order: &[usize], monomials: &Monomials) -> Vec<u64> {
    let own = |index: usize| {
        let exponents = monomials.exponents(index);
        let on_leaf: Vec<u32> = order.iter().map(|&state| exponents[state]).collect();
        (0..monomials.len()).find(|&other| monomials.exponents(other) == on_leaf)
    };
    (0..monomials.len()).map(|index| own(index).map_or(0, |place| coefficients[place])).collect()
}

pub(crate) struct SearchLimits<'a> {
    pub(crate) relation_degree: u32,
    highest: u32,
    reach: FormulaLimits,
    pub(crate) deadline: &'a Deadline<'a>,
}

fn has_constant(symbols: &Symbols, polynomial: &Polynomial) -> bool {
    polynomial.terms().any(|(monomial, _)| monomial.degree_where(|variable| symbols.is_state(variable)) == 0)
}
