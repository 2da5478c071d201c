//! Claims of lifts are about their quadratic fields.

use kahan_core::prelude::*;

// The energy of the flow is not that of the map.
kahan! {
    lift pub struct Flow;
    xdot = v;
    vdot = -sin(x);
    integral E = v^2/2 - cos_x;
}

// The map keeps t2 = t^2, and nothing else makes this constant.
kahan! {
    lift pub struct OnRelations;
    xdot = t^3;
    integral J = x*(t2 - t^2);
}

// Claims have no functions.
kahan! {
    lift pub struct Function;
    xdot = v;
    vdot = -sin(x);
    integral E = v^2/2 - cos(x);
}

// A claim has the name of a new variable.
kahan! {
    lift pub struct Taken;
    xdot = v;
    vdot = -sin(x);
    integral cos_x = v;
}

fn main() {
    // The types stand in for what the blocks would be.
    let start = Flow.embed(&vector![0.5, 0.0]);
    let _: SVector<f64, 4> = Flow.step(&start, 0.1);
}
