//! Computes f′(x), A(x,ε) = I − ε f′(x) and b(x,ε) = x + εBx + 2εc for f(x) = Q(x,x) + Bx + c. Each
//! row is multiplied by the denominator of its component of f.

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::poly::{Polynomial, Variable};
use crate::rational_function::RationalFunction;

/// Returns the numerators of f′(x) for a field fᵢ = pᵢ/qᵢ. Entry (i, j) is ∂pᵢ/∂xⱼ.
#[must_use]
pub fn field_jacobian(field: &Field) -> Vec<Vec<Polynomial>> {
    let row = |component: &RationalFunction| {
        let mut row = vec![Polynomial::zero(); field.dimension()];
        for (state, slope) in component.numerator().gradient(|variable| field.symbols.is_state(variable)) {
            row[usize::from(state.0)] = slope;
        }
        row
    };
    field.components.iter().map(row).collect()
}

/// A sparse matrix. Each row lists nonzero entries with their columns.
pub(crate) type SparseRows = Vec<Vec<(usize, Polynomial)>>;

pub(crate) fn dense(rows: SparseRows) -> Vec<Vec<Polynomial>> {
    let columns = rows.len();
    let row = |entries: Vec<(usize, Polynomial)>| {
        let mut row = vec![Polynomial::zero(); columns];
        for (column, entry) in entries {
            row[column] = entry;
        }
        row
    };
    rows.into_iter().map(row).collect()
}

pub(crate) fn pattern(rows: &[Vec<Polynomial>]) -> Vec<Vec<bool>> {
    rows.iter().map(|row| row.iter().map(|entry| !entry.is_zero()).collect()).collect()
}

#[must_use]
pub(crate) fn matrix_of(
    mut slopes: Vec<Vec<Polynomial>>,
    epsilon: Variable,
    diagonal: impl Fn(usize) -> Polynomial,
) -> Vec<Vec<Polynomial>> {
    let minus_eps = -&Polynomial::variable(epsilon);
    for (i, row) in slopes.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry = &minus_eps * &*entry;
            if i == j {
                *entry = &*entry + &diagonal(i);
            }
        }
    }
    slopes
}

/// Returns Â = diag(q)·A for a field pᵢ/qᵢ. Entry (i, j) is qᵢδᵢⱼ − ε ∂pᵢ/∂xⱼ.
#[must_use]
pub fn scaled_matrix(field: &Field) -> Vec<Vec<Polynomial>> {
    matrix_of(field_jacobian(field), field.symbols.epsilon(), |i| field.components[i].denominator().clone())
}

/// Returns b̂ = diag(q)·b for a field pᵢ/qᵢ. With ℓᵢ and cᵢ for the linear and the constant part of
/// pᵢ, entry i is qᵢxᵢ + εℓᵢ + 2εcᵢ.
#[must_use]
pub fn scaled_rhs(field: &Field) -> Vec<Polynomial> {
    let eps = Polynomial::variable(field.symbols.epsilon());
    (0..field.dimension())
        .map(|i| {
            let start = field.components[i].denominator() * &Polynomial::variable(field.symbols.state(i));
            let constant = field.homogeneous_part(i, 0).scale(&Rational::from(2));
            &start + &(&eps * &(&field.homogeneous_part(i, 1) + &constant))
        })
        .collect()
}
