//! Searches for formulas and compact forms of integrals, and for Hirota–Kimura bases: sets of
//! monomials with one linear relation along every orbit.

use kahan_algebra::prime_field::SplitMix64;

use super::search::{SHARE_FOR_FORMULAS, Search};
use crate::claims::proved::Formula;
use crate::deadline::Deadline;
use crate::integrals::independence::quotient_gradient;
use crate::integrals::reconstructed::{SearchGoals, integrals};
use crate::integrals::search::FormulaLimits;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::SampledStep;
use crate::modular::matrix::Echelon;
use crate::modular::monomials::Monomials;
use crate::orbits::basis::{Basis, candidates, choose_bases, prove};
use crate::orbits::hilbert::Hilbert;
use crate::orbits::relations::Relations;
use crate::poisson::modified::{Gradients, Modified, add_modified};
use crate::report::{MOST_READABLE, ModifiedPlace};

use super::Deadlines;

/// The integrals that one search finds, from relations up to its degree.
pub(super) struct Integrals {
    pub(super) integrals: Vec<Formula>,
    /// All proved formulas, including long formulas that bases replace.
    pub(super) all: Vec<Formula>,
    pub(super) bases: Vec<Basis>,
    /// The number of independent integrals, including integrals without a formula.
    pub(super) independent: usize,
    /// For each modified Hamiltonian: whether it is proved as a claim, and how it is reported.
    pub(super) modified: Vec<(bool, ModifiedPlace)>,
}

