//! The index is `i`, and neighbours are `i` plus an integer.

use kahan_core::prelude::*;

kahan! {
    struct Symbolic { a }
    for i in periodic { x[i]dot = x[i+a]; }
}

kahan! {
    struct Half;
    for i in periodic { x[i]dot = x[i+1/2]; }
}

kahan! {
    struct Point;
    for i in periodic { x[i]dot = x[i+0.5]; }
}

kahan! {
    struct OtherIndex;
    for i in periodic { x[i]dot = x[j]; }
}

kahan! {
    struct OtherName;
    for k in periodic { x[k]dot = x[k+1]; }
}

kahan! {
    struct Plain;
    for i in periodic { x[i]dot = x*x[i+1]; }
}

kahan! {
    struct Shifted;
    for i in periodic { x[i+1]dot = x[i]; }
}

kahan! {
    struct Far;
    for i in periodic { x[i]dot = x[i+65]; }
}

fn main() {}
