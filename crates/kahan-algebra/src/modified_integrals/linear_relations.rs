//! Linear relations between polynomials in the states, over the field of rational functions of the
//! parameters: sparse elimination to reduced row echelon form.

use crate::poly::{Budget, Monomial, OverBudget, Polynomial, gcd_within};
use crate::rational_function::RationalFunction;
use crate::symbols::Symbols;

/// The entries of a row or of a relation that are not zero, by ascending column.
type Row = Vec<(usize, RationalFunction)>;

/// The cost of reducing a fraction of long integers, by that of a product of them.
const COST_OF_FRACTIONS: u64 = 50;

/// The coefficients cₖ of a relation Σ cₖ vₖ = 0 that are not zero, by ascending k: polynomials in
/// the parameters with coprime integer coefficients.
pub(super) type Relation = Vec<(usize, Polynomial)>;

/// A basis of the relations Σ cₖ vₖ = 0 between polynomials vₖ, with cₖ free of states.
///
/// The basis is in reduced echelon form read from the end: the last index of a relation occurs in
/// no other one, and the last indices of a subspace are among those of the whole space.
pub(super) fn linear_relations(
    vectors: &[Polynomial],
    symbols: &Symbols,
    budget: &mut Budget,
) -> Result<Vec<Relation>, OverBudget> {
    let (rows, is_zero) = equations(vectors, symbols);
    let mut by_first: Vec<Vec<Row>> = vec![Vec::new(); vectors.len()];
    rows.into_iter().for_each(|row| by_first[row[0].0].push(row));
    let mut pivots: Vec<Option<Row>> = vec![None; vectors.len()];
    for column in 0..vectors.len() {
        let mut rows = std::mem::take(&mut by_first[column]);
        let size = |row: &Row| (row.len(), row[0].1.numerator().len() + row[0].1.denominator().len());
        let Some(best) = (0..rows.len()).min_by_key(|&index| size(&rows[index])) else { continue };
        let pivot = rows.swap_remove(best);
        let inverse = pivot[0].1.recip().expect("entries are not zero");
        let pivot: Row = pivot
            .iter()
            .map(|(column, entry)| Ok((*column, entry.mul_within(&inverse, budget)?)))
            .collect::<Result<_, _>>()?;
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
        cleared(&relation, budget)
    });
    with_last.collect()
}

/// An equation for each monomial in the states, and which coefficients are zero because an equation
/// has no other one; these stand in no equation.
fn equations(vectors: &[Polynomial], symbols: &Symbols) -> (Vec<Row>, Vec<bool>) {
    let mut entries: Vec<(Monomial, usize, Polynomial)> = Vec::new();
    for (column, vector) in vectors.iter().enumerate() {
        let by_states = vector.group(|variable| symbols.is_state(variable));
        entries.extend(by_states.into_iter().map(|(states, entry)| (states, column, entry)));
    }
    entries.sort_by(|left, right| left.0.cmp(&right.0));
    let mut rows: Vec<Vec<(usize, Polynomial)>> = Vec::new();
    for row in entries.chunk_by(|left, right| left.0 == right.0) {
        rows.push(row.iter().map(|(_, column, entry)| (*column, entry.clone())).collect());
    }
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

/// row − factor · pivot.
fn reduced(
    row: &Row,
    factor: &RationalFunction,
    pivot: &Row,
    budget: &mut Budget,
) -> Result<Row, OverBudget> {
    let words = factor.numerator().coefficient_words();
    let mut difference = Row::with_capacity(row.len() + pivot.len());
    let mut own = row.iter().peekable();
    for (column, entry) in pivot {
        while let Some(before) = own.next_if(|(other, _)| other < column) {
            difference.push(before.clone());
        }
        // Long fractions cost more than the product of their numerators, which the budget counts.
        let long = entry.numerator().coefficient_words().max(words) - 1;
        budget.charge(long.saturating_mul(long).saturating_mul(COST_OF_FRACTIONS))?;
        let product = entry.mul_within(factor, budget)?;
        let entry = match own.next_if(|(other, _)| other == column) {
            Some((_, known)) => known.sub_within(&product, budget)?,
            None => -&product,
        };
        if !entry.is_zero() {
            difference.push((*column, entry));
        }
    }
    difference.extend(own.cloned());
    Ok(difference)
}

/// The relation times the least common denominator of its coefficients, over their content.
fn cleared(relation: &Row, budget: &mut Budget) -> Result<Relation, OverBudget> {
    let mut common = Polynomial::one();
    for (_, entry) in relation {
        common = common_multiple(&common, entry.denominator(), budget)?;
    }
    let mut numerators = Relation::new();
    for (column, entry) in relation {
        let cofactor = common.div_within(entry.denominator(), budget)?.expect("a multiple of it");
        numerators.push((*column, entry.numerator().mul_within(&cofactor, budget)?));
    }
    let contents = numerators.iter().map(|(_, numerator)| numerator.content());
    let content = contents.reduce(|content, next| content.gcd(&next)).expect("its last entry is not 0");
    let inverse = content.recip().expect("a content is not 0");
    Ok(numerators.into_iter().map(|(column, numerator)| (column, numerator.scale(&inverse))).collect())
}

/// The least common multiple.
pub(super) fn common_multiple(
    a: &Polynomial,
    b: &Polynomial,
    budget: &mut Budget,
) -> Result<Polynomial, OverBudget> {
    let cofactor = b.div_within(&gcd_within(a, b, budget)?, budget)?.expect("a common divisor divides");
    a.mul_within(&cofactor, budget)
}
