//! Invariant Poisson brackets from a density and n − 2 integrals.
//!
//! Contracting the invariant volume ρ dx with n − 2 integrals leaves the bivector
//! Pⁱʲ = (1/ρ) Σ ±∂H₁/∂x_{k₁} ⋯ ∂H_{n−2}/∂x_{k_{n−2}}, the minor of the gradients without columns i and j. It is a Poisson tensor (Nambu,
//! "Generalized Hamiltonian dynamics", 1973) with the Hₘ as Casimir functions, and invariant as ρ and the Hₘ are.

use kahan_algebra::poly::{Budget, OverBudget, Polynomial};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;

use crate::claims::{Claims, Formula};
use crate::deadline::Deadline;

/// The work that one entry may take, in products of terms.
const MOST_TERMS: usize = 2_000;
const MOST_WORK: u64 = 4_000_000;

/// So many choices of n − 2 integrals are tried, and so many of the brackets written.
const MOST_CHOICES: usize = 12;
const MOST_BRACKETS: usize = 3;

/// A bracket of more characters is not written.
const MOST_CHARACTERS: usize = 1_000;

/// Proved brackets as claims of the language of `kahan!`, the shortest first; none where there are fewer than n − 2 integrals,
/// and those that are too long left out.
pub(crate) fn brackets(
    claims: &Claims<'_>,
    symbols: &Symbols,
    integrals: &[Formula],
    density: &Formula,
    deadline: &Deadline,
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
        let chosen: Vec<&Formula> = chosen.into_iter().map(|index| &integrals[index]).collect();
        let Ok(Some(entries)) = tensor(symbols, &chosen, density) else { continue };
        let value = claims.bracket_entries(symbols, &entries);
        found.extend((value.len() <= MOST_CHARACTERS).then_some(value));
    }
    found.sort_by_key(String::len);
    let names = 1..=MOST_BRACKETS;
    names.zip(&found).filter_map(|(index, entries)| claims.bracket(index, entries)).collect()
}

/// All choices of `count` of the indices below `of`, ascending.
fn choices(of: usize, count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    (0..of)
        .flat_map(|last| {
            choices(last, count - 1).into_iter().map(move |mut chosen| {
                chosen.push(last);
                chosen
            })
        })
        .collect()
}

/// An entry above the diagonal: i, j and {xᵢ, xⱼ}.
pub(crate) type Entry = (usize, usize, RationalFunction);

/// The entries that are not 0; `None` where a denominator is 0.
fn tensor(
    symbols: &Symbols,
    integrals: &[&Formula],
    density: &Formula,
) -> Result<Option<Vec<Entry>>, OverBudget> {
    let n = symbols.dimension();
    let mut gradients = Vec::new();
    for formula in integrals {
        let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
        let own = RationalFunction::new_within(
            formula.numerator.clone(),
            formula.denominator.clone(),
            &mut budget,
        )?;
        let Some(own) = own else { return Ok(None) };
        let slopes: Result<Vec<_>, _> =
            (0..n).map(|i| own.derivative_within(symbols.state(i), &mut budget)).collect();
        gradients.push(slopes?);
    }
    let mut entries = Vec::new();
    for i in 0..n {
        for j in i + 1..n {
            let columns: Vec<usize> = (0..n).filter(|&column| column != i && column != j).collect();
            let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
            let minor = minor(&gradients, &columns, &mut budget)?;
            let signed = if (i + j) % 2 == 1 { minor } else { -&minor };
            let weight = RationalFunction::new_within(
                density.denominator.clone(),
                density.numerator.clone(),
                &mut budget,
            )?;
            let Some(weight) = weight else { return Ok(None) };
            let entry = signed.mul_within(&weight, &mut budget)?;
            if !entry.is_zero() {
                entries.push((i, j, entry));
            }
        }
    }
    Ok((!entries.is_empty()).then_some(entries))
}

/// The determinant of the rows' entries in these columns, by expansion along the first row.
fn minor(
    rows: &[Vec<RationalFunction>],
    columns: &[usize],
    budget: &mut Budget,
) -> Result<RationalFunction, OverBudget> {
    let Some((first, rest)) = rows.split_first() else {
        return Ok(RationalFunction::from(Polynomial::one()));
    };
    let mut sum = RationalFunction::zero();
    for (place, &column) in columns.iter().enumerate() {
        if first[column].is_zero() {
            continue;
        }
        let others: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
        let product = minor(rest, &others, budget)?.mul_within(&first[column], budget)?;
        sum = match place % 2 {
            0 => sum.add_within(&product, budget)?,
            _ => sum.sub_within(&product, budget)?,
        };
    }
    Ok(sum)
}
