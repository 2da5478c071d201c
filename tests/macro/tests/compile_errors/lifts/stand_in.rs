//! Code that uses a broken lift gives no further errors.

use kahan_core::prelude::*;

kahan! {
    lift pub struct Broken { k }
    xdot = v;
    vdot = -k*sgn(x);
}

kahan! {
    lift pub struct Exact { g }
    xdot = v;
    vdot = -g*sin(x);
}

fn main() {
    let broken = Broken { k: 1.0 };
    let start = broken.embed(&vector![0.5, 0.0]);
    let next = broken.step(&start, 0.1);
    let _: SVector<f64, 2> = broken.project(&next);
    // `embed` takes only `f64` and `f32`, not `Dd`.
    let _ = Exact { g: Dd::from(1.0) }.embed(&vector![Dd::from(0.5), Dd::from(0.0)]);
}
