//! What cannot be lifted.

use kahan_core::prelude::*;

// A corner.
kahan! {
    lift pub struct Corner;
    xdot = -abs(x);
}

// A function of an unknown name.
kahan! {
    lift pub struct Unknown;
    xdot = -f(x);
}

// A delay.
kahan! {
    lift pub struct Delay;
    xdot = -x(t - 1);
}

// An unknown name.
kahan! {
    lift pub struct Name { k }
    xdot = -k*sin(x) + c;
}

// Without `lift` a field has no functions.
kahan! {
    pub struct NotLifted;
    xdot = v;
    vdot = -sin(x);
}

// Nothing to be lifted.
kahan! {
    lift pub struct Nothing;
}

fn main() {}
