//! Contenders, each of which makes a given number of steps. After every [`SEGMENT`] steps, the
//! orbit starts again at the initial state.

use std::hint::black_box;

const SEGMENT: usize = 2048;

/// The role of a contender in the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// The reference of all ratios, which is the generated, prepared step.
    Baseline,
    /// Generated code that is called in another way than the baseline.
    Generated,
    ByHand,
    /// A method that a user could choose instead of generated code.
    Rival,
}

pub(crate) struct Contender {
    pub(crate) name: &'static str,
    pub(crate) role: Role,
    run: Box<dyn Fn(usize)>,
}

impl Contender {
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

    /// Makes a contender from a function `orbit` of an initial state and a number of steps.
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

    pub(crate) fn run(&self, steps: usize) {
        (self.run)(steps);
    }
}

#[inline(never)]
fn chain<const N: usize>(step: &impl Fn([f64; N]) -> [f64; N], mut x: [f64; N], steps: usize) -> [f64; N] {
    for _ in 0..steps {
        x = step(x);
    }
    x
}
