//! Invariant Poisson brackets: brackets with polynomial entries, and brackets of rank 2 from a
//! density and n − 2 integrals.

mod constant;
mod construct;
mod polynomial;
#[cfg(test)]
mod tests;

use std::cmp::Reverse;

use kahan_algebra::poly::{Budget, Polynomial, gcd_all_within};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;
use kahan_algebra::system::Claim;

use crate::claims::proved::{Claims, Formula};
use crate::claims::writing::begins_negative;
use crate::deadline::Deadline;

pub(crate) use constant::bracket_of_structure;
use construct::invariant_tensor;
pub(crate) use polynomial::{PoissonTensor, polynomial_tensors};

const MOST_TERMS: usize = 2_000;
const MOST_WORK: u64 = 4_000_000;

/// The most sets of n − 2 integrals from which brackets are made.
const MOST_CHOICES: usize = 12;
/// The most brackets of rank 2 from a density and integrals.
const MOST_BRACKETS: usize = 3;

const MOST_CHARACTERS: usize = 2_500;

/// The most characters of a bracket of rank 2 in four dimensions, if one of full rank exists.
const MOST_BESIDE: usize = 400;

/// A proved invariant Poisson bracket.
#[derive(Clone, Debug)]
pub struct Bracket {
    /// The claim in the language of `kahan!`, for example `bracket P1 { … };`.
    pub text: String,
    /// The claim as read from the text.
    pub claim: Claim,
    /// The rank at a general point.
    pub rank: usize,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Brackets {
    pub(crate) proved: Vec<Bracket>,
    /// The number of proved brackets with polynomial entries, which come first.
    pub(crate) polynomial: usize,
    /// The indices of constant tensors K for which (I − ε² f′²)K is proved to be a bracket.
    pub(crate) structures: Vec<usize>,
}

/// Proves the brackets of the given tensors, by descending rank and ascending length. Then proves
/// brackets of rank 2 from the density and n − 2 integrals, the shortest first.
///
/// A bracket has at most 2500 characters. If one has full rank, brackets of rank 2 have at most 400
/// characters in four dimensions, and are omitted in more dimensions.
pub(crate) fn brackets(
    claims: &Claims<'_>,
    symbols: &Symbols,
    tensors: &[PoissonTensor],
    integrals: &[Formula],
    density: Option<&Formula>,
    deadline: &Deadline<'_>,
) -> Brackets {
    let n = symbols.dimension();
    if n < 2 {
        return Brackets::default();
    }
    let written = |tensor: &[RationalFunction]| {
        let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
        Some(claims.bracket_entries(symbols, &coprime(symbols, tensor, &mut budget)?))
    };
    let mut proved: Vec<Bracket> = Vec::new();
    let mut taken: Vec<String> = Vec::new();
    let mut add = |proved: &mut Vec<Bracket>, rank: usize, entries: String| {
        let is_new = !taken.contains(&entries);
        let bracket = is_new.then(|| claims.bracket(proved.len() + 1, rank, &entries)).flatten();
        let is_proved = bracket.is_some();
        proved.extend(bracket);
        taken.push(entries);
        is_proved
    };
    let mut polynomial: Vec<(&PoissonTensor, String)> = tensors
        .iter()
        .filter_map(|tensor| {
            let entries: Vec<_> = tensor.entries.iter().cloned().map(RationalFunction::from).collect();
            Some((tensor, written(&entries)?))
        })
        .collect();
    polynomial.sort_by_key(|(tensor, entries)| (Reverse(tensor.rank), entries.len()));
    let mut structures = Vec::new();
    for (tensor, entries) in polynomial {
        let is_proved = if entries.len() <= MOST_CHARACTERS && !tensor.is_implied {
            add(&mut proved, tensor.rank, entries)
        } else {
            tensor.structure.is_some() && claims.bracket(1, tensor.rank, &entries).is_some()
        };
        structures.extend(tensor.structure.filter(|_| is_proved));
    }
    structures.sort_unstable();
    let count = proved.len();
    let is_full = proved.first().is_some_and(|bracket| bracket.rank + 1 >= n);
    let is_beside = is_full && n > 3;
    let most = if is_beside { MOST_BESIDE } else { MOST_CHARACTERS };
    // With `is_beside`, long integrals are not used, because their brackets are as long.
    let is_long = |&index: &usize| is_beside && integrals[index].text.len() > most;
    let mut found: Vec<String> = Vec::new();
    if let Some(density) = density.filter(|_| !is_full || n <= 4) {
        let choices = choices(integrals.len(), n - 2).into_iter();
        for chosen in choices.filter(|chosen| !chosen.iter().any(is_long)).take(MOST_CHOICES) {
            if deadline.passed() {
                break;
            }
            let tensor = tensor(symbols, &chosen, integrals, density);
            found.extend(tensor.and_then(|tensor| written(&tensor)).filter(|entries| entries.len() <= most));
        }
    }
    found.sort_by_key(String::len);
    for entries in found.into_iter().take(MOST_BRACKETS) {
        add(&mut proved, 2, entries);
    }
    Brackets { proved, polynomial: count, structures }
}

fn choices(of: usize, count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
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
    invariant_tensor(symbols, &density, &casimirs?, &mut budget)
}

/// Divides the tensor of a bracket by common factors that contain no state. Makes the first
/// coefficient of the first nonzero entry positive.
fn coprime(
    symbols: &Symbols,
    tensor: &[RationalFunction],
    budget: &mut Budget,
) -> Option<Vec<RationalFunction>> {
    fn numerators(tensor: &[RationalFunction]) -> Vec<&Polynomial> {
        tensor.iter().filter(|entry| !entry.is_zero()).map(RationalFunction::numerator).collect()
    }
    let coefficients = |numerator: &Polynomial| {
        let groups = numerator.group(|variable| symbols.is_state(variable)).into_iter();
        groups.map(|(_, coefficient)| coefficient).collect::<Vec<_>>()
    };
    let coefficients: Vec<Polynomial> = numerators(tensor).into_iter().flat_map(coefficients).collect();
    let free = RationalFunction::from(gcd_all_within(&coefficients, budget).ok()?).recip()?;
    let tensor: Option<Vec<_>> = tensor.iter().map(|entry| entry.mul_within(&free, budget).ok()).collect();
    let tensor = tensor?;
    let numerators = numerators(&tensor);
    let common = numerators.iter().map(|numerator| numerator.content()).reduce(|a, b| a.gcd(&b))?.abs();
    let number = if begins_negative(numerators[0]) { -common } else { common };
    let scale = RationalFunction::constant(number.recip()?);
    tensor.iter().map(|entry| entry.mul_within(&scale, budget).ok()).collect()
}
