//! Finds the modified Hamiltonians of the map, one for each constant K with f = K∇H that
//! `hamiltonians` finds.

use kahan_algebra::field::Field;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::render::Text;
use kahan_algebra::symbols::Symbols;

use crate::claims::proved::{Claims, Formula};
use crate::claims::writing::factors_of;
use crate::deadline::Deadline;
use crate::integrals::independence::IndependentGradients;
use crate::maps::search_field::SearchField;
use crate::modular::subspace::primitive_in_states;
use crate::poisson::hamiltonian::{Hamiltonian, hamiltonians};
use crate::report::ModifiedPlace;

/// A formula may be replaced by H + (x̃ − x)·∇H/3 if it has more characters than this.
const LONG_FORMULA: usize = 1000;

/// A formula is replaced only if it is more than this many times as long as H + (x̃ − x)·∇H/3.
const FAR_SHORTER: usize = 4;

pub(crate) struct Modified {
    pub(crate) found: Hamiltonian,
    /// The numerator and denominator of the modified Hamiltonian, if within the budget.
    pub(crate) written: Option<(Polynomial, Polynomial)>,
}

impl Modified {
    /// Finds the modified Hamiltonians, by ascending number of terms.
    pub(crate) fn all(
        searched: &SearchField,
        field: &Field,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Vec<Modified> {
        let mut found = hamiltonians(searched, random, deadline);
        found.retain(|found| found.holds(field));
        let written = |found: &Hamiltonian| {
            let (above, below) = found.modified(searched, field)?;
            Some((primitive_in_states(&field.symbols, &above), primitive_in_states(&field.symbols, &below)))
        };
        let mut all: Vec<Modified> =
            found.into_iter().map(|found| Modified { written: written(&found), found }).collect();
        let terms = |(above, below): &(Polynomial, Polynomial)| above.terms().count() + below.terms().count();
        all.sort_by_key(|modified| modified.written.as_ref().map_or(usize::MAX, terms));
        all
    }
}

/// Adds to `integrals` the proved and independent ones of `all`. Returns which ones are proved.
pub(crate) fn add_modified(
    all: &[Modified],
    searched: &SearchField,
    claims: &Claims<'_>,
    symbols: &Symbols,
    integrals: &mut Vec<Formula>,
    random: &mut SplitMix64,
) -> Vec<bool> {
    let mut add = |modified: &Modified| {
        let Some((above, below)) = &modified.written else { return false };
        let is_listed = |known: &Formula| known.numerator == *above && known.denominator == *below;
        if integrals.iter().any(is_listed) {
            return true;
        }
        let factors = factors_of(integrals);
        let formula = claims.integral(symbols, integrals.len() + 1, above, below, &factors);
        let is_proved = formula.is_some();
        add_if_independent(searched, integrals, formula, random);
        is_proved
    };
    all.iter().map(&mut add).collect()
}

fn add_if_independent(
    searched: &SearchField,
    integrals: &mut Vec<Formula>,
    formula: Option<Formula>,
    random: &mut SplitMix64,
) {
    let Some(formula) = formula else { return };
    if IndependentGradients::of(searched, integrals, random).admits(&formula.numerator, &formula.denominator)
    {
        integrals.push(formula);
    }
}

pub(crate) struct Gradients<'a> {
    pub(crate) formulas: Vec<Option<Vec<u64>>>,
    pub(crate) in_bases: Vec<Vec<u64>>,
    pub(crate) modified: &'a [Option<Vec<u64>>],
    pub(crate) rank: &'a dyn Fn(&[Vec<u64>]) -> usize,
}

impl Gradients<'_> {
    /// Decides how each modified Hamiltonian is reported. An independent one is added to the
    /// report. A dependent one replaces a much longer integral that it implies, or is omitted.
    pub(crate) fn places(
        &self,
        all: &[Modified],
        integrals: &[Formula],
        symbols: &Symbols,
    ) -> Vec<ModifiedPlace> {
        let mut kept: Vec<usize> = (0..integrals.len()).collect();
        let mut compact: Vec<Vec<u64>> = Vec::new();
        let mut place = |(modified, own): (&Modified, &Option<Vec<u64>>)| {
            let Some(own) = own else { return ModifiedPlace::Implied };
            // Returns the rank of the gradients of all formulas except `but`. If `with_own` is
            // true, the gradient `own` is included.
            let rank = |but: Option<usize>, with_own: bool| {
                let formulas = kept.iter().filter(|&&index| Some(index) != but);
                let formulas = formulas.filter_map(|&index| self.formulas[index].clone());
                let others = self.in_bases.iter().chain(&compact).cloned();
                (self.rank)(&formulas.chain(others).chain(with_own.then(|| own.clone())).collect::<Vec<_>>())
            };
            let all = rank(None, false);
            if rank(None, true) > all {
                compact.push(own.clone());
                return ModifiedPlace::Alone;
            }
            let length = |index: usize| integrals[index].text.len();
            let shorter = FAR_SHORTER * modified.found.compact(symbols, &Text).len();
            let long = kept.iter().copied().filter(|&index| length(index) > LONG_FORMULA.max(shorter));
            let replaced = long.filter(|&index| rank(Some(index), true) == all).max_by_key(|&i| length(i));
            let Some(index) = replaced else { return ModifiedPlace::Implied };
            kept.retain(|&known| known != index);
            compact.push(own.clone());
            ModifiedPlace::InsteadOf(index)
        };
        all.iter().zip(self.modified).map(&mut place).collect()
    }
}
