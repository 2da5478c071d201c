//! Items that are not allowed within or beside a family.

use kahan_core::prelude::*;

kahan! {
    struct Ring;
    for i in ring { x[i]dot = x[i+1]; }
}

kahan! {
    struct Both;
    for i in periodic { x[i]dot = x[i+1]; }
    ydot = y;
}

kahan! {
    struct Two;
    for i in periodic { x[i]dot = x[i+1]; }
    for i in open { y[i]dot = y[i+1]; }
}

kahan! {
    struct Empty;
    for i in periodic { }
}

kahan! {
    struct Twice;
    for i in periodic { x[i]dot = x[i+1]; x[i]dot = x[i]; }
}

kahan! {
    struct NoEquation;
    for i in periodic { x[i]dot = y[i]*x[i+1]; }
}

kahan! {
    struct NoDot;
    for i in periodic { x[i] = x[i+1]; }
}

kahan! {
    struct AtNoSite;
    for i in periodic { xdot = x[i+1]; }
}

kahan! {
    struct Cubic;
    for i in periodic { x[i]dot = x[i]*x[i+1]*x[i-1]; }
}

kahan! {
    struct Divided;
    for i in periodic { x[i]dot = x[i+1]/x[i]; }
}

kahan! {
    struct Beyond { c }
    for i in open { x[i]dot = c[i+1]*x[i]; }
}

kahan! {
    struct Sum;
    for i in periodic { x[i]dot = sum(x[i]); }
}

kahan! {
    struct Outside;
    x[i]dot = x[i+1];
}

kahan! {
    struct Unused { c }
    for i in periodic { x[i]dot = x[i+1]; }
}

kahan! {
    struct Missing;
    for i in periodic { x[i]dot = x[i+1] }
}

// Coefficients of a family cannot contain `eps`.
kahan! {
    pub struct HalfStepInAFamily;
    for i in periodic {
        x[i]dot = x[i+1] - eps^2*x[i];
    }
}

fn main() {}
