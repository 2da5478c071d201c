//! The tiers of one step, each timed as a chain of dependent steps.

use std::hint::black_box;
use std::time::Instant;

use kahan_bench_fields::serve::Task;
use kahan_bench_fields::{self as fields, EPS, start};
use kahan_core::prelude::*;
use kahan_core::{ExtendScalars, ThroughF64};

/// After this number of steps, a chain starts again at the initial state.
const SEGMENT: usize = 1024;

pub(crate) fn all() -> Vec<Task> {
    let (top, lorenz, clebsch) = (fields::euler_top(), fields::lorenz(), fields::clebsch());
    let mut tasks = Vec::new();
    tasks.extend(system("LotkaVolterra", fields::LotkaVolterra, start::LOTKA_VOLTERRA));
    tasks.extend(system("EulerTop", top, start::SPACE));
    tasks.extend(system("E1", fields::E1, start::SPACE));
    tasks.extend(system("E3", fields::E3, start::SPACE));
    tasks.extend(system("E5", fields::E5, start::SPACE));
    tasks.extend(system("E6", fields::E6, start::SPACE));
    tasks.extend(system("Lorenz", lorenz, start::LORENZ));
    tasks.extend(system("Clebsch", clebsch, start::CLEBSCH));
    tasks
}

fn system<M, const N: usize>(name: &'static str, map: M, start: [f64; N]) -> Vec<Task>
where
    M: ExtendScalars<f64, N> + Copy + 'static,
{
    let start = SVector::from(start);
    let task = |what, run: Box<dyn Fn(usize)>| Task {
        system: name,
        what,
        operations: 0,
        seconds: Box::new(move |steps| {
            let begun = Instant::now();
            for done in (0..steps).step_by(SEGMENT) {
                run(SEGMENT.min(steps - done));
            }
            begun.elapsed().as_secs_f64()
        }),
    };
    macro_rules! arrive {
        ($orbit:expr, $steps:expr) => {{
            black_box($orbit.nth($steps).expect("an orbit over floats goes on"));
        }};
    }
    let single_start = start.map(|entry| entry as f32);
    vec![
        task("fast", Box::new(move |n| arrive!(map.orbit(black_box(start), EPS), n))),
        task(
            "fast, a step at a time",
            Box::new(move |n| {
                let at = map.at(EPS);
                let mut x = black_box(start);
                for _ in 0..n {
                    x = at.step(&x);
                }
                black_box(x);
            }),
        ),
        task("compensated", Box::new(move |n| arrive!(map.orbit(black_box(start), EPS).compensated(), n))),
        task("projective", Box::new(move |n| arrive!(map.orbit(black_box(start), EPS).projective(), n))),
        task(
            "stable",
            Box::new(move |n| {
                let at = map.at(EPS);
                let mut x = black_box(start);
                for _ in 0..n {
                    x = at.try_step(&x).expect("no pole is near");
                }
                black_box(x);
            }),
        ),
        task(
            "accurate",
            Box::new(move |n| {
                let wide = map.extend_scalars(|parameter| Dd::from(*parameter));
                arrive!(wide.orbit(black_box(start).map(Dd::from), Dd::from(EPS)), n);
            }),
        ),
        task(
            "f32",
            Box::new(move |n| {
                let narrow = map.extend_scalars(|parameter| *parameter as f32);
                arrive!(narrow.orbit(black_box(single_start), EPS as f32), n);
            }),
        ),
        task(
            "f32 through f64",
            Box::new(move |n| {
                let narrow = ThroughF64(map.extend_scalars(|parameter| *parameter as f32));
                arrive!(narrow.orbit(black_box(single_start), EPS as f32), n);
            }),
        ),
        task(
            "f32, stable",
            Box::new(move |n| {
                let at = map.extend_scalars(|parameter| *parameter as f32).at(EPS as f32);
                let mut x = black_box(single_start);
                for _ in 0..n {
                    x = at.try_step(&x).expect("no pole is near");
                }
                black_box(x);
            }),
        ),
    ]
}
