//! Computes det(I − ε f′) of a field f, times its denominators, even if the map has too many terms
//! to be expanded.

use kahan_algebra::field::Field;
use kahan_algebra::kahan::{maximal_minors, scaled_matrix};
use kahan_algebra::poly::{Budget, OverBudget, Polynomial};

/// The greatest number of variables, because a minor is stored for every subset of the columns.
const MOST_VARIABLES: usize = 12;

/// Returns ∏q · det(I − ε f′), where qᵢ is the denominator of component i of the field f.
///
/// # Errors
/// Returns [`OverBudget`] beyond the budget, or for more than 12 variables.
pub fn determinant(field: &Field, budget: &mut Budget) -> Result<Polynomial, OverBudget> {
    of_matrix(&scaled_matrix(field), budget)
}

/// Returns q·gᵀ adj(A) f for the field f and the covector g, where A = I − ε f′, and q is the
/// product of the denominators of all components of f. The quotient by [`determinant`] is gᵀ A⁻¹ f.
///
/// # Errors
/// Returns [`OverBudget`] beyond the budget, or for more than 12 variables.
pub fn bordered_determinant(
    field: &Field,
    covector: &[Polynomial],
    budget: &mut Budget,
) -> Result<Polynomial, OverBudget> {
    let mut rows = scaled_matrix(field);
    for (row, component) in rows.iter_mut().zip(&field.components) {
        row.push(component.numerator().clone());
    }
    rows.push(covector.iter().cloned().chain([Polynomial::zero()]).collect());
    Ok(-&of_matrix(&rows, budget)?)
}

fn of_matrix(rows: &[Vec<Polynomial>], budget: &mut Budget) -> Result<Polynomial, OverBudget> {
    if rows.len() > MOST_VARIABLES + 1 {
        return Err(OverBudget);
    }
    Ok(maximal_minors(rows, budget)?.into_values().next().unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::kahan::RationalMap;
    use kahan_algebra::{lexer, read};

    #[test]
    fn both_are_those_of_the_rational_map() {
        let text = "xdot = a*y*z + x/b; ydot = z*x - 2; zdot = x*y + b*x^2;";
        let field = read(&lexer::lex(text).tokens).system().expect("a system").field;
        let map = RationalMap::of(&field).unwrap();
        let mut budget = Budget::new(1000, 1_000_000);
        assert_eq!(determinant(&field, &mut budget).unwrap(), map.denominator);
        let two_eps = Polynomial::variable(field.symbols.epsilon()).scale(&2.into());
        for i in 0..3 {
            let mut unit = vec![Polynomial::zero(); 3];
            unit[i] = Polynomial::one();
            let increment = bordered_determinant(&field, &unit, &mut budget).unwrap();
            let moved = &map.denominator * &Polynomial::variable(field.symbols.state(i));
            assert_eq!(moved + &two_eps * &increment, map.numerators[i]);
        }
    }
}
