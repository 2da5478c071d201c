//! Simplifies and proves integrals, and accepts those that are independent.

use std::slice::from_ref;

use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;

use crate::claims::proved::{Claims, Formula};
use crate::claims::writing::{factors_of, quotient};
use crate::integrals::independence::{IndependentGradients, quotient_gradient};
use crate::integrals::limit::with_a_limit;
use crate::integrals::members::special_members;
use crate::integrals::reduction::reduced;
use crate::maps::affine_subspace::AffineSubspace;
use crate::maps::search_field::{Sample, SampledStep, SearchField};
use crate::modular::monomials::Monomials;
use crate::modular::subspace::primitive_in_states;

/// All known integrals are accepted before a search with more unknowns than this number.
const MOST_AHEAD: usize = 150;

/// An integral P/Q is not simplified if P and Q have at most this many characters together.
const SHORT_INTEGRAL: usize = 60;

pub(crate) struct AcceptedIntegrals<'a> {
    pub(crate) searched: &'a SearchField,
    pub(crate) claims: &'a Claims<'a>,
    pub(crate) wanted: usize,
    pub(crate) known: &'a [(Polynomial, Polynomial)],
    pub(crate) further: &'a [(Polynomial, Polynomial)],
    pub(crate) step: Option<SampledStep>,
    pub(crate) independent: IndependentGradients<'a>,
    pub(crate) tell: &'a dyn Fn(&Formula),
    pub(crate) formulas: Vec<Formula>,
}

impl AcceptedIntegrals<'_> {
    pub(crate) fn is_done(&self) -> bool {
        self.formulas.len() >= self.wanted
    }

    /// Accepts P/Q if it is proved, and independent of the accepted integrals. If P and Q are both
    /// integrals, accepts P and Q instead.
    pub(crate) fn offer(&mut self, numerator: Polynomial, denominator: Polynomial) {
        if denominator.as_constant().is_none()
            && self.step.as_ref().is_some_and(|step| step.keeps(self.searched, &denominator))
        {
            self.offer_one(denominator, Polynomial::one());
            self.offer_one(numerator, Polynomial::one());
        } else {
            self.offer_one(numerator, denominator);
        }
    }

    /// Accepts `known` integrals up to this degree, or all if searching this degree is expensive.
    pub(crate) fn offer_known(&mut self, degree: u32) {
        self.offer_further(degree);
        let symbols = self.searched.family().symbols();
        let is_expensive = 2 * Monomials::count(self.searched.dimension(), degree) > MOST_AHEAD;
        for (above, below) in self.known {
            if is_expensive || symbols.degree(above).max(symbols.degree(below)) <= degree {
                self.offer(above.clone(), below.clone());
            }
        }
    }

    pub(crate) fn offer_further(&mut self, degree: u32) {
        let symbols = self.searched.family().symbols();
        for (above, below) in self.further {
            if symbols.degree(above).max(symbols.degree(below)) < degree {
                self.offer(above.clone(), below.clone());
            }
        }
    }

    pub(crate) fn offer_one(&mut self, numerator: Polynomial, denominator: Polynomial) {
        let symbols = self.searched.family().symbols();
        if self.is_done() || !self.independent.admits(&numerator, &denominator) {
            return;
        }
        let (numerator, denominator) =
            (primitive_in_states(symbols, &numerator), primitive_in_states(symbols, &denominator));
        let (numerator, denominator) = self.simplified(numerator, denominator);
        let numerator = with_a_limit(symbols, numerator, &denominator);
        let index = self.formulas.len() + 1;
        let by = factors_of(&self.formulas);
        let proved = |(above, below): &(Polynomial, Polynomial)| {
            self.claims.integral(symbols, index, above, below, &by)
        };
        let own = (numerator, denominator);
        if let Some(formula) = proved(&self.shortest(&own, &by)).or_else(|| proved(&own)) {
            self.independent.keep(&formula.numerator, &formula.denominator);
            (self.tell)(&formula);
            self.formulas.push(formula);
        }
    }

    /// Returns P/Q if its text is short. Otherwise returns the shortest quotient of two of the
    /// elements P, Q and P + cQ with special c. It must depend on the states at ε = 0.
    fn shortest(
        &self,
        (numerator, denominator): &(Polynomial, Polynomial),
        by: &[Polynomial],
    ) -> (Polynomial, Polynomial) {
        let symbols = self.searched.family().symbols();
        let own = (numerator.clone(), denominator.clone());
        let len = |member: &Polynomial| quotient(symbols, from_ref(member), &[], by).len();
        let lens = [numerator, denominator].map(len);
        let special = match lens.iter().sum::<usize>() {
            0..=SHORT_INTEGRAL => Vec::new(),
            _ => special_members(self.searched, numerator, denominator),
        };
        if special.is_empty() {
            return own;
        }
        // A flat polynomial has no state at ε = 0. A quotient by it becomes a polynomial there.
        let is_flat = |member: &Polynomial| {
            !symbols.has_state(&member.substitute(symbols.epsilon(), &Rational::zero()))
        };
        let members = lens.into_iter().zip([numerator, denominator]);
        let members: Vec<(usize, &Polynomial)> =
            members.chain(special.iter().map(|member| (len(member), member))).collect();
        let has_flat = members.iter().any(|(_, member)| is_flat(member));
        let pairs = members.iter().flat_map(|above| members.iter().map(move |below| (above, below)));
        let is_fit = |((_, above), (_, below)): &(&(usize, &Polynomial), &(usize, &Polynomial))| {
            above != below
                && (is_flat(below) || !has_flat)
                && with_a_limit(symbols, (*above).clone(), below) == **above
        };
        // `min_by_key` returns the first of equal pairs, so P/Q wins a tie.
        let best = pairs.filter(is_fit).min_by_key(|((above, _), (below, _))| above + below);
        best.map_or(own, |((_, above), (_, below))| ((*above).clone(), (*below).clone()))
    }

    fn simplified(&self, numerator: Polynomial, denominator: Polynomial) -> (Polynomial, Polynomial) {
        let Some(step) = &self.step else { return (numerator, denominator) };
        let (above, below) =
            reduced(self.searched, step, &factors_of(&self.formulas), numerator.clone(), denominator.clone());
        if self.independent.admits(&above, &below) { (above, below) } else { (numerator, denominator) }
    }

    /// Returns the gradients of the accepted integrals at a point. The list is empty if `leaf` is
    /// not the whole space.
    pub(crate) fn known_gradients(
        &self,
        leaf: &AffineSubspace,
        sample: &Sample,
        point: &[u64],
    ) -> Vec<Vec<u64>> {
        let order = leaf.order();
        if order.len() < self.searched.dimension() {
            return Vec::new();
        }
        let mut place = vec![0; order.len()];
        for (&state, &value) in order.iter().zip(point) {
            place[state] = value;
        }
        let gradients = self.formulas.iter().filter_map(|known| {
            let own = quotient_gradient(self.searched, sample, &place, &known.numerator, &known.denominator)?;
            Some(order.iter().map(|&state| own[state]).collect())
        });
        gradients.collect()
    }
}
