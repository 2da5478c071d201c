//! One way of advancing a state, as something that can be run for a number of steps.
//!
//! In: a starting point and a function from state to state. Out: a loop of dependent steps,
//! compiled on its own for each contender, so that all loops are alike. Chains begin anew every
//! [`SEGMENT`] steps: no orbit has time to leave the range in which arithmetic takes its usual
//! time.

use std::hint::black_box;

/// The steps after which a chain begins anew.
const SEGMENT: usize = 2048;

/// What a contender is to the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// What all ratios refer to: the generated step, prepared.
    Baseline,
    /// The generated code, called in another way.
    Generated,
    /// Careful code for this one system.
    ByHand,
    /// Something else that a user could have taken.
    Rival,
}

/// A named chain of dependent steps.
pub(crate) struct Contender {
    pub(crate) name: &'static str,
    pub(crate) role: Role,
    run: Box<dyn Fn(usize)>,
}

impl Contender {
    /// A contender that goes from state to state by `step`, beginning with `start`.
    pub(crate) fn new<const N: usize>(
        name: &'static str,
        role: Role,
        start: [f64; N],
        step: impl Fn([f64; N]) -> [f64; N] + 'static,
    ) -> Self {
        let run = move |steps| {
            for done in (0..steps).step_by(SEGMENT) {
                let length = SEGMENT.min(steps - done);
                black_box(chain(black_box(&step), black_box(start), length));
            }
        };
        Self { name, role, run: Box::new(run) }
    }

    /// A contender that runs by itself: `orbit` is called with a starting point and a number of
    /// steps.
    pub(crate) fn of_orbit<const N: usize>(
        name: &'static str,
        role: Role,
        start: [f64; N],
        orbit: impl Fn([f64; N], usize) -> [f64; N] + 'static,
    ) -> Self {
        let run = move |steps| {
            for done in (0..steps).step_by(SEGMENT) {
                let length = SEGMENT.min(steps - done);
                black_box(black_box(&orbit)(black_box(start), length));
            }
        };
        Self { name, role, run: Box::new(run) }
    }

    /// Runs that many steps.
    pub(crate) fn run(&self, steps: usize) {
        (self.run)(steps);
    }
}

/// The loop that is measured.
#[inline(never)]
fn chain<const N: usize>(step: &impl Fn([f64; N]) -> [f64; N], mut x: [f64; N], steps: usize) -> [f64; N] {
    for _ in 0..steps {
        x = step(x);
    }
    x
}
