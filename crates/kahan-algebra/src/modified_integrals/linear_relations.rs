//! Finds linear relations between polynomials in the states by sparse elimination.

use crate::poly::{Budget, Monomial, Polynomial, Variable, WithinBudget};
use crate::rational_function::{RationalFunction, Row, reduced, with_leading_one};

/// The nonzero coefficients of a relation Σ cₖ vₖ = 0 by ascending k. Coefficients are polynomials
/// in the parameters.
pub(super) type Relation = Vec<(usize, Polynomial)>;

/// Returns a basis of the relations Σ cₖ vₖ = 0 between polynomials vₖ. No cₖ contains a state.
///
/// The last index k of a relation occurs in no other relation of the basis.
pub(super) fn linear_relations(
    vectors: &[Polynomial],
    is_state: impl Fn(Variable) -> bool,
    budget: &mut Budget,
) -> WithinBudget<Vec<Relation>> {
    let (rows, is_zero) = equations(vectors, is_state);
    let mut by_first: Vec<Vec<Row>> = vec![Vec::new(); vectors.len()];
    rows.into_iter().for_each(|row| by_first[row[0].0].push(row));
    let mut pivots: Vec<Option<Row>> = vec![None; vectors.len()];
    for column in 0..vectors.len() {
        let mut rows = std::mem::take(&mut by_first[column]);
        let size = |row: &Row| (row.len(), row[0].1.numerator().len() + row[0].1.denominator().len());
        let Some(best) = (0..rows.len()).min_by_key(|&index| size(&rows[index])) else { continue };
        let pivot = rows.swap_remove(best);
        let pivot = with_leading_one(&pivot, budget)?;
        for row in rows {
            let row = reduced(&row, &row[0].1.clone(), &pivot, budget)?;
            if let Some((first, _)) = row.first() {
                by_first[*first].push(row);
            }
        }
        pivots[column] = Some(pivot);
    }
    for column in (0..vectors.len()).rev() {
        let Some(mut row) = pivots[column].take() else { continue };
        for (later, entry) in row.clone().iter().skip(1) {
            if let Some(pivot) = &pivots[*later] {
                row = reduced(&row, entry, pivot, budget)?;
            }
        }
        pivots[column] = Some(row);
    }
    let mut relations: Vec<Row> = vec![Vec::new(); vectors.len()];
    for (column, row) in pivots.iter().enumerate() {
        for (free, entry) in row.iter().flatten().skip(1) {
            relations[*free].push((column, -entry));
        }
    }
    let free = (0..vectors.len()).filter(|&column| pivots[column].is_none() && !is_zero[column]);
    let with_last = free.map(|column| {
        let mut relation = std::mem::take(&mut relations[column]);
        relation.push((column, RationalFunction::one()));
        without_denominators(&relation, budget)
    });
    with_last.collect()
}

/// Returns the equations of Σ cₖ vₖ = 0 with the polynomials vₖ in `vectors`: a linear equation for
/// each monomial in the states. Removes equations with a single cₖ, and marks this cₖ as 0.
fn equations(vectors: &[Polynomial], is_state: impl Fn(Variable) -> bool) -> (Vec<Row>, Vec<bool>) {
    let mut entries: Vec<(Monomial, usize, Polynomial)> = Vec::new();
    for (column, vector) in vectors.iter().enumerate() {
        let by_states = vector.group(&is_state);
        entries.extend(by_states.into_iter().map(|(states, entry)| (states, column, entry)));
    }
    entries.sort_by(|left, right| left.0.cmp(&right.0));
    let rows = entries.chunk_by(|left, right| left.0 == right.0);
    let entry = |(_, column, entry): &(Monomial, usize, Polynomial)| (*column, entry.clone());
    let mut rows: Vec<Vec<_>> = rows.map(|row| row.iter().map(entry).collect()).collect();
    let mut is_zero = vec![false; vectors.len()];
    loop {
        let alone: Vec<usize> = rows.iter().filter(|row| row.len() == 1).map(|row| row[0].0).collect();
        if alone.is_empty() {
            break;
        }
        alone.into_iter().for_each(|column| is_zero[column] = true);
        rows.iter_mut().for_each(|row| row.retain(|(column, _)| !is_zero[*column]));
        rows.retain(|row| !row.is_empty());
    }
    let function = |(column, entry): (usize, Polynomial)| (column, RationalFunction::from(entry));
    (rows.into_iter().map(|row| row.into_iter().map(function).collect()).collect(), is_zero)
}

fn without_denominators(relation: &Row, budget: &mut Budget) -> WithinBudget<Relation> {
    let entries = relation.iter().map(|(_, entry)| entry);
    let (numerators, _) = RationalFunction::over_common_within(entries, budget)?;
    let contents = numerators.iter().map(Polynomial::content);
    let content = contents.reduce(|content, next| content.gcd(&next)).expect("its last entry is not 0");
    let inverse = content.recip().expect("a content is not 0");
    let columns = relation.iter().map(|(column, _)| *column);
    Ok(columns.zip(&numerators).map(|(column, numerator)| (column, numerator.scale(&inverse))).collect())
}
