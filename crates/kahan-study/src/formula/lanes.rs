//! One formula evaluated for a group of orbits in SIMD lanes, each with its own constants.

use std::cell::RefCell;

use kahan_algebra::arithmetic::Float64;
use kahan_algebra::rational::Rational;
use kahan_core::observe::{GROUP, Group};
use kahan_program::{Arithmetic, Calls, Program};

use super::{Called, Formula, Operation};

/// A formula that is evaluated on several orbits at once, with constants for each orbit. Results
/// equal, bit for bit, those of [`Formula::of`] on one orbit.
pub(crate) struct FormulaGroup {
    program: Program<Vec<Operation>>,
    variables: Vec<(usize, usize)>,
    workspace: RefCell<Vec<Group<f64>>>,
}

impl FormulaGroup {
    /// Combines formulas of the same text, one for each orbit. Panics without formulas.
    pub(crate) fn of(formulas: &[&Formula]) -> Self {
        let own = |lane: usize| &formulas[lane.min(formulas.len() - 1)].known;
        let group = |place: usize| std::array::from_fn(|lane| own(lane)[place]);
        let workspace = RefCell::new((0..formulas[0].known.len()).map(group).collect());
        let Formula { program, variables, .. } = formulas[0].clone();
        FormulaGroup { program, variables, workspace }
    }

    /// Returns the value on each orbit; `points` holds the values of each variable on all orbits.
    pub(crate) fn at(&self, points: &[Group<f64>]) -> Group<f64> {
        let mut workspace = self.workspace.borrow_mut();
        for (variable, place) in &self.variables {
            workspace[*place] = points[*variable];
        }
        self.program.compute(&Lanes, 0, &mut workspace).expect("doubles have quotients by zero");
        workspace[self.program.outputs[0].0]
    }
}

struct Lanes;

#[inline(always)]
fn zip_lanes(a: &Group<f64>, b: &Group<f64>, of: impl Fn(f64, f64) -> f64) -> Group<f64> {
    let mut all = [0.0; GROUP];
    for ((all, a), b) in all.iter_mut().zip(a).zip(b) {
        *all = of(*a, *b);
    }
    all
}

impl Arithmetic for Lanes {
    type Value = Group<f64>;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<Group<f64>> {
        Some([value.to_f64(); GROUP])
    }

    #[inline(always)]
    fn add(&self, a: &Group<f64>, b: &Group<f64>) -> Group<f64> {
        zip_lanes(a, b, |a, b| a + b)
    }

    #[inline(always)]
    fn subtract(&self, a: &Group<f64>, b: &Group<f64>) -> Group<f64> {
        zip_lanes(a, b, |a, b| a - b)
    }

    #[inline(always)]
    fn multiply(&self, a: &Group<f64>, b: &Group<f64>) -> Group<f64> {
        zip_lanes(a, b, |a, b| a * b)
    }

    #[inline(always)]
    fn negate(&self, a: &Group<f64>) -> Group<f64> {
        zip_lanes(a, a, |a, _| -a)
    }

    #[inline(always)]
    fn divide(&self, a: &Group<f64>, b: &Group<f64>) -> Option<Group<f64>> {
        Some(zip_lanes(a, b, |a, b| a / b))
    }

    fn is_zero(&self, a: &Group<f64>) -> bool {
        a.iter().all(|a| *a == 0.0)
    }
}

impl Calls<Called> for Lanes {
    fn call(&self, function: &Called, a: &Group<f64>, b: &Group<f64>) -> Option<Group<f64>> {
        Some(zip_lanes(a, b, |a, b| Float64.call(function, &a, &b).expect("doubles have values")))
    }
}
