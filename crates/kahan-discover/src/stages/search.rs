//! Searches for formulas of invariants, given the relations on orbits.

use kahan_algebra::field::Field;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::system::Claim;

use super::Deadlines;
use super::formulas::Integrals;
use crate::claims::proved::{Claims, Formula};
use crate::deadline::Deadline;
use crate::densities::density::{densities, pfaffian_density};
use crate::integrals::composition::{CompositionIntegrals, survivors};
use crate::maps::search_field::{SampledStep, SearchField};
use crate::orbits::hilbert::Hilbert;
use crate::poisson::brackets::{Brackets, PoissonTensor, bracket_of_structure, brackets, polynomial_tensors};
use crate::poisson::modified::Modified;
use crate::report::{DensitySearch, ModifiedPlace};

/// The fraction of the remaining time for formulas of invariants that other results already give.
pub(super) const SHARE_FOR_FORMULAS: f64 = 0.1;

/// The inputs of the search for formulas: the field, its map, and the integrals known by theorems.
pub(super) struct Search<'a> {
    pub(super) searched: &'a SearchField,
    pub(super) field: &'a Field,
    pub(super) claims: &'a Claims<'a>,
    pub(super) modified: &'a [Modified],
    /// Proved integrals of the map that follow from the field by linear algebra.
    pub(super) proved: &'a [Formula],
    /// Integrals of the flow that the map preserves.
    pub(super) kept: &'a [Polynomial],
    /// Integrals P/Q that theorems give. One of degree d is tried after the search at degree d.
    pub(super) further: &'a [(Polynomial, Polynomial)],
    pub(super) is_even: bool,
    pub(super) place: &'a SampledStep,
    pub(super) begins: &'a dyn Fn(&str),
    pub(super) tell: &'a dyn Fn(&Claim, &str),
}

pub(super) struct SearchResult {
    pub(super) of: Integrals,
    pub(super) densities: Vec<Formula>,
    pub(super) density_search: DensitySearch,
    pub(super) tensors: Vec<PoissonTensor>,
    pub(super) brackets: Brackets,
    pub(super) survivors: Option<CompositionIntegrals>,
}

impl SearchResult {
    pub(super) fn integrals_found(&self) -> usize {
        let Integrals { integrals, bases, modified, .. } = &self.of;
        let in_bases: usize = bases.iter().map(|basis| basis.integrals.len()).sum();
        let alone = modified.iter().filter(|(_, place)| *place == ModifiedPlace::Alone);
        integrals.len() + in_bases + alone.count()
    }
}

impl Search<'_> {
    /// Searches for formulas, bases, densities and brackets. Reuses densities found `before`.
    pub(super) fn found(
        &self,
        hilbert: Option<&Hilbert>,
        before: Option<&SearchResult>,
        random: &mut SplitMix64,
        until: &Deadlines<'_>,
    ) -> SearchResult {
        (self.begins)("formulas of integrals");
        let of = self.integrals(hilbert, random, until);
        let Integrals { integrals, .. } = &of;
        (self.begins)("invariant Poisson brackets");
        let tensors = self.tensors(before, integrals.len(), random, &until.densities);
        (self.begins)("invariant densities");
        let (densities, density_search) = self.densities(before, &tensors, &of.all, random, &until.densities);
        let symbols = &self.field.symbols;
        densities.iter().for_each(|formula| (self.tell)(&formula.claim, &formula.text));
        let density = densities.first();
        let brackets = brackets(self.claims, symbols, &tensors, integrals, density, &until.densities);
        brackets.proved.iter().for_each(|bracket| (self.tell)(&bracket.claim, &bracket.text));

        (self.begins)("what survives composition");
        let survivors = hilbert
            .filter(|hilbert| hilbert.integrals > 0)
            .and_then(|hilbert| survivors(self.searched, integrals, hilbert.degree(), random, &until.end));
        SearchResult { of, densities, density_search, tensors, brackets, survivors }
    }

    fn tensors(
        &self,
        before: Option<&SearchResult>,
        integrals: usize,
        random: &mut SplitMix64,
        until: &Deadline<'_>,
    ) -> Vec<PoissonTensor> {
        let searched = self.searched;
        // In two and three variables, a density and n − 2 integrals give all brackets. In three,
        // shorter brackets may exist, so entries up to degree 2 are searched nevertheless.
        let is_said = searched.dimension() < 4 && integrals + 2 >= searched.dimension();
        let highest = if is_said { 2 } else { u32::MAX };
        match before {
            Some(before) => before.tensors.clone(),
            None if searched.dimension() < 3 => Vec::new(),
            None => {
                let structures = self.modified.iter().map(|modified| &modified.found).enumerate();
                let known =
                    structures.filter_map(|one| bracket_of_structure(searched, self.field, one, random));
                let known = known.collect();
                polynomial_tensors(searched, known, highest, random, until)
            }
        }
    }

    /// Searches for a density, unless a density was found `before` or follows from a bracket.
    fn densities(
        &self,
        before: Option<&SearchResult>,
        tensors: &[PoissonTensor],
        all_integrals: &[Formula],
        random: &mut SplitMix64,
        until: &Deadline<'_>,
    ) -> (Vec<Formula>, DensitySearch) {
        let (searched, symbols) = (self.searched, &self.field.symbols);
        let of_tensor =
            tensors.iter().find_map(|tensor| pfaffian_density(tensor, self.claims, symbols, all_integrals));
        let known = before.filter(|before| !before.densities.is_empty());
        // A bracket of full rank implies a density. If `pfaffian_density` did not find the density,
        // the formula is long, so little time is spent on a search.
        let is_implied = tensors.first().is_some_and(|tensor| tensor.rank == searched.dimension());
        let for_formulas = until.after_share(SHARE_FOR_FORMULAS);
        let until_densities = if is_implied { &for_formulas } else { until };
        match (of_tensor, known) {
            (Some(density), _) => {
                let search = DensitySearch { seen: Some(density.degree), none_up_to: None };
                (vec![density], search)
            }
            (None, Some(before)) => (before.densities.clone(), before.density_search),
            (None, None) => densities(
                searched,
                self.claims,
                all_integrals,
                self.field,
                self.is_even,
                random,
                until_densities,
            ),
        }
    }
}
