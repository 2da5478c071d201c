//! Claims of lifts concern their quadratic fields.

use kahan_core::prelude::*;

// The flow's energy is not preserved by the map.
kahan! {
    lift pub struct Flow;
    xdot = v;
    vdot = -sin(x);
    integral E = v^2/2 - cos_x;
}

// The claim holds only on the preserved relation t2 = t^2.
kahan! {
    lift pub struct OnRelations;
    xdot = t^3;
    integral J = x*(t2 - t^2);
}

// Claims contain no functions.
kahan! {
    lift pub struct Function;
    xdot = v;
    vdot = -sin(x);
    integral E = v^2/2 - cos(x);
}

// A claim with the name of a new variable.
kahan! {
    lift pub struct Taken;
    xdot = v;
    vdot = -sin(x);
    integral cos_x = v;
}

fn main() {
    // Stand-in types replace the broken blocks.
    let start = Flow.embed(&vector![0.5, 0.0]);
    let _: SVector<f64, 4> = Flow.step(&start, 0.1);
}
