//! Steps over poles of the map, counted.
//!
//! In: the points of an orbit. Out: how many of its steps pass over a pole. A step from x takes ε
//! from 0 to its value, and x̃ along a curve; where the denominator of x̃ vanishes on the way, the
//! curve goes through infinity, and x̃ lies beyond.

use kahan_core::observe::Observer;
use kahan_core::{Composition, Scalar};

use super::{MachineFloat, MapAt, RuntimeFloat, RuntimePoint};
use crate::denominator::Denominator;
use crate::engine::{split, stage_constants};

/// How many steps pass over a pole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Passed {
    /// The steps.
    pub steps: u64,
    /// Whether there may be more: the sign of det A has been asked, which tells an odd number of
    /// roots from none.
    pub is_lower_bound: bool,
}

/// Counts the steps of an orbit that pass over a pole of the map: those whose reduced denominator
/// d(x, ε′), at the point x where the step begins, has a root ε′ in (0, ε], or for ε < 0 in [ε, 0).
/// A double root is one, too. Of a [composition](MapAt::composed) each stage is a step of Kahan's
/// map, from its own point at its own ε, and a step counts where one of its stages does.
///
/// Roots are those of exact arithmetic on the numbers that the map is given. Where the map has too
/// many terms to be written out, a step counts where det A(x,ε) < 0, as det A is 1 for ε = 0: then
/// the count is a lower bound, and a zero of det A counts as a pole, removable or not.
///
/// Cost: the terms of d a step, in floats; where these can't tell, as near double roots, in exact
/// numbers, which takes much longer. Without d an elimination a step. The stages of a
/// composition are made once more. The first count of a map puts the parameters into d.
///
/// ```
/// use std::ops::ControlFlow;
///
/// use kahan_runtime::{Field, Follow, PassedPoles};
///
/// // 1/x falls by 2ε a step, from 1 to 0.02 and on to −0.12.
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
    /// The point seen last, and for a moment those of stages.
    place: RuntimePoint<T>,
    passed: Passed,
}

impl<'a, T: MachineFloat> PassedPoles<'a, T> {
    /// The count of an orbit of this map.
    #[must_use]
    pub fn of(at: &'a MapAt<T>) -> Self {
        PassedPoles { at, place: RuntimePoint::new(), passed: Passed::default() }
    }
}

impl<T: MachineFloat> Observer<T> for PassedPoles<'_, T> {
    type Report = Passed;

    const MAY_END: bool = false;

    fn observe(&mut self, step: u64, x: &[T]) {
        if step > 0 {
            let passes = self.at.passes_a_pole(&mut self.place, &mut self.passed.is_lower_bound);
            self.passed.steps += u64::from(passes);
        }
        self.place.clear();
        self.place.extend_from_slice(x);
    }

    fn report(self) -> Passed {
        self.passed
    }
}

/// A stage of a step that differs from the others.
#[derive(Clone, Debug)]
pub(super) struct StagePoles<T: RuntimeFloat> {
    /// Kahan's map at the ε of the stage.
    map: MapAt<T>,
    /// `None` where the map is not written out.
    denominator: Option<Denominator>,
}

impl<T: MachineFloat> MapAt<T> {
    /// Whether the step from `x` passes a pole; `x` is used up. Notes where the sign of det A alone
    /// was asked.
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
