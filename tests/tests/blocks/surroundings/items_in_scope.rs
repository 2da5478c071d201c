//! Scopes in which names of generated code, and names of the states, have other meanings.

#[allow(
    dead_code,
    missing_docs,
    non_camel_case_types,
    non_upper_case_globals,
    reason = "names to be in the way"
)]
#[allow(clippy::pedantic, reason = "names to be in the way")]
mod crowd {
    pub(super) struct Option;
    pub(super) struct Some;
    pub(super) struct Result;
    pub(super) struct Clone;
    pub(super) struct Copy;
    pub(super) struct Debug;
    pub(super) struct PartialEq;
    pub(super) struct str;
    pub(super) struct f32;
    pub(super) struct f64;
    pub(super) struct u64;
    pub(super) struct SVector;
    pub(super) struct SMatrix;
    pub(super) struct Dual;
    pub(super) mod core {}
    pub(super) mod std {}
    pub(super) mod kahan_core {}
    pub(super) mod __kahan {}
    pub(super) mod nalgebra {}
    pub(super) trait Scalar {}
    pub(super) trait QuadraticField {}
    pub(super) trait KahanMap {}
    pub(super) trait Named {}
    pub(super) const x: i8 = 1;
    pub(super) static y: i8 = 2;
    pub(super) struct z;
    pub(super) const mu: i8 = 3;
    pub(super) struct eps;
    pub(super) const prepared: i8 = 4;
    pub(super) static convert: i8 = 5;
    pub(super) fn reduced() {}
    pub(super) fn vector() {}

    ::kahan_core::kahan! {
        /// A system whose names have other meanings in this scope.
        pub(super) struct E7 { mu }
        xdot = -x^2;
        ydot = -mu*x*y;
        zdot = 2*mu*y^2 + x*z;
        density rho = 1/(x*y*(1 - eps^2*x^2));
        integral H = y when mu = 0, eps = 1;
    }
}

use crate::blocks::surroundings::{assert_kahan, ratio};

#[test]
fn items_in_scope_do_not_capture_what_is_generated() {
    assert_kahan(&crowd::E7 { mu: ratio(3, 2) });
}
