//! Fields, points, and comparison bit for bit.

use std::fmt::Debug;

use kahan_core::Scalar;
use kahan_runtime::{Field, MachineFloat};
use kahan_systems::registry::find;

pub(crate) fn catalog(command: &str) -> Field {
    Field::parse(find(command).expect("in the catalog").text()).expect("a field")
}

pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, modulus: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        u32::try_from((self.0 >> 33) % u64::from(modulus)).expect("small")
    }

    pub(crate) fn point<T: MachineFloat>(&mut self, n: usize) -> Vec<T> {
        (0..n).map(|_| number::<T>(f64::from(self.below(41)) - 20.0) / number(7.0)).collect()
    }
}

pub(crate) fn number<T: MachineFloat>(value: f64) -> T {
    kahan_runtime::interpreted::round(
        &kahan_algebra::rational::Rational::from_f64(value).expect("a finite number"),
    )
}

/// Returns ordinary values of ε, values too small or too large to divide by, and 0.
pub(crate) fn steps<T: MachineFloat>() -> Vec<T> {
    let powers = [-140, -70, -20, 15, 17, 65, 100].map(|power| f64::from(power).exp2());
    let sizes = [0.0, 0.05, 1.0 / 7.0, 0.5, 3.0].into_iter().chain(powers);
    let single = |value: f64| value == 0.0 || (value as f32 != 0.0 && (value as f32).is_finite());
    let fits = |value: &f64| size_of::<T>() == 8 || single(*value);
    sizes.filter(fits).flat_map(|size| [number::<T>(size), -number::<T>(size)]).collect()
}

pub(crate) fn same<T: Scalar>(a: &T, b: &T) -> bool {
    let is_number = |value: &T| *value == value.clone();
    let sign = |value: &T| (T::one() / value.clone()).approximate().is_sign_negative();
    match (is_number(a), is_number(b)) {
        (true, true) => a == b && sign(a) == sign(b),
        (one, other) => one == other,
    }
}

pub(crate) fn assert_same<'a, T: Scalar>(
    found: impl IntoIterator<Item = &'a T, IntoIter: ExactSizeIterator>,
    expected: impl IntoIterator<Item = &'a T, IntoIter: ExactSizeIterator>,
    what: impl Debug,
) {
    let (found, expected) = (found.into_iter(), expected.into_iter());
    assert_eq!(found.len(), expected.len(), "{what:?}");
    for (a, b) in found.zip(expected) {
        assert!(same(a, b), "{what:?}: {a:?} and {b:?}");
    }
}
