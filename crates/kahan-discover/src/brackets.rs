//! Invariant Poisson brackets: with polynomial entries, of any rank, and of rank 2 from a density
//! and n − 2 integrals, which are Casimir functions of the bracket.

mod construct;
mod polynomial;
#[cfg(test)]
mod tests;

use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;

use crate::claims::{Claims, Formula};
use crate::deadline::Deadline;

use construct::invariant_tensor;
pub(crate) use polynomial::{PoissonTensor, polynomial_tensors};

/// The work that one bracket may take, in products of terms.
const MOST_TERMS: usize = 2_000;
const MOST_WORK: u64 = 4_000_000;

/// So many choices of n − 2 integrals are tried, and so many of the brackets written.
const MOST_CHOICES: usize = 12;
const MOST_BRACKETS: usize = 3;

/// A bracket of more characters is not written.
const MOST_CHARACTERS: usize = 2_500;

/// Proves brackets and returns them with their ranks, as claims of the language of `kahan!`: first
/// those with the given tensors, whose number is returned, too. If none of them has full rank,
/// those of a density with n − 2 integrals follow, the shortest first. A bracket of more than 2500
/// characters is left out.
pub(crate) fn brackets(
    claims: &Claims<'_>,
    symbols: &Symbols,
    tensors: &[PoissonTensor],
    integrals: &[Formula],
    density: Option<&Formula>,
    deadline: &Deadline<'_>,
) -> (Vec<(usize, String)>, usize) {
    let n = symbols.dimension();
    if n < 2 {
        return (Vec::new(), 0);
    }
    let written = |tensor: &[RationalFunction]| {
        let entries = claims.bracket_entries(symbols, tensor);
        (entries.len() <= MOST_CHARACTERS).then_some(entries)
    };
    let claim =
        |index: usize, (rank, entries): (usize, String)| Some((rank, claims.bracket(index, &entries)?));
    let polynomial = tensors.iter().filter_map(|tensor| {
        let entries: Vec<RationalFunction> = tensor.entries.iter().cloned().map(Into::into).collect();
        Some((tensor.rank, written(&entries)?))
    });
    let mut proved: Vec<(usize, String)> =
        (1..).zip(polynomial).filter_map(|(index, bracket)| claim(index, bracket)).collect();
    let count = proved.len();
    let is_full = proved.first().is_some_and(|(rank, _)| rank + 1 >= n);
    let mut found: Vec<String> = Vec::new();
    if let Some(density) = density.filter(|_| !is_full) {
        for chosen in choices(integrals.len(), n - 2).into_iter().take(MOST_CHOICES) {
            if deadline.passed() {
                break;
            }
            found.extend(tensor(symbols, &chosen, integrals, density).and_then(|tensor| written(&tensor)));
        }
    }
    found.sort_by_key(String::len);
    let made = found.into_iter().take(MOST_BRACKETS).map(|entries| (2, entries));
    proved.extend((count + 1..).zip(made).filter_map(|(index, bracket)| claim(index, bracket)));
    (proved, count)
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
