//! Tests poles over the rationals, and the values of the map at removable poles.

use std::format;
use std::panic::catch_unwind;
use std::string::String;

use num_traits::{One, Zero};

use super::by_hand::{Coupled, E1, E3, E7};
use super::rationals::{Q, q};
use crate::{KahanMap, vector};

#[test]
fn e3_has_a_value_at_its_removable_pole() {
    let (x, eps) = (vector![q(3, 2), q(1, 1), q(-2, 1)], q(1, 2));
    let next = vector![q(24, 13), q(16, 13), q(2, 1)];
    assert!(E3.det_matrix(&x, eps.clone()).is_zero());
    assert_eq!(E3.step(&x, eps.clone()), next);
    assert_eq!(E3.try_step(&x, eps.clone()), Ok(next.clone()));
    assert_eq!(E3.orbit(x.clone(), eps.clone()).nth(1), Some(next.clone()));
    assert_eq!(E3.det_jacobian(&x, eps.clone()), q(4096, 2197));
    assert_eq!(E3.step_back(&next, eps), x);
}

#[test]
fn e1_has_a_value_at_its_removable_pole() {
    let (x, eps) = (vector![q(-2, 1), q(1, 1), q(1, 3)], q(1, 2));
    let next = vector![q(2, 1), q(-1, 1), q(-2, 3)];
    assert!(E1.det_matrix(&x, eps.clone()).is_zero());
    assert_eq!(E1.step(&x, eps.clone()), next);
    assert_eq!(E1.det_jacobian(&x, eps.clone()), -Q::one());
    // The map of E7 keeps the factor that cancels at ξ = 1. The step fails where this factor is 0.
    assert!(E7 { xi: q(1, 1) }.try_step(&x, eps).is_err());
}

#[test]
fn at_a_removable_pole_the_rational_map_is_all_zeros() {
    let (x, eps) = (vector![q(3, 2), q(1, 1), q(-2, 1)], q(1, 2));
    let (numerators, denominator) = E3.rational_map(&x, eps);
    assert!(denominator.is_zero());
    assert!(numerators.iter().all(Q::is_zero));
}

#[test]
fn a_pole_is_an_error_that_names_the_determinant_and_eps() {
    let error = E1.try_step(&vector![q(-1, 1), q(1, 1), q(0, 1)], q(1, 2)).unwrap_err();
    assert_eq!((error.determinant(), error.eps()), (0.0, 0.5));
    let text = format!("{error}");
    assert!(text.contains("det A = 0") && text.contains("pole") && text.contains("eps = 0.5"), "{text}");
}

#[test]
fn elimination_reports_its_pole() {
    // At x = y = z = w = 0, the matrix A has the determinant (1 + 2ε)(1 − ε)(1 + ε²).
    let origin = vector![Q::zero(), Q::zero(), Q::zero(), Q::zero()];
    assert!(Coupled.det_matrix(&origin, q(-1, 2)).is_zero());
    assert!(Coupled.try_step(&origin, q(-1, 2)).is_err());
    assert!(Coupled.try_step(&origin, q(1, 1)).is_err());
    assert!(Coupled.try_step(&origin, q(1, 2)).is_ok());
}

#[test]
fn an_exact_step_at_a_pole_panics_and_says_so() {
    let pole = || vector![q(-1, 1), q(1, 1), q(0, 1)];
    let message = |result: std::thread::Result<()>| *result.unwrap_err().downcast::<String>().unwrap();
    let step = message(catch_unwind(|| drop(E1.step(&pole(), q(1, 2)))));
    let jacobian = message(catch_unwind(|| drop(E1.jacobian(&pole(), q(1, 2)))));
    let origin = || vector![Q::zero(), Q::zero(), Q::zero(), Q::zero()];
    let eliminated = message(catch_unwind(|| drop(Coupled.jacobian(&origin(), q(1, 1)))));
    for text in [step, jacobian, eliminated] {
        assert!(text.contains("det A = 0"), "{text}");
    }
}

#[test]
fn an_exact_orbit_ends_at_a_pole_and_says_why() {
    // By x̃ = x/(1 + 2εx), the orbit is x = −1/4, −1/3, −1/2, −1, ∞.
    let mut orbit = E1.orbit(vector![q(-1, 4), q(1, 1), q(1, 1)], q(1, 2));
    let mut length = 0;
    while orbit.next().is_some() {
        assert_eq!(orbit.stopped(), None);
        length += 1;
    }
    assert_eq!(length, 4);
    assert_eq!(orbit.stopped().map(|why| (why.determinant(), why.eps())), Some((0.0, 0.5)));
    assert_eq!(orbit.next(), None);
}
