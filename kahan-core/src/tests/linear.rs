//! Tests elimination over floats: backward errors, singular matrices, infinities and NaNs.

use nalgebra::{SMatrix, SVector};

use crate::field::linear::{determinant, determinant_and_adjugate_product, solve};

type Matrix = SMatrix<f64, 3, 3>;

fn awkward() -> Matrix {
    Matrix::new(1e-20, 2.0, -1.0, 4.0, 0.5, 3.0, -2.0, 1.0, 7.0)
}

#[test]
fn pivoting_keeps_the_residual_at_the_level_of_rounding() {
    let (a, b) = (awkward(), SVector::<f64, 3>::new(1.0, -2.0, 0.5));
    let x = solve(a, b).unwrap();
    let residual = (a * x - b).amax();
    assert!(residual <= 8.0 * f64::EPSILON * a.amax() * x.amax(), "residual {residual:e}");
}

#[test]
fn both_determinants_agree_to_rounding() {
    let a = awkward();
    let (_, division_free) = determinant_and_adjugate_product(&a, &SVector::zeros());
    // The permanent of |A|, which is below 100, bounds every intermediate sum.
    assert!((determinant(a) - division_free).abs() <= 64.0 * f64::EPSILON * 100.0);
    assert!((determinant(a) + 73.0).abs() <= 64.0 * f64::EPSILON * 100.0, "{}", determinant(a));
}

#[test]
fn a_singular_matrix_has_determinant_zero_and_no_finite_solution() {
    let a = Matrix::new(1.0, 2.0, 4.0, 2.0, 4.0, 8.0, 0.5, 1.0, 2.0);
    assert_eq!(determinant(a), 0.0);
    let x = solve(a, SVector::<f64, 3>::new(1.0, 1.0, 1.0)).unwrap();
    assert!(x.iter().any(|entry| !entry.is_finite()));
    assert_eq!(determinant(Matrix::zeros()), 0.0);
}

#[test]
fn what_is_not_a_number_is_never_hidden() {
    for place in [(0, 0), (1, 0), (2, 0), (0, 1), (2, 2)] {
        let mut a = Matrix::identity();
        a[place] = f64::NAN;
        assert!(determinant(a).is_nan(), "{place:?}");
        assert!(solve(a, SVector::<f64, 3>::new(1.0, 1.0, 1.0)).unwrap().iter().any(|entry| entry.is_nan()));
    }
    let beside_zeros = Matrix::new(0.0, 1.0, 0.0, f64::NAN, 0.0, 1.0, 0.0, 1.0, 1.0);
    assert!(determinant(beside_zeros).is_nan());
}
