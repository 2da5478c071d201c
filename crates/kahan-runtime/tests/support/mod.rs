//! Fields that are read over ℚ, and points at which these fields are compared with compiled fields.

use kahan_core::Scalar;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_runtime::interpreted::{Interpreted, round};
use kahan_runtime::{Field, Rational};

/// Reads a field over ℚ, with values of its parameters in the order of declaration.
pub(crate) fn read<const N: usize>(text: &str, parameters: &[BigRational]) -> Interpreted<BigRational, N> {
    let field = Field::parse(text).expect("a field");
    let map = field.with(field.parameters().iter().zip(parameters)).expect("a value for each parameter");
    map.as_kahan_map().expect("as many variables")
}

pub(crate) fn q(text: &str) -> BigRational {
    Rational::parse(text).expect("a number").to_big()
}

pub(crate) fn samples<T: Scalar, const N: usize>(count: usize) -> Vec<(SVector<T, N>, T)> {
    let mut state = 20_260_801_u64;
    let mut next = |modulus: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from((state >> 33) % modulus).expect("small")
    };
    (0..count)
        .map(|_| {
            let point = SVector::from_fn(|_, _| round(&Rational::new(next(41) - 20, 7)));
            (point, round(&Rational::new(2 * next(20) + 1, 11 * 23)))
        })
        .collect()
}
