//! Mistakes in claims of lifted blocks. These claims are about the quadratic field.

use kahan_core::prelude::*;

// The map does not preserve the flow's energy.
kahan! {
    lift pub struct Flow;
    xdot = v;
    vdot = -sin(x);
    integral E = v^2/2 - cos_x;
}

// The claim holds only if t2 = t^2, but it must hold for all values of the new variable t2.
kahan! {
    lift pub struct OnRelations;
    xdot = t^3;
    integral J = x*(t2 - t^2);
}

// Claims cannot contain functions.
kahan! {
    lift pub struct Function;
    xdot = v;
    vdot = -sin(x);
    integral E = v^2/2 - cos(x);
}

// The claim has the name of a new variable.
kahan! {
    lift pub struct Taken;
    xdot = v;
    vdot = -sin(x);
    integral cos_x = v;
}

fn main() {
    // The broken blocks are replaced by types with the expected methods.
    let start = Flow.embed(&vector![0.5, 0.0]);
    let _: SVector<f64, 4> = Flow.step(&start, 0.1);
}
