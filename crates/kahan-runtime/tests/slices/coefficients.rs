//! Fields made from their coefficients.

use kahan_core::nalgebra::{DMatrix, Matrix2, Vector2};
use kahan_runtime::{CoefficientError, Coefficients, Field};

fn of_text(text: &str) -> Field {
    Field::parse(text).unwrap()
}

#[test]
fn slices_and_matrices_are_the_field_of_a_text() {
    let text = of_text("x1dot = 1/2 + x2 - 3*x1*x2; x2dot = x1/4 + x2^2;");
    let (c, b) = ([0.5, 0.0], [0.0, 1.0, 0.25, 0.0]);
    // Quadratic coefficients: `whole` has all ordered pairs xⱼxₖ; `once` has x₁², x₂x₁ and x₂².
    let whole = [0.0, -1.0, -2.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let once = [0.0, -3.0, 0.0, 0.0, 0.0, 1.0];
    let matrices = Field::from_coefficients(
        &Vector2::from(c),
        &Matrix2::from_row_slice(&b),
        &DMatrix::from_row_slice(2, 4, &whole),
    );
    for field in [Field::from_coefficients(&c, &b, &whole), Field::from_coefficients(&c, &b, &once), matrices]
    {
        assert_eq!(field.unwrap().system().field, text.system().field);
    }
}

#[test]
fn the_size_is_that_of_any_array() {
    for n in 1..12_usize {
        for columns in [n * n, n * (n + 1) / 2] {
            let q = vec![1.0; n * columns];
            assert_eq!(Field::from_coefficients(&[], &[], &q).unwrap().variables().len(), n, "{columns}");
        }
        let b = vec![1.0; n * n];
        assert_eq!(Field::from_coefficients(&[], &b, &[]).unwrap().variables().len(), n);
    }
}

#[test]
fn wrong_arrays_are_told() {
    let told = |c: &[f64], b: &[f64], q: &[f64]| Field::from_coefficients(c, b, q).unwrap_err().to_string();
    assert_eq!(told(&[1.0, 2.0], &[1.0], &[]), "B has 1 numbers; it needs 4");
    assert_eq!(told(&[1.0, 2.0], &[], &[1.0; 7]), "Q has 7 numbers; it needs 8 or 6");
    assert_eq!(told(&[f64::NAN], &[], &[]), "a coefficient of component 0 is not finite");
    assert!(told(&[], &[], &[1.0; 5]).starts_with("Q has 5 numbers"));
}

#[test]
fn entries_have_components_states_and_parameters_of_the_field() {
    let mut field = Coefficients::new(["u", "v"], ["a"]).unwrap();
    let mistake = field.add(2, [None, None], None, 1.0).unwrap_err();
    assert_eq!(mistake, CoefficientError::OutOfRange { what: "component", index: 2, count: 2 });
    assert!(
        field.add(0, [Some(0), Some(2)], None, 1.0).is_err()
            && field.add(0, [None; 2], Some(1), 1.0).is_err()
    );
    field.add(1, [Some(1), Some(0)], Some(0), 0.5).unwrap();
    let text = field.text();
    assert_eq!(text.given(), "udot = 0;\nvdot = 1/2*a*u*v;");
    assert_eq!(text.system().unwrap().field, of_text(text.given()).system().field);
    assert!(Coefficients::new(["eps"], []).is_err() && Coefficients::new(["x", "x"], []).is_err());
}
