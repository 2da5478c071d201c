//! The step of a field in which products of sums of states are written, as in `(x - 1)*(y - 1)/s`:
//! from A and f as they are written, without an expansion.
//!
//! Near a zero of both sums the terms of the expanded product cancel, and a large factor, as 1/s,
//! magnifies the rounding error until it shows in the step. Cramer's rule on A·(x̃ − x) = 2εf
//! multiplies f by cofactors and leaves it as it is.

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::kahan::{dense, matrix_of, pattern};
use crate::kept::Kept;
use crate::poly::Polynomial;

use crate::plan::forms::candidate::Candidate;
use crate::plan::forms::minors::{Determinants, MOST_OPERATIONS, determinants, operations};
use crate::plan::writing::draft::Signed;
use crate::plan::writing::writer::{Entry, Writer};

/// One form for each row that the determinants are developed along last; none where there are too
/// many operations.
pub(in crate::plan) fn candidates(field: &Field, kept: &Kept) -> Vec<Candidate> {
    let n = field.dimension();
    let epsilon = field.symbols.epsilon();
    let (values, slopes) = kept.jacobian(&field.symbols);
    let eps = Polynomial::variable(epsilon);
    let mut rows = matrix_of(dense(slopes), epsilon, |_| Polynomial::one());
    for (row, component) in rows.iter_mut().zip(&kept.components) {
        row.push(&eps * component);
    }
    if operations(&pattern(&rows)) > MOST_OPERATIONS {
        return Vec::new();
    }
    let plan = values.plan(rows.iter().flatten());
    let candidate = |turn: usize| {
        let mut writer = Writer::empty(field).swap_remove(0);
        let nodes = writer.draft.builder.include(&plan);
        let entry = |node| Entry { polynomial: None, written: Signed::plus(node) };
        let mut rows: Vec<Vec<Entry>> =
            nodes.chunks(n + 1).map(|row| row.iter().copied().map(entry).collect()).collect();
        // An odd order of the rows changes all signs, which cancel in the quotients.
        rows.rotate_left(turn);
        let Determinants { denominator, numerators } = determinants(&mut writer, &rows);
        let reciprocal = writer.reciprocal(&Rational::from(2), denominator.node);
        let over = |numerator| (numerator, reciprocal, denominator.negative);
        Candidate::over(writer, numerators.into_iter().map(over))
    };
    (0..n).map(candidate).collect()
}
