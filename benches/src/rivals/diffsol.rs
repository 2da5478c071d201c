//! The adaptive Tsitouras method of order 5(4) from the crate `diffsol`.

use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};
use kahan_core::prelude::*;

/// Returns a function that computes the state after a time, from the initial state and this time.
/// Both the absolute and the relative tolerance are `tolerance`. The function panics on failure.
pub(crate) fn end<F, const N: usize>(field: F, tolerance: f64) -> impl Fn([f64; N], f64) -> [f64; N]
where
    F: QuadraticField<f64, N>,
{
    move |start, time| {
        let problem = OdeBuilder::<NalgebraMat<f64>>::new()
            .rtol(tolerance)
            .atol([tolerance; N])
            .rhs(|x: &[f64], _parameters: &[f64], _time, slope: &mut [f64]| {
                slope.copy_from_slice(field.field(&SVector::from_column_slice(x)).as_slice());
            })
            .init(|_parameters: &[f64], _time, x: &mut [f64]| x.copy_from_slice(&start), N)
            .build()
            .expect("a problem of closures builds");
        let mut solver = problem.tsit45().expect("an explicit solver fits every problem of closures");
        solver.set_stop_time(time).expect("the end lies ahead");
        while solver.step().expect("the orbits of the benchmarks are tame")
            != OdeSolverStopReason::TstopReached
        {}
        let state = solver.state();
        std::array::from_fn(|i| state.y[i])
    }
}
