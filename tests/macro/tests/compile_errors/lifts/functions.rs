//! Equations that cannot be lifted.

use kahan_core::prelude::*;

// A function with a corner.
kahan! {
    lift pub struct Corner;
    xdot = -abs(x);
}

// An unknown function.
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

// Only lifts may contain functions.
kahan! {
    pub struct NotLifted;
    xdot = v;
    vdot = -sin(x);
}

// A field that needs no lift.
kahan! {
    lift pub struct Nothing;
}

fn main() {}
