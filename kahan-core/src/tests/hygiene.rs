//! Tests the macros in a scope without a prelude, beside user types named like prelude items.

mod scope {
    #![no_implicit_prelude]
    #![allow(dead_code, reason = "names to be in the way")]

    struct Option;
    struct Clone;

    pub(super) fn state() -> crate::nalgebra::SVector<f32, 2> {
        crate::vector![1.0, 2.0,]
    }
}

#[test]
fn vector_needs_nothing_in_scope() {
    assert_eq!(scope::state(), nalgebra::SVector::<f32, 2>::new(1.0, 2.0));
}
