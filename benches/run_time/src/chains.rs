//! Times orbits in code that the macro generates, and in machine code made at run time.

use std::hint::black_box;

use kahan_bench_fields::EPS;
use kahan_bench_fields::serve::Task;
use kahan_core::ExtendScalars;
use kahan_core::prelude::*;
use kahan_runtime::{MachineFloat, MapAt};

use crate::pair::{Pair, in_segments, timed};

pub(crate) fn of<M, const N: usize>(pair: &Pair<M, N>) -> Vec<Task>
where
    M: ExtendScalars<f64, N> + Copy + 'static,
{
    let &Pair { system, generated, ref read, start } = pair;
    let task = |what, run: Box<dyn Fn(usize)>| in_segments(system, what, move |steps| timed(|| run(steps)));
    macro_rules! arrive {
        ($orbit:expr, $steps:expr) => {{
            black_box($orbit.nth($steps).expect("an orbit over floats goes on"));
        }};
    }
    let (point, single_start) = (SVector::from(start), start.map(|entry| entry as f32));
    let (at, single) = (read.at(EPS), read.at(EPS as f32));
    let (in_calls, with_carry) = (at.clone(), at.clone());
    vec![
        task(
            "macro: steps of a chain",
            Box::new(move |n| arrive!(generated.orbit(black_box(point), EPS), n)),
        ),
        task("run time: steps of a chain", Box::new(move |n| advance(&at, start, n))),
        task(
            "macro: a step at a time",
            Box::new(move |n| {
                let at = generated.at(EPS);
                let mut x = black_box(point);
                for _ in 0..n {
                    x = at.step(&x);
                }
                black_box(x);
            }),
        ),
        task(
            "run time: a step at a time",
            Box::new(move |n| {
                let (mut x, mut next) = (&mut black_box(start), &mut [0.0; N]);
                for _ in 0..n {
                    in_calls.step(x, next).expect("as many entries as variables");
                    std::mem::swap(&mut x, &mut next);
                }
                black_box(x);
            }),
        ),
        task(
            "macro: compensated",
            Box::new(move |n| arrive!(generated.orbit(black_box(point), EPS).compensated(), n)),
        ),
        task(
            "run time: compensated",
            Box::new(move |n| {
                let (mut x, mut carry) = (black_box(start), [0.0; N]);
                with_carry
                    .advance_with_carry(&mut x, &mut carry, n as u64)
                    .expect("as many entries as variables");
                black_box((x, carry));
            }),
        ),
        task(
            "macro: f32",
            Box::new(move |n| {
                let narrow = generated.extend_scalars(|parameter| *parameter as f32);
                arrive!(narrow.orbit(black_box(SVector::from(single_start)), EPS as f32), n);
            }),
        ),
        task("run time: f32", Box::new(move |n| advance(&single, single_start, n))),
    ]
}

fn advance<T: MachineFloat, const N: usize>(at: &MapAt<T>, start: [T; N], steps: usize) {
    let mut x = black_box(start);
    at.advance(&mut x, steps as u64).expect("as many entries as variables");
    black_box(x);
}
