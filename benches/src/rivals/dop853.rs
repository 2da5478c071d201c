//! The adaptive Dormand–Prince method of order 8 from the crate `ode_solvers`.

use kahan_core::prelude::*;
use ode_solvers::{Dop853, OutputType, SVector as Vector, System};

struct Field<F>(F);

impl<F: QuadraticField<f64, N>, const N: usize> System<f64, Vector<f64, N>> for Field<F> {
    fn system(&self, _time: f64, x: &Vector<f64, N>, slope: &mut Vector<f64, N>) {
        let x: [f64; N] = (*x).into();
        let value: [f64; N] = self.0.field(&SVector::from(x)).into();
        *slope = value.into();
    }
}

/// Returns a function that computes the state after a time, from the initial state and this time.
/// Both the absolute and the relative tolerance are `tolerance`. The function panics on failure.
pub(crate) fn end<F, const N: usize>(field: F, tolerance: f64) -> impl Fn([f64; N], f64) -> [f64; N]
where
    F: QuadraticField<f64, N> + Clone,
{
    move |start, time| {
        let start = Vector::from(start);
        let mut solver = Dop853::new(Field(field.clone()), 0.0, time, time, start, tolerance, tolerance);
        solver.set_output(OutputType::Sparse);
        solver.integrate().expect("the orbits of the benchmarks are tame");
        (*solver.y_out().last().expect("the end is always put out")).into()
    }
}
