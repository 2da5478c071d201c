//! Writes Cramer's rule as operations without divisions. Minors of k rows follow from those of k −
//! 1 rows, and all determinants are computed from the same minors. Zero entries cost nothing.

use kahan_syntax::table::{Table, sorted_by_key};

use crate::poly::Polynomial;

use crate::plan::writing::plan_draft::{PlanDraft, Signed};
use crate::plan::writing::writer::{MatrixEntry, Writer};

/// The determinant of A, and those of A with one column replaced by the right-hand side.
pub(in crate::plan) struct Determinants {
    pub(in crate::plan) denominator: Signed,
    pub(in crate::plan) numerators: Vec<Signed>,
}

/// Computes the determinants of A with the right-hand side as last column. The last row is expanded
/// last.
pub(in crate::plan) fn determinants(writer: &mut Writer, rows: &[Vec<MatrixEntry>]) -> Determinants {
    let n = rows.len();
    let mut minors: Table<u64, Signed> = Table::new();
    for (k, row) in rows.iter().enumerate() {
        minors = match k {
            0 => single(&writer.draft, row),
            1 => pairs(writer, &rows[0], row),
            _ => expanded(&mut writer.draft, &minors, row),
        };
    }
    let draft = &mut writer.draft;
    let all = (1_u64 << (n + 1)) - 1;
    let zero = Signed::plus(draft.zero());
    let minor = |missing: usize| minors.get(&(all & !(1 << missing))).copied().unwrap_or(zero);
    let numerators = (0..n).map(|j| {
        // Moving the last column to place j changes the sign n−1−j times.
        minor(j).flipped((n - 1 - j) % 2 == 1)
    });
    Determinants { denominator: minor(n), numerators: numerators.collect() }
}

fn single(draft: &PlanDraft, row: &[MatrixEntry]) -> Table<u64, Signed> {
    let entries = row.iter().enumerate().map(|(column, entry)| (1 << column, entry.written));
    entries.filter(|(_, written)| !draft.is_zero(*written)).collect()
}

fn pairs(writer: &mut Writer, first: &[MatrixEntry], second: &[MatrixEntry]) -> Table<u64, Signed> {
    let mut minors = Table::new();
    for j in 1..first.len() {
        for i in 0..j {
            let polynomial = minor_of(&first[i], &second[j], &first[j], &second[i]);
            if polynomial.as_ref().is_some_and(Polynomial::is_zero) {
                continue;
            }
            let written = polynomial.and_then(|polynomial| writer.known(&polynomial)).unwrap_or_else(|| {
                let left = times(&mut writer.draft, first[i].written, second[j].written);
                let right = times(&mut writer.draft, first[j].written, second[i].written);
                let mut terms = vec![left, right.flipped(true)];
                terms.retain(|term| !writer.draft.is_zero(*term));
                writer.draft.signed_sum(&terms)
            });
            if writer.draft.is_zero(written) {
                continue;
            }
            minors.insert(1 << i | 1 << j, written);
        }
    }
    minors
}

/// Returns the minor ab − cd as a polynomial, or `None` if the polynomial of an entry is unknown.
fn minor_of(a: &MatrixEntry, b: &MatrixEntry, c: &MatrixEntry, d: &MatrixEntry) -> Option<Polynomial> {
    let [a, b, c, d] = [a, b, c, d].map(|entry| entry.polynomial.as_ref());
    Some(&(a? * b?) - &(c? * d?))
}

fn times(draft: &mut PlanDraft, a: Signed, b: Signed) -> Signed {
    Signed { node: draft.multiply(a.node, b.node), negative: a.negative != b.negative }
}

fn expanded(draft: &mut PlanDraft, minors: &Table<u64, Signed>, row: &[MatrixEntry]) -> Table<u64, Signed> {
    let mut terms: Table<u64, Vec<Signed>> = Table::new();
    for (&chosen, minor) in minors.iter() {
        for (column, MatrixEntry { written: entry, .. }) in row.iter().enumerate() {
            if chosen >> column & 1 == 1 || draft.is_zero(*entry) {
                continue;
            }
            // The entry changes the sign once for each chosen column to its right.
            let odd = (chosen >> column).count_ones() % 2 == 1;
            let product = times(draft, *minor, *entry).flipped(odd);
            terms.or_default(chosen | 1 << column).push(product);
        }
    }
    terms.into_iter().map(|(chosen, terms)| (chosen, draft.signed_sum(&terms))).collect()
}

/// Bounds the number of operations in [`determinants`] for a pattern of nonzero entries.
pub(in crate::plan) fn operations(pattern: &[Vec<bool>]) -> usize {
    let mut known: Vec<u64> = vec![0];
    let mut count = 0;
    for row in pattern {
        let mut next: Table<u64, usize> = Table::new();
        for &chosen in &known {
            for (column, _) in
                row.iter().enumerate().filter(|(column, entry)| **entry && chosen >> column & 1 == 0)
            {
                *next.or_default(chosen | 1 << column) += 1;
            }
        }
        count += if known == [0] { 0 } else { next.values().map(|terms| 2 * terms - 1).sum() };
        known = next.into_keys().collect();
        if known.len() > MOST_MINORS {
            return usize::MAX;
        }
    }
    count
}

/// Sorts orders of the rows by cost, and returns the order at index `rank`. The orders are the
/// rotations of three: the given order, sparse rows first, and dense rows first.
pub(in crate::plan) fn cheap_order(pattern: &[Vec<bool>], rank: usize) -> Vec<usize> {
    let given: Vec<usize> = (0..pattern.len()).collect();
    let entries = |i: &usize| pattern[*i].iter().filter(|entry| **entry).count();
    let sparse_first = sorted_by_key(given.clone(), entries);
    let dense_first: Vec<usize> = sparse_first.iter().rev().copied().collect();
    let mut orders: Vec<(usize, Vec<usize>)> = Vec::new();
    for mut order in [given, sparse_first, dense_first] {
        for _ in 0..order.len() {
            order.rotate_left(1);
            let rows: Vec<Vec<bool>> = order.iter().map(|&i| pattern[i].clone()).collect();
            orders.push((operations(&rows), order.clone()));
        }
    }
    let mut orders = sorted_by_key(orders, Clone::clone);
    orders.dedup();
    let last = orders.len() - 1;
    orders.swap_remove(rank.min(last)).1
}

const MOST_MINORS: usize = 4096;
/// The most operations of a block that is solved by Cramer's rule. For larger blocks, elimination
/// is faster.
pub(in crate::plan) const MOST_OPERATIONS: usize = 600;
