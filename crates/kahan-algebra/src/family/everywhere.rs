//! Reduces sums over all sites of a chain to finitely many terms.
//!
//! The sums are written for a long chain. In an open chain, the *extent* of a term is the smallest
//! interval that contains its sites. A sum over the sites vanishes in all open chains if and only
//! if the terms of each extent cancel separately.
//!
//! Proof of "only if": let S(a, b) be the sum for a chain that consists of the sites a to b. In
//! S(a, b) − S(a+1, b) − S(a, b−1) + S(a+1, b−1), exactly the terms with extent [a, b] remain.

use kahan_syntax::syntax::Boundary;

use crate::poly::{Budget, Monomial, Polynomial, Variable, WithinBudget};
use crate::rational_function::RationalFunction;
use crate::symbols::Symbol;

use super::Family;
use super::expand::Chain;

const MOST_TERMS: usize = 100_000;
/// Each stage of the proof of a claim takes at most this much work, in multiplications of terms.
pub const MOST_WORK: u64 = 300_000;

pub(super) fn budget() -> Budget {
    Budget::new(MOST_TERMS, MOST_WORK)
}

/// The smallest range of sites that a chain must contain so that a term occurs in it. In a ring
/// every term occurs, and the range is the middle site.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct SiteRange {
    pub first: usize,
    pub last: usize,
}

impl SiteRange {
    pub(super) fn sites(self) -> usize {
        self.last - self.first + 1
    }

    pub(super) fn with(self, other: Self) -> Self {
        SiteRange { first: self.first.min(other.first), last: self.last.max(other.last) }
    }
}

pub(super) struct MiddleSite<'a> {
    pub chain: Chain<'a>,
    pub site: usize,
}

impl<'a> MiddleSite<'a> {
    /// Chooses a chain that is long enough for all equations and sums.
    pub(super) fn of(family: &'a Family) -> Self {
        let sites = 8 * family.reach + 2;
        MiddleSite { chain: family.chain(sites), site: sites / 2 }
    }

    pub(super) fn at(&self, component: &RationalFunction, offset: i64) -> RationalFunction {
        let site = (self.site as i64 + offset) as usize;
        self.chain.moved(component, site).expect("no two sites are one in a long chain")
    }

    pub(super) fn state(&self, state: Variable) -> (i64, usize) {
        let (place, block) = (usize::from(state.0), self.chain.family.block());
        ((place / block) as i64 - self.site as i64, place % block)
    }

    fn site_of(&self, variable: Variable) -> Option<usize> {
        match self.chain.symbols.symbol(variable) {
            Symbol::State(k) => Some(k / self.chain.family.block()),
            Symbol::Parameter(k) => {
                k.checked_sub(self.chain.family.parameters.len()).map(|k| k % self.chain.sites)
            }
            Symbol::Epsilon | Symbol::SecondState(_) => None,
        }
    }

    pub(super) fn is_at_sites(&self, variable: Variable) -> bool {
        self.site_of(variable).is_some()
    }

    pub(super) fn extent_of_site(&self, offset: i64) -> SiteRange {
        let offset = if self.chain.family.boundary == Boundary::Open { offset } else { 0 };
        let site = (self.site as i64 + offset) as usize;
        SiteRange { first: site, last: site }
    }

    /// Returns the smallest range that contains the range `place` and the sites of a monomial. For
    /// a ring, returns `place`.
    pub(super) fn extent(&self, monomial: &Monomial, place: SiteRange) -> SiteRange {
        if self.chain.family.boundary == Boundary::Periodic {
            return place;
        }
        let sites = monomial.powers().iter().filter_map(|(variable, _)| self.site_of(*variable));
        sites.fold(place, |extent, site| extent.with(SiteRange { first: site, last: site }))
    }

    /// Moves a range by a number of sites. Ranges in a ring do not move.
    pub(super) fn moved(&self, extent: SiteRange, by: i64) -> SiteRange {
        let by = if self.chain.family.boundary == Boundary::Open { by } else { 0 };
        let [first, last] = [extent.first, extent.last].map(|site| (site as i64 + by) as usize);
        SiteRange { first, last }
    }

    /// Returns the first site whose values occur in these monomials, or the middle site if there is
    /// none.
    pub(super) fn first_site<'b>(&self, monomials: impl Iterator<Item = &'b Monomial>) -> usize {
        let variables = monomials.flat_map(Monomial::powers);
        variables.filter_map(|(variable, _)| self.site_of(*variable)).min().unwrap_or(self.site)
    }

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

    pub(super) fn shifted_polynomial(&self, polynomial: &Polynomial, by: i64) -> Polynomial {
        polynomial.map_monomials(|monomial| Some(self.shifted(monomial, by)))
    }
}

/// Multiplies two polynomials within the budget.
pub(super) fn product(a: &Polynomial, b: &Polynomial, budget: &mut Budget) -> WithinBudget<Polynomial> {
    if a.is_one() {
        budget.charge(b.len() as u64)?;
        return Ok(b.clone());
    }
    a.mul_within(b, budget)
}
