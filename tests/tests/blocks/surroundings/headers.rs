//! Optional parts of a header: attributes, documentation and all visibilities.

use std::fmt::Debug;

use kahan_core::prelude::*;

use crate::blocks::surroundings::{assert_kahan, ratio};

kahan! {
    /// A type for which the user derives more than the macro does.
    #[derive(Debug, Default, Clone, PartialEq, PartialOrd)]
    #[must_use]
    pub(crate) struct Derived {
        /// The rate.
        #[doc(alias = "speed")]
        rate,
        decay,
    }
    xdot = rate*y;
    ydot = -decay*y*x;
}

kahan! {
    #[derive(Eq, Hash)]
    struct Private;
    xdot = x*(1 - x);
}

kahan! {
    pub(in crate::blocks::surroundings::headers) struct Empty {}
    xdot = 1 + x^2;
}

/// A module with two blocks, one of which has limited visibility.
pub(super) mod inner {
    use super::kahan;

    kahan! { pub(super) struct First; xdot = x - x^2/3; }
    kahan! { pub(in super::super) struct Second { k } xdot = k*x + 1; }
}

fn is_a_plain_value<T: Clone + Debug + PartialEq>(value: &T) -> bool {
    *value == value.clone() && !format!("{value:?}").is_empty()
}

#[test]
fn attributes_and_visibilities_are_kept() {
    let derived = Derived { rate: ratio(3, 2), decay: ratio(1, 3) };
    assert_kahan(&derived);
    assert!(is_a_plain_value(&derived) && is_a_plain_value(&Private));
    assert!(Derived::<f64>::default() < Derived { rate: 1.0, decay: 0.0 });
    assert_kahan(&Private);
    assert_kahan(&Empty);
    assert_kahan(&inner::First);
    assert_kahan(&inner::Second { k: ratio(1, 2) });
}

#[test]
fn values_are_copied_when_the_scalar_is() {
    let derived = Derived { rate: 1.5_f32, decay: 0.5 };
    let copy = derived;
    assert_eq!(derived, copy);
}
