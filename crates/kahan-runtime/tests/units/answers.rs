//! Collects results in any units of length and time, and converts them to the reference units.

use core::fmt::Debug;

use kahan_core::{FloatScalar, nalgebra::SVector};

use super::fields::{ORDINARY, Unit, two_to};

/// Named results, in the order in which they were added.
pub(crate) struct Answers {
    unit: Unit,
    all: Vec<(String, Vec<f64>)>,
}

/// The exponents of length and of time in a number's physical dimension.
#[derive(Clone, Copy)]
pub(crate) struct Dimension {
    pub(crate) length: i32,
    pub(crate) time: i32,
}

pub(crate) const NUMBER: Dimension = Dimension { length: 0, time: 0 };
pub(crate) const LENGTH: Dimension = Dimension { length: 1, time: 0 };
pub(crate) const AREA: Dimension = Dimension { length: 2, time: 0 };
pub(crate) const TIME: Dimension = Dimension { length: 0, time: 1 };
pub(crate) const RATE: Dimension = Dimension { length: 0, time: -1 };
pub(crate) const SPEED: Dimension = Dimension { length: 1, time: -1 };

impl Answers {
    pub(crate) fn new(unit: Unit) -> Self {
        Self { unit, all: Vec::new() }
    }

    pub(crate) fn add<T: FloatScalar>(&mut self, name: &str, dimension: Dimension, numbers: &[T]) {
        let Dimension { length, time } = dimension;
        let back = |number: &T| {
            // The factors are multiplied one after the other, because their product may overflow.
            number.approximate() * two_to(self.unit.length * length) * two_to(self.unit.time * time)
        };
        self.all.push((name.to_owned(), numbers.iter().map(back).collect()));
    }

    pub(crate) fn add_point<T: FloatScalar, const N: usize>(&mut self, name: &str, point: &SVector<T, N>) {
        self.add(name, LENGTH, point.as_slice());
    }

    pub(crate) fn say(&mut self, name: &str, what: impl Debug) {
        self.all.push((format!("{name}: {what:?}"), Vec::new()));
    }
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// Panics if the results in any of these units differ from those in reference units.
pub(crate) fn check_units(name: &str, units: &[Unit], answer: impl Fn(Unit, &mut Answers)) {
    let of = |unit| {
        let mut answers = Answers::new(unit);
        answer(unit, &mut answers);
        answers.all
    };
    let ordinary = of(ORDINARY);
    for &unit in units {
        let there = of(unit);
        assert_eq!(ordinary.len(), there.len(), "{name} in {unit:?}");
        for ((what, numbers), (other, others)) in ordinary.iter().zip(&there) {
            assert_eq!(what, other, "{name} in {unit:?}");
            let are_same =
                numbers.len() == others.len() && numbers.iter().zip(others).all(|(a, b)| same(*a, *b));
            assert!(are_same, "{name} in {unit:?}: {what} is {numbers:?}, not {others:?}");
        }
    }
}
