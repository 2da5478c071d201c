//! Scopes without the prelude, where even `Option` and `Clone` are unknown.

mod bare {
    #![no_implicit_prelude]

    ::kahan_core::kahan! {
        /// A system in a scope without the prelude.
        pub(super) struct E1;
        xdot = -x^2;
        ydot = -x*y;
        zdot = 2*y^2 + x*z;
        integral H = y/x;
        density rho = 1/(x*y*(x*z + y^2));
        bracket P { {y,z} = y*(1 - eps^2*x^2); {z,x} = -x*(1 - eps^2*x^2); }
    }

    ::kahan_core::kahan! {
        /// A system with a parameter and a constant that no float represents exactly.
        pub(super) struct Damped { mu }
        xdot = y/(1 + mu^2);
        ydot = -mu*x - 12345678901234567890.123456789*y;
    }

    pub(super) fn next(
        x: ::kahan_core::nalgebra::SVector<f64, 1>,
    ) -> ::kahan_core::nalgebra::SVector<f64, 1> {
        let mu = 2.0_f64;
        let field = ::kahan_core::kahan! { xdot = -mu*x; };
        ::kahan_core::KahanMap::step(&field, &x, 0.25)
    }
}

use kahan_core::prelude::*;

use crate::blocks::surroundings::{assert_kahan, ratio};

#[test]
fn a_block_needs_nothing_in_scope() {
    let (x, next) = assert_kahan(&bare::E1);
    assert_eq!(bare::E1.integrals(&x, ratio(2, 7)), bare::E1.integrals(&next, ratio(2, 7)));
    assert_eq!(
        bare::E1.density(&next, ratio(2, 7)) * bare::E1.det_jacobian(&x, ratio(2, 7)),
        bare::E1.density(&x, ratio(2, 7))
    );
    assert_eq!(bare::E1.bracket_P(&x, ratio(2, 7))[(0, 1)], ratio(0, 1));
    assert_kahan(&bare::Damped { mu: ratio(3, 2) });
}

#[test]
fn a_block_without_a_header_needs_nothing_in_scope() {
    // The exact step is x̃ = (1 − εμ)/(1 + εμ) x.
    assert!((bare::next(vector![3.0])[0] - 1.0).abs() < 1e-15);
}
