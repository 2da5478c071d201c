//! The number of steps that pass over a pole of the map.
//!
//! In: the points of an orbit. Out: a count, or an estimate by signs of det A if the denominator is
//! too long. As ε grows from 0 to its value, the image x̃ moves along a curve that begins at x. If
//! the denominator of x̃ vanishes on the way, x̃ lies beyond a pole.

use kahan_core::observe::Observer;
use kahan_core::{Composition, Scalar};

use super::{MachineFloat, MapAt, RuntimeFloat, RuntimePoint};
use crate::denominator::Denominator;
use crate::engine::{split, stage_constants};

/// The number of steps over poles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PassedPoleCount {
    /// The number of steps that pass over a pole.
    pub steps: u64,
    /// Whether signs of det A replaced roots of the denominator. [`PassedPoles`] states the errors
    /// of such a count.
    pub is_lower_bound: bool,
}

/// An observer that counts the steps of an orbit over poles of the map.
///
/// Let d(x, ·) be the reduced denominator at the point x. A step from x passes over a pole if d(x,
/// ·) has a root between 0 and ε, or at ε. Double roots count. A step of a
/// [composition](MapAt::composed) passes over a pole if one of its stages does.
///
/// Roots are found as if by exact arithmetic on the given numbers. If d has too many terms to be
/// expanded, steps with det A(x,ε) < 0 are counted. This count misses steps over an even number of
/// roots, and includes steps over removable zeros of det A.
///
/// Cost of each step: an evaluation of d in floats, or, if d was not expanded, one elimination.
/// Near double roots, exact numbers are used, which are much slower.
///
/// ```
/// use std::ops::ControlFlow;
///
/// use kahan_runtime::{Field, Follow, PassedPoles};
///
/// // 1/x falls by 0.14 in each step, from 1 to 0.02 and then to −0.12.
/// let map = Field::parse("xdot = x^2;").unwrap().map().unwrap().at(0.07);
/// let mut x = [1.0];
/// let goes_on = |_| ControlFlow::Continue(());
/// let followed = map.observe(&mut x, 10, PassedPoles::of(&map), goes_on).unwrap();
/// assert_eq!((followed.report.steps, followed.report.is_lower_bound), (1, false));
/// assert!(x[0] < 0.0);
/// ```
#[derive(Clone, Debug)]
pub struct PassedPoles<'a, T: MachineFloat> {
    at: &'a MapAt<T>,
    place: RuntimePoint<T>,
    passed: PassedPoleCount,
}

impl<'a, T: MachineFloat> PassedPoles<'a, T> {
    /// Counts along orbits of this map.
    #[must_use]
    pub fn of(at: &'a MapAt<T>) -> Self {
        PassedPoles { at, place: RuntimePoint::new(), passed: PassedPoleCount::default() }
    }
}

impl<T: MachineFloat> Observer<T> for PassedPoles<'_, T> {
    type Report = PassedPoleCount;

    const MAY_END: bool = false;

    fn observe(&mut self, step: u64, x: &[T]) {
        if step > 0 {
            let passes = self.at.passes_a_pole(&mut self.place, &mut self.passed.is_lower_bound);
            self.passed.steps += u64::from(passes);
        }
        self.place.clear();
        self.place.extend_from_slice(x);
    }

    fn report(self) -> PassedPoleCount {
        self.passed
    }
}

#[derive(Clone, Debug)]
pub(super) struct StagePoles<T: RuntimeFloat> {
    map: MapAt<T>,
    denominator: Option<Denominator>,
}

impl<T: MachineFloat> MapAt<T> {
    /// Returns whether the step from `x` passes over a pole. For a composition, overwrites `x`.
    fn passes_a_pole(&self, x: &mut [T], is_lower_bound: &mut bool) -> bool {
        let stages = self.poles.get_or_init(|| self.stage_poles());
        let last = 2 * stages.len() - 2;
        for k in 0..=last {
            let StagePoles { map, denominator } = &stages[k.min(last - k)];
            let point: RuntimePoint<f64> = x.iter().map(Scalar::approximate).collect();
            let passes = match denominator {
                Some(denominator) => denominator.has_root(&point),
                None => {
                    *is_lower_bound = true;
                    let constants: Vec<f64> = map.constants.iter().map(Scalar::approximate).collect();
                    self.engine().has_negative_determinant(&constants, &point)
                }
            };
            if passes {
                return true;
            }
            if k < last {
                map.advance_checked([x, &mut []], 1);
            }
        }
        false
    }

    fn stage_poles(&self) -> Vec<StagePoles<T>> {
        let field = self.map.field();
        let kahan = self.composed(Composition::KAHAN);
        let of_stage = |constants: Vec<T>| {
            let (parameters, eps) = split(&constants);
            let values: Vec<f64> = parameters.iter().map(Scalar::approximate).collect();
            let map = kahan.at_constants(self.map.clone(), parameters.iter().copied(), eps);
            let denominator = field.derived().map.as_ref().and_then(|map| {
                let symbols = &field.system().field.symbols;
                Denominator::of(symbols, &map.reduced.denominator, &values, eps.approximate())
            });
            StagePoles { map, denominator }
        };
        stage_constants(self.kind, &self.constants, self.composition).into_iter().map(of_stage).collect()
    }
}
