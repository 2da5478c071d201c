//! Drifts, in fields that use the keywords `drift` and `by` as names.

use kahan_core::prelude::*;

use crate::blocks::surroundings::{assert_kahan, ratio};

kahan! {
    /// A field with a parameter and a state named like the keywords of a drift.
    pub(super) struct Contextual { drift }
    bydot = by^2 + 2*drift*by;
    xdot = drift*x;
    drift by_inverse = 1/by by by_inverse - 2*eps when drift = 0;
    drift growth = x by growth*(1 + drift*eps)/(1 - drift*eps);
    drift square = x^2*growth/x by square*(growth/growth)*(1 + drift*eps)^2/(1 - drift*eps)^2;
}

kahan! {
    /// A drift that increases by a multiple of an integral in each step.
    pub(super) struct Shear;
    xdot = 0;
    ydot = x^2;
    integral slope = x;
    drift position = y by position + 2*eps*slope^2;
}

#[test]
fn the_next_value_follows_from_the_value() {
    let eps = || ratio(2, 7);
    let map = Contextual { drift: ratio(1, 3) };
    let (x, next) = assert_kahan(&map);
    assert_eq!(map.drift_growth(&x, eps())[1], map.drift_growth(&next, eps())[0]);
    assert_eq!(map.drift_square(&x, eps())[1], map.drift_square(&next, eps())[0]);
    assert_eq!(map.drift_growth(&x, eps())[0], x[1]);
    let still = Contextual { drift: ratio(0, 1) };
    let (x, next) = assert_kahan(&still);
    assert_eq!(still.drift_by_inverse(&x, eps())[1], still.drift_by_inverse(&next, eps())[0]);
    let (x, next) = assert_kahan(&Shear);
    assert_eq!(Shear.drift_position(&x, eps()), [x[1].clone(), next[1].clone()]);
}
