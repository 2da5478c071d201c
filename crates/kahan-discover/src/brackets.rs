//! Invariant Poisson brackets from a density and n − 2 integrals, which are Casimir functions of
//! the bracket.

mod construct;
#[cfg(test)]
mod tests;

use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;

use crate::claims::{Claims, Formula};
use crate::deadline::Deadline;

use construct::invariant_tensor;

/// The work that one bracket may take, in products of terms.
const MOST_TERMS: usize = 2_000;
const MOST_WORK: u64 = 4_000_000;

/// So many choices of n − 2 integrals are tried, and so many of the brackets written.
const MOST_CHOICES: usize = 12;
const MOST_BRACKETS: usize = 3;

/// A bracket of more characters is not written.
const MOST_CHARACTERS: usize = 2_500;

/// Proved brackets as claims of the language of `kahan!`, the shortest first; none where there are
/// fewer than n − 2 integrals, and those that are too long left out.
pub(crate) fn brackets(
    claims: &Claims<'_>,
    symbols: &Symbols,
    integrals: &[Formula],
    density: &Formula,
    deadline: &Deadline<'_>,
) -> Vec<String> {
    let n = symbols.dimension();
    if n < 2 {
        return Vec::new();
    }
    let mut found: Vec<String> = Vec::new();
    for chosen in choices(integrals.len(), n - 2).into_iter().take(MOST_CHOICES) {
        if deadline.passed() {
            break;
        }
        let Some(tensor) = tensor(symbols, &chosen, integrals, density) else { continue };
        let entries = claims.bracket_entries(symbols, &tensor);
        found.extend((entries.len() <= MOST_CHARACTERS).then_some(entries));
    }
    found.sort_by_key(String::len);
    let names = 1..=MOST_BRACKETS;
    names.zip(&found).filter_map(|(index, entries)| claims.bracket(index, entries)).collect()
}

/// All choices of `count` of the indices below `of`, each ascending, those of the lowest indices
/// first.
fn choices(of: usize, count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    // Without this the recursion would go through all sets, also where none is large enough.
    if of < count {
        return Vec::new();
    }
    let with_last = |last: usize| {
        choices(last, count - 1).into_iter().map(move |mut chosen| {
            chosen.push(last);
            chosen
        })
    };
    (0..of).flat_map(with_last).collect()
}

/// The bracket with the chosen integrals as Casimir functions, its entries above the diagonal row
/// by row; `None` beyond the budget.
fn tensor(
    symbols: &Symbols,
    chosen: &[usize],
    integrals: &[Formula],
    density: &Formula,
) -> Option<Vec<RationalFunction>> {
    let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
    let mut function = |above: &Polynomial, below: &Polynomial| {
        RationalFunction::new_within(above.clone(), below.clone(), &mut budget).ok()?
    };
    let casimirs = chosen.iter().map(|&index| &integrals[index]);
    let casimirs: Option<Vec<_>> =
        casimirs.map(|integral| function(&integral.numerator, &integral.denominator)).collect();
    let density = function(&density.numerator, &density.denominator)?;
    let tensor = invariant_tensor(symbols, &density, &casimirs?, &mut budget)?;
    // A bracket is one up to a number: the entries are written with coprime integers, the first
    // positive.
    let mut contents = tensor.iter().filter(|entry| !entry.is_zero()).map(|e| e.numerator().content());
    let first = contents.next()?;
    let common = contents.fold(first.clone(), |common, other| common.gcd(&other)).abs();
    let number = if first.is_negative() { -common } else { common };
    let scale = RationalFunction::constant(number.recip()?);
    tensor.iter().map(|entry| entry.mul_within(&scale, &mut budget).ok()).collect()
}
