//! Equations that cannot be lifted.

use kahan_core::prelude::*;

// The function has a corner.
kahan! {
    lift pub struct Corner;
    xdot = -abs(x);
}

// The function is unknown.
kahan! {
    lift pub struct Unknown;
    xdot = -f(x);
}

// The equation contains a delay.
kahan! {
    lift pub struct Delay;
    xdot = -x(t - 1);
}

// A name is unknown.
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

// The field needs no lift.
kahan! {
    lift pub struct Nothing;
}

fn main() {}
