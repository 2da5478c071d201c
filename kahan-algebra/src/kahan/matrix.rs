//! f′(x), the matrix A(x,ε) = I − ε f′(x) and the right-hand side b(x,ε) = x + εBx + 2εc.

use crate::field::Field;
use crate::poly::Polynomial;
use crate::rational::Rational;

/// The numerators of f′(x): entry (i, j) is ∂pᵢ/∂xⱼ, over qᵢ.
#[must_use]
pub fn field_jacobian(field: &Field) -> Vec<Vec<Polynomial>> {
    let n = field.dimension();
    field
        .components
        .iter()
        .map(|component| (0..n).map(|j| component.numerator.derivative(field.symbols.state(j))).collect())
        .collect()
}

/// Â = diag(q) A: entry (i, j) is qᵢδᵢⱼ − ε ∂pᵢ/∂xⱼ.
#[must_use]
pub fn scaled_matrix(field: &Field) -> Vec<Vec<Polynomial>> {
    let minus_eps = -&Polynomial::variable(field.symbols.epsilon());
    let mut matrix = field_jacobian(field);
    for (i, row) in matrix.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry = &minus_eps * &*entry;
            if i == j {
                *entry = &*entry + &field.components[i].denominator;
            }
        }
    }
    matrix
}

/// b̂ = diag(q) b: entry i is qᵢxᵢ + ε(linear part of pᵢ) + 2ε(constant part of pᵢ).
#[must_use]
pub fn scaled_rhs(field: &Field) -> Vec<Polynomial> {
    let eps = Polynomial::variable(field.symbols.epsilon());
    (0..field.dimension())
        .map(|i| {
            let start = &field.components[i].denominator * &Polynomial::variable(field.symbols.state(i));
            let constant = field.homogeneous_part(i, 0).scale(&Rational::from(2));
            &start + &(&eps * &(&field.homogeneous_part(i, 1) + &constant))
        })
        .collect()
}
