//! Claims with `when`, at the values that the conditions fix.

use kahan_core::prelude::*;
use kahan_systems::E7;

use crate::blocks::surroundings::{DeterminantByRows, assert_kahan, ratio};

kahan! {
    /// Three growing states; their sum is an integral if c = −a − b.
    pub(super) struct Three { a, b, c }
    xdot = a*x*y;
    ydot = b*x*y;
    zdot = c*x*y;
    integral total = c*(x + y + z) when c = -a - b;
    integral step = eps*c*(x + y + z) when eps = 1, c = -a - b;
}

const EPS: (i64, i64) = (2, 7);

#[test]
fn conditional_claims_of_the_catalog_hold_where_they_are_made() {
    let eps = || ratio(EPS.0, EPS.1);
    let one = E7 { xi: ratio(1, 1) };
    let (x, next) = assert_kahan(&one);
    let jacobian = one.jacobian(&x, eps());
    let two = E7 { xi: ratio(2, 1) };
    let (_, next_of_two) = assert_kahan(&two);
    assert_eq!(one.H1(&x, eps()), one.H1(&next, eps()));
    assert_eq!(one.K1(&x, eps()), one.K1(&next, eps()));
    assert_eq!(two.H_at_2(&x, eps()), two.H_at_2(&next_of_two, eps()));
    assert_ne!(two.H1(&x, eps()), two.H1(&next_of_two, eps()));
    assert_eq!(one.density_rho1(&next, eps()) * jacobian.determinant_by_rows(), one.density_rho1(&x, eps()));
    let carried = &jacobian * one.bracket_Q1(&x, eps()) * jacobian.transpose();
    assert_eq!(carried, one.bracket_Q1(&next, eps()));
}

#[test]
fn the_names_that_conditions_are_solved_for_have_their_values() {
    let three = |c| Three { a: ratio(1, 2), b: ratio(1, 3), c };
    let kept = three(ratio(-5, 6));
    let (x, next) = assert_kahan(&kept);
    let eps = || ratio(EPS.0, EPS.1);
    assert_eq!(kept.total(&x, eps()), kept.total(&next, eps()));
    // The condition of `total` fixes c, so the value of c in `other` is ignored.
    let other = three(ratio(7, 1));
    assert_eq!(other.total(&x, eps()), kept.total(&x, eps()));
    assert_eq!(other.total(&x, eps()), ratio(-5, 6) * x.sum());
    // The claim `step` has the accessor `integral_step`, because `step` is a method of the map.
    assert_eq!(other.integral_step(&x, eps()), ratio(-5, 6) * x.sum());
}