impl Search<'_> {
    pub(super) fn integrals(
        &self,
        hilbert: Option<&Hilbert>,
        random: &mut SplitMix64,
        until: &Deadlines<'_>,
    ) -> Integrals {
        let searched = self.searched;
        let symbols = &self.field.symbols;
        let shown = hilbert.map_or(0, |hilbert| hilbert.integrals);
        let defining = hilbert
            .filter(|_| shown > 0)
            .and_then(|hilbert| hilbert.defining_degree(&self.place.sample.map, random, &until.integrals));
        let candidates =
            defining.map_or_else(Vec::new, |degree| candidates(searched, degree, random, &until.integrals));
        let SampledStep { sample, here, .. } = self.place;
        let of_modified = |modified: &Modified| modified.found.modified_gradient(searched, sample, here);
        let own: Vec<Option<Vec<u64>>> = self.modified.iter().map(of_modified).collect();
        let in_compact_forms = self.rank(&own.iter().flatten().cloned().collect::<Vec<_>>());
        let in_bases = choose_bases(&candidates, shown, self.place, &mut Vec::new(), &until.integrals);
        let in_bases = in_bases.iter().map(|basis| basis.integrals.len()).sum::<usize>();
        let are_enough = in_bases.max(in_compact_forms) >= shown;
        let for_formulas = until.integrals.after_share(SHARE_FOR_FORMULAS);
        let until_formulas = if in_compact_forms >= shown { &for_formulas } else { &until.integrals };
        let reach = if are_enough { FormulaLimits::SHORT } else { FormulaLimits::FULL };
        let is_short = |formula: &Formula| !are_enough || formula.text.len() <= MOST_READABLE;
        let tell = |formula: &Formula| (self.tell)(&formula.claim, &formula.text);
        let tell_if_short = |formula: &Formula| {
            if is_short(formula) {
                tell(formula);
            }
        };
        let known: Vec<_> = self.modified.iter().filter_map(|modified| modified.written.clone()).collect();
        let quotients =
            candidates.iter().filter_map(|basis| basis.quotient_of_terms(searched, &mut random.clone()));
        let further: Vec<_> = self.further.iter().cloned().chain(quotients).collect();
        let aims = SearchGoals {
            proved: self.proved,
            kept: self.kept,
            further: (&further, &until.end),
            hilbert,
            known: &known,
            reach,
            tell: &tell_if_short,
        };
        let mut all_integrals = integrals(searched, self.claims, &aims, random, until_formulas);
        let are_proved =
            add_modified(self.modified, searched, self.claims, symbols, &mut all_integrals, random);
        all_integrals.iter().for_each(tell_if_short);

        let mut gradients: Vec<Vec<u64>> =
            all_integrals.iter().filter_map(|formula| self.gradient(formula)).collect();
        gradients.extend(own.iter().flatten().cloned());
        gradients.extend(defining.map_or_else(Vec::new, |degree| self.normals(degree, &until.integrals)));
        let independent = self.rank(&gradients).max(shown);

        let (mut integrals, long): (Vec<Formula>, Vec<Formula>) =
            all_integrals.iter().cloned().partition(is_short);
        let mut gradients: Vec<Vec<u64>> =
            integrals.iter().filter_map(|formula| self.gradient(formula)).collect();
        let mut add = |gradients: &mut Vec<Vec<u64>>, formula: Formula| {
            let gradient = self.gradient(&formula);
            if gradient.is_some_and(|gradient| self.extends(gradients, gradient)) {
                tell(&formula);
                integrals.push(formula);
            }
        };
        let says_the_same = |formula: &Formula| {
            let mut rows = [&gradients[..], &own.iter().flatten().cloned().collect::<Vec<_>>()].concat();
            let rank = self.rank(&rows);
            rows.extend(self.gradient(formula));
            rank > gradients.len() && self.rank(&rows) == rank
        };
        let (same, long): (Vec<Formula>, Vec<Formula>) = long.into_iter().partition(says_the_same);
        for formula in same {
            add(&mut gradients, formula);
        }
        for own in own.iter().flatten() {
            self.extends(&mut gradients, own.clone());
        }
        let mut bases = choose_bases(&candidates, independent, self.place, &mut gradients, &until.densities);
        for basis in &mut bases {
            basis.join_terms(searched, random);
            basis.proof = prove(basis, searched, self.field, &until.densities);
        }
        for formula in long {
            add(&mut gradients, formula);
        }
        let in_bases = bases.iter().filter_map(|basis| basis.gradients(&sample.map, here)).flatten();
        let known = Gradients {
            formulas: integrals.iter().map(|formula| self.gradient(formula)).collect(),
            in_bases: in_bases.collect(),
            modified: &own,
            rank: &|gradients| self.rank(gradients),
        };
        let places = known.places(self.modified, &integrals, symbols);
        let modified = are_proved.into_iter().zip(places).collect();
        Integrals { integrals, all: all_integrals, bases, independent, modified }
    }

    fn gradient(&self, formula: &Formula) -> Option<Vec<u64>> {
        let SampledStep { sample, here, .. } = self.place;
        quotient_gradient(self.searched, sample, here, &formula.numerator, &formula.denominator)
    }

    fn rank(&self, gradients: &[Vec<u64>]) -> usize {
        let modulus = self.place.sample.map.modulus();
        Echelon::of(modulus, gradients.to_vec(), self.searched.dimension()).rank()
    }

    /// Adds a gradient, and returns `true`, if it is independent of the earlier gradients.
    fn extends(&self, gradients: &mut Vec<Vec<u64>>, gradient: Vec<u64>) -> bool {
        gradients.push(gradient);
        let is_independent = self.rank(gradients) == gradients.len();
        if !is_independent {
            gradients.pop();
        }
        is_independent
    }

    /// Returns a basis of the gradients at `place` of all relations up to `degree` along its orbit.
    fn normals(&self, degree: u32, deadline: &Deadline<'_>) -> Vec<Vec<u64>> {
        let SampledStep { sample, here, .. } = self.place;
        let monomials = Monomials::new(self.searched.dimension(), degree);
        Relations::on_orbit(&sample.map, here.clone(), &monomials, deadline)
            .map_or_else(Vec::new, |relations| relations.normals(sample.map.modulus(), &monomials))
    }
}
