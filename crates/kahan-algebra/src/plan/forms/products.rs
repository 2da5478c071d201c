//! Writes the step of a field with products of sums, such as `(x - 1)*(y - 1)/s`.
//!
//! Where x − 1 and y − 1 are near 0, the terms of the expanded product cancel, and division by a
//! small s magnifies the rounding error. Cramer's rule for A·(x̃ − x) = 2εf keeps the products.

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::kahan::{dense, matrix_of, pattern};
use crate::poly::Polynomial;
use crate::subexpressions::FieldWithSubexpressions;

use crate::plan::forms::candidate::Candidate;
use crate::plan::forms::minors::{Determinants, MOST_OPERATIONS, determinants, operations};
use crate::plan::writing::plan_draft::Signed;
use crate::plan::writing::writer::{MatrixEntry, Writer};

/// Returns a candidate for each choice of the last row in Laplace expansion, but none that needs
/// too many operations.
pub(in crate::plan) fn candidates(field: &Field, kept: &FieldWithSubexpressions) -> Vec<Candidate> {
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
        let entry = |node| MatrixEntry { polynomial: None, written: Signed::plus(node) };
        let mut rows: Vec<Vec<MatrixEntry>> =
            nodes.chunks(n + 1).map(|row| row.iter().copied().map(entry).collect()).collect();
        // An odd permutation changes the signs of all determinants, but not the quotients.
        rows.rotate_left(turn);
        let Determinants { denominator, numerators } = determinants(&mut writer, &rows);
        let reciprocal = writer.reciprocal(&Rational::from(2), denominator.node);
        let over = |numerator| (numerator, reciprocal, denominator.negative);
        Candidate::over(writer, numerators.into_iter().map(over))
    };
    (0..n).map(candidate).collect()
}
