//! Sums over all sites, of which each term says in which chains it occurs.
//!
//! A statement about every number of sites is one about finitely many terms. Each term is seen from
//! one site, in the middle of a chain so long that nothing in it meets itself, and has an
//! extent: the sites between which a chain must reach to hold it. In a chain that ends at two
//! given sites stand the terms whose extents lie between them. So a sum vanishes in all chains where
//! the terms of each extent cancel by themselves: take from a chain those that are one site shorter
//! at either end, and add the one that is shorter at both; what is left are the terms that need both
//! ends.

use kahan_syntax::syntax::Boundary;

use crate::poly::{Budget, Monomial, Polynomial, Variable, Within};
use crate::rational_function::RationalFunction;
use crate::symbols::Symbol;

use super::Family;
use super::expand::Chain;

/// The most terms of a polynomial that is multiplied with others.
const MOST_TERMS: usize = 100_000;
/// The most products of terms that the proof of one claim of a family takes.
pub const MOST_WORK: u64 = 300_000;

/// Returns a fresh budget for one proof about one claim.
pub(super) fn budget() -> Budget {
    Budget::new(MOST_TERMS, MOST_WORK)
}

/// The first and the last site that a term needs. In a ring there are no ends: all are the middle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Extent {
    pub first: usize,
    pub last: usize,
}

impl Extent {
    /// How many sites the shortest chain has that holds it.
    pub(super) fn sites(self) -> usize {
        self.last - self.first + 1
    }

    pub(super) fn with(self, other: Self) -> Self {
        Extent { first: self.first.min(other.first), last: self.last.max(other.last) }
    }
}

/// One site of a long chain, and what is around it.
pub(super) struct Middle<'a> {
    pub chain: Chain<'a>,
    /// The site.
    pub site: usize,
}

impl<'a> Middle<'a> {
    /// Equations and sums reach `reach` sites far each, and what they name as far again.
    pub(super) fn of(family: &'a Family) -> Self {
        let sites = 8 * family.reach + 2;
        Middle { chain: family.chain(sites), site: sites / 2 }
    }

    /// A quotient written for site i, at the site that is `offset` from the middle.
    pub(super) fn at(&self, component: &RationalFunction, offset: i64) -> RationalFunction {
        let site = (self.site as i64 + offset) as usize;
        self.chain.moved(component, site).expect("no two sites are one in a long chain")
    }

    /// How far the site of a state is from the middle, and its array.
    pub(super) fn state(&self, state: Variable) -> (i64, usize) {
        let (place, block) = (usize::from(state.0), self.chain.family.block());
        ((place / block) as i64 - self.site as i64, place % block)
    }

    /// The site of a variable; none of a parameter of the chain.
    fn site_of(&self, variable: Variable) -> Option<usize> {
        match self.chain.symbols.symbol(variable) {
            Symbol::State(k) => Some(k / self.chain.family.block()),
            Symbol::Parameter(k) => {
                k.checked_sub(self.chain.family.parameters.len()).map(|k| k % self.chain.sites)
            }
            Symbol::Epsilon | Symbol::SecondState(_) => None,
        }
    }

    /// Whether a variable has a value at each site.
    pub(super) fn is_at_sites(&self, variable: Variable) -> bool {
        self.site_of(variable).is_some()
    }

    /// The extent of a site.
    pub(super) fn extent_of_site(&self, offset: i64) -> Extent {
        let offset = if self.chain.family.boundary == Boundary::Open { offset } else { 0 };
        let site = (self.site as i64 + offset) as usize;
        Extent { first: site, last: site }
    }

    /// The extent of a term that stands at a place of this extent.
    pub(super) fn extent(&self, monomial: &Monomial, place: Extent) -> Extent {
        if self.chain.family.boundary == Boundary::Periodic {
            return place;
        }
        let sites = monomial.powers().iter().filter_map(|(variable, _)| self.site_of(*variable));
        sites.fold(place, |extent, site| extent.with(Extent { first: site, last: site }))
    }

    /// Moves an extent by a number of sites; in a ring it stays.
    pub(super) fn moved(&self, extent: Extent, by: i64) -> Extent {
        let by = if self.chain.family.boundary == Boundary::Open { by } else { 0 };
        let [first, last] = [extent.first, extent.last].map(|site| (site as i64 + by) as usize);
        Extent { first, last }
    }

    /// The first site that occurs in these monomials; the middle if none does.
    pub(super) fn first_site<'b>(&self, monomials: impl Iterator<Item = &'b Monomial>) -> usize {
        let variables = monomials.flat_map(Monomial::powers);
        variables.filter_map(|(variable, _)| self.site_of(*variable)).min().unwrap_or(self.site)
    }

    /// Moves every site of a monomial by `by` sites.
    pub(super) fn shifted(&self, monomial: &Monomial, by: i64) -> Monomial {
        let shift = |variable: Variable| {
            let step = match self.chain.symbols.symbol(variable) {
                Symbol::State(_) => self.chain.family.block() as i64,
                Symbol::Parameter(k) if k >= self.chain.family.parameters.len() => 1,
                _ => 0,
            };
            Variable((i64::from(variable.0) + step * by) as u16)
        };
        monomial.powers().iter().map(|&(variable, exponent)| (shift(variable), exponent)).collect()
    }

    /// Moves every site of a polynomial by `by` sites.
    pub(super) fn shifted_polynomial(&self, polynomial: &Polynomial, by: i64) -> Polynomial {
        polynomial.map_monomials(|monomial| Some(self.shifted(monomial, by)))
    }
}

/// Everything that is multiplied out, charged to a budget.
pub(super) fn product(a: &Polynomial, b: &Polynomial, budget: &mut Budget) -> Within<Polynomial> {
    if a.is_one() {
        budget.charge(b.len() as u64)?;
        return Ok(b.clone());
    }
    a.mul_within(b, budget)
}
